# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Walls that move, and walls of several parts, with springs that remember (friction mu spring ratio, rolling, twisting): belts,
turntables, drums and seams. The truss law, so that the normal force and its stiffness are known by hand:

    F = A E (1 - x^2)/2,  K = A E x/R,  x = z/R,  A = pi/4 R^2        z: distance of the centre, R: radius"""

import numpy as np
import pytest
from test_friction_springs import E, G, MASS, RADIUS, RATIO, SECTION, depth_at_rest

from potdem import scripts

MU, MU_ROLL = 0.3, 0.05
SPRING = f"{MU} spring {RATIO} damping 0.5"
ROLLS = f"{SPRING} rolling {MU_ROLL} 0.1 0.5"
DT = 5e-5


def stiffness(z):
    """of the spring of friction"""
    return RATIO * E * SECTION * z / RADIUS**2


def on_wall(region, place, words, rotation="no", gravity="0 0 -1", more=""):
    script = scripts.box(40) + scripts.particles([(*place, 2 * RADIUS)])
    script += f"set group all mass {MASS}\npair_style zero 1.0\npair_coeff * *\n{region}\n"
    script += f"fix move all {'nve/sphere' if rotation == 'yes' else 'nve'}\nfix weight all gravity {G} vector {gravity}\n{more}\n"
    script += f"fix wall all potdem/wall/region wall law truss {E} 1.0 rotation {rotation} friction {words}\n"
    script += f"timestep {DT}\nthermo 200\nthermo_modify format float {scripts.ALL_DIGITS}\n"
    return script


# --- a belt -------------------------------------------------------------------------------------------------------------------

SPEED = 0.7
BELT = f"variable way equal {SPEED}*time\nregion wall plane 0 0 0 0 0 1 move v_way NULL NULL units box"
LEDGER = "compute ledger all potdem/energy\nvariable v equal vx[1]\ncompute w all property/atom omegay\n" \
         "variable w equal C_w[1]\nthermo_style custom step v_v c_ledger c_ledger[1] c_ledger[7] c_ledger[10] c_ledger[11]"


def test_a_belt_takes_a_grain_along(run_lammps):
    """v = mu g t while it slides, then the speed of the belt, which has worked the impulse times its speed: m u^2, half of it heat"""
    script = on_wall(BELT, (0, 0, depth_at_rest(MASS * G)), SPRING, more=LEDGER)
    thermo = run_lammps(script + "run 16000\n").thermo
    time, v = thermo["Step"] * DT, thermo["v_v"]
    slides = (time > 0.1 * SPEED / (MU * G)) & (time < 0.95 * SPEED / (MU * G))
    # exact from when the spring is at its limit
    assert np.diff(v[slides]) / np.diff(time[slides]) == pytest.approx(MU * G, rel=1e-9)
    # it swings in, with 0.5 of critical damping, for 0.5 s
    assert v[-1] == pytest.approx(SPEED, rel=1e-12)
    work, heat = MASS * SPEED**2, 0.5 * MASS * SPEED**2
    # the impulse of a sum over steps is exact; at the first instant the wall counts as at rest, where the spring is not yet strained
    assert thermo["c_ledger[10]"][-1] == pytest.approx(work, rel=1e-9)
    # trapezoidal rule, where the spring sticks
    assert thermo["c_ledger[7]"][-1] == pytest.approx(heat, rel=1e-4)
    assert np.ptp(thermo["c_ledger"]) < 1e-4 * heat
    assert thermo["c_ledger[11]"].max() == pytest.approx(0.5 * (MU * MASS * G)**2 / stiffness(depth_at_rest(MASS * G)), rel=1e-9)
    assert thermo["c_ledger[11]"][-1] < 1e-20


def test_a_sphere_that_rolls_on_a_belt_is_carried_along_in_the_end(run_lammps):
    """it slides, rolls backwards over the belt, and is slowed down by its rolling resistance until it stands on it: the belt has
    worked m u^2, half of it is heat, of sliding and of rolling, whatever the coefficients"""
    script = on_wall(BELT, (-4, 0, depth_at_rest(MASS * G)), ROLLS, "yes", more=LEDGER)
    run = run_lammps(script + "run 80000\n" + scripts.result("vx[1]", "v_w"))
    thermo, (v, w) = run.thermo, scripts.results(run.stdout)[0]
    # rolling and the sliding springs have swung in for a second
    assert v == pytest.approx(SPEED, rel=1e-6) and abs(w) < 1e-6 * SPEED / RADIUS
    assert thermo["c_ledger[10]"][-1] == pytest.approx(MASS * SPEED**2, rel=1e-6)
    assert thermo["c_ledger[7]"][-1] == pytest.approx(0.5 * MASS * SPEED**2, rel=2e-4)
    assert np.ptp(thermo["c_ledger"]) < 2e-4 * MASS * SPEED**2


# --- a turntable --------------------------------------------------------------------------------------------------------------

OMEGA, TURN = 2.0, 2 * np.pi / 2.0
TABLE = f"variable turn equal {OMEGA}*time\nregion wall plane 0 0 0 0 0 1 rotate v_turn 0 0 0 0 0 1 units box"


def on_table(radius, more=""):
    return on_wall(TABLE, (radius, 0, depth_at_rest(MASS * G)), SPRING, more=f"set atom 1 vy {OMEGA * radius}\n{more}")


def test_a_turntable_carries_a_grain_at_rest_on_it(run_lammps):
    """omega^2 r < mu g. The spring is strained by m omega^2 r, which turns with the table: in five turns the grain has settled at
    (k r - m omega^2 r = 0 from where it started) and does not creep, neither outwards nor against the table"""
    radius, turns = 0.5, 5
    show = scripts.result("x[1]", "y[1]", "time")
    script = on_table(radius) + f"run {round(TURN / DT)}\n{show}" * (turns + 1)
    found = scripts.results(run_lammps(script).stdout)
    distance, angle = np.hypot(found[:, 0], found[:, 1]), np.arctan2(found[:, 1], found[:, 0]) - OMEGA * found[:, 2]
    angle = (angle + np.pi) % (2 * np.pi) - np.pi
    k = stiffness(depth_at_rest(MASS * G))
    assert distance == pytest.approx(radius / (1 - MASS * OMEGA**2 / k), rel=1e-6)
    # in its first swings it lags a little: m omega^2/k of a radian at most; then it stays to rounding of 3e5 steps
    assert np.abs(angle).max() < MASS * OMEGA**2 / k
    assert np.ptp(angle) < 1e-6 and np.ptp(distance) < 1e-6 * radius


def test_a_grain_too_far_out_leaves_the_turntable(run_lammps):
    """omega^2 r > mu g"""
    radius = 0.8
    script = on_table(radius) + f"run {round(TURN / DT)}\n" + scripts.result("x[1]", "y[1]")
    assert np.hypot(*scripts.results(run_lammps(script).stdout)[0]) > 1.5 * radius


# --- a drum -------------------------------------------------------------------------------------------------------------------

INNER, SPIN = 3.0, 0.4


def in_drum(words, rotation, more=""):
    """from its lowest point; a drag that vanishes at rest lets it come to rest"""
    z = depth_at_rest(MASS * G)
    drum = f"variable turn equal {SPIN}*time\nregion wall cylinder y 0 0 {INNER} INF INF units box rotate v_turn 0 0 0 0 1 0"
    script = on_wall(drum, (0, 0, z - INNER), words, rotation, more=f"fix drag all viscous 1.0\n{more}")
    show = scripts.result("x[1]", "z[1]", "vx[1]", "vz[1]", "fx[1]")
    return script + f"run {round(25.0 / DT)}\n" + show + f"run {round(2.0 / DT)}\n" + show


def height(found):
    """angle from the lowest point, to the side to which the wall moves there: omega x foot is towards -x"""
    return np.arctan2(-found[0], -found[1])


def test_a_grain_in_a_drum_stays_at_the_angle_of_friction(run_lammps):
    """the wall slides under it: m g sin(angle) = mu m g cos(angle)"""
    first, last = scripts.results(run_lammps(in_drum(SPRING, "no")).stdout)
    for found in (first, last):
        # by the drag swings die as exp(-t/2), and 25 s are 4e-6
        assert height(found) == pytest.approx(np.arctan(MU), rel=1e-5)
        assert np.hypot(*found[2:4]) < 1e-5


def test_a_sphere_in_a_drum_rolls_at_the_angle_of_its_rolling_resistance(run_lammps):
    """its centre at rest and its spin steady: friction T holds the weight, T = m g sin(angle), and turns it by T z against the torque
    mu_r N R with N = m g cos(angle): tan(angle) = mu_r R/z. Without the resistance it would roll at the lowest point"""
    for words, factor in ((ROLLS, MU_ROLL), (SPRING, 0.0)):
        _, found = scripts.results(run_lammps(in_drum(words, "yes")).stdout)
        angle = height(found)
        z = INNER - np.hypot(found[0], found[1])
        # swings die as exp(-t/2.8), for the spin has inertia too: 27 s are 7e-5
        assert np.tan(angle) == pytest.approx(factor * RADIUS / z, rel=2e-3, abs=1e-4)
        assert np.hypot(*found[2:4]) < 1e-3


# --- seams --------------------------------------------------------------------------------------------------------------------

HEIGHT = 0.45
SEAMS = {
    "intersect": "region a block -5 0 -5 5 -5 0 side out units box\nregion b block 0 5 -5 5 -5 0 side out units box\n"
                 "region wall intersect 2 a b",
    "other order": "region a block -5 0 -5 5 -5 0 side out units box\nregion b block 0 5 -5 5 -5 0 side out units box\n"
                   "region wall intersect 2 b a",
    "what a union leaves out": "region a block -5 0 -5 5 -5 0 units box\nregion b block 0 5 -5 5 -5 0 units box\n"
                               "region wall union 2 a b side out"}
STICKS = f"50 spring {RATIO}"
CRAWL, STEP, WAY = 0.1, 1e-3, 0.2    # a grain is dragged over the seam at x = 0


def dragged(seam, start, words=STICKS, rotation="no", more=""):
    script = scripts.box(40) + scripts.particles([(start, 0.3, HEIGHT, 2 * RADIUS)])
    script += f"set group all mass {MASS}\npair_style zero 1.0\npair_coeff * *\n{more}"
    return script + wall_of(seam, words, rotation)


def wall_of(seam, words=STICKS, rotation="no"):
    return f"{SEAMS[seam]}\nfix wall all potdem/wall/region wall law truss {E} 1.0 rotation {rotation} friction {words}\n" \
           f"fix drag all move linear {CRAWL} 0 0 units box\ntimestep {STEP}\nthermo_modify format float {scripts.ALL_DIGITS}\n"


SHOW = scripts.result("fx[1]", "fy[1]", "fz[1]", "x[1]")


@pytest.mark.parametrize("start", [-0.1, -0.09997])
@pytest.mark.parametrize("seam", SEAMS)
def test_a_seam_of_flush_parts_is_not_felt(run_lammps, seam, start):
    """T = -k times the whole displacement on either side, also where a step ends on the seam itself"""
    script = dragged(seam, start) + f"run 100\n{SHOW}" * 20
    found = scripts.results(run_lammps(script).stdout)
    way = CRAWL * STEP * 100 * np.arange(1, 21)
    assert found[:, 3] == pytest.approx(start + way, abs=1e-12)
    # the sum of the steps of a dashpot-free spring is exact to rounding
    assert found[:, 0] == pytest.approx(-stiffness(HEIGHT) * way, rel=1e-9)
    assert found[:, 1] == pytest.approx(0.0, abs=1e-9)
    assert found[:, 2] == pytest.approx(0.5 * SECTION * E * (1 - (HEIGHT / RADIUS)**2), rel=1e-9)


def test_nor_does_rolling_feel_it(run_lammps):
    """torque -R^2 k_r w t of a sphere that turns by a little while it is carried over"""
    words, spin = "0 spring 0.8 rolling 50 0.1 0", 0.05
    script = dragged("intersect", -0.1, words, "yes", f"set atom 1 omega 0 {spin} 0\n")
    script += "compute t all property/atom tqx tqy tqz\nthermo_style custom step f_wall\n"
    script += ("run 100\n" + scripts.result("C_t[1][2]")) * 20
    found = scripts.results(run_lammps(script).stdout)[:, 0]
    k = 0.1 * E * SECTION * HEIGHT / RADIUS**2
    assert found == pytest.approx(-RADIUS**2 * k * spin * STEP * 100 * np.arange(1, 21), rel=1e-9)


def test_what_leaves_the_wall_forgets(run_lammps):
    """over the seam, away, and back: from nothing"""
    lift = "unfix drag\ndisplace_atoms all move 0 0 1\nrun 1\ndisplace_atoms all move 0 0 -1\n"
    script = dragged("intersect", -0.1) + f"run 1500\n{SHOW}" + lift
    script += f"fix drag all move linear {CRAWL} 0 0 units box\nrun 100\n{SHOW}"
    before, after = scripts.results(run_lammps(script).stdout)
    assert before[0] == pytest.approx(-stiffness(HEIGHT) * CRAWL * STEP * 1500, rel=1e-9)
    assert after[0] == pytest.approx(-stiffness(HEIGHT) * CRAWL * STEP * 100, rel=1e-9)


@pytest.mark.parametrize("steps", [700, 1000, 1300])
@pytest.mark.parametrize("seam", SEAMS)
def test_a_restart_before_on_and_behind_the_seam(run_lammps, seam, steps):
    script = dragged(seam, -0.1) + f"run {steps}\nwrite_restart half.restart\nclear\nread_restart half.restart\n"
    script += "pair_style zero 1.0\npair_coeff * *\n" + wall_of(seam) + f"run 0\n{SHOW}run {2000 - steps}\n{SHOW}"
    read, last = scripts.results(run_lammps(script).stdout)
    assert read[0] == pytest.approx(-stiffness(HEIGHT) * CRAWL * STEP * steps, rel=1e-9)
    assert last[0] == pytest.approx(-stiffness(HEIGHT) * CRAWL * STEP * 2000, rel=1e-9)
