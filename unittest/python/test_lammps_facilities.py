# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""What users of LAMMPS expect of any style: minimisers find the minimum of the energy, stresses are those of the
forces, fix nve/limit limits."""

import functools
import itertools
import math

import numpy as np
import pytest
from scipy.optimize import minimize, root

from potdem import dumps, formulas, scripts
from potdem.pair_laws import Hertz
from potdem.text import replaced

# --- minimisers -------------------------------------------------------------------------------------------
# Each result is the minimum of the same energy written in Python, from the same start, found by scipy.

LAMMPS_MINIMISERS = ["quickmin", "fire", "cg"]


def run_minimiser(style, force):
    """to a force below `force` on each particle"""
    return f"""
min_style {style}
min_modify norm max
minimize 0 {force:.17g} 100000 1000000
"""


def minimum(energy, gradient, start):
    """by quasi-Newton steps, then the gradient to rounding"""
    near = minimize(energy, start, jac=gradient, method="BFGS", options={"gtol": 1e-8, "maxiter": 10000})
    found = root(gradient, near.x, method="hybr", tol=1e-14)
    assert np.abs(found.x - near.x).max() < 1e-4
    assert np.linalg.eigvalsh(found_hessian(gradient, found.x)).min() > 0
    return found.x


def found_hessian(gradient, x, h=1e-6):
    columns = [(gradient(x + h * e) - gradient(x - h * e)) / (2 * h) for e in np.eye(len(x))]
    return 0.5 * (np.array(columns) + np.array(columns).T)


E, A, REACH = 1000.0, 0.5, 1.75
LOAD = np.array([6.0, 2.0, -14.0])


def truss_body(x, start):
    """energy and gradient of the bonds of all pairs that were within REACH: E A re (q^3/6 - q/2 + 1/3), q = r/re"""
    energy, gradient = 0.0, np.zeros_like(x)
    stiffness = E * formulas.section(1.0, A)
    for i, j in itertools.combinations(range(len(x)), 2):
        rest = np.linalg.norm(start[j] - start[i])
        if rest > REACH * (1 + 1e-6):
            continue
        del_ = x[j] - x[i]
        r = np.linalg.norm(del_)
        q = r / rest
        energy += stiffness * rest * (q**3 / 6 - q / 2 + 1 / 3)
        pull = stiffness * 0.5 * (q * q - 1) * del_ / r
        gradient[i] -= pull
        gradient[j] += pull
    return energy, gradient


def truss_block(bond=""):
    """3 x 3 x 4 particles, the bottom layer held, the top layer loaded with dead forces"""
    script = scripts.box(14) + "region block block -1.5 1.5 -1.5 1.5 -2 2 units box\n"
    script += scripts.crystal(region="block")
    return script + scripts.elastic(E, f"factor {A}", bond) + f"""
