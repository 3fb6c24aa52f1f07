# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""potdem_gather.h: what ranks tell each other arrives, beyond 2^31 bytes too; beyond 2^31 items there is an error."""

import re
import subprocess
from pathlib import Path

import pytest

from potdem import running


def gather(build, what, nprocs):
    """what each rank says"""
    program = build / "unittest" / "mpi_gather"
    if not program.exists():
        pytest.skip(f"{program} has not been built: LAMMPS is without MPI")
    done = subprocess.run(running.on_ranks(nprocs, [program, what]), env=running.environment(), text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL, timeout=300, check=False)
    assert done.returncode == 0, done.stdout[-3000:]
    found = dict(re.findall(r"^rank (\d+): (.*(?:\n(?!rank).*)*)", done.stdout, re.MULTILINE))
    assert sorted(found) == [str(rank) for rank in range(nprocs)]
    return list(found.values())


def need_memory(gigabytes):
    known = re.search(r"^MemAvailable: +(\d+) kB", Path("/proc/meminfo").read_text(), re.MULTILINE)
    free = int(known.group(1)) / 1e6
    if free < gigabytes:
        pytest.skip(f"needs {gigabytes} GB of memory, {free:.1f} GB are free")


@pytest.mark.parametrize("nprocs", [1, 2, 3])
def test_few_rows(build, nprocs):
    assert [text.strip() for text in gather(build, "few", nprocs)] == ["right"] * nprocs


def test_more_bytes_than_an_int_counts(build):
    """24.4 million failed bonds of 88 bytes in one step, as many on each rank"""
    need_memory(10)
    assert [text.strip() for text in gather(build, "bytes", 2)] == ["right"] * 2


def test_more_items_than_an_int_counts(build):
    """the same error on all ranks"""
    need_memory(5)
    for text in gather(build, "items", 2):
        assert "2147483648 grains of sand in one step are more than the 2147483647 that processors can tell each other at once" in " ".join(text.split())
        assert "shorter timestep" in text
