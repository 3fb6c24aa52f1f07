# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""`friction mu auto` at walls: Coulomb friction that holds a grain at rest, checked on an incline and in a corner."""

import math

import pytest

G, DIAMETER, ANGLE = 9.81, 0.01, math.radians(20)


def grain(tilt, walls, mu, steps, more=""):
    """one grain that starts where its soft layer carries it about; gravity is tilted about y"""
    return f"""
units si
atom_style sphere
atom_modify map yes
boundary f f f
region box block -10 10 -10 10 -10 10
create_box 1 box
create_atoms 1 single 0.00495 0 0.00495 units box
set type 1 diameter {DIAMETER}
set type 1 density 2000
pair_style zero 0.02
pair_coeff * *
neighbor 0.3 bin
{walls}
fix move all nve
fix weight all gravity {G} vector {math.sin(tilt):.17g} 0 {-math.cos(tilt):.17g}
fix wall all potdem/wall/region walls 3e8 0.2 particle 3e6 0.2 friction {mu} auto viscous 1e-3
timestep 5e-5
thermo {steps // 10}
variable place equal x[1]
variable speed equal vx[1]
thermo_style custom step v_place v_speed f_wall[1] f_wall[3]
thermo_modify format float %.17g
{more}
run {steps}
"""


FLOOR = "region walls plane 0 0 0 0 0 1"
# the solid corner x < 0 or z < 0 is what the walls leave out
CORNER = "region floor plane 0 0 0 0 0 1\nregion side plane 0 0 0 1 0 0\nregion walls intersect 2 floor side"


def weight():
    return 2000 * math.pi / 6 * DIAMETER**3 * G


def test_a_grain_below_the_friction_angle_does_not_creep(run_lammps):
    """the issue asks for less than 1e-6 d per second; held within the step, it does not creep at all"""
    run = run_lammps(grain(ANGLE, FLOOR, 0.5, 100000))
    late = run.thermo["v_place"][2:]    # after 1 s, 4 s long
    assert abs(late[-1] - late[0]) < 1e-6 * DIAMETER * 4
    # the reaction is the whole weight: rounding
    assert run.thermo["f_wall[1]"][-1] == pytest.approx(weight() * math.sin(ANGLE), rel=1e-9)
    assert run.thermo["f_wall[3]"][-1] == pytest.approx(-weight() * math.cos(ANGLE), rel=1e-6)


def test_a_grain_above_the_friction_angle_slides_as_coulomb_says(run_lammps):
    mu = 0.3
    run = run_lammps(grain(ANGLE, FLOOR, mu, 40000))
    steps, speed = run.thermo["Step"], run.thermo["v_speed"]
    acceleration = (speed[-1] - speed[4]) / ((steps[-1] - steps[4]) * 5e-5)
    # exact once the bouncing of the start has died out
    assert acceleration == pytest.approx(G * (math.sin(ANGLE) - mu * math.cos(ANGLE)), rel=1e-6)


def test_a_sliding_grain_stops_after_the_coulomb_distance(run_lammps):
    mu, start = 0.4, 0.5
    run = run_lammps(grain(0.0, FLOOR, mu, 20000, f"run 20000\nset atom 1 vx {start}"))
    stopped = run.thermo["v_place"][-1] - run.thermo["v_place"][10]
    # one step's travel at the start, 2.5e-5 m
    assert stopped == pytest.approx(start**2 / (2 * mu * G), abs=start * 5e-5)
    assert abs(run.thermo["v_speed"][-1]) < 1e-15


def test_a_grain_rests_in_a_corner(run_lammps):
    """pushed into the corner by tilted gravity: at rest, and walls carry its weight"""
    run = run_lammps(grain(-ANGLE, CORNER, 0.1, 60000))
    late = run.thermo["v_place"][4:]
    assert max(late) - min(late) < 1e-6 * DIAMETER
    assert run.thermo["f_wall[1]"][-1] == pytest.approx(-weight() * math.sin(ANGLE), rel=1e-6)
    assert run.thermo["f_wall[3]"][-1] == pytest.approx(-weight() * math.cos(ANGLE), rel=1e-6)


def test_a_force_after_the_wall_is_refused(run_lammps):
    script = grain(ANGLE, FLOOR, 0.5, 10, "fix late all addforce 0 0 0")
    message = run_lammps(script, expect_error="").error
    for words in ("potdem/wall/region wall", "friction auto", "fix late (addforce)", "define fix wall last"):
        assert words in message, message
