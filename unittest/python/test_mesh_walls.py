# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Regions of triangles from STL files as walls: the same as LAMMPS's own regions where both can describe a shape, whatever the
triangles; no kick at edges; sheets; what is wrong with a file."""

import numpy as np
import pytest
from test_wall_edges import LAW, RADIUS, STIFFNESS, lead

from potdem import scripts, stl

E, NU, FRICTION = 1000.0, 0.3, "friction 0.4 mindlin damping 0.3 rotation yes"


def grains(region, n=4, law=f"{E} {NU} particle {E} {NU} layer none {FRICTION}", gravity="0.3 0.2 -1", more=""):
    """n^3 grains that spin, thrown into a wall: a block of 10 x 10 x 10 in the other tests' words"""
    return scripts.box(30) + "bond_style none\nregion heap block -4 4 -4 4 -4 4 units box\n" + scripts.crystal(
        spacing=8.0 / n, region="heap", diameter=1.1) + f"""
pair_style potdem/hertz rotation yes
pair_coeff * * {E} {NU} friction 0.4 mindlin damping 0.3
{scripts.velocities_by_formula(2.0)}
{region}
fix move all nve/sphere
fix weight all gravity 5 vector {gravity}
fix wall all potdem/wall/region wall {law}
compute spins all erotate/sphere
timestep 2e-3
thermo 200
thermo_style custom step ke c_spins f_wall f_wall[1] f_wall[2] f_wall[3] f_wall[4] f_wall[5] f_wall[6]
{more}
thermo_modify format float {scripts.ALL_DIGITS}
"""


def table(run):
    return np.array([run.thermo[name] for name in run.thermo])


BLOCK = "region wall block -5 5 -5 5 -5 5 units box"


@pytest.mark.every_style
@pytest.mark.parametrize("cells, binary, nprocs", [(1, False, 1), (7, True, 2), (40, True, 1)])
def test_a_block_of_triangles_is_a_block(run_lammps, tmp_path, cells, binary, nprocs):
    """energies, force and torque over impacts, rolling and sticking in edges and corners. Up to 1000 steps, while what rounding
    leaves of the nearest places grows from 1e-16 as chaotic motion does"""
    stl.write(tmp_path / "block.stl", stl.box([-5] * 3, [5] * 3, cells), binary)
    right = table(run_lammps(grains(BLOCK) + "run 1000\n"))
    found = run_lammps(grains("region wall potdem/mesh block.stl units box") + "run 1000\n", nprocs=nprocs)
    assert f"{12 * cells**2} triangles from block.stl" in found.stdout and "volume 1000" in found.stdout
    assert np.abs(right[3]).max() > 1.0    # the walls do push
    assert table(found) == pytest.approx(right, rel=1e-7, abs=1e-7)


def test_lammps_own_wall_takes_it_too(run_lammps, tmp_path):
    stl.write(tmp_path / "block.stl", stl.box([-5] * 3, [5] * 3, 5))
    walls = "unfix wall\nfix wall all wall/gran/region hooke 1000 NULL 20 NULL 0.4 1 region wall\nthermo_style custom step ke c_spins\n"
    right, found = (table(run_lammps(grains(f"{region}", more=walls) + "run 1000\n"))
                    for region in (BLOCK, "region wall potdem/mesh block.stl units box"))
    assert found == pytest.approx(right, rel=1e-7)


MOVES = "variable way equal 0.3*sin(2*time)\nvariable turn equal 0.2*time\n"


@pytest.mark.parametrize("move", ["move v_way NULL v_way", "rotate v_turn 0.2 0.1 0 0 0.6 0.8"])
def test_it_moves_and_turns(run_lammps, tmp_path, move):
    stl.write(tmp_path / "block.stl", stl.box([-5] * 3, [5] * 3, 3))
    right, found = (table(run_lammps(grains(f"{MOVES}{region} {move}") + "run 600\n"))
                    for region in (BLOCK, "region wall potdem/mesh block.stl units box"))
    assert found == pytest.approx(right, rel=1e-7, abs=1e-7)


