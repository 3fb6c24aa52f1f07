# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Two particles in motion against solutions of their equations of motion: collisions, sliding, rolling."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from potdem import dumps, scripts
from potdem.collisions import CONTACT, D1, D2, DENSITY, HERTZ, K, MASSES, REDUCED, duration, overlap_at_rest, setting
from potdem.pair_laws import Granular, Hertz, ShiftedLJ
from potdem.text import replaced

# --- Hertz without damping --------------------------------------------------------------------------------

def peak(values):
    """maximum of the parabola through the largest value and its neighbours"""
    k = int(np.argmax(values))
    a, b, c = values[k - 1:k + 2]
    return b + (a - c) ** 2 / (8 * (2 * b - a - c))


@pytest.mark.parametrize("speed", [0.01, 1.0, 10.0])
@pytest.mark.parametrize("start", [0.1, 0.5, 0.9])
def test_hertz_collision(run_lammps, speed, start):
    """duration and largest overlap to 0.1 %, hence the largest force to 0.15 %, at a tenth of the critical step,
    wherever within a step the contact begins. The critical step is 2/omega with omega^2 = 2 max(k/m) as the model
    bounds it; leapfrog shortens a period by (omega step)^2/24 of the pair's own omega"""
    w = overlap_at_rest(speed)
    omega = np.sqrt(2 * 1.5 * K * np.sqrt(w) / min(MASSES))
    step = 0.1 * 2 / omega
    gap = speed * step * (2 + start)
    script = setting(gap, speed, f"pair_style potdem/hertz\npair_coeff * * {HERTZ.coeff}\ntimestep {step:.17g}\n")
    script += f"run {int(1.5 * duration(speed) / step) + 5}\n"
    thermo = run_lammps(script).thermo
    r, u, force = thermo["v_r"], thermo["v_u"], thermo["v_f"]
    assert force[0] == force[-1] == 0.0
    assert u[-1] < 0.0
    # both ends of the contact from the free flights before and after
    begins = gap / speed
    ends = thermo["Step"][-1] * step - (r[-1] - CONTACT) / -u[-1]
    assert ends - begins == pytest.approx(duration(speed), rel=1e-3)
    assert peak(CONTACT - r) == pytest.approx(w, rel=1e-3)
    assert peak(force) == pytest.approx(K * w**1.5, rel=1.5e-3)    # overlap^1.5
    assert -u[-1] == pytest.approx(speed, rel=1e-3)


# --- Hertz with viscosity, eq. 5.17 -----------------------------------------------------------------------

def restitution(speed, H, attract):
    """m w'' = -K w^(3/2) - K H w^(1/2) w'. With w = q^2 and dt = q ds everything is a polynomial:
    q' = v/2, v' = -K/m q^2 (q^2 + H v). Ends where the force does: at q^2 + H v = 0, or where contact does, q = 0."""
    scale = np.sqrt(overlap_at_rest(speed))

    def motion(_, state):
        q, v = state
        return 0.5 * v, -K / REDUCED * q * q * (q * q + H * v)

    def contact(_, state):
        return state[0]

    def push(_, state):
        return state[0] ** 2 + H * state[1]

    end = contact if attract else push
    end.terminal, end.direction = True, -1
    # the first step leaves q = 0, where both functions vanish or nearly do
    first = solve_ivp(motion, (0, 1e-3 * scale / speed), (0.0, speed), "DOP853", rtol=1e-13, atol=1e-15 * speed)
    rest = solve_ivp(motion, (0, 1e4 * scale / speed), first.y[:, -1], "DOP853", events=end, rtol=1e-13,
                     atol=[1e-14 * scale, 1e-14 * speed])
    assert len(rest.t_events[0]) == 1
    return -rest.y_events[0][0][1] / speed