region low block EDGE EDGE EDGE EDGE EDGE -1 units box
region high block EDGE EDGE EDGE EDGE 1 EDGE units box
group low region low
group high region high
group free subtract all low
potdem_bonds all 1 {REACH}
fix hold low setforce 0 0 0
fix load high addforce {LOAD[0]} {LOAD[1]} {LOAD[2]}
fix_modify load energy yes
compute ledger all potdem/energy
timestep 0.002
thermo 1000
"""


@functools.lru_cache(maxsize=1)
def relaxed_body(places):
    start = np.array(places).reshape(-1, 3)
    free, loaded = start[:, 2] > -1, start[:, 2] > 1
    assert free.sum() == 27 and loaded.sum() == 9

    def placed(flat):
        x = start.copy()
        x[free] = flat.reshape(-1, 3)
        return x

    def energy(flat):
        x = placed(flat)
        return truss_body(x, start)[0] - float((x[loaded] @ LOAD).sum())

    def gradient(flat):
        slope = truss_body(placed(flat), start)[1]
        slope[loaded] -= LOAD
        return slope[free].ravel()

    return placed(minimum(energy, gradient, start[free].ravel()))


@pytest.mark.parametrize("bond", ["", "damping 0.1"])
@pytest.mark.parametrize("style", LAMMPS_MINIMISERS)
def test_a_loaded_body(run_lammps, tmp_path, style, bond):
    """the dashpots of bonds and velocities that are there do not disturb it"""
    script = truss_block(bond) + scripts.velocities_by_formula(0.5) + scripts.write_dump("start.dump", "x y z")
    script += run_minimiser(style, 1e-9) + scripts.write_dump("end.dump", "x y z") + scripts.result("ebond")
    text = run_lammps(script).stdout
    start, end = (scripts.vectors(dumps.read(tmp_path / f"{name}.dump")[0], "x", "y", "z")
                  for name in ("start", "end"))
    expected = relaxed_body(tuple(start.ravel()))
    moved = np.abs(expected - start).max()
    assert moved > 0.1
    # a force of 1e-9 over the softest stiffness, about 1
    assert np.abs(end - expected).max() < 1e-7 * moved
    assert scripts.results(text)[0][0] == pytest.approx(truss_body(expected, start)[0], rel=1e-7)


GRAINS = [(0.55, 0.6, 0.52, 1.0), (1.45, 1.2, 0.53, 1.1), (0.95, 1.05, 1.34, 1.0), (1.3, 0.5, 1.9, 0.9)]
GRAIN = Hertz(2000.0, 0.2)
PUSHED = np.array([0.2, 0.1, -5.0])
SIZE = 2.0


def grains_in_a_box(x):
    """energy and gradient: Hertz among the grains and, as against half-spaces of the same material, at five walls"""
    energy, gradient = -float((x @ PUSHED).sum()), np.zeros_like(x) - PUSHED
    for i, j in itertools.combinations(range(len(x)), 2):
        r = np.linalg.norm(x[j] - x[i])
        e, f = GRAIN(r, GRAINS[i][3], GRAINS[j][3])
        energy += e
        gradient[i] += f * (x[j] - x[i]) / r
        gradient[j] -= f * (x[j] - x[i]) / r
    for i, k in itertools.product(range(len(x)), range(3)):
        for side in (0, 1) if k < 2 else (0, ):
            w = 0.5 * GRAINS[i][3] - (SIZE - x[i, k] if side else x[i, k])
            if w > 0:
                stiff = 4 / 3 * GRAIN.modulus * math.sqrt(0.5 * GRAINS[i][3])
                energy += 0.4 * stiff * w**2.5
                gradient[i, k] += (1 if side else -1) * stiff * w**1.5
    return energy, gradient


@pytest.mark.parametrize("style", LAMMPS_MINIMISERS)
def test_a_heap_in_a_box(run_lammps, tmp_path, style):
    """friction and viscosity of the grains and walls have no part in it, whatever the velocities are"""
    script = scripts.box(12) + scripts.particles(GRAINS) + f"""
bond_style none
pair_style potdem/hertz
pair_coeff * * {GRAIN.coeff} viscous 0.1 friction 0.5 auto
region walls block 0 {SIZE} 0 {SIZE} 0 9 units box
fix push all addforce {PUSHED[0]} {PUSHED[1]} {PUSHED[2]}
fix_modify push energy yes
fix walls all potdem/wall/region walls {GRAIN.coeff} particle {GRAIN.coeff} layer none friction 0.5 auto viscous 0.1
fix_modify walls energy yes
compute ledger all potdem/energy
timestep 0.002
min_modify dmax 0.01
""" + scripts.velocities_by_formula(1.0) + run_minimiser(style, 1e-9) + scripts.write_dump(
        "end.dump", "x y z") + scripts.result("evdwl", "f_walls")
    text = run_lammps(script).stdout
    end = scripts.vectors(dumps.read(tmp_path / "end.dump")[0], "x", "y", "z")
    start = np.array([row[:3] for row in GRAINS])
    expected = minimum(lambda flat: grains_in_a_box(flat.reshape(-1, 3))[0],
                       lambda flat: grains_in_a_box(flat.reshape(-1, 3))[1].ravel(), start.ravel()).reshape(-1, 3)
    # a force of 1e-9 over the softest stiffness, about 1
    assert np.abs(end - expected).max() < 1e-8
    energy = grains_in_a_box(expected)[0] + float((expected @ PUSHED).sum())
    assert scripts.results(text)[0].sum() == pytest.approx(energy, rel=1e-8)


@pytest.mark.parametrize("style", LAMMPS_MINIMISERS)
def test_a_cluster(run_lammps, tmp_path, style):
    """four particles with Lennard-Jones: a tetrahedron with all distances in equilibrium, six times the depth"""
    K0, R, n, alpha = 300.0, 0.2, 3.0, 0.2
    rows = [(0, 0, 0, 1.0), (1.02, 0.02, 0.01, 1.0), (0.5, 0.88, -0.03, 1.0), (0.48, 0.3, 0.84, 1.0)]
    script = scripts.box(12) + scripts.particles(rows) + f"""
