# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""The selection that unittest/run runs through the plugin as well: tests marked every_style."""

import re

import pytest
from test_build import styles

from potdem import scripts

pytestmark = pytest.mark.every_style


@pytest.mark.parametrize("suffix", ["", "package omp 2\nsuffix omp\n"])
def test_styles_that_no_script_names(run_lammps, suffix):
    """the memory of bonds and of the strain, the ledger and the warnings, and bonds on threads"""
    script = suffix + scripts.box(20) + "region body block 0 3 0 3 0 3 units box\n" + \
        scripts.crystal(region="body") + scripts.elastic(area="lattice") + """
potdem_bonds all 1 1.42
fix move all nve
compute books all potdem/energy
compute step all potdem/timestep
compute strain all potdem/strain/atom
compute piece all potdem/piece/atom
compute largest all reduce max c_strain[1]
timestep 1e-3
thermo_style custom step pe c_books c_step c_largest c_piece
restart 1000 kept.a kept.b
run 2
info fixes system
"""
    text = run_lammps(script).stdout
    for name in ("POTDEM_BOND_HISTORY", "POTDEM_AREA_BOND_HISTORY", "POTDEM_REFERENCE", "POTDEM_LEDGER", "POTDEM_MONITOR",
                 "POTDEM_RESUME"):
        assert name in text


# where a script, or LAMMPS in answer to it, names a style of a kind
NAMED = {
    "pair": r"(pair_style|pair|Atoms .*style =) {}[\s,]",
    "bond": r"(bond_style|Bonds .*style =) {}\s",
    "fix": r"(fix \S+ \S+|style =) {}[\s,]",
    "region": r"region \S+ {}\s",
    "compute": r"compute \S+ \S+ {}\s",
    "command": r"(^|\n){}\s",
}


@pytest.mark.usefixtures("lmp")    # so that it is part of the pass through the plugin
def test_every_style_is_named(root, request):
    """by the selection; runs last"""
    texts = request.config.named_by_every_style
    if request.config.option.keyword or not texts:
        pytest.skip("the whole selection is needed (no -k)")
    text = "\n".join(texts)
    assert [f"{kind} {name}" for kind, name in styles(root) if not re.search(NAMED[kind].format(name), text)] == []
