# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""The thesis's step of 50 µs in its scene 6.9: with the printed modulus the run blows up, with a tenth of it the disc falls with g."""

import re

import pytest

from potdem.paths import EXAMPLES

STEP, GRAVITY, SPEED = 5e-5, 9.81, 5.0
ENDS = 0.02    # s, before the disc touches the bed


def start(run_lammps, folder, expect_error=None, **variables):
    script = (EXAMPLES / "disc-bed" / "in.disc-bed").read_text(encoding="utf-8")
    variables = {"dt": STEP, "settle": 0, "time": ENDS, "picture": "no", "out": folder, **variables}
    return run_lammps(script, vars=variables, expect_error=expect_error)


def test_with_a_tenth_of_the_modulus_it_runs(run_lammps, tmp_path):
    thermo = start(run_lammps, tmp_path).thermo
    assert thermo["v_speed"][-1] == pytest.approx(-SPEED - GRAVITY * ENDS, rel=1e-6)
    assert thermo["v_broken"][-1] == 0


def test_with_the_printed_modulus_it_blows_up(run_lammps, tmp_path):
    run = start(run_lammps, tmp_path, expect_error="has passed the wall", E=3e10)
    (critical,) = re.findall(r"The timestep 5e-05 is longer than the critical step (\S+) .* on step 0", run.stdout)
    assert STEP > 3 * float(critical)