def test_the_reference_of_restitution():
    """1 without viscosity; with little of it the loss is the work of the viscous force along the elastic path,
    2 K H times the integral of w^(1/2) v dw"""
    assert restitution(2.0, 0.0, True) == pytest.approx(1.0, abs=1e-11)
    x, weights = np.polynomial.legendre.leggauss(80)
    q = 0.5 * (x + 1)    # w = w_max (1 - q^2) takes the root at rest out of the integrand
    speed, H = 2.0, 1e-9
    w = overlap_at_rest(speed)
    t = 1 - q**2
    work = 2 * K * H * speed * np.sum(0.5 * weights * np.sqrt(w * t) * np.sqrt(1 - t**2.5) * w * 2 * q)
    for attract in (False, True):
        loss = 1 - restitution(speed, H, attract)
        assert loss == pytest.approx(work / (REDUCED * speed**2), rel=1e-3)    # 1e-9/H of rounding, and H^2


@pytest.mark.parametrize("attract", [False, True])
@pytest.mark.parametrize("speed", [0.05, 0.5, 5.0])
def test_viscoelastic_restitution(run_lammps, speed, attract):
    """The force is taken with the velocity half a step back, so the error is of first order in the step: 0.3 % at
    1/500 of the duration, half of that at 1/1000, and gone in the extrapolation of the two"""
    H = 6e-4
    expected = restitution(speed, H, attract)
    assert 0.2 < expected < 0.95
    keyword = "attract yes" if attract else ""
    found = []
    for steps in (500, 1000):
        step = duration(speed) / steps
        pair = f"pair_style potdem/hertz {keyword}\npair_coeff * * {HERTZ.coeff} viscous {H}\ntimestep {step:.17g}\n"
        thermo = run_lammps(setting(0.37 * speed * step, speed, pair) + f"run {12 * steps}\n").thermo
        assert thermo["v_f"][-1] == 0.0 and thermo["v_r"][-1] > CONTACT
        assert (thermo["v_f"].min() < 0) == attract
        found.append(-thermo["v_u"][-1] / speed)
    assert found[1] == pytest.approx(expected, rel=2e-3)
    assert 2 * found[1] - found[0] == pytest.approx(expected, rel=1e-4)


def test_restitution_falls_with_the_speed():
    """what the law is for: slow collisions lose less"""
    e = [restitution(speed, 6e-4, False) for speed in (0.01, 0.1, 1.0, 10.0)]
    assert np.all(np.diff(e) < 0)


# --- granular and Lennard-Jones: energy -------------------------------------------------------------------

GRANULAR = Granular(1e4, 3.0, 0.2)
LJ = ShiftedLJ(1e4, 0.26, 3.0, 0.2)    # in equilibrium at contact: 0.8 x 1.3 + 0.26


@pytest.mark.parametrize("law", [GRANULAR, LJ], ids=["granular", "lj"])
def test_energy_of_a_smooth_encounter_is_second_order(run_lammps, law):
    """from contact inwards and back, within the cut: halving the step quarters the fluctuation (3.7 to 4.3 for
    terms of fourth order)"""
    period = 2 * np.pi * np.sqrt(REDUCED / law.K0)
    speed = 0.04 * law.alpha * CONTACT * 2 * np.pi / period
    fluctuation = []
    for n in (1, 2, 4):
        step = period / 100 / n
        pair = f"pair_style {law.style}\npair_modify shift yes\npair_coeff * * {law.coeff}\ntimestep {step:.17g}\n"
        thermo = run_lammps(setting(0.0, speed, pair) + f"run {50 * n}\n").thermo
        energy = thermo["TotEng"]
        assert np.ptp(thermo["KinEng"]) > 0.5 * thermo["KinEng"].max()
        fluctuation.append(np.abs(energy - energy[0]).max() / thermo["KinEng"].max())
    assert fluctuation[0] < 0.01
    assert fluctuation[0] / fluctuation[1] == pytest.approx(4, abs=0.3)
    assert fluctuation[1] / fluctuation[2] == pytest.approx(4, abs=0.3)


