# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Numerical damping against eq. 5.30, with a constant force given by fix addforce."""

import numpy as np
import pytest

from potdem import dumps, scripts

FORCES = np.array([(1.0, -2.0, 0.5), (1.0, -2.0, 0.5), (1.0, 0.0, 0.0), (1.0, -2.0, 0.5), (0.0, 0.0, 0.0)])
# along the force, against it, across it, at rest, without force
VELOCITIES = np.array([(0.3, -0.1, 0.2), (-0.3, 0.1, 0.2), (0.0, 3.0, -1.0), (0.0, 0.0, 0.0), (1.0, 1.0, 1.0)])


def forces(run_lammps, tmp_path, options, group="all"):
    """what is left of FORCES on five particles that do not touch"""
    script = scripts.box(40) + scripts.particles([(3.0 * k, 0, 0, 1.0) for k in range(len(FORCES))])
    script += "pair_style none\nbond_style none\ngroup some id 1 2\n"
    for number, (f, v) in enumerate(zip(FORCES, VELOCITIES), start=1):
        script += f"group g{number} id {number}\nvelocity g{number} set {v[0]} {v[1]} {v[2]}\n"
        script += f"fix f{number} g{number} addforce {f[0]} {f[1]} {f[2]}\n"
    script += f"fix damping {group} potdem/damping {options}\nrun 0\n" + scripts.write_dump("f.dump", "fx fy fz")
    run_lammps(script)
    return scripts.vectors(dumps.read(tmp_path / "f.dump")[0], "fx", "fy", "fz")


# one multiplication: rounding 1e-16
EXACT = dict(rel=1e-15, abs=0)


@pytest.mark.every_style
@pytest.mark.parametrize("options", ["0.3", "0.3 form vector"])
def test_vector_form(run_lammps, tmp_path, options):
    """-lambda F sgn(F.v), and nothing where F.v = 0"""
    power = np.sum(FORCES * VELOCITIES, axis=1)
    assert list(np.sign(power)) == [1, -1, 0, 0, 0]
    expected = FORCES * (1 - 0.3 * np.sign(power))[:, None]
    assert forces(run_lammps, tmp_path, options) == pytest.approx(expected, **EXACT)


def test_component_form(run_lammps, tmp_path):
    """-lambda |F_k| sgn(v_k) for each component"""
    expected = FORCES - 0.3 * np.abs(FORCES) * np.sign(VELOCITIES)
    assert forces(run_lammps, tmp_path, "0.3 form component") == pytest.approx(expected, **EXACT)


@pytest.mark.parametrize("options", ["0.9 form vector", "0.9 form component"])
def test_no_velocity_no_damping(run_lammps, tmp_path, options):
    """and at zero force nothing either"""
    left = forces(run_lammps, tmp_path, options)
    assert np.array_equal(left[3:], FORCES[3:])


def test_zero_damping(run_lammps, tmp_path):
    assert np.array_equal(forces(run_lammps, tmp_path, "0.0"), FORCES)


def test_only_the_group(run_lammps, tmp_path):
    left = forces(run_lammps, tmp_path, "0.3", group="some")
    assert left[:2] == pytest.approx(FORCES[:2] * [[0.7], [1.3]], **EXACT)
    assert np.array_equal(left[2:], FORCES[2:])


GRAVITY = 9.81


def falling(run_lammps, options, group="all"):
    """velocities in z of two particles, the second of group 'light', after 100 steps of 1 ms of free fall, upwards at first"""
    script = scripts.box(40) + scripts.particles([(0, 0, 0, 1.0), (3, 0, 0, 0.5)]) + f"""
pair_style none
bond_style none
group light id 2
velocity all set 0 0 0.3
fix weight {group} gravity {GRAVITY} vector 0 0 -1
fix damping all potdem/damping {options}
fix move all nve
timestep 1e-3
run 100
""" + scripts.result("vz[1]", "vz[2]")
    return scripts.results(run_lammps(script).stdout)[0]


# of 100 sums of doubles
FALL = dict(rel=1e-13, abs=0)


@pytest.mark.every_style
@pytest.mark.parametrize("form", ["vector", "component"])
def test_undamped_weight_is_free_fall(run_lammps, form):
    """up and down, v = v0 - g t, for particles of any mass"""
    assert falling(run_lammps, f"0.2 form {form} weight no") == pytest.approx([0.3 - GRAVITY * 0.1] * 2, **FALL)


def test_weight_is_damped_unless_told(run_lammps):
    """(1+lambda) g on the way up, (1-lambda) g down"""
    assert np.array_equal(falling(run_lammps, "0.2"), falling(run_lammps, "0.2 weight yes"))
    up = 0.3 / (1.2 * GRAVITY)
    # the step in which it turns
    assert falling(run_lammps, "0.2")[0] == pytest.approx(-0.8 * GRAVITY * (0.1 - up), abs=0.4 * GRAVITY * 1e-3)