def test_friction_remembers_over_edges(run_lammps, tmp_path):
    """a grain that rolls down a slope of 15 squares in a row, with a spring that sticks: as on a plane, where rolling is known,
    too: 1/(1 + 2/5 R^2/z^2) of the acceleration along it, with the centre at the height z"""
    sheet = stl.rectangle([-9, -9, 0], [18, 0, 0], [0, 18, 0], 15)
    stl.write(tmp_path / "plane.stl", sheet)
    script = scripts.box(40) + scripts.particles([(-7.9, 0.37, 0.5, 1.0)]) + "pair_style none\nbond_style none\n{region}\n" + f"""
fix move all nve/sphere
fix weight all gravity 1 vector 0.3 0.01 -1
fix wall all potdem/wall/region wall {E} {NU} particle {E} {NU} layer none friction 0.5 mindlin damping 0.5 rotation yes &
  restitution 0.2
timestep 2e-3
thermo 100
variable x equal x[1]
variable vx equal vx[1]
variable z equal z[1]
thermo_style custom step v_x v_vx v_z
thermo_modify format float {scripts.ALL_DIGITS}
run 3500
"""
    right = run_lammps(script.replace("{region}", "region wall plane 0 0 0 0 0 1 units box")).thermo
    found = run_lammps(script.replace("{region}", "region wall potdem/mesh plane.stl units box")).thermo
    assert found["v_x"][-1] - found["v_x"][0] > 3 * 18 / 15
    for name in ("v_x", "v_vx", "v_z"):
        assert found[name] == pytest.approx(right[name], rel=1e-9)
    slope = 0.3 / np.sqrt(1 + 0.3**2 + 0.01**2)
    rolls = slope / (1 + 0.4 * (0.5 / found["v_z"][-1])**2)
    # normal and spring swing in at first, damped
    assert np.diff(found["v_vx"])[-5:] == pytest.approx(rolls * 100 * 2e-3, rel=1e-6)


RIDGE = np.concatenate([stl.rectangle([-5, -5, -2], [5, 0, 2], [0, 10, 0], 3), stl.rectangle([0, -5, 0], [5, 0, -3], [0, 10, 0], 4)])
STEP = np.concatenate([stl.rectangle([-5, -5, 0], [5, 0, 0], [0, 10, 0], 3), stl.rectangle([0, -5, 0], [0, 0, 1], [0, 10, 0], 2),
                       stl.rectangle([0, -5, 1], [5, 0, 0], [0, 10, 0], 5)])
RAMP = np.concatenate([stl.rectangle([-5, -5, 0], [5, 0, 0], [0, 10, 0], 3), stl.rectangle([0, -5, 0], [5, 0, 5], [0, 10, 0], 2)])
# triangles, more of the region, path, largest number of faces touched at a time: as in test_wall_edges
PATHS = {
    "over a plane of triangles": (stl.rectangle([-5, -5, 0], [10, 0, 0], [0, 10, 0], 9), "", [(-2, -1.3, 0.4), (2, 1.5, 0.45)], 1),
    "over a ridge": (RIDGE, "", [(-3, -1, -0.5), (-0.05, 0, 0.45), (0.05, 0.1, 0.45), (2, 0, -0.55)], 1),
    "onto a step": (STEP, "", [(-2, 0, 0.4), (-0.4, 0.1, 0.45), (-0.35, 0, 1.2), (0.1, 0, 1.45), (2, 0.1, 1.4)], 2),
    "onto a ramp": (RAMP, "", [(-2, 0, 0.45), (-0.25, 0.1, 0.48), (2, 0, 2.65)], 2),
    "out over the border of a sheet and back below it": (
        stl.rectangle([-5, -5, 0], [5, 0, 0], [0, 10, 0], 4), "", [(-1, 0, 0.4), (0.3, 0.1, 0.35), (0.4, 0, 0), (0.3, 0, -0.35),
                                                                  (-1, 0.1, -0.4)], 1),
    "around an edge and a corner of a block": (
        stl.box([-5, -5, -5], [5, 5, 0], 3), "side out", [(4, 0, 0.4), (5.2, 0.3, 0.35), (5.4, 4, -1), (5.2, 5.3, 0.2), (4, 4, 0.4)],
        1),
    "into the corner of a block": (stl.box([-5] * 3, [5] * 3, 3), "", [(-4, -4, -4), (-4.7, -4.65, -4.6), (-4.7, 0, 0)], 3),
}


