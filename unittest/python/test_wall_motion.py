# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Walls that move, turn and grow: what friction, the viscous term and the ledger see of their velocity."""

import numpy as np
import pytest
from test_wall_edges import LAW, RADIUS, STIFFNESS, start

from potdem import scripts
from potdem.text import replaced

HERTZ = "1e4 0.2 particle 1e4 0.2"
HEIGHT = 0.45
SHOW = scripts.result("fx[1]", "fy[1]", "fz[1]", "f_table")


def held(regions, place=(0.3, -0.2, HEIGHT), walls=f"fix table all potdem/wall/region table {HERTZ} friction 0.5 0.01",
         step=1e-3):
    """a particle that does not move, in contact with walls that do"""
    return start(regions, place, f"timestep {step}\nfix hold all move linear 0 0 0 units box\n{walls}\n")


def force(run_lammps, script):
    return scripts.results(run_lammps(script).stdout)


def normal_force(run_lammps, height=HEIGHT):
    return force(run_lammps, held("region table plane 0 0 0 0 0 1") + "run 0\n" + SHOW)[0][2]


BELT = "variable way equal 0.7*time\nregion belt plane 0 0 0 0 0 1 move v_way NULL NULL units box\n"


@pytest.mark.parametrize("regions", [
    BELT + "region side plane -9 0 0 1 0 0 units box\nregion table intersect 2 belt side",
    BELT + "region side plane -9 0 0 1 0 0 units box\nregion table intersect 2 side belt",
    BELT + "region hole block 5 6 -9 9 -9 0 units box\nregion table union 2 hole belt",
    # what a union leaves out
    replaced(BELT, "0 0 1 move", "0 0 -1 move") + "region lump sphere 9 9 0 1 units box\n"
    "region table union 2 lump belt side out",
    BELT + "region far plane -9 0 0 1 0 0 units box\nregion near plane 0 0 -3 0 0 1 units box\n"
    "region room intersect 2 near far\nregion table intersect 2 room belt"])
def test_part_of_a_union_or_intersection_moves(run_lammps, regions):
    """friction is that of the part that is touched: eta times 0.7"""
    rows = force(run_lammps, held(regions) + "run 2\n" + SHOW)
    assert rows[0][:3] == pytest.approx([0.01 * 0.7, 0, normal_force(run_lammps)], rel=1e-9, abs=1e-12)


@pytest.mark.parametrize("axis", ["0 0 1", "0 0 3"])
@pytest.mark.parametrize("regions", ["", "region side plane -9 0 0 1 0 0 units box\n"
                                     "region table intersect 2 disc side"])
def test_a_turntable(run_lammps, axis, regions):
    """the surface moves with omega x foot, whatever the length of the axis; in an intersection, too"""
    omega = 0.9
    name = "disc" if regions else "table"
    regions = (f"variable turn equal {omega}*time\nregion {name} plane 0 0 0 0 0 1 rotate v_turn 0.1 0.1 0 {axis} "
               f"units box\n{regions}")
    rows = force(run_lammps, held(regions) + "run 2\n" + SHOW)
    expected = 0.01 * np.cross([0, 0, omega], [0.2, -0.3, 0])
    assert rows[0][:2] == pytest.approx(expected[:2], rel=1e-9)


def test_a_cylinder_that_grows(run_lammps):
    """the wall recedes with dR/dt: the viscous term is that of a particle that leaves"""
    H, rate = 0.05, 0.3
    regions = f"variable radius equal 3+{rate}*time\nregion table cylinder y 0.3 {3 - HEIGHT} v_radius INF INF units box"
    walls = f"fix table all potdem/wall/region table {HERTZ} "
    place = (0.3, -0.2, 0.0)
    with_, without = (force(run_lammps, held(regions, place, walls + more) + "run 2\n" + SHOW)[0][2]
                      for more in (f"viscous {H}", ""))
    distance = HEIGHT + 2e-3 * rate
    assert without > 0
    # a difference over one step of 1e-3: the growth itself, to rounding
    assert with_ == pytest.approx(without * (1 - H * rate / (1.1 * RADIUS - distance)), rel=1e-9)


def slider(velocity):
    """a grain on a belt whose speed is not that of the grain"""
    return start(replaced(BELT, "belt", "table"), (0.3, -0.2, HEIGHT), f"""
fix move all nve
fix weight all gravity 9.81 vector 0 0 -1
fix table all potdem/wall/region table {HERTZ} friction 0.3 auto
set atom 1 vx {velocity}
timestep 1e-3
""")


