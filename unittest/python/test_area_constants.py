# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""tools/area_constants.py: its solver is `area body`, and the table of docs/area.md names the constants that the code has"""

import re
import shutil

import area_constants
import pytest
from test_area_body import solve_in_lammps


from potdem import networks
from potdem.paths import ROOT


def test_table_has_every_constant():
    code = (ROOT / "src" / "core" / "areas" / "constants.h").read_text()
    found = [(c.name, c.value) for c in area_constants.constants()]
    assert len(found) == code.count("static constexpr")
    table = re.findall(r"^\| `([A-Z_]+)` \| (\S+) \|", (ROOT / "docs" / "area.md").read_text(), re.MULTILINE)
    assert table == found


@pytest.mark.skipif(shutil.which("g++") is None, reason="no g++")
def test_solver_is_that_of_lammps(run_lammps, tmp_path):
    """the same particles about another origin: rounding. A constant that is given has an effect"""
    body = networks.packing(5, 8, spread=0.2)
    _, pairs, areas = solve_in_lammps(run_lammps, tmp_path, body, area="body density 1", mass=body.v)
    program = area_constants.build(tmp_path, "g++")
    assert area_constants.solve(program, body, pairs, {}) == pytest.approx(areas, rel=1e-9)
    other = area_constants.solve(program, body, pairs, {"POTDEM_MOST": "2"})
    assert other.max() < 0.7 * areas.max()
