# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""compute potdem/strain/atom against the Green-Lagrange tensor of motions that are known."""

import numpy as np
import pytest

from potdem import dumps, scripts

COLUMNS = "c_strain[1] c_strain[2] c_strain[3] c_strain[4] c_strain[5] c_strain[6] c_strain[7] c_strain[8]".split()
# strains are differences of squared lengths over squared lengths: rounding 1e-16, amplified by the condition of the
# fit (below 100) and by positions ten times larger than the distances
EXACT = 1e-12


def rotation(axis, angle):
    axis = np.asarray(axis, dtype=float) / np.linalg.norm(axis)
    k = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    return np.eye(3) + np.sin(angle) * k + (1 - np.cos(angle)) * k @ k


GRADIENTS = {
    "none": np.eye(3),
    "rotation": rotation((1, 2, 3), 2.1),
    "stretch": np.diag([1.1, 0.95, 1.02]),
    "shear": np.eye(3) + np.array([[0, 0.1, 0], [0, 0, 0.05], [0.02, 0, 0]]),
    "all": rotation((3, -1, 2), 1.3) @ np.array([[1.2, 0.1, -0.05], [0, 0.9, 0.2], [0, 0, 1.05]]),
}


def green_lagrange(F):
    e = 0.5 * (F.T @ F - np.eye(3))
    return np.array([e[0, 0], e[1, 1], e[2, 2], e[0, 1], e[0, 2], e[1, 2]])


def affine(F):
    """moves every particle from x to F x. The formulas must all see the old positions: their values are
    kept per atom first"""
    rows = ["+".join(f"({F[i, j]:.17g})*{x}" for j, x in enumerate("xyz")) for i in range(3)]
    return "\n".join([
        "run 0",
        *(f"variable {k} atom {row}" for k, row in zip("abc", rows)),
        "fix kept all property/atom d_a d_b d_c",
        "set group all d_a v_a d_b v_b d_c v_c",
        *(f"variable {k} atom d_{d}" for k, d in zip("pqr", "abc")),
        "set group all x v_p y v_q z v_r",
        "",
    ])


def strains(run_lammps, tmp_path, script, nprocs=1):
    run_lammps(script + "run 0\n" + scripts.write_dump("s.dump", "x y z " + " ".join(COLUMNS)), nprocs=nprocs)
    table = dumps.read(tmp_path / "s.dump")[0]
    return scripts.vectors(table, *COLUMNS)


BODY = scripts.box(30) + "region body block -2 2 -2 2 -2 2\n" + scripts.crystal(region="body") + scripts.elastic()
STRAIN = "compute strain all potdem/strain/atom\n"


@pytest.mark.parametrize("name", GRADIENTS)
def test_affine_motion(run_lammps, tmp_path, name):
    """exact at every particle, surfaces and corners included, whatever the rotation"""
    F = GRADIENTS[name]
    table = strains(run_lammps, tmp_path, BODY + "potdem_bonds all 1 1.42\n" + STRAIN + affine(F))
    assert np.abs(table[:, :6] - green_lagrange(F)).max() < EXACT
    assert set(table[:, 7]) == {6.0}
    assert table[:, 6].min() == 6 and table[:, 6].max() == 18    # 3 + 3 bonds in a corner


def random_packing(count, seed, size=6.0, apart=0.7):
    """rows of (x, y, z, diameter): random places at least `apart` from each other, random diameters"""
    generator = np.random.default_rng(seed)
    points = np.empty((0, 3))
    while len(points) < count:
        point = generator.uniform(-size / 2, size / 2, 3)
        if np.all(np.linalg.norm(points - point, axis=1) > apart):
            points = np.vstack([points, point])
    return np.column_stack([points, generator.uniform(0.6, 1.2, count)])


@pytest.mark.parametrize("name", GRADIENTS)
@pytest.mark.parametrize("nprocs", [1, 4])
def test_affine_motion_of_a_random_packing(run_lammps, tmp_path, name, nprocs):
    """no two bonds alike: exact wherever they determine six components"""
    F = GRADIENTS[name]
    script = scripts.box(30) + scripts.particles(random_packing(200, seed=7)) + scripts.elastic()
    table = strains(run_lammps, tmp_path, script + "potdem_bonds all 1 1.8\n" + STRAIN + affine(F), nprocs)
    whole = table[:, 7] == 6
    assert whole.sum() > 190
    assert np.abs(table[whole, :6] - green_lagrange(F)).max() < EXACT


