# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Bond, contact and wall on one or two particles against the formulas of the model, written here again."""

import numpy as np
import pytest

from potdem import formulas, scripts
from potdem.text import replaced

E, A = 1000.0, 0.5
# forces and energies are products of a dozen factors: rounding 1e-15 each
EXACT = dict(rel=1e-13, abs=1e-12)

PENETRATION = [("", 0, False), ("penetration 1", 1, False), ("penetration 3 normalized", 3, True)]


def pair_of(d1=1.0, d2=1.0, distance=1.0, types=1):
    """two particles on the x axis, the second at +distance, density 1"""
    second = (distance, 0, 0, d2, types)
    return scripts.box(20, types=types) + scripts.particles([(0, 0, 0, d1, 1), second])


def outputs(*more):
    return f"""
thermo_style custom step pe ebond evdwl pxx pyy pxy vol {" ".join(more)}
thermo_modify format float {scripts.ALL_DIGITS}
"""


# --- bonds -------------------------------------------------------------------------------------------

STRETCHES = [0.2, 0.7, 0.99, 1.0, 1.001, 1.3, 2.1]


@pytest.mark.parametrize("keyword, m, normalized", PENETRATION)
def test_bond_force_and_energy(run_lammps, keyword, m, normalized):
    """energy, forces, compute bond/local and the virial over a range of stretches"""
    length, d1, d2 = 1.1, 1.0, 1.4
    script = pair_of(d1, d2, length) + scripts.elastic(E, f"factor {A}", keyword) + "potdem_bonds all 1 1.2\n"
    # contact is off: bonded pairs do not touch
    script += "compute b all bond/local dist engpot force\n"
    script += "compute d all reduce sum c_b[1] c_b[2] c_b[3] inputs local\n"
    script += outputs("c_d[1]", "c_d[2]", "c_d[3]")
    for x in STRETCHES:
        script += f"set atom 2 x {x * length:.17g}\nrun 0\n"
        script += scripts.result("ebond", "evdwl", "fx[1]", "fx[2]", "fy[2]", "c_d[1]", "c_d[2]", "c_d[3]", "pxx*vol")
    rows = scripts.results(run_lammps(script).stdout)
    assert len(rows) == len(STRETCHES)
    modulus = E * formulas.section(0.5 * (d1 + d2), A)
    for x, (ebond, evdwl, f1, f2, fy, dist, energy, force, virial) in zip(STRETCHES, rows):
        tension = formulas.truss_tension(x, modulus, m, normalized)
        # the stored length is rounded, which matters where the stretch is a small difference
        slack = 2e-15 * modulus * (1 + 1 / x)
        expected = formulas.truss_energy(x, length, modulus, m, normalized)
        # with the factor the energy is a table good to 1e-10
        assert ebond == pytest.approx(expected, rel=1e-10 if m else 1e-13, abs=1e-15 * modulus)
        assert energy == pytest.approx(ebond, rel=1e-13)
        assert evdwl == 0.0
        assert f1 == pytest.approx(tension, rel=1e-12, abs=slack)
        assert f2 == -f1 and fy == 0.0
        assert dist == pytest.approx(x * length, rel=1e-14)
        # LAMMPS's sign: repulsion is positive
        assert force == pytest.approx(-tension, rel=1e-12, abs=slack)
        assert virial == pytest.approx(-tension * x * length, rel=1e-12, abs=10 * slack)


def test_bond_dashpot(run_lammps):
    """2 xi sqrt(k mu) times the rate of stretch, along the bond only"""
    length, xi = 1.1, 0.3
    v1, v2 = np.array([0.4, 0.1, -0.2]), np.array([-0.3, 0.25, 0.6])
    script = pair_of(1.0, 1.4, length) + scripts.elastic(E, f"factor {A}", f"damping {xi}") + "potdem_bonds all 1 1.2\n"
    script += "velocity all set 0 0 0\n"
    for atom, v in ((1, v1), (2, v2)):
        script += f"group g{atom} id {atom}\nvelocity g{atom} set {v[0]} {v[1]} {v[2]}\n"
    script += outputs() + "run 0\n" + scripts.result("fx[1]", "fy[1]", "fz[1]", "fx[2]", "ebond")
    fx1, fy1, fz1, fx2, energy = scripts.results(run_lammps(script).stdout)[0]
    masses = formulas.sphere_mass(1.0), formulas.sphere_mass(1.4)
    stiffness = E * formulas.section(1.2, A) / length
    reduced = masses[0] * masses[1] / (masses[0] + masses[1])
    expected = 2 * xi * np.sqrt(stiffness * reduced) * (v2[0] - v1[0])
    # the elastic force is zero but for the rounding of the length, 1e-16 of the modulus
    assert fx1 == pytest.approx(expected, rel=1e-12, abs=1e-12)
    assert (fx2, fy1, fz1) == (-fx1, 0.0, 0.0)
    assert energy == pytest.approx(0.0, abs=1e-12)


