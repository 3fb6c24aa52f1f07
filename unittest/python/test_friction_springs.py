# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Friction that remembers (friction mu spring ratio, friction mu mindlin): particles on slopes, impacts, piles that sleep."""

import numpy as np
import pytest

from potdem import scripts
from potdem.text import replaced

E, MU, RATIO, MASS, RADIUS, G = 1e5, 0.5, 0.8, 1.0, 0.5, 9.81
SECTION = np.pi / 4 * RADIUS**2    # of the truss law at a wall, with a = 1


def depth_at_rest(normal):
    """distance of the centre from the wall where the truss law carries the normal force"""
    return RADIUS * np.sqrt(1.0 - 2.0 * normal / (E * SECTION))


def on_slope(degrees, friction, rotation="no", nprocs_friendly=""):
    """a sphere at rest on a floor, gravity turned by the angle"""
    angle = np.radians(degrees)
    z = depth_at_rest(MASS * G * np.cos(angle))
    script = scripts.box((400, 2, 4), boundary="f p f")
    script += scripts.particles([(-150, 0, z, 2 * RADIUS)]) + f"set group all mass {MASS}\n"
    script += "pair_style zero 1.0\npair_coeff * *\nregion floor plane 0 0 0 0 0 1\n"
    script += f"fix floor all potdem/wall/region floor law truss {E} 1.0 friction {friction} rotation {rotation}\n"
    script += f"fix weight all gravity {G} vector {np.sin(angle):.17g} 0 {-np.cos(angle):.17g}\n"
    script += "timestep 2e-5\n" + ("fix move all nve/sphere\n" if rotation == "yes" else "fix move all nve\n")
    return script + "thermo_style custom step\nthermo 100000000\n"


SPRING = f"{MU} spring {RATIO} damping 0.5"


@pytest.mark.parametrize("degrees", [10.0, 26.0])
def test_below_the_angle_of_friction_it_sticks_without_creep(run_lammps, degrees):
    """atan 0.5 is 26.6 degrees, where it slips a little as it swings in; after the spring has come to rest a million steps move it
    less than 1e-9 of its diameter"""
    script = on_slope(degrees, SPRING) + "run 50000\n" + scripts.result("x[1]", "vx[1]")
    script += "run 1000000\n" + scripts.result("x[1]", "vx[1]")
    before, after = scripts.results(run_lammps(script).stdout)
    if degrees < 20.0:    # the truss law's stiffness is A E x / re
        stiffness = RATIO * E * SECTION / RADIUS * depth_at_rest(MASS * G * np.cos(np.radians(degrees))) / RADIUS
        assert before[0] + 150.0 == pytest.approx(MASS * G * np.sin(np.radians(degrees)) / stiffness, rel=1e-6)
    assert abs(after[0] - before[0]) < 1e-9 * 2 * RADIUS


def test_above_it_slides_with_the_acceleration_of_coulomb(run_lammps):
    """from when the spring slips: the exact difference of two velocities"""
    script = on_slope(35.0, SPRING) + "run 20000\n" + scripts.result("vx[1]", "time") + "run 20000\n" + scripts.result("vx[1]", "time")
    first, second = scripts.results(run_lammps(script).stdout)
    angle = np.radians(35.0)
    assert (second[0] - first[0]) / (second[1] - first[1]) == pytest.approx(G * (np.sin(angle) - MU * np.cos(angle)), rel=1e-6)


@pytest.mark.parametrize("degrees", [20.0, 40.0])
def test_a_sphere_rolls_without_sliding(run_lammps, degrees):
    """a = 5/7 g sin(angle) as long as mu > 2/7 tan(angle); the arm is the distance to the floor, less than the radius by the overlap"""
    script = on_slope(degrees, SPRING, "yes") + "run 30000\n" + scripts.result("vx[1]", "time") + "run 30000\n"
    script += scripts.result("vx[1]", "time")
    first, second = scripts.results(run_lammps(script).stdout)
    angle = np.radians(degrees)
    arm = depth_at_rest(MASS * G * np.cos(angle)) / RADIUS
    expected = G * np.sin(angle) / (1.0 + 0.4 / arm**2)
    assert (second[0] - first[0]) / (second[1] - first[1]) == pytest.approx(expected, rel=1e-5)


# --- impacts ------------------------------------------------------------------------------------------------------------------


