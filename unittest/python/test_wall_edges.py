# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Edges, corners, openings and seams of walls: a particle is led along a path, and on it the force must be continuous
and the slope of the energy. That is asked of POTDEM, of LAMMPS's regions, and of the remedies that the page of the fix
gives where LAMMPS's regions fall short."""

import numpy as np
import pytest

from potdem import formulas, scripts

RADIUS = 0.5
LAW = "law truss 1000 0.8"
STIFFNESS = 1000 * formulas.section(RADIUS, 0.8) / RADIUS    # largest of the law; F/r of a turning normal is below it


def start(regions, place, more=""):
    return scripts.box(60) + scripts.particles([(*place, 2 * RADIUS)]) + f"""
pair_style none
bond_style none
{regions}
{more}
thermo 1
"""


def lead(run_lammps, regions, walls, path, steps=2000, law=LAW):
    """forces, energies and places along the straight pieces of a path"""
    path = np.array(path, dtype=float)
    script = start(regions, path[0], "timestep 0.001\n" + "".join(
        f"fix {wall} all potdem/wall/region {wall} {law}\n" for wall in walls))
    sums = {"e": "+".join(f"f_{wall}" for wall in walls)}
    sums |= {f"f{k}": "+".join(f"f_{wall}[{k}]" for wall in walls) for k in (1, 2, 3)}
    script += "".join(f"variable {name} equal {text}\n" for name, text in sums.items())
    script += "".join(f"variable {name} equal {name}[1]\n" for name in "xyz")
    script += "thermo_style custom step v_x v_y v_z v_e v_f1 v_f2 v_f3\n"
    script += f"thermo_modify format float {scripts.ALL_DIGITS}\n"
    for a, b in zip(path, path[1:]):
        v = " ".join(f"{k:.17g}" for k in (b - a) / (0.001 * steps))
        script += f"fix lead all move linear {v} units box\nrun {steps} post no\nunfix lead\n"
    thermo = run_lammps(script).thermo
    return (scripts.vectors(thermo, "v_x", "v_y", "v_z"), -scripts.vectors(thermo, "v_f1", "v_f2", "v_f3"),
            thermo["v_e"])


def box_of(style, numbers, more=""):
    return f"region table {style} {numbers} {more} units box"


def blocks(one, two):
    """a table of two blocks is what both leave out"""
    return (f"region one block {one} side out units box\nregion two block {two} side out units box\n"
            "region table intersect 2 one two")


