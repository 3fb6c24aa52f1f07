# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""fix adapt and the extra columns of compute pair/local and bond/local: coefficients that change during a run against the
formulas with the new coefficients."""

import dataclasses
import math

import numpy as np
import pytest

from potdem import formulas, scripts
from potdem.pair_laws import Granular, Hertz, ShiftedLJ, Truss

TIGHT = 1e-12    # rounding of a few operations

# the law as the script gives it, a coefficient, the value that fix adapt gives it
PAIRS = [
    (Hertz(2000.0, 0.3), "E", 3500.0),
    (Hertz(2000.0, 0.3), "nu", 0.1),
    (Truss(2000.0, 0.5), "E", 3500.0),
    (Truss(2000.0, 0.5), "a", 0.7),
    (ShiftedLJ(300.0, 0.2, 3.0, 0.2), "K0", 700.0),
    (ShiftedLJ(300.0, 0.2, 3.0, 0.2), "R", 0.15),
    (ShiftedLJ(300.0, 0.2, 3.0, 0.2), "alpha", 0.22),
    (Granular(300.0, 3.0, 0.2), "K0", 700.0),
    (Granular(300.0, 3.0, 0.2), "alpha", 0.15),
]


def pair_of_particles(law, distance=0.95, pair_options=""):
    return scripts.box(20) + "bond_style none\n" + scripts.particles(
        [(0, 0, 0, 1.0), (distance, 0, 0, 1.0)]) + f"""
pair_style {law.style}
pair_coeff * * {law.coeff} {pair_options}
"""


@pytest.mark.parametrize("law, name, value", PAIRS, ids=lambda v: getattr(v, "style", None))
def test_a_changed_pair_coefficient(run_lammps, law, name, value):
    """at set-up the force is that of the new coefficient, after the run that of the old one again"""
    script = pair_of_particles(law) + f"""
variable new equal {value}
fix change all adapt 1 pair {law.style} {name} * * v_new reset yes
run 0
""" + scripts.result("fx[2]", "pe") + "unfix change\nrun 0\n" + scripts.result("fx[2]", "pe")
    during, after = scripts.results(run_lammps(script).stdout)
    old_cut = law.reach(1.0)
    changed = dataclasses.replace(law, **{name: value, **({"modulus": 0.0} if isinstance(law, Hertz) else {})})
    for row, formula in ((during, changed), (after, law)):
        energy, force = formula(0.95, 1.0, 1.0)
        assert force != 0.0 and 0.95 < old_cut
        assert row[0] == pytest.approx(force, rel=TIGHT)
        assert row[1] == pytest.approx(energy, rel=TIGHT)
    assert during[0] != pytest.approx(after[0], rel=1e-3)


def test_a_coefficient_that_follows_time(run_lammps):
    """a static pair whose modulus grows with every step, under pair_style hybrid, mixed pairs included"""
    script = scripts.box(20, types=2) + "bond_style none\n" + scripts.particles(
        [(0, 0, 0, 1.0, 1), (0.9, 0, 0, 1.0, 2)]) + """
pair_style hybrid potdem/hertz
pair_coeff 1 1 potdem/hertz 2000 0.3
pair_coeff 2 2 potdem/hertz 1000 0.2
variable stiffer equal 1000+500*step
fix change all adapt 1 pair potdem/hertz E 2 2 v_stiffer
thermo 1
variable push equal fx[2]
thermo_style custom step v_push
thermo_modify format float %.17g
run 4
"""
    thermo = run_lammps(script).thermo
    for step, push in zip(thermo["Step"], thermo["v_push"]):
        modulus = 1.0 / ((1 - 0.3**2) / 2000.0 + (1 - 0.2**2) / (1000.0 + 500.0 * step))
        assert push == pytest.approx(4.0 / 3.0 * modulus * math.sqrt(0.25) * 0.1**1.5, rel=TIGHT)


def test_friction_that_begins_during_a_run(run_lammps):
    """mu from zero on: velocities of ghosts are there, and the force appears (two ranks, one particle each)"""
    law = Hertz(2000.0, 0.3)
    script = scripts.box((20, 2, 2)) + "bond_style none\n" + scripts.particles(
        [(-0.45, 0, 0, 1.0), (0.45, 0, 0, 1.0)]) + f"""