def oblique(pair, friction, angle, speed=5.0, step=2e-7, partner=True, newton="off"):
    """two equal spheres, or a sphere and a wall, at a speed (m/s) and an angle from the normal"""
    a = np.radians(angle)
    rows = [(0, 0, 0.1000001, 0.2)] + ([(0, 0, -0.1000001, 0.2)] if partner else [])
    script = scripts.box(4, newton=newton) + scripts.particles(rows, density=2650.0)
    script += f"comm_modify vel yes\nset atom 1 vx {speed * np.sin(a):.17g} vz {-speed * np.cos(a):.17g}\n"
    if partner:
        script += f"set atom 2 vx {-speed * np.sin(a):.17g} vz {speed * np.cos(a):.17g}\n"
        script += f"pair_style {pair[0]} rotation yes\npair_coeff * * {pair[1]} friction {friction}\n"
    else:
        script += "pair_style zero 0.3\npair_coeff * *\nregion floor plane 0 0 0 0 0 1\n"
        script += f"fix floor all potdem/wall/region floor {pair[1]} friction {friction} rotation yes\n"
    script += f"fix move all nve/sphere\ntimestep {step}\ncompute ledger all potdem/energy\n"
    script += "thermo_style custom step c_ledger c_ledger[1] c_ledger[7] c_ledger[11]\nthermo_modify format float %.17g\n"
    return script + "thermo 100\nrun 6000\n"


HERTZ = ("potdem/hertz", "7e10 0.25")
WALL = ("", "7e10 0.25 particle 7e10 0.25 layer none")


@pytest.mark.parametrize("partner, newton", [(True, "off"), (True, "on"), (False, "off")])
@pytest.mark.parametrize("friction", ["0.1 mindlin", "0.1 spring 0.7", "0.1 mindlin damping 0.3"])
@pytest.mark.parametrize("angle", [5.0, 30.0, 70.0])
def test_the_ledger_closes_over_an_oblique_impact(run_lammps, angle, partner, friction, newton):
    """at every moment; the energy of the spring is there while it is strained, and is gone or had back in the end"""
    run = run_lammps(oblique(HERTZ if partner else WALL, friction, angle, partner=partner, newton=newton))
    total, kinetic, heat, springs = (run.thermo[name] for name in ("c_ledger", "c_ledger[1]", "c_ledger[7]", "c_ledger[11]"))
    assert springs.max() > 1e-6 * kinetic[0] and springs.min() >= 0.0 and springs[-1] == 0.0
    assert np.abs(total - total[0]).max() < 2e-5 * kinetic[0]
    # friction takes energy only; of what it has not taken yet the rectangle rule over a step is not exact
    assert np.diff(heat).min() > -2e-6 * kinetic[0]
    assert heat[-1] == pytest.approx(kinetic[0] - kinetic[-1], abs=2e-5 * kinetic[0])


@pytest.mark.parametrize("partner", [True, False])
def test_gross_sliding_is_the_impact_of_rigid_bodies(run_lammps, partner):
    """at a large angle the spheres slide throughout: the tangential impulse is mu times the normal one (Chung and Ooi, 2011, tests 5
    and 6), so that dv_x = mu (1 + e) v_n and omega follows, with e = 1. The spring sticks at first touch and at the last, and the
    normal of two spheres turns a little: 1e-3. They are slow, so that it turns little"""
    mu, angle, speed = 0.1, 70.0, 0.01
    run = run_lammps(oblique(HERTZ if partner else WALL, f"{mu} mindlin", angle, speed, 1e-6, partner) +
                     "group first id 1\ncompute y all property/atom omegay\ncompute spin first reduce sum c_y\n"
                     "thermo_style custom step c_spin\nrun 0\n" + scripts.result("vx[1]", "vz[1]", "c_spin"))
    (vx, vz, spin) = scripts.results(run.stdout)[0]
    normal = speed * np.cos(np.radians(angle))
    assert vz == pytest.approx(normal, rel=1e-3)
    assert vx == pytest.approx(speed * np.sin(np.radians(angle)) - 2.0 * mu * normal, rel=1e-3)
    # angular momentum about the point of contact: 2/5 m r^2 omega = r mu (2 m v_n)
    assert abs(spin) == pytest.approx(5.0 * mu * normal / 0.1, rel=1e-2)


def test_friction_is_adapted_from_nothing(run_lammps):
    """the contact has a memory with mu = 0, and is held by mu as it grows"""
    script = scripts.box(4) + scripts.particles([(0, -0.45, 0, 1), (0, 0.45, 0, 1)]) + "comm_modify vel yes\n"
    script += "pair_style potdem/truss\npair_coeff * * 1000 0.5 friction 0 spring 0.8\ngroup two id 2\n"
    script += "variable mu equal ramp(0,0.3)\nfix grow all adapt 1 pair potdem/truss mu * * v_mu\n"
    script += "fix pull two move linear 0.1 0 0\ntimestep 1e-4\nthermo_style custom step v_mu\nrun 500\n"
    script += "compute f all pair/local p4 force\ncompute s all reduce sum c_f[1] c_f[2] inputs local\n"
    script += "thermo_style custom step v_mu c_s[1] c_s[2]\nthermo_modify format float %.17g\nunfix grow\nrun 0\n"
    (found,) = scripts.results(run_lammps(script + scripts.result("c_s[1]", "c_s[2]")).stdout)
    # 0.8 A E x/re over 5 mm; the normal turns by a hundredth of its direction
    assert found[0] == pytest.approx(0.8 * 1000 * 0.5 * np.pi / 4 * 0.9 * 0.005, rel=1e-3)
    assert found[0] < 0.3 * found[1]


