# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""fix potdem/wall/region with `rotation`: spheres that slide, roll and spin on walls."""

import math

import numpy as np
import pytest

from potdem import formulas, scripts

G, RADIUS, DENSITY = 10.0, 0.5, 2.0
MASS = formulas.sphere_mass(2 * RADIUS, DENSITY)


def modulus(weight):
    """of the contact, so that the weight presses a sphere by just the layer of 0.1 r: its centre is one radius above
    the wall, and the formulas of a rigid sphere hold to rounding"""
    return weight / (4 / 3 * math.sqrt(RADIUS) * (0.1 * RADIUS) ** 1.5)


def plane(tilt, friction, step, steps, speed=0.0, spin=0.0, region="plane 0 0 0 0 0 1", columns="", more=""):
    """a sphere in equilibrium on the plane z = 0, gravity tilted about y towards +x; rolling along +x is spin > 0"""
    E = 2 * modulus(MASS * G * math.cos(tilt))
    return scripts.box(200) + scripts.particles([(0, 0, RADIUS, 2 * RADIUS)], DENSITY) + f"""
set atom 1 vx {speed:.17g}
set atom 1 omega 0 {spin:.17g} 0
pair_style none
bond_style none
comm_modify cutoff 2.0
variable turn equal 0.9*time
region floor {region} units box
fix move all nve/sphere
fix weight all gravity {G} vector {math.sin(tilt):.17g} 0 {-math.cos(tilt):.17g}
fix floor all potdem/wall/region floor {E:.17g} 0 particle {E:.17g} 0 friction {friction} rotation yes
compute ledger all potdem/energy
compute w all property/atom omegay
variable x equal x[1]
variable v equal vx[1]
variable u equal vy[1]
variable w equal C_w[1]
{more}
timestep {step:.17g}
thermo 1
thermo_style custom step v_x v_v v_u v_w c_ledger c_ledger[1] c_ledger[7] f_floor[1] f_floor[3] {columns}
thermo_modify format float {scripts.ALL_DIGITS}
run {steps}
"""


@pytest.mark.parametrize("mu", [0.05, 0.2, 0.6])
def test_sliding_into_rolling(run_lammps, mu):
    """a solid sphere that slides at first rolls from the time 2 v/(7 mu g) on, at 5/7 of its speed whatever mu is, and
    2/7 of its energy have become heat"""
    speed, step = 2.0, 1e-3
    time = 2 * speed / (7 * mu * G)
    thermo = run_lammps(plane(0, f"{mu} auto", step, round(1.2 * time / step), speed)).thermo
    t, v, spin = thermo["Step"] * step, thermo["v_v"], thermo["v_w"]
    assert v[-1] == pytest.approx(5 / 7 * speed, rel=1e-12)
    assert spin[-1] * RADIUS == pytest.approx(v[-1], rel=1e-12)
    slides = t < time - step
    assert v[slides] == pytest.approx(speed - mu * G * t[slides], rel=1e-12)
    assert spin[slides] == pytest.approx(2.5 * mu * G * t[slides] / RADIUS, rel=1e-12, abs=1e-14)
    assert np.all(np.abs(v[t > time + step] - v[-1]) < 1e-12)
    # the trapezoidal rule of the ledger does not see where in a step the sliding ends: mu m g times the slip of a step
    heat = 0.5 * MASS * speed**2 * 2 / 7
    assert thermo["c_ledger[7]"][-1] == pytest.approx(heat, abs=mu * MASS * G * 3.5 * mu * G * step**2)
    assert np.ptp(thermo["c_ledger"]) < mu * MASS * G * 3.5 * mu * G * step**2


def test_a_given_viscosity_leads_to_rolling_too(run_lammps):
    """eta |u| < mu N at the end: the slip decays at the rate eta over 2/7 m, to 1e-12 of itself in this run"""
    speed, mu, eta = 2.0, 0.2, 20.0
    thermo = run_lammps(plane(0, f"{mu} {eta}", 1e-3, 1000, speed)).thermo
    assert thermo["v_v"][-1] == pytest.approx(5 / 7 * speed, rel=1e-11)
    slip = thermo["v_v"] - RADIUS * thermo["v_w"]
    late = (slip < 1e-2 * mu * MASS * G / eta) & (slip > 1e-6)
    rate = -np.polyfit(thermo["Step"][late] * 1e-3, np.log(slip[late]), 1)[0]
    # of the difference equation, whose factor per step is 1 - 3.5 eta dt/m
    assert rate == pytest.approx(-math.log(1 - 3.5 * eta * 1e-3 / MASS) / 1e-3, rel=1e-6)