def test_bond_dashpot_takes_the_energy_of_an_oscillator(run_lammps):
    """the logarithmic decrement of a lightly damped, nearly linear pair"""
    xi, strain = 0.05, 1e-5
    script = pair_of() + scripts.elastic(E, f"factor {A}", f"damping {xi}") + "potdem_bonds all 1 1.2\n"
    omega = np.sqrt(E * formulas.section(1.0, A) / (0.5 * formulas.sphere_mass(1.0)))
    period = 2 * np.pi / (omega * np.sqrt(1 - xi**2))
    script += f"displace_atoms all move 0 0 0\nset atom 2 x {1 + strain:.17g}\nfix 1 all nve\n"
    script += f"timestep {period / 2000:.17g}\n"
    script += outputs() + "run 4000\n" + scripts.result("x[2]-x[1]-1")
    left = scripts.results(run_lammps(script).stdout)[0][0]
    # two periods; the step's error is (2 pi/2000)^2 ~ 1e-5, that of the nonlinear strain 1e-5
    assert left / strain == pytest.approx(np.exp(-2 * 2 * np.pi * xi / np.sqrt(1 - xi**2)), rel=2e-4)


# --- contacts ----------------------------------------------------------------------------------------

@pytest.mark.parametrize("keyword, m, normalized", PENETRATION)
def test_contact_force_and_energy(run_lammps, keyword, m, normalized):
    d1, d2 = 1.0, 1.4
    mean = 0.5 * (d1 + d2)
    distances = [0.2, 0.8, 1.1999, 1.2, 1.3, 1.5]
    script = pair_of(d1, d2, 1.5) + f"pair_style potdem/truss\npair_coeff * * {E} {A} {keyword}\n" + outputs()
    script += "bond_style none\n"
    for r in distances:
        script += f"set atom 2 x {r:.17g}\nrun 0\n" + scripts.result("evdwl", "fx[1]", "fx[2]", "fy[1]", "pxx*vol")
    modulus = E * formulas.section(mean, A)
    for r, (energy, f1, f2, fy, virial) in zip(distances, scripts.results(run_lammps(script).stdout)):
        if r >= mean:
            assert (energy, f1, f2, virial) == (0.0, 0.0, 0.0, 0.0)
            continue
        push = -formulas.truss_tension(r / mean, modulus, m, normalized)
        slack = 2e-15 * modulus    # rounding of r/dbar where the strain is small
        assert f2 == pytest.approx(push, rel=1e-12, abs=slack)
        assert f1 == -f2 and fy == 0.0
        assert energy == pytest.approx(formulas.truss_energy(r / mean, mean, modulus, m, normalized),
                                       rel=1e-10 if m else 1e-12, abs=slack)
        assert virial == pytest.approx(push * r, rel=1e-12, abs=slack)


def test_contact_of_two_materials(run_lammps):
    """moduli in series, areas averaged"""
    E1, E2, a1, a2, r = 500.0, 4000.0, 0.4, 0.8, 0.9
    script = pair_of(1.0, 1.0, r, types=2) + "bond_style none\npair_style potdem/truss\n"
    script += f"pair_coeff 1 1 {E1} {a1}\npair_coeff 2 2 {E2} {a2}\n" + outputs() + "run 0\n" + scripts.result("fx[2]")
    force = scripts.results(run_lammps(script).stdout)[0][0]
    modulus = 2 / (1 / E1 + 1 / E2) * formulas.section(1.0, 0.5 * (a1 + a2))
    assert force == pytest.approx(-formulas.truss_tension(r, modulus), **EXACT)


def test_contact_through_single(run_lammps):
    """compute pair/local takes single(), the thermo output the loop"""
    script = pair_of(1.0, 1.4, 1.0)
    script += f"bond_style none\npair_style potdem/truss\npair_coeff * * {E} {A} penetration 2\n"
    script += "compute p all pair/local eng force\ncompute s all reduce sum c_p[1] c_p[2] inputs local\n"
    script += outputs("c_s[1]", "c_s[2]") + "run 0\n" + scripts.result("evdwl", "fx[2]", "c_s[1]", "c_s[2]")
    energy, force, local_energy, local_force = scripts.results(run_lammps(script).stdout)[0]
    assert local_energy == pytest.approx(energy, rel=1e-14)
    assert local_force == pytest.approx(force, rel=1e-14)


