# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""rolling mu ratio xi, twisting mu ratio xi: spheres that come to rest, that stay at rest, and what a contact remembers of it."""

import numpy as np
import pytest
from test_friction_springs import E, G, HERTZ, MASS, RADIUS, SECTION, WALL, depth_at_rest, oblique, on_slope

from potdem import scripts

MU_ROLL = 0.05
STICKS = f"0.5 spring 0.8 damping 0.5 rolling {MU_ROLL} 0.1 0.5"


def test_a_rolling_sphere_stops_after_the_exact_distance(run_lammps):
    """rolling with v = w z, z the height of its centre: m a = -F, I a/z = F z - mu N R. Sliding friction only transmits"""
    z, speed = depth_at_rest(MASS * G), 1.0
    script = on_slope(0.0, STICKS, "yes") + f"set atom 1 vx {speed} omega 0 {speed / z:.17g} 0\n"
    script += "run 200000\n" + scripts.result("x[1]", "vx[1]")
    ((x, v),) = scripts.results(run_lammps(script).stdout)
    slowing = MU_ROLL * MASS * G * RADIUS / (0.4 * MASS * RADIUS**2 / z + MASS * z)
    # its spring, loaded at first, takes the last (limit/k)/2 of the way off
    assert x + 150.0 == pytest.approx(speed**2 / (2 * slowing), rel=2e-3)
    assert abs(v) < 1e-6


@pytest.mark.parametrize("degrees, stays", [(2.0, True), (4.0, False)])
def test_a_sphere_on_a_slope(run_lammps, degrees, stays):
    """tan 2 < 0.05 R/z < tan 4 degrees: it stays without creep over a million steps; or rolls with what is left"""
    script = on_slope(degrees, STICKS, "yes") + "run 200000\n" + scripts.result("x[1]", "vx[1]", "time")
    script += f"run {1000000 if stays else 20000}\n" + scripts.result("x[1]", "vx[1]", "time")
    before, after = scripts.results(run_lammps(script).stdout)
    if stays:
        assert abs(after[0] - before[0]) < 1e-9 * 2 * RADIUS
        return
    angle = np.radians(degrees)
    arm = depth_at_rest(MASS * G * np.cos(angle))
    pulled = MASS * G * (np.sin(angle) * arm - MU_ROLL * np.cos(angle) * RADIUS)
    assert (after[1] - before[1]) / (after[2] - before[2]) == pytest.approx(pulled / (MASS * arm + 0.4 * MASS * RADIUS**2 / arm), rel=1e-4)


def test_a_spinning_sphere_stops_by_twisting(run_lammps):
    """I dw/dt = -mu N R about the normal"""
    spin, mu = 2.0, 0.02
    script = on_slope(0.0, f"0.5 spring 0.8 twisting {mu} 0.1 0.5", "yes") + f"set atom 1 omega 0 0 {spin}\n"
    script += "compute w all property/atom omegaz\ncompute spin all reduce sum c_w\nthermo_style custom step c_spin\n"
    script += "run 20000\n" + scripts.result("c_spin") + "run 200000\n" + scripts.result("c_spin")
    (first,), (last,) = scripts.results(run_lammps(script).stdout)
    assert first == pytest.approx(spin - mu * G * RADIUS / (0.4 * RADIUS**2) * 0.4, rel=1e-3)
    assert abs(last) < 1e-6 * spin


@pytest.mark.parametrize("partner, newton", [(True, "off"), (True, "on"), (False, "off")])
def test_the_ledger_closes_over_an_impact(run_lammps, partner, newton):
    friction = "0.3 mindlin damping 0.1 rolling 0.1 0.2 0.1 twisting 0.1 0.2 0.1"
    script = oblique(HERTZ if partner else WALL, friction, 30.0, partner=partner, newton=newton)
    script = script.replace("comm_modify vel yes\n", "comm_modify vel yes\nset atom 1 omega 60 30 90\n")
    if not partner:
        script = script.replace(f"friction {friction} rotation yes", f"rotation yes friction {friction}")
    run = run_lammps(script)
    total, kinetic, heat, springs = (run.thermo[name] for name in ("c_ledger", "c_ledger[1]", "c_ledger[7]", "c_ledger[11]"))
    assert springs.max() > 1e-6 * kinetic[0] and springs[-1] == 0.0
    assert np.abs(total - total[0]).max() < 3e-5 * kinetic[0]
    assert heat[-1] == pytest.approx(kinetic[0] - kinetic[-1], abs=3e-5 * kinetic[0])
    plain = run_lammps(script.replace(" rolling 0.1 0.2 0.1 twisting 0.1 0.2 0.1", "")).thermo["c_ledger[7]"]
    assert heat[-1] > 1.001 * plain[-1]