@pytest.mark.parametrize("mu, slips", [(0.17, False), (0.5, False), (0.16, True), (0.05, True)])
def test_down_an_incline(run_lammps, mu, slips):
    """at 30 degrees a solid sphere rolls where mu > 2/7 tan(theta) = 0.165, with 5/7 g sin(theta)"""
    tilt, step, steps = math.radians(30), 1e-3, 1000
    thermo = run_lammps(plane(tilt, f"{mu} auto", step, steps)).thermo
    time = steps * step
    friction = mu * math.cos(tilt) if slips else 2 / 7 * math.sin(tilt)
    assert thermo["v_v"][-1] == pytest.approx(G * (math.sin(tilt) - friction) * time, rel=1e-12)
    assert thermo["v_w"][-1] == pytest.approx(2.5 * G * friction / RADIUS * time, rel=1e-12)
    assert thermo["f_floor[1]"][-1] == pytest.approx(MASS * G * friction, rel=1e-9)
    assert np.ptp(thermo["c_ledger"]) < 1e-11 * thermo["c_ledger[1]"][-1]
    assert (thermo["c_ledger[7]"][-1] > 1e-3) == slips
    if not slips:
        assert abs(thermo["c_ledger[7]"][-1]) < 1e-12


def test_on_a_turntable(run_lammps):
    """a sphere that rolls on a turning table goes round on a circle, 2/7 as fast as the table: v' = 2/7 Omega x v"""
    step, steps = 1e-3, 4000
    thermo = run_lammps(plane(0, "1.0 auto", step, steps, 1.0, 1.0 / RADIUS,
                              "plane 0 0 0 0 0 1 rotate v_turn 0 0 0 0 0 2")).thermo
    angle = np.unwrap(np.arctan2(thermo["v_u"], thermo["v_v"]))
    # the speed of the table is that of half a step before: a slip of a rad/s x half a step
    assert (angle[-1] - angle[10]) / ((steps - 10) * step) == pytest.approx(2 / 7 * 0.9, rel=1e-5)
    assert np.hypot(thermo["v_u"], thermo["v_v"])[[10, -1]] == pytest.approx(1.0, rel=2e-3)
    assert np.ptp(thermo["c_ledger"]) < 1e-5 * thermo["c_ledger[1]"][0]


def test_rolling_in_a_bowl(run_lammps):
    """small oscillations of a rolling sphere in a spherical bowl: period 2 pi sqrt(7 (R - r)/(5 g))"""
    bowl, step = 5.0, 1e-3
    period = 2 * math.pi * math.sqrt(7 * (bowl - RADIUS) / (5 * G))
    amplitude = 0.02
    script = plane(0, "1.0 auto", step, round(1.3 * period / step), 0.0, 0.0, f"sphere 0 0 {bowl} {bowl}", "f_floor",
                   f"set atom 1 x {amplitude * (bowl - RADIUS)}\n"
                   f"set atom 1 z {bowl - (bowl - RADIUS) * math.sqrt(1 - amplitude**2):.17g}")
    thermo = run_lammps(script).thermo
    v = thermo["v_v"]
    turns = np.flatnonzero((v[:-1] < 0) & (v[1:] >= 0))    # half a period, then every period
    k = turns[0]
    half = step * (thermo["Step"][k] - v[k] / (v[k + 1] - v[k]))
    # a pendulum: longer by amplitude^2/16; and the swing of the load on the contact, of amplitude^2, too
    assert half == pytest.approx(0.5 * period, rel=amplitude**2)


def instant(friction, velocity, spin, region, rotation="rotation yes", step=1e-4, place=(0.3, -0.2, 0.45)):
    """forces and torques of one instant, and the reaction"""
    script = scripts.box(200) + scripts.particles([(*place, 2 * RADIUS)], DENSITY) + f"""
pair_style none
bond_style none
velocity all set {velocity[0]} {velocity[1]} {velocity[2]}
set atom 1 omega {spin[0]} {spin[1]} {spin[2]}
{region}
timestep {step}
fix floor all potdem/wall/region floor 1e4 0.2 particle 1e4 0.2 layer none friction {friction} {rotation}
compute t all property/atom fx fy fz tqx tqy tqz
thermo_style custom step f_floor
run 0
"""
    return script + scripts.result(*(f"C_t[1][{k}]" for k in range(1, 7)), *(f"f_floor[{k}]" for k in range(1, 7)))