PERIODIC = scripts.crystal() + scripts.elastic() + "potdem_bonds all 1 1.75\n" + STRAIN


@pytest.mark.parametrize("nprocs", [1, 4])
def test_periodic_layer(run_lammps, tmp_path, nprocs):
    """finite in x, periodic in y and z: a stretch along x and a shear that keeps the periods"""
    F = np.array([[1.05, 0, 0], [0.08, 1, 0], [-0.03, 0, 1]])
    table = strains(run_lammps, tmp_path, scripts.box((5, 5, 5), "s p p") + PERIODIC + affine(F), nprocs)
    assert np.abs(table[:, :6] - green_lagrange(F)).max() < EXACT
    assert table[:, 6].max() == 26 and set(table[:, 7]) == {6.0}


@pytest.mark.parametrize("nprocs", [1, 4])
def test_translation_through_a_periodic_box(run_lammps, tmp_path, nprocs):
    """particles leave on one side and come in on the other: still no strain"""
    script = scripts.box(5, "p p p") + PERIODIC + "fix move all nve\nvelocity all set 2 -3 1\ntimestep 0.01\nrun 200\n"
    table = strains(run_lammps, tmp_path, script, nprocs)
    assert np.abs(table[:, :6]).max() < EXACT
    assert set(table[:, 6]) == {26.0}


@pytest.mark.parametrize("nprocs", [1, 4])
def test_periodic_box_that_changes(run_lammps, nprocs):
    """the reference state belongs to the old box: an error rather than a wrong strain"""
    script = scripts.box(5, "p p p") + PERIODIC
    script += "run 0\nchange_box all x scale 1.03 y scale 0.98 remap units box\nrun 0\n"
    script += scripts.write_dump("s.dump", " ".join(COLUMNS))
    assert "box of fixed size" in run_lammps(script, nprocs=nprocs, expect_error="strain").error


def test_two_particles_have_one_component(run_lammps, tmp_path):
    """rank 1: the minimal-norm tensor with n E n = eps is eps n n^T"""
    n = np.array([2.0, -1.0, 2.0]) / 3
    script = scripts.box(20) + scripts.particles([(0, 0, 0, 1.0), (*n, 1.0)]) + scripts.elastic()
    script += "potdem_bonds all 1 1.1\n" + STRAIN
    script += "".join(f"set atom 2 {k} {1.1 * x:.17g}\n" for k, x in zip("xyz", n))
    table = strains(run_lammps, tmp_path, script)
    eps = 0.5 * (1.1**2 - 1)
    tensor = eps * np.outer(n, n)
    expected = [tensor[0, 0], tensor[1, 1], tensor[2, 2], tensor[0, 1], tensor[0, 2], tensor[1, 2]]
    for row in table:
        assert row[:6] == pytest.approx(expected, abs=EXACT)
        assert (row[6], row[7]) == (1, 1)


def test_plane_layer_has_three_components(run_lammps, tmp_path):
    """a layer in x, y knows nothing of z: rank 3, and zero in the other three"""
    script = scripts.box(20) + "region body block -2 2 -2 2 -0.5 0.5\n" + scripts.crystal(region="body")
    script += scripts.elastic()
    F = rotation((1, 1, 0), 0.7) @ np.array([[1.1, 0.05, 0], [0, 0.97, 0], [0, 0, 1.0]])
    table = strains(run_lammps, tmp_path, script + "potdem_bonds all 1 1.42\n" + STRAIN + affine(F))
    expected = green_lagrange(F)
    expected[[2, 4, 5]] = 0.0
    assert np.abs(table[:, :6] - expected).max() < EXACT
    assert set(table[:, 7]) == {3.0}
    assert table[:, 6].min() == 3 and table[:, 6].max() == 8