def test_two_spheres_exchange_no_angular_momentum_by_rolling(run_lammps):
    """torques are opposite; and the columns of pair/local are the torques on the particles, which nothing else turns: mu is 0"""
    script = scripts.box(4, newton="off") + scripts.particles([(0, 0, 0, 1), (0, 0, 0.95, 0.95)], density=3.0) + "comm_modify vel yes\n"
    script += "set atom 1 omega 0.3 0.1 0.2\nset atom 2 omega -0.2 0.4 -0.5\npair_style potdem/truss rotation yes\n"
    script += "pair_coeff * * 1e5 0.5 friction 0 spring 0.8 rolling 0.1 0.5 0 twisting 0.1 0.5 0\ntimestep 1e-6\n"
    script += "fix move all nve/sphere\nfix still all setforce 0 0 0\nset group all vx 0 vy 0 vz 0\n"
    script += "compute t all property/atom tqx tqy tqz\ncompute sum all reduce sum c_t[1] c_t[2] c_t[3]\ngroup first id 1\n"
    script += "compute one first reduce sum c_t[1] c_t[2] c_t[3]\ncompute p all pair/local p4 p8 p9 p10\n"
    script += "compute q all reduce sum c_p[*] inputs local\nthermo_style custom step c_sum[1] c_sum[2] c_sum[3] c_one[1] c_q[1]\n"
    script += "run 200\nrun 0\n" + scripts.result("c_sum[1]", "c_sum[2]", "c_sum[3]", "c_one[1]", "c_one[2]", "c_one[3]",
                                                  "c_q[1]", "c_q[2]", "c_q[3]", "c_q[4]")
    found = scripts.results(run_lammps(script).stdout)[0]
    torque = found[3:6]
    assert np.abs(torque).min() > 0.0
    assert found[:3] == pytest.approx(0.0, abs=1e-13 * np.abs(torque).max())
    assert found[6] == 0.0 and found[7] == 0.0
    assert found[8] == pytest.approx(np.hypot(torque[0], torque[1]), rel=1e-12)
    assert abs(found[9]) == pytest.approx(abs(torque[2]), rel=1e-12)
    # by hand: R ratio K times the angle, at a small overlap: the stiffness of the truss law at x = r/dbar
    stiffness = 0.5 * 1e5 * 0.5 * np.pi / 4 * 0.975**2 / 0.975
    angles = 2e-4 * np.array([0.5, -0.3, 0.7])
    R = 0.5 * 0.475 / 0.975
    x = 0.95 / 0.975
    assert torque == pytest.approx(-R * R * stiffness * x * angles, rel=2e-3)


def test_pair_local_says_whether_a_contact_slides(run_lammps):
    script = scripts.box(4) + scripts.particles([(0, -0.45, 0, 1), (0, 0.45, 0, 1)]) + "comm_modify vel yes\n"
    script += "pair_style potdem/truss\npair_coeff * * 1000 0.5 friction 0.3 spring 0.8\ngroup two id 2\nfix pull two move linear 0.1 0 0\n"
    script += "compute f all pair/local p4 p8 force\ncompute s all reduce sum c_f[1] c_f[2] c_f[3] inputs local\ntimestep 1e-4\n"
    script += "thermo_style custom step c_s[1] c_s[2] c_s[3]\nrun 100\nrun 0\n" + scripts.result("c_s[1]", "c_s[2]", "c_s[3]")
    script += "run 10000\nrun 0\n" + scripts.result("c_s[1]", "c_s[2]", "c_s[3]")
    sticks, slips = scripts.results(run_lammps(script).stdout)
    assert sticks[1] == 0.0 and 0.0 < sticks[0] < 0.3 * sticks[2]
    assert slips[1] == 1.0 and slips[0] == pytest.approx(0.3 * slips[2], rel=1e-9)


