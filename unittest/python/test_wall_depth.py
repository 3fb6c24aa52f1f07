# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""A particle too fast for the force that a wall has while its centre is in front of the surface: Hertz's force goes on behind
it. Depths and speeds are those of Hertz's impact, m v^2/2 = (8/15) Ebar sqrt(r) w^(5/2)."""

import math

import numpy as np
import pytest

from potdem import scripts
from potdem.text import replaced

RADIUS, MASS, MODULUS = 0.5, 1.0, 1000 / (2 * (1 - 0.2**2))
HERTZ = "1000 0.2 particle 1000 0.2 layer none"
# region whose surface is met at z = 0, from above
REGIONS = {
    "plane": "plane 0 0 0 0 0 1",
    "block": "block -3 3 -3 3 0 9",
    "obstacle": "block -3 3 -3 3 -4 0 side out",
    "thin obstacle": "block -3 3 -3 3 -0.92 0 side out",
    "hollow sphere": "sphere 0 0 4 4",
    "ball": "sphere 0 0 -4 4 side out",
    "hollow cylinder": "cylinder y 0 4 4 -9 9",
    "hollow cone": "cone z 0.5 0 6 6 0 9",    # off its axis, where LAMMPS knows no nearest place
}


def depth(speed):
    """largest overlap"""
    return (15 * MASS * speed**2 / (16 * MODULUS * math.sqrt(RADIUS))) ** 0.4


def speed_for(overlap):
    return math.sqrt(16 / 15 * MODULUS * math.sqrt(RADIUS) * overlap**2.5 / MASS)


def falling(speed, region=REGIONS["plane"], wall=HERTZ, height=0.51, steps=4000, more=""):
    return scripts.box(20) + scripts.particles([(0, 0, height, 2 * RADIUS)]) + f"""
set group all mass {MASS}
set group all vz {-speed}
pair_style zero 1.0
pair_coeff * *
region wall {region} units box
fix wall all potdem/wall/region wall {wall}
fix move all nve
{more}
variable z equal z[1]
variable vz equal vz[1]
timestep 1e-4
thermo 1
thermo_style custom step v_z v_vz
thermo_modify format float {scripts.ALL_DIGITS}
run {steps}
"""


@pytest.mark.parametrize("overlap", [0.8, 1.2, 1.9])    # over the radius
@pytest.mark.parametrize("region", REGIONS)
def test_it_is_turned_back_with_its_speed(run_lammps, region, overlap):
    speed = speed_for(overlap * RADIUS)
    table = run_lammps(falling(speed, REGIONS[region])).thermo
    assert RADIUS - table["v_z"].min() == pytest.approx(overlap * RADIUS, rel=1e-4)
    assert table["v_vz"][-1] == pytest.approx(speed, rel=1e-5)


def test_the_law_of_one_material_is_the_same(run_lammps):
    speed = speed_for(1.5 * RADIUS)
    tables = [run_lammps(falling(speed, wall=wall)).thermo for wall in (HERTZ, "law hertz 1000 0.2")]
    assert tables[0]["v_z"].min() < 0
    np.testing.assert_allclose(tables[1]["v_z"], tables[0]["v_z"], rtol=0, atol=1e-12)


def test_neighbour_lists_made_meanwhile_keep_it(run_lammps):
    speed = speed_for(1.5 * RADIUS)
    often = run_lammps(falling(speed, more="neigh_modify delay 0 every 1 check yes\nneighbor 0.001 bin")).thermo
    assert often["v_vz"][-1] == pytest.approx(speed, rel=1e-5)


def test_a_wall_that_moves(run_lammps):
    """a piston of infinite mass meets a particle at rest, which leaves with twice its speed"""
    speed = speed_for(1.3 * RADIUS)
    more = f"variable up equal {speed}*step*dt\nvariable rate equal {speed}"
    script = replaced(falling(0.0, more=""), "region wall plane 0 0 0 0 0 1 units box",
                      f"{more}\nregion wall plane 0 0 0 0 0 1 move NULL NULL v_up units box")
    table = run_lammps(script).thermo
    assert table["v_vz"][-1] == pytest.approx(2 * speed, rel=1e-4)


def test_the_critical_step_counts_it(run_lammps):
    """stiffness 2 Ebar sqrt(r w), eq. 5.25"""
    script = falling(0.0, height=-0.3 * RADIUS, steps=0, more="compute critical all potdem/timestep")
    table = run_lammps(replaced(script, "custom step", "custom step c_critical")).thermo
    stiffness = 2 * MODULUS * math.sqrt(RADIUS * 1.3 * RADIUS)
    assert table["c_critical"][0] == pytest.approx(2 / math.sqrt(stiffness / MASS), rel=1e-9)


def test_a_sphere_that_is_through_ends_the_run(run_lammps):
    run_lammps(falling(speed_for(2.1 * RADIUS)), expect_error="has passed the wall")


@pytest.mark.parametrize("wall", ["law truss 1000 0.4", "law dmt 1000 0.2 0.1"])
def test_other_laws_end_at_the_surface(run_lammps, wall):
    run_lammps(falling(50.0, wall=wall), expect_error="has passed the wall")


def test_regions_of_parts_end_at_the_surface(run_lammps):
    """which of the parts has been passed cannot be told"""
    parts = "region one plane 0 0 0 0 0 1 units box\nregion two plane -5 0 0 1 0 0 units box"
    script = replaced(falling(speed_for(1.5 * RADIUS), "intersect 2 one two"), "region wall", f"{parts}\nregion wall", 1)
    run_lammps(replaced(script, "one two units box", "one two"), expect_error="has passed the wall")


def test_a_centre_on_the_surface_ends_the_run(run_lammps):
    """the direction of the force is not known there"""
    run_lammps(falling(0.0, height=0.0), expect_error="has passed the wall")