@pytest.mark.parametrize("name", PATHS)
def test_no_kick(run_lammps, tmp_path, name):
    """force and work along a path, as asked of regions in test_wall_edges"""
    triangles, more, path, most = PATHS[name]
    stl.write(tmp_path / "wall.stl", triangles)
    places, forces, energy = lead(run_lammps, f"region table potdem/mesh wall.stl {more} units box", ["table"], path)
    ways = np.linalg.norm(np.diff(places, axis=0), axis=1)
    assert np.linalg.norm(forces, axis=1).max() > 0.05 * STIFFNESS * RADIUS
    slope = np.linalg.norm(np.diff(forces, axis=0), axis=1) / ways
    assert slope.max() < 1.001 * most * STIFFNESS, places[slope.argmax()]
    work = np.concatenate([[0], np.cumsum(np.sum(0.5 * (forces[1:] + forces[:-1]) * np.diff(places, axis=0), axis=1))])
    assert np.abs(energy - energy[0] + work).max() < 4 * 0.5 * STIFFNESS * ways.max()**2


def test_energy_over_the_facets_of_a_sphere(run_lammps, tmp_path):
    """some of its edges point inwards, by a degree: the force turns there, what the path takes is what the contact keeps; trapezoidal rule,
    off by half a turn in half a step at each edge"""
    stl.write(tmp_path / "wall.stl", stl.sphere([0, 0, 0], 3, 12))
    places, forces, energy = lead(run_lammps, "region table potdem/mesh wall.stl side out units box", ["table"],
                                  [(-2, 0, 3.1), (2, 0.2, 3.1)])
    work = np.sum(0.5 * (forces[1:] + forces[:-1]) * np.diff(places, axis=0), axis=1)
    assert energy.max() > 1.0
    assert np.cumsum(work) == pytest.approx(energy[0] - energy[1:], abs=1e-4 * energy.max())


def test_facets_of_a_pipe_push_once(run_lammps, tmp_path):
    """a sphere in a hollow of facets that are 7.5 degrees apart: at each place the law's force of the nearest facet alone, whose
    distance is known"""
    sides, reach = 48, 4.0
    angle = 2 * np.pi * np.arange(sides + 1) / sides
    ring = np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1) * reach / np.cos(np.pi / sides)
    pipe = np.concatenate([stl.rectangle(a - [0, 0, 5], [0, 0, 10], b - a, 2) for a, b in zip(ring, ring[1:])])
    stl.write(tmp_path / "pipe.stl", pipe)
    turn = np.linspace(0.0, 0.5, 9)
    path = [(3.6 * np.cos(t), 3.6 * np.sin(t), 0.1) for t in turn]
    places, forces, _ = lead(run_lammps, "region table potdem/mesh pipe.stl units box", ["table"], path, steps=50)
    radius, t = np.hypot(places[:, 0], places[:, 1]), np.arctan2(places[:, 1], places[:, 0])
    middle = (np.floor(t / (2 * np.pi / sides)) + 0.5) * 2 * np.pi / sides
    x = (reach - radius * np.cos(t - middle)) / RADIUS
    area = float(LAW.split()[-1]) * np.pi / 4 * RADIUS**2
    assert np.linalg.norm(forces, axis=1) == pytest.approx(area * 1000 * 0.5 * (1 - x**2), rel=1e-9)