@pytest.mark.parametrize("nprocs", [1, 3])
@pytest.mark.parametrize("newton", ["off", "on"])
def test_what_rolls_goes_on_from_a_restart_file(run_lammps, newton, nprocs):
    """forces and torques are the same to rounding, and so is what follows"""
    rolls = "friction 0.5 mindlin damping 0.3 rolling 0.2 0.3 0.2 twisting 0.1 0.3 0.2"
    settings = f"""region floor plane 0 0 0 0 0 1
fix floor all potdem/wall/region floor 1e7 0.3 particle 1e7 0.3 restitution 0.1 rotation yes {rolls}
fix weight all gravity 9.81 vector 0.2 0 -1
fix move all nve/sphere
timestep 2e-5
compute y all property/atom tqx tqy tqz
compute turn all reduce sum c_y[1] c_y[2] c_y[3]
thermo_style custom step c_turn[1] c_turn[2] c_turn[3]
thermo_modify format float %.17g
"""
    rows = [(0, 0, 0.04999, 0.1), (0.09999, 0, 0.04999, 0.1), (0.05, 0.0866, 0.04999, 0.1), (0.05, 0.0288, 0.1316, 0.1)]
    script = scripts.box((2, 2, 2), newton=newton, skin=0.02) + "comm_modify vel yes\n" + scripts.particles(rows, density=2000.0)
    script += "set atom 4 omega 3 5 8\n"
    script += f"pair_style potdem/hertz rotation yes\npair_coeff * * 1e7 0.3 restitution 0.1 {rolls}\n" + settings
    state = scripts.result("fx[4]", "fz[4]", "c_turn[1]", "c_turn[2]", "c_turn[3]", "x[4]", "vx[4]", "vx[1]")
    script += "run 10000\nwrite_restart pile.restart\nrun 0\n" + state + "run 1000\n" + state
    script += f"clear\nread_restart pile.restart\n{settings}run 0\n" + state + "run 1000\n" + state
    before, after, read, went_on = scripts.results(run_lammps(script, nprocs=nprocs).stdout)
    scale = 9.81 * 2000.0 * np.pi / 6 * 0.1**3
    assert np.abs(before[2:5]).max() > 1e-5 * scale
    assert read == pytest.approx(before, rel=1e-9, abs=1e-9 * scale)
    assert went_on == pytest.approx(after, rel=1e-7, abs=1e-7 * scale)


def test_rolling_springs_count_for_the_critical_step(run_lammps):
    """a stiff one turns a sphere on a floor: theta'' = -ratio K R^2/(0.4 m R^2) theta alone, so that the step is below 2/omega"""
    script = on_slope(0.0, "0 spring 0.8 rolling 10 20 0", "yes") + "compute step all potdem/timestep\nthermo_style custom step c_step\nrun 0\n"
    ((found,),) = scripts.results(run_lammps(script + scripts.result("c_step")).stdout)
    x = depth_at_rest(MASS * G) / RADIUS
    stiffness = E * SECTION / RADIUS * x
    assert found == pytest.approx(2.0 / np.sqrt(20 * stiffness / (0.4 * MASS)), rel=1e-9)



@pytest.mark.parametrize("friction", ["", "friction 0 spring 0.8 ", "friction 0.3 0.1 "])
@pytest.mark.parametrize("word, axis", [("rolling", 2), ("twisting", 3)])
def test_it_is_adapted_from_nothing_to_nothing_and_back(run_lammps, word, axis, friction):
    """the contact has a memory with mu = 0, too, and keeps ratio and xi. By hand: mu R F, R = r1 r2/(r1 + r2), the truss law's F"""
    spin = {2: "0 900 0", 3: "0 0 900"}[axis]
    script = scripts.box(4, newton="off") + scripts.particles([(0, 0, 0, 1), (0, 0, 0.95, 1)], density=3.0) + "comm_modify vel yes\n"
    script += f"set atom 1 omega {spin}\npair_style potdem/truss rotation yes\npair_coeff * * 1e5 0.5 {friction}{word} 0 0.5 0\n"
    script += "timestep 1e-6\nfix still all move linear 0 0 0\nvariable mu equal 0.1*(step>100)*(step<300)+0.2*(step>=400)\n"
    script += f"fix grow all adapt 1 pair potdem/truss {word} * * v_mu\ngroup first id 1\ncompute t all property/atom tqx tqy tqz\n"
    script += f"compute one first reduce sum c_t[{axis}]\nthermo_style custom step c_one\nthermo_modify format float %.17g\n"
    for steps in (200, 150, 150):
        script += f"run {steps}\n" + scripts.result("c_one")
    found = scripts.results(run_lammps(script).stdout)[:, 0]
    force = 1e5 * 0.5 * np.pi / 4 * 0.5 * (1.0 - 0.95**2)
    if friction != "friction 0.3 0.1 ":    # whose friction turns it, too
        assert found == pytest.approx([-0.1 * 0.25 * force, 0.0, -0.2 * 0.25 * force], rel=1e-9)
    else:
        assert found[0] - found[1] == pytest.approx(-0.1 * 0.25 * force, rel=1e-2)
        assert found[2] - found[1] == pytest.approx(-0.2 * 0.25 * force, rel=1e-2)