def test_a_spring_is_let_go_without_a_normal_force(run_lammps):
    """the Lennard-Jones law reaches beyond where it pushes"""
    script = scripts.box(4) + scripts.particles([(0, -0.45, 0, 1), (0, 0.45, 0, 1)]) + "comm_modify vel yes\n"
    script += "pair_style potdem/lj\npair_coeff * * 1000 0.2 2 0.2 friction 0.5 spring 0.8\ngroup two id 2\n"
    script += "compute ledger all potdem/energy\nfix pull two move linear 0.1 0 0\ntimestep 1e-4\n"
    script += "set atom 2 y 0.4\nthermo_style custom step c_ledger[11]\nthermo_modify format float %.17g\nrun 50\n"
    script += scripts.result("c_ledger[11]") + "unfix pull\nset atom 2 y 0.6\nrun 1\n" + scripts.result("c_ledger[11]")
    held, released = scripts.results(run_lammps(script).stdout)[:, 0]
    assert held > 0.0 and released == 0.0


# --- piles --------------------------------------------------------------------------------------------------------------------

PILE = """
pair_style potdem/hertz rotation yes
pair_coeff * * 1e7 0.3 viscous 1e-4 friction 0.5 mindlin damping 0.3
region floor plane 0 0 0 0 0 1
fix floor all potdem/wall/region floor 1e7 0.3 particle 1e7 0.3 viscous 1e-4 friction 0.5 mindlin damping 0.3 rotation yes
fix weight all gravity 9.81 vector 0.2 0 -1
fix move all nve/sphere
timestep 2e-5
compute y all property/atom tqy omegay
group top id 4
compute turn top reduce sum c_y[1] c_y[2]
thermo_style custom step c_turn[1] c_turn[2]
thermo_modify format float %.17g
"""


@pytest.mark.parametrize("nprocs", [1, 3])
@pytest.mark.parametrize("newton", ["off", "on"])
def test_a_pile_that_leans_goes_on_from_a_restart_file(run_lammps, newton, nprocs):
    """forces are the same to rounding, and so is what follows"""
    rows = [(0, 0, 0.0499, 0.1), (0.0999, 0, 0.0499, 0.1), (0.05, 0.0865, 0.0499, 0.1), (0.05, 0.0288, 0.1313, 0.1)]
    script = scripts.box((2, 2, 2), newton=newton, skin=0.02, centre=0.0)
    script += "comm_modify vel yes\n" + scripts.particles(rows, density=2000.0) + PILE
    columns = [f"{what}[{i}]" for what in ("fx", "fz", "x", "vx") for i in (1, 4)]
    columns += ["c_turn[1]", "c_turn[2]"]
    script += "run 4000\nwrite_restart pile.restart\nrun 0\n" + scripts.result(*columns) + "run 1000\n" + scripts.result(*columns)
    script += "clear\nread_restart pile.restart\n" + PILE[PILE.index("region"):] + "run 0\n" + scripts.result(*columns)
    script += "run 1000\n" + scripts.result(*columns)
    before, after, read, went_on = scripts.results(run_lammps(script, nprocs=nprocs).stdout)
    scale = 9.81 * 2000.0 * np.pi / 6 * 0.1**3
    assert np.abs(before[:4]).max() > 1e-3 * scale
    assert read == pytest.approx(before, rel=1e-9, abs=1e-9 * scale)
    assert went_on == pytest.approx(after, rel=1e-7, abs=1e-7 * scale)


# --- input --------------------------------------------------------------------------------------------------------------------


def test_tiled_communication_needs_newton_off(run_lammps):
    script = scripts.box(4, newton="on") + scripts.particles([(0, 0, 0, 1), (0.95, 0, 0, 1)])
    script += "comm_style tiled\ncomm_modify vel yes\npair_style potdem/hertz\npair_coeff * * 1e7 0.3 friction 0.3 mindlin\nfix move all nve\n"
    run_lammps(script + "run 1\n", expect_error="newton off")
    run_lammps(replaced(script, "newton on", "newton off") + "run 1\n")