pair_style potdem/hertz
pair_coeff * * {law.coeff} friction 0 1e4
velocity all set 0 0 0
set atom 2 vy 0.5
variable mu equal 0.25*step
fix change all adapt 1 pair potdem/hertz mu * * v_mu
thermo 1
variable fy equal fy[2]
variable fx equal fx[2]
thermo_style custom step v_fx v_fy
thermo_modify format float %.17g
run 2
"""
    for nprocs in (1, 2):
        thermo = run_lammps(script, nprocs=nprocs).thermo
        assert thermo["v_fy"][0] == 0.0
        for k in (1, 2):
            assert thermo["v_fy"][k] == pytest.approx(-0.25 * k * thermo["v_fx"][k], rel=TIGHT)


BAD_PAIRS = [
    ("potdem/hertz", "2000 0.3", "E", "-1", "E = -1 is out of range, it must be > 0"),
    ("potdem/hertz", "2000 0.3", "nu", "0.7", "nu = 0.7 is out of range"),
    ("potdem/truss", "2000 0.5 friction 0.1 5", "mu", "-0.1", "friction mu = -0.1 is out of range, it must be >= 0"),
    ("potdem/truss", "2000 0.5 friction 0.1 auto", "eta", "1", "eta is 'auto' for some types"),
    ("potdem/lj", "300 0.2 3 0.2", "cut", "3", "interact up to a distance 3.8, beyond 1.04"),
    ("potdem/truss", "2000 0.5", "nu", "0.1", "param nu not supported"),
]


@pytest.mark.parametrize("style, coeff, name, value, message", BAD_PAIRS)
def test_bad_values_are_refused(run_lammps, style, coeff, name, value, message):
    script = scripts.box(20) + "bond_style none\n" + scripts.particles([(0, 0, 0, 1.0), (0.95, 0, 0, 1.0)]) + f"""
pair_style {style}
pair_coeff * * {coeff}
variable new equal {value}
fix change all adapt 1 pair {style} {name} * * v_new
run 0
"""
    run_lammps(script, expect_error=message)


def bonded(options="", more=""):
    return scripts.box(20) + scripts.particles([(0, 0, 0, 1.0), (1.0, 0, 0, 1.0)]) + scripts.elastic() + f"""
bond_coeff * 1000 area factor 0.5 {options}
potdem_bonds all 1 1.1
{more}
"""


def test_a_changed_bond_coefficient(run_lammps):
    script = bonded() + f"""
variable new equal 1700
run 0
displace_atoms all ramp x 0 0.05 x 0 1
fix change all adapt 1 bond potdem/truss E * v_new reset yes
run 0
""" + scripts.result("fx[2]", "pe") + "unfix change\nrun 0\n" + scripts.result("fx[2]", "pe")
    rows = scripts.results(run_lammps(script).stdout)
    for row, E in zip(rows, (1700.0, 1000.0)):
        modulus = E * formulas.section(1.0, 0.5)
        assert row[0] == pytest.approx(-formulas.truss_tension(1.05, modulus), rel=1e-10)
        assert row[1] == pytest.approx(formulas.truss_energy(1.05, 1.0, modulus), rel=1e-10)


def test_a_bond_keeps_its_strength_when_its_modulus_changes(run_lammps):
    """strength is a stress: with half the modulus the bond fails at the strain that reaches it"""
    stress = 1000.0 * 0.5 * (1.05**2 - 1.0)
    for share, broken in ((1.01, 0), (0.99, 1)):
        script = bonded() + f"""