def push(distance):
    return 4 / 3 * 1e4 / (2 * (1 - 0.2**2)) * math.sqrt(RADIUS) * (RADIUS - distance) ** 1.5


V, SPIN = np.array([0.3, -0.4, -0.2]), np.array([1.0, 2.0, -3.0])
FLOOR = "region floor plane 0 0 0 0 0 1"


@pytest.mark.parametrize("eta", ["0.7", "1e5"])
def test_force_and_torque(run_lammps, eta):
    """friction is that of the velocity of the surface at the foot, and acts there"""
    row = scripts.results(run_lammps(instant(f"0.3 {eta}", V, SPIN, FLOOR)).stdout)[0]
    arm = np.array([0, 0, -0.45])
    slip = (V + np.cross(SPIN, arm)) * [1, 1, 0]
    size = min(float(eta) * np.linalg.norm(slip), 0.3 * push(0.45))
    drag = -size * slip / np.linalg.norm(slip)
    total = drag + [0, 0, push(0.45)]
    assert row[:3] == pytest.approx(total, rel=1e-12)
    assert row[3:6] == pytest.approx(np.cross(arm, drag), rel=1e-12, abs=1e-14)
    assert row[6:9] == pytest.approx(-total, rel=1e-12)
    assert row[9:] == pytest.approx(np.cross([0.3, -0.2, 0], -total), rel=1e-12)


def test_without_rotation_spin_does_not_matter(run_lammps):
    still, spinning, no = (scripts.results(run_lammps(instant("0.3 0.7", V, spin, FLOOR, word)).stdout)[0]
                           for spin, word in (((0, 0, 0), ""), (SPIN, ""), (SPIN, "rotation no")))
    assert np.array_equal(still, spinning) and np.array_equal(still, no)
    assert np.all(still[3:6] == 0)


def test_auto_on_two_faces(run_lammps):
    """with auto nothing slides on either face after the step, forces and torques balanced; one instant, explicit"""
    region = "region floor block -0.16 9 -9 9 0 9 units box"    # side at 0.46, floor at 0.45
    step = 1e-4
    row = scripts.results(run_lammps(instant("50 auto", 1e-3 * V, 1e-3 * SPIN, region, step=step)).stdout)[0]
    v, spin = 1e-3 * V + step * row[:3] / MASS, 1e-3 * SPIN + step * row[3:6] / (0.4 * MASS * RADIUS**2)
    for n, distance in (((1, 0, 0), 0.46), ((0, 0, 1), 0.45)):
        slip = np.cross(n, v - distance * np.cross(spin, n))
        assert np.abs(slip).max() < 1e-13
    assert row[4] != 0.0 and row[:3] != pytest.approx([push(0.46), 0, push(0.45)], rel=1e-3)


def test_at_rest_in_a_corner(run_lammps):
    """gravity presses it into a corner; friction on both faces lets it neither creep nor turn"""
    region = f"""region floor block 0 9 -9 9 0 9 units box
fix move all nve/sphere
fix weight all gravity {G} vector -0.3 0 -1"""
    script = instant("0.4 auto", (0, 0, 0), (0, 3, 0), region, "viscous 2e-2 rotation yes", place=(0.48, 0, 0.48))
    script += "compute w all property/atom omegay\nvariable w equal C_w[1]\n"
    show = scripts.result("x[1]", "z[1]", "v_w", "f_floor[1]", "f_floor[3]")
    script += "run 40000\nrun 0 post no\n" + show + "run 100000\nrun 0 post no\n" + show
    _, settled, end = (row for rows in scripts.results_by_length(run_lammps(script).stdout).values() for row in rows)
    assert np.abs(end[:2] - settled[:2]).max() < 1e-6 * 2 * RADIUS * 10    # 1e-6 d per second, 10 s
    assert abs(end[2]) < 1e-9
    weight = MASS * G * np.array([-0.3, -1]) / math.hypot(0.3, 1)
    assert end[3:] == pytest.approx(weight, rel=1e-9)
