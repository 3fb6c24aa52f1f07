# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""compute potdem/timestep against eigenvalues of the whole system, and against the step at which a run blows up."""

from itertools import product

import numpy as np
import pytest
from scipy.linalg import eigh

from potdem import dumps, formulas, lattices, scripts
from potdem.lattices import CRITICAL_STEPS
from potdem.pair_laws import Granular, Hertz, ShiftedLJ, Truss
from potdem.text import replaced

# sums of the same numbers in another order
SAME = 1e-10


def critical(run_lammps, script, **options):
    """stable step, the same without viscosity, sqrt(m/K), particle"""
    return scripts.results(run_lammps(script + scripts.CRITICAL_STEP, **options).stdout)[-1]


# --- lattices --------------------------------------------------------------------------------------------

@pytest.mark.parametrize("kind, reach, exact, rule", CRITICAL_STEPS)
def test_lattices(run_lammps, kind, reach, exact, rule):
    script, mass = scripts.periodic_crystal(kind, reach), lattices.volume(kind)
    step, elastic, stiffest, _ = critical(run_lammps, script)
    # the section that gives E = 1, from the rule's column: the stiffest bond is the shortest one
    rest = lattices.shells(kind, reach)[0].min()
    modulus = mass * rest / stiffest**2
    frequency2 = lattices.largest_frequency2(kind, reach, mass, modulus)
    # the table has three digits
    assert stiffest == pytest.approx(rule, abs=6e-4)
    assert 2 / np.sqrt(frequency2) == pytest.approx(exact, abs=6e-4)
    assert 0.85 * 2 / np.sqrt(frequency2) < step < 2 / np.sqrt(frequency2) * (1 + SAME)
    assert step == elastic


@pytest.mark.parametrize("strain", [-0.1, 0.1, 0.4])
def test_strained_lattices(run_lammps, strain):
    """what a stretched bond carries makes it stiff across, too: without that part the bound would be too long"""
    missed = []
    for kind, reach, *_ in CRITICAL_STEPS:
        script, mass = scripts.periodic_crystal(kind, reach, strain), lattices.volume(kind)
        step, _, stiffest, _ = critical(run_lammps, script)
        rest = lattices.shells(kind, reach)[0].min()
        modulus = mass * rest / stiffest**2 / (1 + strain)
        exact = 2 / np.sqrt(lattices.largest_frequency2(kind, reach, mass, modulus, strain))
        assert 0.75 * exact < step < exact * (1 + SAME), (kind, reach)
        lengths, n = lattices.shells(kind, reach)
        along = modulus * (1 + strain) * np.einsum("bi,bj,b->ij", n, n, 1 / lengths)
        missed.append(2 / np.sqrt(2 * np.linalg.eigvalsh(along)[-1] / mass) > 1.001 * exact)
    assert any(missed) == (strain > 0)


# --- any system of springs -------------------------------------------------------------------------------

class Springs:
    """the linearised system, written down a second time: (i, j, n, along, across), j = None for a wall"""

    def __init__(self, masses):
        self.masses = np.asarray(masses)
        self.list = []

    def add(self, i, j, n, along, across):
        self.list.append((i, j, np.asarray(n), along, across))

    @property
    def exact(self):
        """2 over the largest frequency"""
        size = len(self.masses)
        K = np.zeros((size, 3, size, 3))
        for i, j, n, along, across in self.list:
            H = along * np.outer(n, n) + across * (np.eye(3) - np.outer(n, n))
            K[i, :, i, :] += H
            if j is not None:
                K[j, :, j, :] += H
                K[i, :, j, :] -= H
                K[j, :, i, :] -= H
        K = K.reshape(3 * size, 3 * size)
        return 2 / np.sqrt(eigh(K, np.diag(np.repeat(self.masses, 3)), eigvals_only=True)[-1])

    @property
    def bound(self):
        """particle by particle, the masses of its partners as in potdem_stiffness.h; and the particle, from 1"""
        S = np.zeros((len(self.masses), 3, 3))
        for i, j, n, along, across in self.list:
            H = max(0, along) * np.outer(n, n) + max(0, across) * (np.eye(3) - np.outer(n, n))
            if j is None:
                S[i] += H / self.masses[i]
            else:
                both = 1 / np.sqrt(self.masses[i] * self.masses[j])
                S[i] += H * (1 / self.masses[i] + both)
                S[j] += H * (1 / self.masses[j] + both)
        frequency2 = np.linalg.eigvalsh(S)[:, -1]
        return 2 / np.sqrt(frequency2.max()), frequency2.argmax() + 1

    @property
    def rule(self):
        return min(np.sqrt(self.masses[k] / along) for i, j, _, along, _ in self.list for k in (i, j)
                   if k is not None and along > 0)