OVER = [(-1, 0, 0.4), (1, 0.1, 0.4)]
CORNER = "-5 5 -5 5 -5 5"
# regions, walls, path, largest number of faces touched at a time
PATHS = {
    "into the corner of a block": (box_of("block", CORNER), ["table"],
                                   [(-4, -4, -4), (-4.7, -4.65, -4.6), (-4.7, 0, 0)], 3),
    "around an edge and a corner of a block": (box_of("block", "-5 5 -5 5 -5 0", "side out"), ["table"],
                                               [(4, 0, 0.4), (5.2, 0.3, 0.35), (5.4, 4, -1), (5.2, 5.3, 0.2),
                                                (4, 4, 0.4)], 1),
    "out of the open side of a block": (box_of("block", CORNER, "open 2"), ["table"],
                                        [(4, 0, -4.6), (5.5, 0.2, -4.6), (5.35, 0.3, -5.2), (5.1, 0, -5.4),
                                         (4, 0, -5.4)], 1),
    "floor and side out of the open end of a channel, a fix for each": (
        "region floor block -5 5 -5 5 -5 5 open 1 open 2 open 3 open 4 open 6 units box\n"
        "region side block -5 5 -5 5 -5 5 open 1 open 2 open 4 open 5 open 6 units box", ["floor", "side"],
        [(4, -4.6, -4.6), (6, -4.6, -4.65), (6, -4.4, -5.3), (4, -4.4, -5.4)], 2),
    "around the inner edge of an L, as what an obstacle leaves": (
        f"region hall block {CORNER} units box\nregion pillar block 0 6 0 6 -6 6 side out units box\n"
        "region table intersect 2 hall pillar", ["table"], [(1, -0.4, 0), (-0.3, -0.3, 0), (-0.4, 4.6, 0.3)], 2),
    "onto a step": ("region low block -5 0 -5 5 -5 0 side out units box\nregion high block 0 5 -5 5 -5 1 side out units box\n"
                    "region table intersect 2 low high", ["table"],
                    [(-2, 0, 0.4), (-0.4, 0.1, 0.45), (-0.35, 0, 1.2), (2, 0.1, 1.4)], 2),
    "over the seam of two blocks": (blocks("-5 0.0001 -5 5 -5 0", "0.0001 5 -5 5 -5 0"), ["table"], OVER, 1),
    "over the seam, its place hit exactly": (blocks("-5 0.25 -5 5 -5 0", "0.25 5 -5 5 -5 0"), ["table"], OVER, 1),
    "over a gap of 1e-8": (blocks("-5 -1e-8 -5 5 -5 0", "0 5 -5 5 -5 0"), ["table"], OVER, 1),
    "over two blocks that overlap": (blocks("-5 0.3 -5 5 -5 0", "-0.2 5 -5 5 -5 0"), ["table"], OVER, 1),
    "over the edge of two blocks, one on the other": (
        blocks("-5 0 -5 5 -5 -0.3", "-5 0 -5 5 -0.3 0"), ["table"], [(-1, 0, 0.4), (0.3, 0.1, 0.3), (0.35, 0, -1.4)], 1),
    "over the ridge of two prisms": (
        "region one prism -5 0 -5 5 -5 0 0 0 -2 side out units box\n"
        "region two prism 0 5 -5 5 -5 0 0 0 0 side out units box\nregion table intersect 2 one two", ["table"],
        [(-3, -1, 0.4), (1, -0.9, 0.4)], 1),
    "onto a ramp": ("region floor plane 0 0 0 0 0 1 units box\n"
                    "region ramp plane 0 0 0 -0.5 0 1 units box\n"
                    "region table intersect 2 floor ramp", ["table"], [(-2, 0, 0.45), (0, 0.1, 0.48), (2, 0, 1.45)], 2),
    "along a channel of two blocks": (
        "region one block -5 0.1001 -5 5 -5 5 units box\nregion two block 0.1001 5 -5 5 -5 5 units box\n"
        "region table union 2 one two", ["table"], [(-1, 0, -4.6), (1, 0.1, -4.55)], 1),
    "along a channel of two blocks that overlap": (
        "region one block -5 0.3 -5 5 -5 5 units box\nregion two block -0.2 5 -5 5 -5 5 units box\n"
        "region table union 2 one two", ["table"], [(-1, -4.7, -4.6), (1, -4.6, -4.55)], 2),
    "out of what two blocks leave out, given as a union": (
        "region one block -5 0.0001 -5 5 -5 0 units box\nregion two block 0.0001 5 -5 5 -5 0 units box\n"
        "region table union 2 one two side out", ["table"], [(-1, 0, 0.4), (5.2, 0.1, 0.35), (5.4, 0, -1)], 1),
    "a table on a table, nested": (
        "region one block -5 0 -5 5 -5 0 units box\nregion two block 0 5 -5 5 -5 0 units box\n"
        "region low union 2 one two side out\nregion high block 2 5 -5 5 -5 1 side out units box\n"
        "region table intersect 2 low high", ["table"], [(-1, 0, 0.4), (1.6, 0.1, 0.4), (1.65, 0, 1.3), (3, 0, 1.4)], 2),
    "between two planes": ("region one plane 0 0 0 0 0 1 units box\nregion two plane 0 0 0 1 0 1 units box\n"
                           "region table intersect 2 one two", ["table"], [(2, 0, 0.4), (0.2, 0.1, 0.45)], 2),
    "from a floor onto a dome": ("region floor plane 0 0 0 0 0 1 units box\nregion dome sphere 0 0 0 2 side out units box\n"
                                 "region table intersect 2 floor dome", ["table"],
                                 [(-4, 0, 0.4), (-2.35, 0.1, 0.4), (-1.7, 0.1, 1.7), (0.2, 0.1, 2.4)], 2),
    "into the corner of a cylinder": (box_of("cylinder", "z 0 0 5 -5 5"), ["table"],
                                      [(4, 0, -4), (4.6, 0.2, -4.6), (-3, 3, -4.6)], 2),
    "out of a silo": (box_of("cylinder", "z 0 0 5 -5 5", "open 1"), ["table"],
                      [(4.6, 0, -4), (4.6, 0.1, -5.2), (5, 0.2, -5.4), (5.4, 0, -5.2), (5.4, 0, -4)], 1),
    "around the edge of a cylinder": (box_of("cylinder", "z 0 0 5 -5 0", "side out"), ["table"],
                                      [(4, 0.1, 0.4), (5.2, 0.3, 0.3), (5.4, 0, -2)], 1),
    "into the bottom of a cone": (box_of("cone", "z 0 0 2 5 -5 5"), ["table"], [(1, 0, -4), (1.7, 0.2, -4.6)], 2),
    "out of a hopper": (box_of("cone", "z 0 0 2 5 -5 5", "open 1"), ["table"],
                        [(2.0, 0, -4), (1.6, 0.1, -5.2), (2.1, 0, -5.4)], 1),
    "around the rim of a cone": (box_of("cone", "z 0 0 2 5 -5 5", "side out"), ["table"],
                                 [(4, 0, 5.4), (5.2, 0.2, 5.3), (5.4, 0, 4.7)], 1),
    "into the corner of a prism": (box_of("prism", CORNER + " 2 1 1"), ["table"],
                                   [(-1, 0, 0), (-4.5, -4.55, -4.5)], 3),
    "around the edge of a prism": (box_of("prism", "-5 5 -5 5 -5 0 2 1 1", "side out"), ["table"],
                                   [(5, 0, 0.4), (7.2, 0.1, 0.35), (7.2, 0, -1.4)], 1),
    "over a sphere": (box_of("sphere", "0 0 0 3", "side out"), ["table"], [(-2, 0, 3.1), (2, 0.2, 3.1)], 1),
    "along an ellipsoid": (box_of("ellipsoid", "0 0 0 6 5 8"), ["table"], [(-2, 0, 7.2), (3, 0.2, 6.5)], 1),
    "over an ellipsoid": (box_of("ellipsoid", "0 0 0 3 2 4", "side out"), ["table"],
                          [(0.1, 2.4, -2), (0.2, 2.3, 2.0)], 1),
}


@pytest.mark.parametrize("name", PATHS)
def test_no_kick(run_lammps, name):
    """|dF/dx| stays below the stiffness times the number of faces, and the work along the path is the energy that is
    left, but for K dx^2/2 where a contact begins or ends (four times here at most)"""
    places, forces, energy = lead(run_lammps, *PATHS[name][:3])
    ways = np.linalg.norm(np.diff(places, axis=0), axis=1)
    assert np.linalg.norm(forces, axis=1).max() > 0.05 * STIFFNESS * RADIUS
    slope = np.linalg.norm(np.diff(forces, axis=0), axis=1) / ways
    assert slope.max() < 1.001 * PATHS[name][3] * STIFFNESS, places[slope.argmax()]
    work = np.concatenate([[0], np.cumsum(np.sum(0.5 * (forces[1:] + forces[:-1]) * np.diff(places, axis=0), axis=1))])
    assert np.abs(energy - energy[0] + work).max() < 4 * 0.5 * STIFFNESS * ways.max()**2