def test_particles_on_a_lattice_in_it(run_lammps, tmp_path):
    """as many as in LAMMPS's block; and in a sphere those that lie within"""
    stl.write(tmp_path / "block.stl", stl.box([-3.1, -2.2, -1.3], [4.1, 3.2, 2.3], 4))
    stl.write(tmp_path / "ball.stl", stl.sphere([0.2, 0.1, 0.3], 4.0, 20))
    script = scripts.box(20) + "lattice sc 0.5\n{region}\ncreate_atoms 1 region body\nprint \"RESULT $(atoms)\"\n"

    def count(region):
        return scripts.results(run_lammps(script.replace("{region}", region)).stdout)[0][0]

    assert count("region body potdem/mesh block.stl units box") == count("region body block -3.1 4.1 -2.2 3.2 -1.3 2.3 units box")
    # the polyhedron lies between two spheres
    inner = 4.0 * np.cos(np.radians(90 / 20 * 0.85))
    assert count(f"region body sphere 0.2 0.1 0.3 {inner} units box") <= count(
        "region body potdem/mesh ball.stl units box") <= count("region body sphere 0.2 0.1 0.3 4.0 units box")


def test_lattice_units_and_scale(run_lammps, tmp_path):
    """a drawing in millimetres; and units lattice, LAMMPS's default, told by the extent in the log"""
    stl.write(tmp_path / "block.stl", stl.box([-5000] * 3, [5000] * 3))
    right = table(run_lammps(grains(BLOCK) + "run 200\n"))
    assert table(run_lammps(grains("region wall potdem/mesh block.stl scale 0.001 units box") + "run 200\n")) == pytest.approx(
        right, rel=1e-9, abs=1e-9)
    log = run_lammps(scripts.box(20) + "lattice sc 0.5\nregion wall potdem/mesh block.stl scale 0.001\n").stdout
    assert "from (-2.5 -2.5 -2.5) to (2.5 2.5 2.5)" in log


GOOD = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n"
BAD_FILES = {
    "empty": ("", ["neither", "binary"]),
    "prose": ("This is no mesh", ["neither", "binary"]),
    "cut": (GOOD[:60], ["line 5"]),
    "cut between lines": (GOOD.split("endloop")[0], ["endsolid"]),
    "two corners": (GOOD.replace("vertex 1 0 0\n", ""), ["line 7", "three corners"]),
    "a word": (GOOD.replace("vertex 1 0 0", "vertex 1 O 0"), ["line 5", "three numbers"]),
    "a number that is none": (GOOD.replace("vertex 1 0 0", "vertex 1 nan 0"), ["line 5", "three numbers"]),
    "unknown": (GOOD.replace("outer loop", "inner loop"), ["line 3", "inner"]),
    "no triangles": ("solid a\nendsolid a\n", ["no triangles"]),
    "no area": (GOOD.replace("vertex 0 1 0", "vertex 2 0 0"), ["area of zero"]),
}


@pytest.mark.parametrize("name", BAD_FILES)
@pytest.mark.parametrize("nprocs", [1, 2])
def test_bad_file(run_lammps, tmp_path, name, nprocs):
    text, words = BAD_FILES[name]
    (tmp_path / "wall.stl").write_text(text)
    run = run_lammps(scripts.box(20) + "region wall potdem/mesh wall.stl units box\n", nprocs=nprocs, expect_error="wall.stl")
    assert all(word in run.error for word in words), run.error


@pytest.mark.parametrize("words, culprit", [
    ("nofile.stl units box", "nofile.stl"), ("", "mesh"), ("wall.stl scale -1", "scale"), ("wall.stl scale", "missing"),
    ("wall.stl scale 1 size 2", "size"), ("wall.stl units box side in out", "out")])
def test_bad_arguments(run_lammps, tmp_path, words, culprit):
    (tmp_path / "wall.stl").write_text(GOOD)
    run_lammps(scripts.box(20) + f"region wall potdem/mesh {words}\n", expect_error=culprit)


def test_a_sheet_is_told(run_lammps, tmp_path):
    (tmp_path / "wall.stl").write_text(GOOD)
    run = run_lammps(scripts.box(20) + "region wall potdem/mesh wall.stl units box\n")
    assert "a sheet with two sides, for walls only: 3 edges" in run.stdout


def test_binary_file_cut_short(run_lammps, tmp_path):
    stl.write(tmp_path / "wall.stl", stl.box([0] * 3, [1] * 3), binary=True)
    (tmp_path / "wall.stl").write_bytes((tmp_path / "wall.stl").read_bytes()[:-7])
    run_lammps(scripts.box(20) + "region wall potdem/mesh wall.stl\n", expect_error="length that it should have")