def slope(force, r):
    """-dF/dr by central differences; their error is of order 1e-10"""
    h = 1e-4 * r
    return -(8 * (force(r + h) - force(r - h)) - (force(r + 2 * h) - force(r - 2 * h))) / (12 * h)


# central differences
BY_DIFFERENCES = 1e-7


def check(run_lammps, script, springs, tolerance, **options):
    step, elastic, stiffest, particle = critical(run_lammps, script, **options)
    bound, first = springs.bound
    assert step == elastic == pytest.approx(bound, rel=tolerance)
    assert particle == first
    assert stiffest == pytest.approx(springs.rule, rel=tolerance)
    assert 0.65 * springs.exact < step < springs.exact * (1 + tolerance)
    return step, springs.exact


def random_body(penetration=0, shaken=0.12):
    """a loose lump with free surfaces, of particles that differ, bonded at rest and then shaken: script and springs"""
    random = np.random.default_rng(5)
    sites = np.array(list(product(range(4), repeat=3)), dtype=float)
    sites = sites[random.random(len(sites)) < 0.8]
    size = len(sites)
    rest = 1.05 * sites + random.uniform(-0.1, 0.1, sites.shape)
    now = rest + shaken * random.uniform(-1, 1, sites.shape)
    diameters = random.uniform(0.8, 1.2, size)
    masses = random.uniform(0.5, 2.0, size)
    reach, E, a, contact = 1.7, 300.0, 0.6, 0.4
    script = scripts.box(20) + scripts.particles([(*p, d) for p, d in zip(rest, diameters)])
    script += "".join(f"set atom {k} mass {m:.17g}\n" for k, m in enumerate(masses, 1))
    options = f"penetration {penetration}" if penetration else ""
    script += scripts.elastic(E, f"factor {a}", options, contact, options) + f"potdem_bonds all 1 {reach}\nrun 0\n"
    script += "".join(f"set atom {k} x {p[0]:.17g} y {p[1]:.17g} z {p[2]:.17g}\n" for k, p in enumerate(now, 1))
    springs = Springs(masses)
    for i in range(size):
        for j in range(i):
            length, r = np.linalg.norm(rest[i] - rest[j]), np.linalg.norm(now[i] - now[j])
            mean = 0.5 * (diameters[i] + diameters[j])
            bonded = length < reach
            if not bonded and r >= mean:
                continue
            modulus = E * formulas.section(mean, a if bonded else contact)
            unstretched = length if bonded else mean

            def force(r, modulus=modulus, unstretched=unstretched):
                return -formulas.truss_tension(r / unstretched, modulus, penetration)

            springs.add(i, j, (now[i] - now[j]) / r, slope(force, r), -force(r) / r)
    return script, springs


@pytest.mark.parametrize("penetration", [0, 3])
def test_random_body(run_lammps, penetration):
    check(run_lammps, *random_body(penetration), BY_DIFFERENCES)


LAWS = [Hertz(3e4, 0.3), Truss(2e4, 0.5), ShiftedLJ(2e4, 0.35, 3, 0.45), Granular(2e4, 3, 0.4)]
WALL_E, WALL_NU, WALL_LAYER = 5e5, 0.25, 0.1
HALF = 1.47