def sliding(run_lammps, friction, velocity, r=0.9, step=1e-4):
    """forces on both particles of an overlapping pair, the second moving"""
    v = " ".join(f"{k:.17g}" for k in velocity)
    script = pair_of(1.0, 1.0, r)
    script += f"bond_style none\npair_style potdem/truss\npair_coeff * * {E} {A} friction {friction}\n"
    script += f"velocity all set 0 0 0\ngroup two id 2\nvelocity two set {v}\ntimestep {step:.17g}\n" + outputs()
    script += "run 0\n" + scripts.result(*(f"f{k}[{i}]" for i in (1, 2) for k in "xyz"))
    row = scripts.results(run_lammps(script).stdout)[0]
    return row[:3], row[3:]


def normal_force(r=0.9):
    return -formulas.truss_tension(r, E * formulas.section(1.0, A))


@pytest.mark.parametrize("mu, eta, regime", [(0.4, 2.0, "viscous"), (0.4, 1e6, "Coulomb"), (0.0, 5.0, "none")])
def test_friction_force(run_lammps, mu, eta, regime):
    velocity = np.array([0.7, 0.3, -0.4])    # the first component is normal and takes no part
    first, second = sliding(run_lammps, f"{mu} {eta}", velocity)
    tangent, speed, push = velocity[1:], 0.5, normal_force()
    size = {"viscous": eta * speed, "Coulomb": mu * push, "none": 0.0}[regime]
    assert second[0] == pytest.approx(push, **EXACT)
    assert second[1:] == pytest.approx(-size * tangent / speed, **EXACT)
    assert first == pytest.approx(-second, rel=0, abs=0)


def test_friction_at_rest_is_exactly_zero(run_lammps):
    first, second = sliding(run_lammps, "0.4 auto", (0.2, 0.0, 0.0))
    assert (first[1], first[2], second[1], second[2]) == (0.0, 0.0, 0.0, 0.0)


def test_friction_auto(run_lammps):
    """viscosity = reduced mass / step, up to the Coulomb limit"""
    step, reduced = 1e-3, 0.5 * formulas.sphere_mass(1.0)
    slow = 0.5 * 0.4 * normal_force() * step / reduced
    for speed, size in ((slow, reduced / step * slow), (100 * slow, 0.4 * normal_force())):
        _, second = sliding(run_lammps, "0.4 auto", (0, speed, 0), step=step)
        assert second[1] == pytest.approx(-size, **EXACT)


def test_no_friction_without_contact(run_lammps):
    first, second = sliding(run_lammps, "0.4 5", (0, 1, 0), r=1.0)
    assert np.all(first == 0.0) and np.all(second == 0.0)


# --- walls -------------------------------------------------------------------------------------------

WALL_E, WALL_NU, NU = 3e4, 0.25, 0.3
RADIUS = 0.5


def wall_force(height, gamma_over_r=0.1, m=2.0):
    """eqs 5.26 and 5.28 for a sphere whose centre is `height` over a plane"""
    gamma = gamma_over_r * RADIUS
    w = max(0.0, RADIUS + gamma - height)
    modulus = 1 / ((1 - NU**2) / E + (1 - WALL_NU**2) / WALL_E)
    chi = min(1.0, (w / gamma) ** (1 / m)) if gamma else 1.0
    return 4 / 3 * modulus * np.sqrt(RADIUS) * w**1.5 * chi


def wall_energy(height, gamma_over_r=0.1, m=2.0):
    """the work of wall_force on the way in, by Gauss-Legendre quadrature, the layer's edge between two pieces.
    With w = t^4 (or its like for the layer's exponent) the integrand is smooth."""
    nodes, weights = np.polynomial.legendre.leggauss(60)
    start, edge = RADIUS * (1 + gamma_over_r), RADIUS
    total = 0.0
    for top, bottom in ((start, max(height, edge)), (min(edge, start), height)):
        if bottom >= top:
            continue
        t = 0.5 * (nodes + 1.0)
        h = top - (top - bottom) * t**12
        total += 0.5 * np.sum(weights * 12 * t**11 * (top - bottom) * [wall_force(k, gamma_over_r, m) for k in h])
    return total