@pytest.mark.parametrize("options, falls", [("0.02", False), ("0.02 weight no", False), ("0", True)])
def test_a_body_that_vibrates_is_held_up(run_lammps, options, falls):
    """two bonded particles that vibrate along z in free fall: what is damped acts on each one's whole velocity. Without damping the body
    has g, whatever it does inside"""
    script = scripts.box(20) + scripts.particles([(0, 0, 0, 1.0), (0, 0, 1.0, 1.0)]) + scripts.elastic(E=1e6) + f"""
potdem_bonds all 1 1.1
velocity all set 0 0 0
set atom 2 z 1.002
fix weight all gravity {GRAVITY} vector 0 0 -1
fix damping all potdem/damping {options}
fix move all nve
timestep 1e-5
run 10000
""" + scripts.result("vcm(all,z)")
    speed = scripts.results(run_lammps(script).stdout)[0][0] / (-GRAVITY * 0.1)
    assert abs(speed - 1) < 1e-9 if falls else 0.4 < speed < 0.6    # 0.51 of free fall, as the page says


def test_weight_of_a_group(run_lammps):
    """a fix gravity weighs its own group only; the rest has no force"""
    assert falling(run_lammps, "0.2 weight no", group="light") == pytest.approx([0.3, 0.3 - GRAVITY * 0.1], **FALL)


def test_other_forces_are_damped_without_the_weight(run_lammps, tmp_path):
    """F = P + m g; damped is P alone. Here P . v > 0 and F . v < 0"""
    push, mass, velocity = np.array([0.0, 1.0, 3.0]), np.pi / 6, 0.5
    script = scripts.box(40) + scripts.particles([(0, 0, 0, 1.0)]) + f"""
pair_style none
bond_style none
velocity all set 0 0 {velocity}
fix push all addforce {push[0]} {push[1]} {push[2]}
fix weight all gravity {GRAVITY} vector 0 0 -1
fix damping all potdem/damping 0.3 weight no
run 0
""" + scripts.write_dump("f.dump", "fx fy fz")
    run_lammps(script)
    force = scripts.vectors(dumps.read(tmp_path / "f.dump")[0], "fx", "fy", "fz")[0]
    # the weight is added and taken away again: rounding of the larger of the two
    assert force == pytest.approx(0.7 * push - [0, 0, mass * GRAVITY], rel=1e-14)


@pytest.mark.parametrize("form", ["vector", "component"])
def test_only_takes_energy(run_lammps, form):
    """a vibrating bond: the total energy never grows, and the pair comes to rest at its length"""
    script = scripts.box(20) + scripts.particles([(0, 0, 0, 1.0), (1.0, 0, 0, 1.0)]) + scripts.elastic() + f"""
potdem_bonds all 1 1.1
set atom 2 x 1.05
velocity all set 0 0 0
fix damping all potdem/damping 0.6 form {form}
fix move all nve
timestep 1e-4
thermo 20
thermo_style custom step etotal
thermo_modify format float %.17g
run 10000
""" + scripts.result("x[2]-x[1]")
    run = run_lammps(script)
    energy = run.thermo["TotEng"]
    # within a period the leapfrog's energy moves by (omega dt)^2/8 of itself, 1e-6
    assert np.all(np.diff(energy) < 1e-5 * energy[:-1] + 1e-12 * energy[0])
    # each of the 12 half periods leaves (1-0.6)/(1+0.6) = 1/4 of the energy: 6e-8
    assert energy[-1] < 1e-6 * energy[0]
    assert scripts.results(run.stdout)[0][0] == pytest.approx(1.0, abs=2e-4)


def test_decay_per_half_period(run_lammps):
    """on a linear spring k the half period leads from a to -a', with (1-lambda) k a^2 = (1+lambda) k a'^2"""
    lam = 0.1
    script = scripts.box(20) + scripts.particles([(0, 0, 0, 1.0), (1.0, 0, 0, 1.0)]) + scripts.elastic()
    script += f"""
potdem_bonds all 1 1.1
set atom 2 x 1.0001
velocity all set 0 0 0
fix damping all potdem/damping {lam}
fix move all nve
timestep 1e-5
variable d equal x[2]-x[1]-1
thermo 1
thermo_style custom step v_d
thermo_modify format float %.17g
run 12000
"""
    d = run_lammps(script).thermo["v_d"]
    low = d[:int(np.argmin(d)) + 1].min()
    # nonlinear terms of the strain 1e-4, and 1e-4 of a period per step
    assert low / d[0] == pytest.approx(-np.sqrt((1 - lam) / (1 + lam)), rel=1e-3)


@pytest.mark.parametrize("other", ["gravity 9.81 vector 0 0 -1", "addforce 1 0 0",
                                   "potdem/wall/region floor 1e4 0.3 particle 1e4 0.3"])
def test_must_come_last(run_lammps, other):
    script = scripts.box(20) + scripts.particles([(0, 0, 0, 1.0)]) + "pair_style none\nbond_style none\n"
    script += "region floor plane 0 0 -5 0 0 1\nfix cushion all potdem/damping 0.2\n" + f"fix late all {other}\nrun 0\n"
    message = run_lammps(script, expect_error="fix late").error
    assert "cushion" in message and "last" in message