def wall_force(law, distance, radius):
    """eq. 5.26 with the soft layer of 5.28; any law takes the wall's particle for one of the laws' Hertz material"""
    w = (1 + WALL_LAYER) * radius - distance
    K = 4 / 3 * Hertz.mixed(law, Hertz(WALL_E, WALL_NU)).modulus * np.sqrt(radius)
    return K * w**1.5 * min(1.0, np.sqrt(w / (WALL_LAYER * radius))) if w > 0 else 0.0


MATERIAL = Hertz(4e5, 0.3)    # of the grains at the walls
DIAMETERS = np.random.default_rng(9).uniform(1.0, 1.15, 27)
BALL = np.array([0, 0, -HALF - 5])    # centre of a ball of radius 5 below the heap


def heap(law, wall=True):
    """overlapping grains in a box whose six faces they touch, on top of a ball: script and places"""
    grid = np.array(list(product((-1, 0, 1), repeat=3)), dtype=float)
    x = 0.95 * grid + np.random.default_rng(4).uniform(-0.05, 0.05, grid.shape)
    script = scripts.box(12) + "bond_style none\n" + scripts.particles([(*p, d) for p, d in zip(x, DIAMETERS)])
    script += f"pair_style {law.style}\npair_coeff * * {law.coeff}\n"
    if wall:
        hertz = f"{WALL_E} {WALL_NU} particle {MATERIAL.E} {MATERIAL.nu}"
        script += f"""region inside block {-HALF} {HALF} {-HALF} {HALF} {-HALF} {HALF}
region below sphere 0 0 {BALL[2]} 5 side out
fix box all potdem/wall/region inside {hertz}
fix ball all potdem/wall/region below {hertz}
"""
    return script, x


def heap_springs(law, x, wall=True):
    springs = Springs([formulas.sphere_mass(d) for d in DIAMETERS])
    for i in range(len(x)):
        for j in range(i):
            r = np.linalg.norm(x[i] - x[j])
            if r >= law.reach(0.5 * (DIAMETERS[i] + DIAMETERS[j])):
                continue

            def force(r, i=i, j=j):
                return law(r, DIAMETERS[i], DIAMETERS[j])[1]

            springs.add(i, j, (x[i] - x[j]) / r, slope(force, r), -force(r) / r)
    for i, place in enumerate(x if wall else []):

        def push(distance, radius=0.5 * DIAMETERS[i]):
            return wall_force(MATERIAL, distance, radius)

        for n in np.vstack([np.eye(3), -np.eye(3)]):
            distance = HALF + place @ n
            if push(distance) > 0:
                springs.add(i, None, n, slope(push, distance), 0.0)
        centre = np.linalg.norm(place - BALL)
        if push(centre - 5) > 0:
            springs.add(i, None, (place - BALL) / centre, slope(push, centre - 5), -push(centre - 5) / centre)
    return springs


@pytest.mark.parametrize("wall", [False, True])
@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.style)
def test_heap(run_lammps, law, wall):
    script, x = heap(law, wall)
    springs = heap_springs(law, x, wall)
    assert sum(j is None for _, j, *_ in springs.list) == (57 if wall else 0)
    check(run_lammps, script, springs, BY_DIFFERENCES)


# --- stable below, unstable above ------------------------------------------------------------------------

TREMBLE = scripts.velocities_by_formula(1e-9)


def growth(run_lammps, script, step, steps):
    """of the kinetic energy of a tremble, which is no motion worth the name"""
    script += TREMBLE + f"""
timestep {step:.17g}
fix watch all print 1 "RESULT $(ke:%.17g)"
run {steps}
"""
    energy = scripts.results(run_lammps(script).stdout)[:, 0]
    return energy.max() / energy[0]


