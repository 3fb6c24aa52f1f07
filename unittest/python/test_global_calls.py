# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Steps on which nobody prints have no call in which all ranks take part: neither a body that breaks nor grains and walls."""

import re
import subprocess

import pytest

from potdem import scripts
from potdem.paths import ROOT

BREAKING = scripts.box((20, 8, 8)) + "region body block -4 4 -2 2 -2 2\n" + scripts.crystal(region="body") + scripts.elastic(
    1000.0) + """
potdem_bonds all 1 2.0
velocity all ramp vx -12 12 x -4 4
fix cracks all potdem/failure 1 tension 60 scatter weibull 4 1
region room block -10 10 -4 4 -4 4 side in
fix walls all potdem/wall/region room 1000 0.3 particle 1000 0.3 friction 0.3 auto
fix damp all potdem/damping 0.1
fix move all nve
"""
GRAINS = scripts.box(8) + "bond_style none\nregion heap block -2 2 -2 2 -2 2\n" + scripts.crystal(
    region="heap", diameter=1.01) + """
pair_style potdem/hertz rotation yes
pair_coeff * * 1000 0.3 friction 0.3 mindlin rolling 0.1 0.5 0.3 viscous 0.01
region room block -3 3 -3 3 -3 3 side in
fix walls all potdem/wall/region room 1000 0.3 particle 1000 0.3 friction 0.3 mindlin rotation yes
fix move all nve/sphere
"""
# LAMMPS itself looks on every step how far particles have moved, unless told otherwise
QUIET = "neigh_modify delay 100000\nthermo 0\ntimestep 0.002\n"


@pytest.fixture(scope="module")
def counter(tmp_path_factory):
    library = tmp_path_factory.mktemp("counter") / "libglobalcalls.so"
    subprocess.run(["mpicc", "-shared", "-fPIC", "-o", library, ROOT / "bench" / "messages.c"], check=True)
    return library


@pytest.mark.parametrize("scene, broken", [(BREAKING, "f_cracks"), (GRAINS, "atoms")], ids=["body", "grains"])
def test_no_global_call_between_outputs(run_lammps, monkeypatch, counter, scene, broken):
    monkeypatch.setenv("LD_PRELOAD", str(counter))

    def calls(steps):
        run = run_lammps(scene + QUIET + f"thermo_style custom step {broken}\nrun {steps}\n", nprocs=2)
        assert run.thermo[broken if broken in run.thermo else "Atoms"][-1] > 20
        return [int(number) for number in re.findall(r"^MESSAGES \d+ \d+ (\d+)$", run.stdout, re.MULTILINE)]

    few = calls(20)
    assert len(few) == 2 and calls(60) == few
