# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""What a scene does not need is not there: no fix, no communication, no list, as LAMMPS itself reports them."""

import re

import pytest

from potdem import scripts
from potdem.text import replaced

INFO = "run 0\ninfo communication\ninfo fixes\n"


def grains(pair="potdem/hertz", coeff="1000 0.3", more=""):
    return scripts.box(8) + "bond_style none\nregion heap block -2 2 -2 2 -2 2\n" + scripts.crystal(
        region="heap", diameter=1.01) + f"pair_style {pair}\npair_coeff * * {coeff}\nfix move all nve\n{more}\n"


def body(bond="", pair="", more="", area="factor 0.5"):
    return scripts.box(12) + "region body block -2 2 -2 2 -2 2\n" + scripts.crystal(region="body") + scripts.elastic(
        area=area, bond=bond, pair_options=pair) + f"potdem_bonds all 1 2.0\nfix move all nve\n{more}\n"


def ghost_velocities(run):
    return re.search(r"Communicate velocities for ghost atoms = (\w+)", run.stdout).group(1) == "yes"


def fixes(run):
    """styles of all fixes, LAMMPS's and the package's internal ones too"""
    return set(re.findall(r"^Fix\[ *\d+\]:.*style = ([^,\s]+)", run.stdout, re.MULTILINE))


NEEDS_VELOCITIES = [
    (grains(), False),
    (grains(coeff="1000 0.3 friction 0 5"), False),
    (grains(coeff="1000 0.3 friction 0.2 5"), True),
    (grains(coeff="1000 0.3 viscous 1e-3"), True),
    (grains("potdem/hertz rotation yes"), False),
    (grains("potdem/lj", "300 0.2 3 0.2"), False),
    (body(), False),
    (body(bond="damping 0.01"), True),
    (body(bond="penetration 2"), False),
    (body(pair="friction 0.2 5"), True),
    (body(more="fix fail all potdem/failure 1 tension 10\nfix damp all potdem/damping 0.1"), False),
    (body(more="compute strain all potdem/strain/atom\ncompute ledger all potdem/energy"), False),
]


@pytest.mark.parametrize("script, needed", NEEDS_VELOCITIES)
def test_velocities_of_ghosts_only_for_what_slides_or_is_viscous(run_lammps, script, needed):
    assert ghost_velocities(run_lammps(script + INFO)) == needed


def test_internal_fixes_only_where_they_are_used(run_lammps):
    """(DUMMY, LAMMPS's fix that does nothing, holds a place for POTDEM_CONTACTS)"""
    assert fixes(run_lammps(grains() + INFO)) == {"nve", "POTDEM_MONITOR", "POTDEM_REFRESH", "DUMMY"}
    bonded = fixes(run_lammps(body() + INFO))
    assert "POTDEM_BOND_HISTORY" in bonded and "POTDEM_CONTACTS" in bonded and "POTDEM_LEDGER" not in bonded
    assert "POTDEM_AREA_BOND_HISTORY" not in bonded and "POTDEM_RESUME" not in bonded
    assert "POTDEM_AREA_BOND_HISTORY" in fixes(run_lammps(body(area="lattice") + INFO))
    assert "POTDEM_LEDGER" in fixes(run_lammps(grains(more="compute ledger all potdem/energy") + INFO))


def test_no_pair_is_searched_or_kept_inside_an_unbroken_body(run_lammps):
    """bonds up to 2 d hold every pair that could touch: the list of the pair style is empty"""
    log = run_lammps(body() + "run 0\n").log
    assert float(re.search(r"Neighs: +(\S+) ave", log).group(1)) == 0
    assert float(re.search(r"Neighs: +(\S+) ave", run_lammps(grains() + "run 0\n").log).group(1)) > 0


def test_a_strain_that_nobody_reads_is_not_computed(run_lammps):
    """its first evaluation would refuse this deforming periodic box"""
    script = scripts.box(4, "p p p") + "region body block -2 2 -2 2 -2 2\n" + scripts.crystal(
        region="body") + scripts.elastic() + """
potdem_bonds all 1 1.5
fix move all nve
fix squeeze all deform 1 x scale 0.99
compute strain all potdem/strain/atom
run 10
"""
    run_lammps(script)
    run_lammps(replaced(script, "run 10", "dump d all custom 5 strain.dump id c_strain[1]\nrun 10"),
               expect_error="potdem/strain/atom")