def test_a_run_in_pieces_feels_the_same_belt(run_lammps):
    """the set-up of a further run has no step to measure the speed of the wall by: it is that of the step before. (Not so the
    velocity of the grain, so that this holds while friction is Coulomb's.)"""
    show = scripts.result("x[1]", "vx[1]", "x[1]", "z[1]", "vz[1]")
    whole, pieces = (force(run_lammps, slider(0.1) + run + show)[0] for run in ("run 60\n", 6 * "run 10\n"))
    assert pieces == pytest.approx(whole, rel=1e-13)
    assert 0.1 < whole[1] < 0.7    # still being carried along


def test_after_a_restart_a_wall_counts_as_at_rest_for_an_instant(run_lammps):
    """far from its starting place; not as if it had come from there within one step, which the viscous term would
    multiply to a blow"""
    regions = ("variable way equal 0.7*time\nregion table plane 0 0 -7 0 0 1 move NULL NULL v_way units box")
    script = held(regions, walls=f"fix table all potdem/wall/region table {HERTZ} viscous 0.05\nreset_timestep 10000")
    first, next_ = force(run_lammps, script + "run 0\n" + SHOW + "run 1\n" + SHOW)
    rest = normal_force(run_lammps)
    assert first[2] == pytest.approx(rest, rel=1e-9)
    height = HEIGHT - 0.7e-3
    assert next_[2] > rest * (1 + 0.05 * 0.7 / (1.1 * RADIUS - height))


def test_a_paddle_passes_a_particle(run_lammps):
    """a bar turns and sweeps past a particle that is held: the force has no jump, and the work of the wall is the energy
    of the contact, to first order in the step (the velocity is that of the step before)"""
    place, omega, step, steps = (1.5, 0.3, 0.0), 0.4, 2e-3, 3500
    regions = f"variable turn equal {omega}*time\nregion table block -0.2 0.2 -1.2 1.2 -2 2 side out " \
              "rotate v_turn 0 0 0 0 0 2 units box"
    script = held(regions, place, f"fix table all potdem/wall/region table {LAW}\ncompute ledger all potdem/energy",
                  step) + f"""
thermo_style custom step f_table f_table[1] f_table[2] f_table[3] f_table[6] c_ledger[10]
thermo_modify format float {scripts.ALL_DIGITS}
run {steps}
"""
    thermo = run_lammps(script).thermo
    forces = scripts.vectors(thermo, "f_table[1]", "f_table[2]", "f_table[3]")
    way = omega * np.linalg.norm(place) * step    # of the surface, at most
    assert np.linalg.norm(forces, axis=1).max() > 0.1 * STIFFNESS * RADIUS
    assert forces[0] == pytest.approx(0) and forces[-1] == pytest.approx(0)
    # plus the turning of the normal with the bar
    bound = STIFFNESS * way + np.linalg.norm(forces, axis=1).max() * omega * step
    assert np.linalg.norm(np.diff(forces, axis=0), axis=1).max() < 1.01 * bound
    assert np.abs(thermo["c_ledger[10]"] - thermo["f_table"]).max() < 0.5 * np.linalg.norm(forces, axis=1).max() * way
    # and the work is that of the torque on the bar
    turned = -np.cumsum(thermo["f_table[6]"]) * omega * step
    assert turned[-1] == pytest.approx(0, abs=2e-3 * thermo["f_table"].max())


def test_across_a_periodic_boundary(run_lammps):
    """a floor as long as the box: between two neighbour lists a particle is beyond the boundary, and on the floor"""
    for floor in ("block -5 5 -5 5 0 9 open 1 open 2 open 3 open 4 open 6", "block -5 5 INF INF 0 20"):
        script = replaced(scripts.box((10, 40, 40), "p f f"), "neighbor 0.3", "neighbor 2.0") + scripts.particles(
            [(4.0, 0, HEIGHT, 2 * RADIUS)]) + f"""
neigh_modify delay 1000 every 1000 check no
pair_style none
bond_style none
comm_modify cutoff 3.0
region floor {floor} units box
fix floor all potdem/wall/region floor {LAW}
fix go all move linear 1 0 0 units box
timestep 1e-3
thermo 50
variable x equal x[1]
thermo_style custom step v_x f_floor[1] f_floor[2] f_floor[3]
thermo_modify format float {scripts.ALL_DIGITS}
run 2000
"""
        if "open" not in floor:    # the ends are walls, where the wall is not open
            script = replaced(script, "run 2000", "run 300")
        thermo = run_lammps(script).thermo
        assert np.ptp(thermo["f_floor[3]"]) < 1e-10 * abs(thermo["f_floor[3]"][0])
        assert np.abs(thermo["f_floor[1]"]).max() < 1e-10