def on_wall(height, velocity=(0, 0, 0), options="", region="plane 0 0 0 0 0 1", step=1e-4, shift="0.0", lines=""):
    """one particle over the plane z = 0 (at x = 0.3, y = -0.2), and what the wall and the particle feel"""
    v = " ".join(f"{k:.17g}" for k in velocity)
    return scripts.box(20) + scripts.particles([(0.3, -0.2, height, 2 * RADIUS)]) + f"""
pair_style none
velocity all set {v}
timestep {step:.17g}
variable shift equal {shift}
region floor {region}
fix wall all potdem/wall/region floor {WALL_E} {WALL_NU} particle {E} {NU} {options}
fix_modify wall energy yes virial yes
thermo_style custom step pe pzz vol f_wall f_wall[1] f_wall[2] f_wall[3] f_wall[4] f_wall[5] f_wall[6]
thermo_modify format float {scripts.ALL_DIGITS}
{lines}
"""


WALL_RESULT = scripts.result("fx[1]", "fy[1]", "fz[1]", "f_wall", *(f"f_wall[{k}]" for k in range(1, 7)))


@pytest.mark.parametrize("options, gamma, m", [("", 0.1, 2.0), ("layer 0.2 3", 0.2, 3.0), ("layer none", 0.0, 2.0)])
def test_wall_force_and_energy(run_lammps, options, gamma, m):
    heights = [0.1, 0.4, 0.49, 0.505, 0.53, 0.56, 0.7]
    script = on_wall(heights[0], options=options)
    for z in heights:
        script += f"set atom 1 z {z:.17g}\nrun 0\n" + WALL_RESULT + scripts.result("pe", "0", "pzz*vol")
    rows = scripts.results_by_length(run_lammps(script).stdout)
    for z, row, (pe, _, virial) in zip(heights, rows[10], rows[3]):
        force = wall_force(z, gamma, m)
        # w is a difference of lengths near 0.5: 1e-16/w relative
        slack = dict(rel=1e-13, abs=1e-12)
        assert row[:3] == pytest.approx([0, 0, force], **slack)
        assert row[3] == pytest.approx(wall_energy(z, gamma, m), rel=1e-11, abs=1e-12)
        assert pe == pytest.approx(row[3], rel=1e-13, abs=1e-13)
        assert row[4:7] == pytest.approx(-row[:3], rel=0, abs=0)
        # the reaction acts at the foot of the particle, (0.3, -0.2, 0)
        assert row[7:] == pytest.approx(np.cross([0.3, -0.2, 0.0], row[4:7]), **slack)
        assert virial == pytest.approx(force * z, **slack)


def wall_run(run_lammps, *args, **kwargs):
    row = scripts.results(run_lammps(on_wall(*args, **kwargs) + "run 0\n" + WALL_RESULT).stdout)[0]
    return row[:3], row[4:7], row[7:]


@pytest.mark.parametrize("speed, floor", [(-0.3, False), (0.2, False), (50.0, True)])
def test_wall_viscous(run_lammps, speed, floor):
    """T (1 + H wdot / w), not below zero"""
    height, H = 0.45, 0.05
    force, _, _ = wall_run(run_lammps, height, (0, 0, speed), f"viscous {H}")
    w = 1.1 * RADIUS - height
    expected = wall_force(height) * (1 - H * speed / w)
    assert (expected < 0) == floor
    assert force[2] == pytest.approx(max(0.0, expected), **EXACT)
    assert np.all(force[:2] == 0.0)


@pytest.mark.parametrize("eta", ["3.0", "1e7"])
def test_wall_friction(run_lammps, eta):
    velocity = np.array([0.3, -0.4, -0.6])
    force, reaction, torque = wall_run(run_lammps, 0.45, velocity, f"friction 0.35 {eta}")
    size = min(float(eta) * 0.5, 0.35 * wall_force(0.45))
    assert force == pytest.approx([-size * 0.6, size * 0.8, wall_force(0.45)], **EXACT)
    assert reaction == pytest.approx(-force, rel=0, abs=0)
    assert torque == pytest.approx(np.cross([0.3, -0.2, 0.0], reaction), **EXACT)


def test_wall_friction_auto(run_lammps):
    """mass / step; one explicit step stops the sliding and does not reverse it"""
    step, mass = 1e-3, formulas.sphere_mass(1.0)
    slow = 0.3 * 0.35 * wall_force(0.45) * step / mass
    force, _, _ = wall_run(run_lammps, 0.45, (slow, 0, 0), "friction 0.35 auto", step=step)
    assert force[0] == pytest.approx(-mass * slow / step, **EXACT)
    assert wall_run(run_lammps, 0.45, (0, 0, -1), "friction 0.35 auto")[0][0] == 0.0


