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