# A mode at the fraction f of its own critical step swings with up to 1/(1 - f^2) of the energy; of the last mode
# at 0.98 that is 25. Beyond the critical step it grows by 2.4 per step at 1.1 times that, energy by 6
CALM = 30.0
BLOWN_UP = 1e6


def is_stable_up_to(run_lammps, script, step, exact):
    assert growth(run_lammps, script, 0.98 * step, 1500) < CALM
    assert growth(run_lammps, script, 1.1 * exact, 18) > BLOWN_UP


@pytest.mark.parametrize("kind, reach, exact, rule", CRITICAL_STEPS[2:6:3])
def test_stability_of_a_lattice(run_lammps, kind, reach, exact, rule):
    script = scripts.periodic_crystal(kind, reach)
    script += "fix move all nve\n"
    step = critical(run_lammps, script)[0]
    is_stable_up_to(run_lammps, script, step, exact)


def test_stability_of_a_random_body(run_lammps):
    script, springs = random_body(shaken=0.0)
    script += "fix move all nve\n"
    is_stable_up_to(run_lammps, script, critical(run_lammps, script)[0], springs.exact)


def squeezed(law):
    """the heap, settled between its walls"""
    return heap(law)[0] + """fix move all nve
fix calm all potdem/damping 0.7
fix pace all potdem/timestep 10 0.5 max 1
run 60000
unfix calm
unfix pace
velocity all set 0 0 0
"""


@pytest.mark.parametrize("law", LAWS[:2], ids=lambda law: law.style)
def test_stability_of_a_heap(run_lammps, tmp_path, law):
    script = squeezed(law)
    places = scripts.write_dump("settled.dump", "x y z")
    step = critical(run_lammps, script + places)[0]
    columns = dumps.read(tmp_path / "settled.dump")[-1]
    exact = heap_springs(law, scripts.vectors(columns, "x", "y", "z")).exact
    assert 0.8 * exact < step < exact * (1 + BY_DIFFERENCES)
    is_stable_up_to(run_lammps, script, step, exact)


# --- damping ---------------------------------------------------------------------------------------------

def two(bond="", more="", masses=(1.0, 1.0)):
    """two bonded particles"""
    script = scripts.box(20) + scripts.particles([(0, 0, 0, 1.0), (1.0, 0, 0, 1.0)])
    script += f"set atom 1 mass {masses[0]}\nset atom 2 mass {masses[1]}\n"
    return script + scripts.elastic(E=1.0, area="factor 1.0", bond=bond) + f"potdem_bonds all 1 1.2\nfix move all nve\n{more}\n"


def two_step(masses=(1.0, 1.0)):
    """2/omega of them"""
    return 2 / np.sqrt(formulas.section(1.0) * (1 / masses[0] + 1 / masses[1]))


# steps in which a tremble grows beyond doubt: the more damping, the slower
@pytest.mark.parametrize("xi, steps", [(0.0, 100), (0.2, 200), (0.8, 600), (3.0, 2000)])
def test_dashpots(run_lammps, xi, steps):
    """eq. 5.34 with sqrt(1 + xi^2): as printed, with sqrt(1 - xi^2), no step would be stable beyond xi = 0.71"""
    step = two_step() * (np.sqrt(1 + xi**2) - xi)
    script = two(f"damping {xi}")
    stable, elastic, _, _ = critical(run_lammps, script)
    assert stable == pytest.approx(step, rel=SAME)
    assert elastic == pytest.approx(two_step(), rel=SAME)
    assert growth(run_lammps, script, 0.99 * step, 1500) < 1 / (1 - 0.99**2)
    assert growth(run_lammps, script, 1.01 * step, steps) > BLOWN_UP


@pytest.mark.parametrize("strength", [0.1, 0.8])
def test_numerical_damping(run_lammps, strength):
    """against the motion the force is 1 + lambda times as large, and a mode at its critical step turns every step"""
    step = two_step() / np.sqrt(1 + strength)
    script = two(more=f"fix damp all potdem/damping {strength}")
    assert critical(run_lammps, script)[0] == pytest.approx(step, rel=SAME)
    assert growth(run_lammps, script, 0.99 * step, 1500) < CALM
    assert growth(run_lammps, script, 1.01 * step, 100) > BLOWN_UP