def test_particle_without_bonds(run_lammps, tmp_path):
    script = scripts.box(20) + scripts.particles([(0, 0, 0, 1.0), (1, 0, 0, 1.0), (5, 5, 5, 1.0)]) + scripts.elastic()
    table = strains(run_lammps, tmp_path, script + "potdem_bonds all 1 1.1\n" + STRAIN)
    assert np.array_equal(table[2], np.zeros(8))


def test_only_live_bonds_count(run_lammps, tmp_path):
    """after the bond along x has failed, only the one along y is left"""
    script = scripts.box(20) + scripts.particles([(0, 0, 0, 1.0), (1, 0, 0, 1.0), (0, 1, 0, 1.0)]) + scripts.elastic()
    script += "potdem_bonds all 1 1.1\n" + STRAIN + "fix failure all potdem/failure 1 tension 50\nfix move all nve\n"
    script += "velocity all set 0 0 0\nset atom 2 x 1.2\ntimestep 1e-9\nrun 2\n"
    table = strains(run_lammps, tmp_path, script)
    assert list(table[:, 6]) == [1, 0, 1]
    assert list(table[:, 7]) == [1, 0, 1]
    assert table[0, :6] == pytest.approx(0, abs=1e-9)    # two steps of 1e-9 at accelerations of order 100


def test_outside_the_group_zero(run_lammps, tmp_path):
    script = BODY + "potdem_bonds all 1 1.42\nregion half block INF INF INF INF 0 INF\ngroup half region half\n"
    script += "compute strain half potdem/strain/atom\n" + affine(GRADIENTS["stretch"])
    table = strains(run_lammps, tmp_path, script)
    measured = np.abs(table[:, :6] - green_lagrange(GRADIENTS["stretch"])).max(axis=1) < EXACT
    assert measured.sum() == 32 and np.all(table[~measured] == 0)


@pytest.mark.every_style
def test_restart_keeps_the_reference(run_lammps, tmp_path):
    """the reference directions survive a restart of the deformed body"""
    F = GRADIENTS["all"]
    script = BODY + "potdem_bonds all 1 1.42\n" + STRAIN + affine(F) + "run 0\nwrite_restart s.restart\n"
    run_lammps(script)
    table = strains(run_lammps, tmp_path, "read_restart s.restart\n" + STRAIN)
    assert np.abs(table[:, :6] - green_lagrange(F)).max() < EXACT


def test_defined_too_late(run_lammps):
    """the body has already moved: say so instead of measuring from the wrong state"""
    script = BODY + "potdem_bonds all 1 1.42\nrun 0\n" + affine(GRADIENTS["stretch"]) + "run 0\n" + STRAIN
    assert "before the bodies move" in run_lammps(script, expect_error="strain").error


@pytest.mark.parametrize("nprocs", [1, 2])
def test_bonds_that_fail(run_lammps, nprocs):
    """asked at each step, that of the failure too, before lists are built anew: a bond that has failed counts at neither
    end from then on, and a strain that is the same everywhere is found from those that are left"""
    script = BODY + "potdem_bonds all 1 1.42\n" + STRAIN + """
fix fail all potdem/failure 1 tension 40 scatter weibull 3 7
compute bonds all reduce sum c_strain[7]
compute most all reduce max c_strain[1]
compute least all reduce min c_strain[1]
compute rank all reduce min c_strain[8]
variable twice equal 2*bonds
variable pull atom 0.1*x
velocity all set v_pull 0 0
fix move all nve/noforce
timestep 0.01
thermo 1
thermo_style custom step dt time c_bonds v_twice c_most c_least c_rank
thermo_modify format float %.17g
run 60
"""
    thermo = run_lammps(script, nprocs=nprocs).thermo
    assert np.array_equal(thermo["c_bonds"], thermo["v_twice"])
    assert len(set(thermo["v_twice"])) > 5    # in steps
    whole = thermo["c_rank"] == 6
    assert whole.sum() > 20 and thermo["c_bonds"][whole][-1] < thermo["c_bonds"][0]
    stretch = 1 + 0.1 * 0.01 * thermo["Step"]
    for column in ("c_most", "c_least"):
        assert thermo[column][whole] == pytest.approx(0.5 * (stretch**2 - 1)[whole], abs=EXACT)