variable new equal 500
fix fail all potdem/failure 1 tension {share * stress / 2:.17g}
fix change all adapt 1 bond potdem/truss E * v_new
run 0
displace_atoms all ramp x 0 0.05 x 0 1
run 1
""" + scripts.result("f_fail")
        assert scripts.results(run_lammps(script).stdout)[0][0] == broken


def test_a_negative_bond_modulus_is_refused(run_lammps):
    run_lammps(bonded(more="variable new equal -1\nfix change all adapt 1 bond potdem/truss E * v_new\nrun 0"),
               expect_error="E = -1 is out of range, it must be > 0")


def test_extra_columns_of_bond_local(run_lammps):
    script = bonded("penetration 2", "compute b all bond/local dist force b1 b2 b3 b4") + f"""
run 0
displace_atoms all ramp x 0 0.05 x 0 1
compute s all reduce sum c_b[1] c_b[2] c_b[3] c_b[4] c_b[5] c_b[6] inputs local
thermo_style custom step c_s[*]
run 0
""" + scripts.result(*(f"c_s[{k}]" for k in range(1, 7)))
    dist, force, strain, stress, area, reference = scripts.results(run_lammps(script).stdout)[0]
    assert dist == pytest.approx(1.05, rel=TIGHT) and reference == pytest.approx(1.0, rel=TIGHT)
    assert area == pytest.approx(formulas.section(1.0, 0.5), rel=TIGHT)
    assert strain == pytest.approx(0.5 * (1.05**2 - 1), rel=1e-11)
    assert stress == pytest.approx(formulas.truss_tension(1.05, 1000.0, m=2), rel=1e-11)
    assert force == pytest.approx(-stress * area, rel=TIGHT)


@pytest.mark.parametrize("rotation", ["no", "yes"])
def test_extra_columns_of_pair_local(run_lammps, rotation):
    """overlap, stiffness, viscous force and friction of one contact; together they are the force of the loop"""
    law, mu, eta, H = Hertz(2000.0, 0.3), 0.3, 2.0, 1e-3
    v = np.array([-0.4, 0.7, 0.2])
    omega = np.array([0.0, 0.3, -0.5])
    script = scripts.box(20) + "bond_style none\n" + scripts.particles([(0, 0, 0, 1.0), (0.9, 0, 0, 1.0)]) + f"""
pair_style potdem/hertz rotation {rotation}
pair_coeff * * {law.coeff} viscous {H} friction {mu} {eta}
set atom 1 vx 0 vy 0 vz 0
set atom 2 vx {v[0]} vy {v[1]} vz {v[2]} omega {' '.join(map(str, omega))}
compute p all pair/local force p1 p2 p3 p4 p5 p6 p7
compute s all reduce sum c_p[1] c_p[2] c_p[3] c_p[4] c_p[5] c_p[6] c_p[7] c_p[8] inputs local
thermo_style custom step c_s[*]
run 0
""" + scripts.result(*(f"c_s[{k}]" for k in range(1, 9)), "fx[1]", "fy[1]", "fz[1]")
    elastic, overlap, stiffness, viscous, drag, *rest = scripts.results(run_lammps(script).stdout)[0]
    friction_1, force_1 = np.array(rest[:3]), np.array(rest[3:])
    assert overlap == pytest.approx(0.1, rel=TIGHT)
    assert stiffness == pytest.approx(1.5 * elastic / 0.1, rel=TIGHT)
    assert viscous == pytest.approx(-elastic * H * v[0] / 0.1, rel=TIGHT)    # eq. 5.17: F H (dw/dt) / w
    slide = np.array([0.0, v[1], v[2]])
    if rotation == "yes":    # the surface of 2 at the contact, its arm points to 1
        slide += np.cross(omega, [-0.45, 0.0, 0.0])
    expected = eta * slide    # below mu F; on 1, the way 2 slides
    assert np.linalg.norm(expected) < mu * elastic
    assert friction_1 == pytest.approx(expected, rel=1e-11, abs=1e-13)
    assert drag == pytest.approx(np.linalg.norm(expected), rel=1e-11)
    assert force_1 == pytest.approx(friction_1 + [-(elastic + viscous), 0, 0], rel=1e-11, abs=1e-13)