@pytest.mark.parametrize("ratio", [1.0, 10.0, 1e6])
def test_a_light_particle_at_a_heavy_one(run_lammps, ratio):
    """exact for equal masses, and for very different ones; in between 10 % below"""
    step, *_, particle = critical(run_lammps, two(masses=(ratio, 1.0)))
    assert step == pytest.approx(2 / np.sqrt(formulas.section(1.0) * (1 + 1 / np.sqrt(ratio))), rel=SAME)
    assert 0.9 * two_step((ratio, 1.0)) < step <= two_step((ratio, 1.0)) * (1 + SAME)
    assert particle == (1 if ratio == 1.0 else 2)


@pytest.mark.parametrize("rotation", ["no", "yes"])
def test_viscous_contact_with_friction(run_lammps, rotation):
    """two spheres: the largest eigenvalue of either matrix, although the two have different directions"""
    law, w, H, eta = Hertz(1e3, 0.3), 0.1, 0.05, 10.0
    script = scripts.box(20) + "bond_style none\n" + scripts.particles([(0, 0, 0, 1.0), (1.0 - w, 0, 0, 1.0)])
    script += f"pair_style potdem/hertz rotation {rotation}\n"
    script += f"pair_coeff * * {law.coeff} viscous {H} friction 0.3 "
    prefactor, mass = law.prefactor(1.0, 1.0), formulas.sphere_mass(1.0)
    k = 2 * 1.5 * prefactor * np.sqrt(w) / mass
    along = 2 * prefactor * H * np.sqrt(w) / mass
    # a sphere that may spin gives way at its surface: 1/m + arm^2/I, arm from the centre to the contact
    across = 2 * eta / mass * (1 + (1 - w)**2 / 0.4 if rotation == "yes" else 1)

    def expected(c):
        return (-c + np.sqrt(c * c + 4 * k)) / k    # step^2 k + 2 step c = 4

    assert across > along
    stable, elastic, _, _ = critical(run_lammps, script + f"{eta}\n")
    assert stable == pytest.approx(expected(across), rel=SAME)
    assert elastic == pytest.approx(2 / np.sqrt(k), rel=SAME)
    # 'auto' follows the step
    assert critical(run_lammps, script + "auto\n")[0] == pytest.approx(expected(along), rel=SAME)


def test_viscous_wall_with_friction(run_lammps):
    law, w, H, eta = Hertz(1e3, 0.3), 0.1, 0.05, 10.0
    script = scripts.box(20) + "bond_style none\npair_style none\n" + scripts.particles([(0, 0, 0.5 - w, 1.0)])
    script += "region floor plane 0 0 0 0 0 1\n"
    script += f"fix floor all potdem/wall/region floor 1e3 0.3 particle 1e3 0.3 layer none viscous {H} friction 0.3 "
    prefactor, mass = 4 / 3 * law.modulus * np.sqrt(0.5), formulas.sphere_mass(1.0)
    k = 1.5 * prefactor * np.sqrt(w) / mass
    for friction, c in (("auto", prefactor * H * np.sqrt(w) / mass), (eta, eta / mass)):
        stable, elastic, stiffest, particle = critical(run_lammps, script + f"{friction}\n")
        assert stable == pytest.approx((-c + np.sqrt(c * c + 4 * k)) / k, rel=SAME)
        # a wall does not move: the rule's sqrt(m/K) is half the critical step
        assert elastic == pytest.approx(2 / np.sqrt(k), rel=SAME) == 2 * stiffest
        assert particle == 1


# --- who counts ------------------------------------------------------------------------------------------