bond_style none
pair_style potdem/lj
pair_coeff * * {K0} {R} {n} {alpha} cut 0.6
timestep 0.005
min_modify dmax 0.01
""" + run_minimiser(style, 1e-10) + scripts.write_dump("end.dump", "x y z") + scripts.result("pe")
    text = run_lammps(script).stdout
    x = scripts.vectors(dumps.read(tmp_path / "end.dump")[0], "x", "y", "z")
    distances = [np.linalg.norm(x[j] - x[i]) for i, j in itertools.combinations(range(4), 2)]
    assert distances == pytest.approx([(1 - alpha) + R] * 6, rel=1e-11)
    assert scripts.results(text)[0][0] == pytest.approx(-6 * K0 * R**2 / (2 * n**2), rel=1e-12)


# --- stresses ---------------------------------------------------------------------------------------------

COMPONENTS = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)]
FLOOR_E, FLOOR_NU, ETA = 2000.0, 0.2, 0.8
# three bonded particles, stretched; a grain on them; all but the grain touch the floor z = 0
ROWS = [(0, 0, 0.47, 1.0), (1.05, 0.02, 0.46, 1.0), (0.5, 0.9, 0.48, 1.0), (0.5, 0.3, 1.22, 1.0)]
REST = {(0, 1): 1.0, (0, 2): 1.01, (1, 2): 1.02}
SPEED = np.array([0.2, -0.1, 0.0])


def stresses_by_hand():
    """kind -> particle -> sum of force times distance vector, f_a x_b (half of it for each of two particles)"""
    x = np.array([row[:3] for row in ROWS])
    virial = {kind: np.zeros((4, 3, 3)) for kind in ("pair", "bond", "fix")}
    for i, j in itertools.combinations(range(4), 2):
        del_ = x[i] - x[j]
        r = np.linalg.norm(del_)
        if (i, j) in REST:
            kind, force = "bond", -formulas.truss_tension(r / REST[i, j], E * formulas.section(1.0, A))
        else:
            kind, force = "pair", GRAIN(r, 1.0, 1.0)[1]
        for k in (i, j):
            virial[kind][k] += 0.5 * force / r * np.outer(del_, del_)
    for i, place in enumerate(x):
        w = 0.5 - place[2]
        if w > 0:
            normal = 4 / 3 * FLOOR_E / (2 * (1 - FLOOR_NU**2)) * math.sqrt(0.5) * w**1.5
            assert ETA * np.linalg.norm(SPEED) < 0.5 * normal
            virial["fix"][i] += np.outer([0, 0, normal] - ETA * SPEED, [0, 0, place[2]])
    assert all(np.abs(values).max() > 0.1 for values in virial.values())
    return virial


@pytest.mark.parametrize("nprocs", [1, 4])
def test_stress_of_pairs_bonds_and_walls(run_lammps, tmp_path, nprocs):
    """compute stress/atom by kind and particle, compute pressure their sum. Friction makes the tensor of a wall
    unsymmetric; as LAMMPS does for the sum over particles, of xy the half f_x y is taken"""
    script = scripts.box(12) + scripts.particles(ROWS) + scripts.elastic(E, f"factor {A}", "")
    script = replaced(script, "pair_style potdem/truss\npair_coeff * * 1000 0.5", f"pair_style potdem/hertz\n"
                            f"pair_coeff * * {GRAIN.coeff}")
    assert "hertz" in script
    for (i, j), rest in REST.items():
        # a body of two at the rest length, made far away
        script += f"group two id {i + 1} {j + 1}\n"
        x = [ROWS[k][:3] for k in (i, j)]
        for k, place in ((i, (4, 4, 4)), (j, (4 + rest, 4, 4))):
            script += f"set atom {k + 1} x {place[0]} y {place[1]} z {place[2]}\n"
        script += "potdem_bonds two 1 1.2\ngroup two delete\n"
        for k, place in zip((i, j), x):
            script += f"set atom {k + 1} x {place[0]} y {place[1]} z {place[2]}\n"
    script += f"""
