# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""A short run of what `unittest/run --full` does for minutes with libFuzzer: whatever is in a material file, in the arguments of a command or in
a sequence of commands ends in an error or a result, and the next command is taken."""

import subprocess

import pytest

from potdem import running

pytestmark = pytest.mark.built_in
INPUTS = {"material": 300, "arguments": 300, "sequence": 60}


@pytest.mark.parametrize("kind", INPUTS)
def test_nothing_that_is_fed_to_it_ends_the_program(root, build, tmp_path, kind):
    kept = sorted(path for path in (root / "unittest" / "trust" / "corpus" / kind).glob("*") if path.is_file())
    done = subprocess.run([build / "unittest" / "fuzz_alone", str(INPUTS[kind]), *kept], cwd=tmp_path, text=True, errors="replace", check=False,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, env=running.environment(POTDEM_FUZZ=kind), timeout=300)
    assert done.returncode == 0 and f"{INPUTS[kind] + len(kept)} inputs" in done.stdout, done.stdout[-2000:]