@pytest.mark.parametrize("law", [GRANULAR, LJ], ids=["granular", "lj"])
def test_energy_of_a_collision_through_the_cut(run_lammps, law):
    """from outside the cut and back. The force begins at the cut with a jump F, so that one step's way in it, F v dt
    on the way in and on the way out, is what may be lost or gained"""
    speed = 30.0
    period = 2 * np.pi * np.sqrt(REDUCED / law.K0)
    reach = (law.cut if law is LJ else law.cut * law.alpha * CONTACT) + (1 - law.alpha) * CONTACT
    jump = abs(law(reach * (1 - 1e-12), D1, D2)[1])
    assert jump > 0
    for n in (500, 2000):
        step = period / n
        pair = f"pair_style {law.style}\npair_modify shift yes\npair_coeff * * {law.coeff}\ntimestep {step:.17g}\n"
        steps = int(2.6 * (reach - CONTACT + 0.3) / speed / step)
        thermo = run_lammps(setting(reach - CONTACT + 0.01, speed, pair) + f"run {steps}\n").thermo
        assert thermo["v_f"][0] == thermo["v_f"][-1] == 0.0
        assert thermo["v_u"][-1] < 0.0
        assert thermo["KinEng"].min() < 0.5 * thermo["KinEng"][0]
        # Lennard-Jones makes the particles faster before they touch
        fastest = np.abs(thermo["v_u"]).max()
        error = abs(thermo["TotEng"][-1] - thermo["TotEng"][0])
        assert error < 2 * jump * fastest * step + 1e-12 * thermo["TotEng"][0]


# --- friction and rotation --------------------------------------------------------------------------------

STYLES = {
    "hertz": (HERTZ.style, HERTZ.coeff + " viscous 1e-3"),
    "granular": (GRANULAR.style, GRANULAR.coeff),
    "lj": (LJ.style, LJ.coeff),
    "truss": ("potdem/truss", "1e5 0.5"),
}


def oblique(name, rotation, steps=2000):
    """two spinning particles that hit each other off centre, in a box that they do not leave"""
    style, coeff = STYLES[name]
    script = scripts.box(40) + "bond_style none\n" + scripts.particles([(0, 0, 0, D1), (1.2, 0.6, 0.2, D2)], DENSITY)
    columns = "mass diameter x y z vx vy vz omegax omegay omegaz"
    return script + f"""
pair_style {style} rotation {rotation}
pair_coeff * * {coeff} friction 0.4 20.0
group one id 1
group two id 2
velocity one set 6.0 0.3 -0.2
velocity two set -3.0 0.2 0.5
set atom 1 omega 1.0 -7.0 3.0
set atom 2 omega 0.3 2.0 -5.0
fix move all nve/sphere
timestep 5e-5
thermo 100
thermo_style custom step pe ke etotal
run 0
""" + scripts.write_dump("a.dump", columns) + f"run {steps}\n" + scripts.write_dump(
        "b.dump", columns)


def momenta(path):
    """linear momentum, angular momentum with the spins, kinetic energy with that of the spins, spins"""
    table = dumps.read(path)[0]
    x, v, omega = (scripts.vectors(table, *(name + k for k in "xyz")) for name in ("", "v", "omega"))
    m = table["mass"][:, None]
    inertia = 0.1 * m * table["diameter"][:, None] ** 2
    return (m * v).sum(axis=0), (m * np.cross(x, v) + inertia * omega).sum(axis=0), 0.5 * float(
        (m * v**2 + inertia * omega**2).sum()), omega


@pytest.mark.parametrize("name", STYLES)
def test_rotation_conserves_both_momenta(run_lammps, tmp_path, name):
    """friction turns spin into motion and back; the sum stays, to rounding of 2000 steps"""
    potential = run_lammps(oblique(name, "yes")).thermo["PotEng"]
    (p0, l0, e0, spin0), (p1, l1, e1, spin1) = momenta(tmp_path / "a.dump"), momenta(tmp_path / "b.dump")
    size = sum(MASSES) * 6.0
    assert np.abs(spin1 - spin0).max() > 0.1
    assert e1 + potential[-1] < 0.999 * (e0 + potential[0])
    assert np.abs(p1 - p0).max() < 1e-12 * size
    assert np.abs(l1 - l0).max() < 1e-12 * size