def test_partners_outside_the_group_count(run_lammps):
    """a light free particle between two held ones that are not in the group"""
    script = scripts.box(20) + scripts.particles([(0, 0, 0, 1.0), (1.0, 0, 0, 1.0), (2.0, 0, 0, 1.0)])
    script += "set atom 2 mass 1.0\nset atom 1 mass 1.0\nset atom 3 mass 1.0\n"
    script += scripts.elastic(E=1.0, area="factor 1.0") + "potdem_bonds all 1 1.2\ngroup free id 1 2\ngroup ends id 1 3\n"
    script = script + scripts.CRITICAL_STEP
    for group, springs in (("free", 2), ("ends", 1)):
        run = run_lammps(replaced(script, "compute critical all", f"compute critical {group}"))
        step, *_, particle = scripts.results(run.stdout)[-1]
        assert step == pytest.approx(2 / np.sqrt(2 * springs * formulas.section(1.0)), rel=SAME)
        assert particle == (2 if group == "free" else 1)


def test_nothing_stiff(run_lammps):
    script = scripts.box(20) + "bond_style none\n" + scripts.particles([(0, 0, 0, 1.0), (1.5, 0, 0, 1.0)])
    script += "pair_style potdem/hertz\npair_coeff * * 1e3 0.3\n"
    assert tuple(critical(run_lammps, script)) == (np.inf, np.inf, np.inf, 0)


# --- collisions to come ----------------------------------------------------------------------------------

def approach(gap, speed, wall):
    """a sphere and its partner, another one or a wall, `gap` apart"""
    rows = [(0, 0, 0, 1.0)] + ([] if wall else [(1 + gap, 0, 0, 1.0)])
    script = scripts.box(20) + "bond_style none\n" + scripts.particles(rows) + "group first id 1\n"
    script += f"pair_style potdem/hertz\npair_coeff * * 1e3 0.3\nvelocity first set {speed} 0 0\n"
    if wall:
        script += f"region wall plane {0.5 + gap} 0 0 -1 0 0\n"
        script += "fix wall all potdem/wall/region wall 1e3 0.3 particle 1e3 0.3 layer none\n"
    return script + "neighbor 1.0 bin\n"


@pytest.mark.parametrize("wall", [False, True])
def test_ahead(run_lammps, wall):
    """approaching partners count as stiff as they will be at the largest overlap: 2/5 K w^(5/2) = m v^2/2"""
    speed, mass = 0.7, formulas.sphere_mass(1.0)
    prefactor = 4 / 3 * Hertz(1e3, 0.3).modulus * np.sqrt(0.5 if wall else 0.25)
    moving, share = (mass, 1) if wall else (mass / 2, 2)
    w = (1.25 * moving * speed**2 / prefactor)**0.4
    expected = 2 / np.sqrt(share * 1.5 * prefactor * np.sqrt(w) / mass)

    def ahead(gap, u, time):
        script = approach(gap, u, wall) + replaced(scripts.CRITICAL_STEP, "timestep\n", f"timestep ahead {time}\n")
        return scripts.results(run_lammps(script).stdout)[-1][0]

    # to a tenth of the energy: overlap to its 2/5, step to a quarter of that, 1 %
    for gap in (0.5, 0.01, -0.2 * w):
        more = (max(gap, 0) + 0.01) / speed
        assert ahead(gap, speed, more) == pytest.approx(expected, rel=0.02)
    assert ahead(0.5, speed, 0.49 / speed) == np.inf    # not within that time
    assert ahead(0.5, -speed, 10) == np.inf             # they part
    assert ahead(0.5, speed, 0) == np.inf
    # at rest there is nothing to come
    static = 2 / np.sqrt(share * 1.5 * prefactor * np.sqrt(0.1) / mass)
    assert ahead(-0.1, 0.0, 10) == pytest.approx(static, rel=SAME)
    assert ahead(-0.1, 1e-12, 10) == pytest.approx(static, rel=1e-6)


# --- ranks, threads, hybrid ------------------------------------------------------------------------------