region floor plane 0 0 0 0 0 1
fix floor all potdem/wall/region floor {FLOOR_E} {FLOOR_NU} particle {FLOOR_E} {FLOOR_NU} layer none friction 0.5 {ETA}
fix_modify floor virial yes
velocity all set {SPEED[0]} {SPEED[1]} {SPEED[2]}
compute pair all stress/atom NULL pair
compute bond all stress/atom NULL bond
compute fix all stress/atom NULL fix
compute all all stress/atom NULL virial
compute p all pressure NULL virial
thermo_style custom step vol c_p[1] c_p[2] c_p[3] c_p[4] c_p[5] c_p[6]
thermo_modify format float {scripts.ALL_DIGITS}
run 0
"""
    columns = [f"c_{kind}[{k}]" for kind in ("pair", "bond", "fix", "all") for k in range(1, 7)]
    thermo = run_lammps(script + scripts.write_dump("s.dump", " ".join(columns)), nprocs=nprocs).thermo
    table = dumps.read(tmp_path / "s.dump")[0]
    expected = stresses_by_hand()
    expected["all"] = sum(expected.values())
    scale = np.abs(expected["all"]).max()
    for kind, tensors in expected.items():
        for k, (a, b) in enumerate(COMPONENTS, start=1):
            assert np.abs(-table[f"c_{kind}[{k}]"] - tensors[:, a, b]).max() < 1e-12 * scale, (kind, a, b)
    for k, (a, b) in enumerate(COMPONENTS, start=1):
        total = expected["all"][:, a, b].sum()
        assert thermo[f"c_p[{k}]"][0] * thermo["Volume"][0] == pytest.approx(total, abs=1e-12 * scale)


# --- fix nve/limit ----------------------------------------------------------------------------------------

@pytest.mark.parametrize("limit", [1e-3, 1.0])
def test_nve_limit(run_lammps, tmp_path, limit):
    """grains made with much overlap: no step is longer than the limit, and one that is long enough changes nothing"""
    rows = [(0, 0, 0, 1.0), (0.5, 0.1, 0, 1.0), (0.2, 0.6, 0.1, 1.0)]
    script = scripts.box(12) + scripts.particles(rows) + f"""
bond_style none
pair_style potdem/hertz
pair_coeff * * {GRAIN.coeff}
timestep 2e-3
dump d all custom 1 d.dump id x y z
dump_modify d sort id format float {scripts.ALL_DIGITS}
"""
    paths = {}
    for integrator in (f"nve/limit {limit}", "nve"):
        run_lammps(script + f"fix move all {integrator}\nrun 100\n")
        paths[integrator] = np.array([scripts.vectors(table, "x", "y", "z")
                                      for table in dumps.read(tmp_path / "d.dump")])
    limited, free = paths.values()
    longest = [np.linalg.norm(np.diff(path, axis=0), axis=2).max() for path in (limited, free)]
    assert longest[1] > 1e-2
    if limit < longest[1]:
        assert longest[0] == pytest.approx(limit, rel=1e-9)
        assert np.abs(limited[-1] - limited[0]).max() > 10 * limit    # and they do come apart
    else:
        assert np.array_equal(limited, free)


# --- pair_write -------------------------------------------------------------------------------------------

@pytest.mark.parametrize("particles, nprocs", [([(0, 0, 0, 1.0)], 1), ([(-1, 0, 0, 1.0), (1, 0, 0, 1.0)], 2)])
def test_pair_write_needs_two_particles(run_lammps, particles, nprocs):
    """their diameters are those of the table"""
    script = scripts.box(8) + scripts.particles(particles) + "bond_style none\npair_style potdem/hertz\n"
    script += f"pair_coeff * * {GRAIN.coeff}\npair_write 1 1 5 r 0.8 0.9 t.table LAW\n"
    message = run_lammps(script, nprocs=nprocs, expect_error="potdem/hertz").error
    assert "pair_write needs the diameters of two particles" in message


# --- pieces -----------------------------------------------------------------------------------------------

@pytest.mark.parametrize("nprocs", [1, 2])
def test_pieces_of_bodies_with_more_bonds_than_fragment_can_take(run_lammps, nprocs):
    """two cubes of 12 and 11 particles across, 23108 and 17497 bonds: more than compute fragment/atom has room for.
    Bonds along a vector of (a, b, c) spacings in a cube of n across: (n - a)(n - b)(n - c)"""
    def bonds(n):
        shell = [v for v in itertools.product(range(-2, 3), repeat=3) if 0 < sum(k * k for k in v) <= 4]
        return sum(math.prod(n - abs(k) for k in v) for v in shell) // 2

    assert bonds(11) > 16384
    script = scripts.box(60) + """
lattice sc 1.0
region one block -20 -9 0 11 0 11 units box
region two block 9 19 0 10 0 10 units box
create_atoms 1 region one
create_atoms 1 region two
set group all diameter 1.0
set group all density 1.0
potdem_bonds all 1 2.0 diameters
""" + scripts.elastic() + """
compute piece all potdem/piece/atom
compute chunk all chunk/atom c_piece compress yes
compute size all property/chunk chunk count
fix move all nve
thermo_style custom step bonds
run 1
""" + scripts.result("c_size[1]", "c_size[2]") + """
variable piece atom c_piece
set group all mol v_piece
compute molecules all chunk/atom molecule compress yes
compute msize all property/chunk molecules count
run 0
""" + scripts.result("c_msize[1]", "c_msize[2]")
    run = run_lammps(script, nprocs=nprocs)
    assert run.thermo["Bonds"][0] == bonds(12) + bonds(11)
    for row in scripts.results(run.stdout):
        assert sorted(row) == [11**3, 12**3]