@pytest.mark.parametrize("name", STYLES)
def test_without_rotation_spins_stay(run_lammps, tmp_path, name):
    """the option is off: spins neither change nor matter, and the linear momentum stays"""
    script = oblique(name, "no")
    run_lammps(script)
    (p0, l0, _, spin0), (p1, l1, _, spin1) = momenta(tmp_path / "a.dump"), momenta(tmp_path / "b.dump")
    with_spin = (tmp_path / "b.dump").read_text()
    assert np.array_equal(spin1, spin0)
    assert np.abs(p1 - p0).max() < 1e-12 * sum(MASSES) * 6.0
    assert np.abs(l1 - l0).max() > 1e-3    # 5.18 without rotation does not conserve it
    run_lammps(replaced(replaced(script, "set atom 1 omega 1.0 -7.0 3.0", ""), "set atom 2 omega 0.3 2.0 -5.0", ""))
    without = dumps.read(tmp_path / "b.dump")[0]
    (tmp_path / "c.dump").write_text(with_spin)
    spinning = dumps.read(tmp_path / "c.dump")[0]
    for column in ("x", "y", "z", "vx", "vy", "vz"):
        assert np.array_equal(without[column], spinning[column])


def test_torque_is_arm_times_friction(run_lammps, tmp_path):
    """one instant: the arms share the distance of the centres as the radii do"""
    r, eta = 1.25, 0.7
    spins = np.array([[1.0, -2.0, 0.5], [0.3, 0.8, -1.5]])
    v = np.array([[0.2, 0.4, -0.1], [-0.3, 0.1, 0.6]])
    script = scripts.box(40) + "bond_style none\n" + scripts.particles([(0, 0, 0, D1), (r, 0, 0, D2)], DENSITY)
    script += f"pair_style potdem/hertz rotation yes\npair_coeff * * {HERTZ.coeff} friction 0.5 {eta}\n"
    for k in (0, 1):
        script += f"group g{k} id {k + 1}\nvelocity g{k} set {v[k][0]} {v[k][1]} {v[k][2]}\n"
        script += f"set atom {k + 1} omega {spins[k][0]} {spins[k][1]} {spins[k][2]}\n"
    run_lammps(script + "run 0\n" + scripts.write_dump("f.dump", "fx fy fz tqx tqy tqz"))
    table = dumps.read(tmp_path / "f.dump")[0]
    force, torque = scripts.vectors(table, "fx", "fy", "fz"), scripts.vectors(table, "tqx", "tqy", "tqz")
    arms = np.array([[D1, 0, 0], [-D2, 0, 0]]) / (D1 + D2) * r    # from the centres to the contact
    surface = v + np.cross(spins, arms)
    slip = surface[0] - surface[1]
    slip[0] = 0.0
    push = HERTZ(r, D1, D2)[1]
    assert eta * np.linalg.norm(slip) < 0.5 * push
    drag = -eta * slip
    assert force[0] == pytest.approx(drag - [push, 0, 0], rel=1e-12)
    assert force[1] == pytest.approx(-force[0], rel=0, abs=0)
    assert torque[0] == pytest.approx(np.cross(arms[0], drag), rel=1e-12, abs=1e-13)
    assert torque[1] == pytest.approx(np.cross(arms[1], -drag), rel=1e-12, abs=1e-13)


G, MU = 10.0, 0.3
GROUND = 2e5    # diameter of the sphere that is the ground


def on_ground(pair, speed, step, steps, more="", move="nve"):
    """a particle in equilibrium on a large sphere that does not move, sliding along x"""
    law = Hertz(1e7, 0.3)
    weight = MASSES[0] * G
    overlap = (weight / law.prefactor(D1, GROUND)) ** (2 / 3)
    script = replaced(scripts.box((40, 40, 500000)), "0.3 bin", "0.1 nsq") + "bond_style none\n"
    script += scripts.particles([(0, 0, 0.5 * D1 - overlap, D1), (0, 0, -0.5 * GROUND, GROUND)], DENSITY)
    return script + f"""
pair_style {law.style} {pair}
pair_coeff * * {law.coeff} friction {MU} {more}
group one id 1
velocity all set 0 0 0
velocity one set {speed} 0 0
fix weight one gravity {G} vector 0 0 -1
fix move one {move}
timestep {step:.17g}
variable x equal x[1]
variable v equal vx[1]
variable wy equal C_w[1][2]
compute w all property/atom omegax omegay omegaz
thermo {steps // 200}
thermo_style custom step v_x v_v v_wy
thermo_modify format float {scripts.ALL_DIGITS}
run {steps}
"""


