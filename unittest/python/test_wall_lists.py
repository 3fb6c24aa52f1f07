# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""fix potdem/wall/region: between two neighbour lists only particles near a wall are asked. That changes nothing: not where the wall
stands still, moves or is made of parts."""

import numpy as np
import pytest

from potdem import scripts

WALLS = {
    "cylinder": "region wall cylinder z 0 0 1 -1 1 units box",
    "funnel": "region wall cone z 0 0 0.2 1.5 -1 1 open 1 open 2 units box",
    "two parts": "region a block -1 1 -1 1 -1 1 units box\nregion b sphere 0 0 -0.6 0.3 side out units box\nregion wall intersect 2 a b",
    "a union": "region a block -1 0.1 -1 1 -1 1 units box\nregion b block 0 1 -1 1 -1 1 units box\nregion wall union 2 a b",
    "prism": "region wall prism -1 1 -1 1 -1 1 0.3 0.2 -0.1 units box",
    "slope": "region wall plane 0 0 -1 0.2 0.1 1 units box",
    "turns": "variable angle equal 3*time\nregion wall block -1 1 -1 1 -1 1 rotate v_angle 0.1 0 0 1 1 2 units box",
    "jumps": "variable z equal -0.3*floor(time/0.1)\nregion wall plane 0 0 -1 0 0 1 move NULL NULL v_z units box",
    "moves": "variable z equal -0.2*time\nregion wall block -1 1 -1 1 -1.2 1 move NULL NULL v_z units box",
}


PERIODIC = {
    "floor": "region wall block INF INF INF INF -1 1 units box",
    "floor and ball": "region a block INF INF INF INF -1 1 units box\nregion b sphere 1.6 0 -0.6 0.35 side out units box\n"
                      "region wall intersect 2 a b",
}


def script(wall, lists, boundary="f f f"):
    """30 grains that fly about fast, each for itself; lists: how neigh_modify checks whether particles moved"""
    rng = np.random.default_rng(1)
    places = np.column_stack([rng.uniform(-0.3, 0.3, (30, 2)), rng.uniform(0, 0.7, 30), 0.04 + 0.002 * np.arange(30)])
    text = scripts.box(4, boundary, newton="off", atom_style="sphere", skin=0.05) + scripts.particles(places, density=1000)
    for number, velocity in enumerate(rng.normal(0, 3, (30, 3)), start=1):
        text += "set atom {} vx {} vy {} vz {}\n".format(number, *velocity)
    text += f"comm_modify vel yes\nneigh_modify delay 0 every 1 check {lists}\n{wall}\npair_style zero 0.2\npair_coeff * *\n"
    text += "fix wall all potdem/wall/region wall 1e7 0.3 particle 1e7 0.3 layer none restitution 0.9 friction 0.3 mindlin damping 0.2 "
    text += "rotation yes\nfix move all nve/sphere\ntimestep 2e-5\nthermo 5000\nthermo_style custom step ke f_wall[3] f_wall\n"
    return text + "thermo_modify format float %.17g lost ignore\nrun 20000\n"


@pytest.mark.parametrize("name, boundary", [*((name, "f f f") for name in WALLS), *((name, "p p f") for name in PERIODIC)])
def test_the_same_as_if_all_were_asked(run_lammps, name, boundary):
    """a list in every step leaves nothing to be skipped"""
    wall = {**WALLS, **PERIODIC}[name]
    found, known = (run_lammps(script(wall, lists, boundary)).thermo for lists in ("yes", "no"))
    assert known["KinEng"][0] != known["KinEng"][-1]    # they met the wall
    for column, values in known.items():
        assert found[column] == pytest.approx(values, rel=1e-12), column
