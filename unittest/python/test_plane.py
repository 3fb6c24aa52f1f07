# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""dimension 2, beyond the forces of test_two_dimensions.py: a plate, breaking, walls, discs that roll, the ledger."""

import math

import numpy as np
import pytest

from potdem import dumps, scripts
from potdem.text import replaced

DENSITY = 2.0


def plane(size=20.0, boundary="f f p"):
    return f"""
units si
dimension 2
newton on off
atom_style bpm/sphere
boundary {boundary}
region box block {-0.5 * size:.17g} {0.5 * size:.17g} {-0.5 * size:.17g} {0.5 * size:.17g} -0.5 0.5 units box
create_box 1 box bond/types 1
thermo_modify format float {scripts.ALL_DIGITS} lost error
"""


def discs(rows):
    return "".join(f"create_atoms 1 single {x:.17g} {y:.17g} 0 units box\nset atom {k} diameter {d:.17g}\n"
                   for k, (x, y, d) in enumerate(rows, start=1)) + f"set group all density/disc {DENSITY}\n"


def columns(tmp_path, file, *names):
    return scripts.vectors(dumps.read(tmp_path / file)[0], *names)


E, THICKNESS = 1000.0, 0.3
PLATE_AREA = 2 * math.sqrt(3) / math.pi * THICKNESS    # a t/d of the page of the bond, d = 1


@pytest.mark.parametrize("stretch", [(1e-6, 0.0), (0.0, 1e-6), (1e-6, -1e-6 / 3)])
def test_plate_of_triangles(run_lammps, stretch):
    """a plate of a triangular lattice with nearest neighbours is isotropic: plane stress with nu = 1/3; a of its thickness"""
    ex, ey = stretch
    lengths = 8.0, 4 * math.sqrt(3.0)
    script = replaced(plane(1.0, "p p p"), "block -0.5 0.5 -0.5 0.5", f"block 0 {lengths[0]} 0 {lengths[1]:.17g}")
    run = run_lammps(script + f"""
lattice hex 1.0 origin 0.25 0.25 0
create_atoms 1 box
set type 1 diameter 1.0
set group all density/disc {DENSITY}
bond_style potdem/truss
bond_coeff * {E} area factor {PLATE_AREA:.17g}
pair_style potdem/truss
pair_coeff * * {E} 0.5
potdem_bonds all 1 1.1
change_box all x scale {1 + ex:.17g} y scale {1 + ey:.17g} remap units box
compute p all pressure NULL virial
thermo_style custom step bonds c_p[1] c_p[2] c_p[3]
thermo_modify format float {scripts.ALL_DIGITS}
run 0
""")
    assert run.thermo["Bonds"][0] == 3 * 64
    for k, (along, across) in enumerate((stretch, stretch[::-1]), start=1):
        stress = E / (1 - 1 / 9) * (along + across / 3)
        # geometric terms of order 1e-6 of the stress in the other direction
        assert -run.thermo[f"c_p[{k}]"][0] / THICKNESS == pytest.approx(stress, abs=1e-5 * E * 1e-6)


def plate(more):
    return plane() + f"""
lattice hex 1.0
region body block -3.3 3.3 -3.3 3.3 -0.4 0.4 units box
create_atoms 1 region body
set type 1 diameter 1.0
set type 1 density/disc {DENSITY}
bond_style potdem/truss
bond_coeff * {E} area factor {PLATE_AREA:.17g}
pair_style potdem/truss
pair_coeff * * {E} 0.5 friction 0.3 0.5
potdem_bonds all 1 1.1
{more}
"""


@pytest.mark.parametrize("nprocs", [1, 4])
def test_a_plate_breaks_on_a_wall(run_lammps, tmp_path, nprocs):
    """falls on a post, breaks, slides: nothing leaves the plane, the ledger closes"""
    run = run_lammps(plate("""
region post sphere 0 -5.6 0 2 side out units box
region floor plane 0 -6.4 0 0 1 0 units box
region walls intersect 2 post floor
velocity all set 0.5 -4.0 0
fix move all nve
fix flat all enforce2d
fix fail all potdem/failure 1 tension 60
fix walls all potdem/wall/region walls 2000 0.2 particle 2000 0.2 friction 0.3 0.2 viscous 1e-3
compute ledger all potdem/energy
timestep 0.0005
thermo 50
thermo_style custom step c_ledger c_ledger[*] f_walls[2] f_walls[3]
thermo_modify format float %.17g
run 2000
""") + scripts.write_dump("end.dump", "z vz fz"), nprocs=nprocs)
    thermo = run.thermo
    assert thermo["c_ledger[6]"][-1] > 0 and thermo["c_ledger[7]"][-1] > 0 and thermo["c_ledger[8]"][-1] > 0
    assert np.ptp(thermo["c_ledger"]) < 1e-3 * thermo["c_ledger[1]"][0]
    assert np.all(columns(tmp_path, "end.dump", "z", "vz", "fz") == 0.0)
    assert np.all(thermo["f_walls[3]"] == 0.0)