@pytest.mark.parametrize("eta", ["auto", "2e4"])
def test_sliding_to_rest(run_lammps, eta):
    """a particle on the ground stops after v^2/(2 mu g). The ground is a sphere of radius 1e5, so that the slope on
    the way is below 1e-5; with eta the last mu m g/eta of the velocity decays slower (1e-4 of v)"""
    speed, step = 2.0, 2e-5
    way = speed**2 / (2 * MU * G)
    steps = int(1.3 * speed / (MU * G) / step)
    thermo = run_lammps(on_ground("", speed, step, steps, eta)).thermo
    assert thermo["v_x"][-1] == pytest.approx(way, rel=5e-4)
    # at rest: what is left is creep down the slope of 1e-5, against eta
    assert abs(thermo["v_v"][-1]) < 1e-6 * speed
    middle = np.argmin(np.abs(thermo["Step"] - steps // 2))
    t = thermo["Step"][middle] * step
    assert thermo["v_v"][middle] == pytest.approx(speed - MU * G * t, rel=1e-3)


def test_sliding_into_rolling(run_lammps):
    """with rotation a solid sphere that slides at first ends rolling at 5/7 of its velocity, after 12 v^2/(49 mu g)
    on the ground; the arm is shorter by half the overlap, 1e-4 of the radius"""
    speed, step = 2.0, 2e-5
    time = 2 * speed / (7 * MU * G)
    steps = int(1.3 * time / step)
    thermo = run_lammps(on_ground("rotation yes", speed, step, steps, "2e3", "nve/sphere")).thermo
    rolling = thermo["v_v"][-1]
    assert rolling == pytest.approx(5 / 7 * speed, rel=1e-3)
    assert thermo["v_wy"][-1] * 0.5 * D1 == pytest.approx(rolling, rel=1e-3)
    half = np.argmin(np.abs(thermo["Step"] * step - 0.5 * time))
    t = thermo["Step"][half] * step
    assert thermo["v_v"][half] == pytest.approx(speed - MU * G * t, rel=1e-3)
    # torque mu m g r over 2/5 m r^2
    assert thermo["v_wy"][half] == pytest.approx(2.5 * MU * G * t / (0.5 * D1), rel=1e-3)


@pytest.mark.parametrize("rotation", ["no", "yes"])
def test_friction_auto_never_reverses_the_sliding(run_lammps, rotation):
    """below the Coulomb limit a single contact stops: with rotation what resists is only 2/7 of the reduced mass. The
    arms are those of overlapping spheres, 0.99 of the radii: 2 % of the 5/7 of the slip are left after a step"""
    script = scripts.box(20) + "bond_style none\n" + scripts.particles([(0, 0, 0, 1.0), (0.99, 0, 0, 1.0)])
    script += f"pair_style potdem/hertz rotation {rotation}\npair_coeff * * 1000 0.3 friction 1000 auto\n"
    script += """group two id 2
velocity all set 0 0 0
velocity two set 0 1e-6 0
fix move all nve/sphere
timestep 1e-4
compute w all property/atom omegaz
variable slip equal vy[2]-vy[1]-0.5*(C_w[1]+C_w[2])*(x[2]-x[1])
"""
    script += 4 * ("run 1\n" + scripts.result("v_slip"))
    slip = scripts.results(run_lammps(replaced(script, "run 1\n", "run 1 post no\n")).stdout)[:, 0]
    assert np.all(slip > -1e-3 * 1e-6)
    assert slip[0] < 0.6e-6    # half a kick at the start, as velocity Verlet has it
    assert slip[-1] < 0.01e-6