def everything(newton="on off"):
    """two bonded bodies pressed on each other and on a wall, dashpots, friction: contacts across all ranks"""
    script = scripts.box(8, "p p f", newton=newton) + "region body block -4 4 -4 4 -3 3\n" + scripts.crystal(
        spacing=1.0, region="body", diameter=1.05)
    script += "region low block INF INF INF INF INF 0\ngroup low region low\ngroup high subtract all low\n"
    script += """pair_style potdem/truss
pair_coeff * * 1000 0.5 friction 0.2 0.1
bond_style potdem/truss
bond_coeff 1 1000 area lattice damping 0.05
potdem_bonds low 1 1.5
potdem_bonds high 1 1.5
displace_atoms all random 0.03 0.03 0.03 567
region floor plane 0 0 -2.8 0 0 1
fix floor all potdem/wall/region floor 1e5 0.3 particle 1000 0.3
"""
    return script


def test_same_on_any_number_of_ranks_and_threads(run_lammps):
    """the particle is looked at by its place: LAMMPS numbers them differently on different numbers of ranks"""
    tail = scripts.result("c_critical", "c_critical[1]", "c_critical[2]")
    tail += 'variable p equal c_critical[3]\nprint "RESULT $(x[v_p]:%.9g) $(y[v_p]:%.9g) $(z[v_p]:%.9g) 0 0"\n'
    script = everything() + scripts.CRITICAL_STEP.split("RESULT")[0].rsplit("print", 1)[0] + tail

    def values(text, nprocs):
        kinds = scripts.results_by_length(run_lammps(text, nprocs=nprocs).stdout)
        return np.concatenate([kinds[3][0], kinds[5][0]])

    one = values(script, 1)
    assert one[0] < one[1] < one[2]
    for nprocs in (2, 4):
        assert values(script, nprocs) == pytest.approx(one, rel=SAME)
    for newton in ("off off",):
        for nprocs in (1, 4):
            other = everything(newton) + script[len(everything()):]
            assert values(other, nprocs) == pytest.approx(one, rel=SAME)
    assert values("package omp 2\nsuffix omp\n" + script, 2) == pytest.approx(one, rel=SAME)


def test_hybrid_styles_add_up(run_lammps):
    """one pair under two laws, in one style each and overlaid; a style of LAMMPS's own is named in a warning"""
    hertz, truss = Hertz(1e3, 0.3), Truss(2e3, 0.5)
    script = scripts.box(20, types=2) + "bond_style none\n"
    script += scripts.particles([(0, 0, 0, 1.0, 1), (0.9, 0, 0, 1.0, 2), (0, 5, 0, 1.0, 1), (0, 5.9, 0, 1.0, 1)])

    def step(*laws):
        stiffness = sum(slope(lambda r: law(r, 1.0, 1.0)[1], 0.9) for law in laws)
        return 2 / np.sqrt(2 * stiffness / formulas.sphere_mass(1.0))

    overlay = f"""pair_style hybrid/overlay potdem/hertz potdem/truss
pair_coeff * * potdem/hertz {hertz.coeff}
pair_coeff 1 1 potdem/truss {truss.coeff}
"""
    assert critical(run_lammps, script + overlay)[0] == pytest.approx(step(hertz, truss), rel=BY_DIFFERENCES)
    hybrid = f"""pair_style hybrid potdem/hertz potdem/truss lj/cut 2.5
pair_coeff 1 1 potdem/hertz {hertz.coeff}
pair_coeff 1 2 potdem/truss {truss.coeff}
pair_coeff 2 2 lj/cut 1 1
"""
    run = run_lammps(script + hybrid + scripts.CRITICAL_STEP)
    assert scripts.results(run.stdout)[-1][0] == pytest.approx(min(step(hertz), step(truss)), rel=BY_DIFFERENCES)
    assert "does not know the stiffness of pair_style lj/cut" in run.stdout
    assert "potdem/truss" not in run.stdout.split("does not know")[1].splitlines()[0]