# --- walls and rotation -----------------------------------------------------------------------------------

G, RADIUS, STEP = 10.0, 0.5, 1e-3
KINDS = {"disc": ("disc", "disc", "disc", 0.5), "sphere": ("yes", "", "", 0.4)}


def rolling(kind, mu, tilt, steps, speed=0.0, region="plane 0 0 0 0 1 0"):
    """in equilibrium one radius above the wall y = 0, as in test_wall_rotation.py; gravity tilted towards +x"""
    rotation, integrator, ledger, _ = KINDS[kind]
    mass = DENSITY * math.pi * RADIUS**2
    contact = 2 * mass * G * math.cos(tilt) / (4 / 3 * math.sqrt(RADIUS) * (0.1 * RADIUS) ** 1.5)
    return plane(100) + discs([(0, RADIUS, 2 * RADIUS)]) + f"""
pair_style none
bond_style none
comm_modify cutoff 2.0
set atom 1 vx {speed}
region floor {region} units box
fix move all nve/sphere {integrator}
fix flat all enforce2d
fix weight all gravity {G} vector {math.sin(tilt):.17g} {-math.cos(tilt):.17g} 0
fix floor all potdem/wall/region floor {contact:.17g} 0 particle {contact:.17g} 0 friction {mu} auto rotation {rotation}
compute ledger all potdem/energy {ledger}
compute w all property/atom omegaz
variable v equal vx[1]
variable w equal C_w[1]
timestep {STEP}
thermo 1
thermo_style custom step v_v v_w c_ledger c_ledger[1] c_ledger[7] f_floor f_floor[1] f_floor[2] f_floor[3]
thermo_modify format float {scripts.ALL_DIGITS}
run {steps}
"""


@pytest.mark.parametrize("kind", KINDS)
def test_sliding_into_rolling(run_lammps, kind):
    """a disc ends with 2/3 of its speed, a sphere with 5/7: 1/(1 + k) with the inertia k m r^2; after k v/((1 + k) mu g)"""
    k, speed, mu = KINDS[kind][3], 2.0, 0.2
    time = k / (1 + k) * speed / (mu * G)
    thermo = run_lammps(rolling(kind, mu, 0, round(1.3 * time / STEP), speed)).thermo
    v, t = thermo["v_v"], thermo["Step"] * STEP
    assert v[-1] == pytest.approx(speed / (1 + k), rel=1e-12)
    assert thermo["v_w"][-1] * RADIUS == pytest.approx(-v[-1], rel=1e-12)
    slides = t < time - STEP
    assert v[slides] == pytest.approx(speed - mu * G * t[slides], rel=1e-12)
    # where in a step the sliding ends, the trapezoidal rule does not see: mu m g times the slip of a step
    mass = DENSITY * math.pi * RADIUS**2
    assert np.ptp(thermo["c_ledger"]) < mu * mass * G * (1 + 1 / k) * mu * G * STEP**2


@pytest.mark.parametrize("kind", KINDS)
def test_down_an_incline(run_lammps, kind):
    """g sin(theta)/(1 + k)"""
    k, tilt, steps = KINDS[kind][3], math.radians(20), 500
    thermo = run_lammps(rolling(kind, 0.5, tilt, steps)).thermo
    assert thermo["v_v"][-1] == pytest.approx(G * math.sin(tilt) / (1 + k) * steps * STEP, rel=1e-12)
    assert np.ptp(thermo["c_ledger"]) < 1e-11 * thermo["c_ledger[1]"][-1]


def test_faces_in_the_plane_are_no_walls(run_lammps):
    """a block as thin as the box of a simulation in two dimensions: its faces z = const do nothing"""
    whole, thin = (run_lammps(rolling("disc", 0.3, 0.2, 50, 0.1, region)).thermo
                   for region in ("block -40 40 0 40 INF INF", "block -40 40 0 40 -0.1 0.1"))
    for name in ("v_v", "v_w", "c_ledger", "f_floor", "f_floor[1]", "f_floor[2]", "f_floor[3]"):
        assert np.array_equal(whole[name], thin[name])
    assert np.all(thin["f_floor[3]"] == 0) and np.all(thin["f_floor[2]"] < 0)