def test_wall_friction_of_a_moving_wall(run_lammps):
    """the wall slides below a particle at rest: what counts is the relative velocity"""
    # LAMMPS takes a region's velocity from its last two places: it needs a step. The particle stays put.
    script = on_wall(0.45, options="friction 0.35 3.0", region="plane 0 0 0 0 0 1 move v_shift NULL NULL", step=1e-3,
                     shift="0.7*time", lines="run 2\n" + WALL_RESULT)
    row = scripts.results(run_lammps(script).stdout)[0]
    assert row[:3] == pytest.approx([min(3.0 * 0.7, 0.35 * wall_force(0.45)), 0.0, wall_force(0.45)], rel=1e-9)


def test_wall_moving_towards_the_particle(run_lammps):
    """viscous term: the approach of the wall counts as that of the particle"""
    script = on_wall(0.45, options="viscous 0.05", region="plane 0 0 0 0 0 1 move NULL NULL v_shift", step=1e-3,
                     shift="0.2*time", lines="run 2\n" + WALL_RESULT)
    row = scripts.results(run_lammps(script).stdout)[0]
    height = 0.45 - 0.2 * 2e-3
    w = 1.1 * RADIUS - height
    assert row[2] == pytest.approx(wall_force(height) * (1 + 0.05 * 0.2 / w), rel=1e-9)


def test_wall_inside_a_sphere(run_lammps):
    """a curved wall: the normal points to the centre"""
    centre = np.array([0.3, -0.2, 3.45])    # the particle is at distance 3 from it, the wall at 3.45 below
    force, reaction, torque = wall_run(run_lammps, 0.45, region=f"sphere {centre[0]} {centre[1]} {centre[2]} 3.45")
    assert force == pytest.approx([0, 0, wall_force(0.45)], **EXACT)
    assert torque == pytest.approx(np.cross([0.3, -0.2, 0.0], reaction), **EXACT)


def test_wall_in_a_corner(run_lammps):
    """a block region has a wall on each side: the forces of three faces at once"""
    sides = (0.45, 0.48, 0.5)
    x, y, z = 0.3 - sides[0], -0.2 - sides[1], 0.45 - sides[2]
    force, reaction, torque = wall_run(run_lammps, 0.45, region=f"block {x} 9 {y} 9 {z} 9")
    expected = np.array([wall_force(side) for side in sides])
    assert force == pytest.approx(expected, rel=1e-12)
    feet = np.array([(x, -0.2, 0.45), (0.3, y, 0.45), (0.3, -0.2, z)])
    assert torque == pytest.approx(np.cross(feet, -np.diag(expected)).sum(axis=0), rel=1e-11)


def test_wall_of_a_rotating_drum(run_lammps):
    """the surface under the particle moves with omega x foot"""
    omega, eta = 0.5, 0.01
    script = on_wall(0.45, options=f"friction 0.35 {eta}",
                     region="cylinder y 0.3 3.0 3.0 INF INF rotate v_shift 0.3 0 3.0 0 1 0",
                     step=1e-3, shift=f"{omega}*time", lines="run 2\n" + WALL_RESULT)
    row = scripts.results(run_lammps(script).stdout)[0]
    velocity = np.cross([0, omega, 0], [0, 0, -3.0])
    # the velocity is a difference over a step: 1e-3 of a turn by 0.5, and its rounding 1e-13
    assert row[:3] == pytest.approx(eta * velocity + [0, 0, wall_force(0.45)], rel=1e-6, abs=1e-6)


def test_wall_reaction_adds_up_over_particles_and_ranks(run_lammps):
    places = [(x, y, 0.4 + 0.01 * (x + y), 1.0) for x in (-6.0, 0.5, 6.0) for y in (-3.0, 4.0)]
    script = on_wall(0.45, options="friction 0.3 2.0")
    script = replaced(script, scripts.particles([(0.3, -0.2, 0.45, 1.0)]), scripts.particles(places))
    script += "velocity all set 0.2 0.1 0\nrun 0\n" + scripts.write_dump("f.dump", "x y z fx fy fz") + scripts.result(
        "f_wall", *(f"f_wall[{k}]" for k in range(1, 7)))
    for nprocs in (1, 4):
        run = run_lammps(script, nprocs=nprocs)
        row = scripts.results(run.stdout)[0]
        expected = np.array([wall_force(z) for _, _, z, _ in places])
        forces = np.stack([np.minimum(2.0 * 0.2236, 0.3 * expected), 0 * expected, expected], axis=1)
        assert row[3] == pytest.approx(-forces[:, 2].sum(), rel=1e-12)
        assert row[0] == pytest.approx(sum(wall_energy(z) for _, _, z, _ in places), rel=1e-11)
        feet = np.array([(x, y, 0) for x, y, _, _ in places])
        torque = np.cross(feet, -forces).sum(axis=0)[:2]
        assert row[4:6] == pytest.approx(torque, rel=1e-12, abs=1e-10)
