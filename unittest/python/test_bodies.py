# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""The networks that potdem_bonds makes, and the stiffness of crystals made of them."""

import numpy as np
import pytest

from potdem import dumps, formulas, scripts

SHELLS = {1.42: 18, 1.75: 26, 2.0: 32, 2.5: 80}


def bond_count(text):
    """(bonds, per particle) of each potdem_bonds line of the log"""
    lines = [line.split() for line in text.splitlines() if line.startswith("potdem_bonds:") and "bonds of type" in line]
    return [(int(words[1]), float(words[-3])) for words in lines]


def listed_bonds(folder, name="bonds.dump"):
    """sorted pairs of IDs in a dump of compute property/local"""
    table = dumps.read(folder / name)[-1]
    return sorted(tuple(sorted((int(a), int(b)))) for a, b in zip(table["c_ids[1]"], table["c_ids[2]"]))


DUMP_BONDS = """
compute ids all property/local batom1 batom2 btype
dump bonds all local 1 bonds.dump index c_ids[1] c_ids[2] c_ids[3]
run 0
undump bonds
"""


def positions(folder, name="x.dump"):
    return scripts.vectors(dumps.read(folder / name)[-1], "x", "y", "z")


def pairs_within(x, reach, period=None):
    """all pairs (1-based) at most `reach` apart; reach a number or a matrix"""
    d = x[:, None, :] - x[None, :, :]
    if period is not None:
        d -= period * np.round(d / period)
    close = np.sqrt((d**2).sum(axis=2)) <= np.asarray(reach) * (1 + 1e-9)
    return sorted((int(i) + 1, int(j) + 1) for i, j in zip(*np.nonzero(np.triu(close, 1))))


@pytest.mark.parametrize("nprocs", [1, 2, 4])
def test_bonds_of_a_periodic_crystal(run_lammps, nprocs):
    """every shell within r_infl, its last one included, for any number of ranks; one body after another
    needs more bonds per particle than the last, so that LAMMPS's arrays grow each time"""
    for reach, shell in SHELLS.items():
        script = scripts.box(6, "p p p") + scripts.crystal() + scripts.elastic()
        script += f"potdem_bonds all 1 {reach}\nrun 1\n"
        script += scripts.result("bonds")
        run = run_lammps(script, nprocs=nprocs)
        assert bond_count(run.stdout) == [(216 * shell // 2, shell)]
        assert scripts.results(run.stdout)[0][0] == 216 * shell // 2


@pytest.mark.parametrize("nprocs", [1, 3])
def test_pairs_of_a_periodic_crystal(run_lammps, tmp_path, nprocs):
    """the pairs themselves, across the boundaries too, against a search over all pairs"""
    script = scripts.box(6, "p p p") + scripts.crystal() + scripts.elastic() + "potdem_bonds all 1 1.75\n" + DUMP_BONDS
    run_lammps(script + scripts.write_dump("x.dump", "x y z"), nprocs=nprocs)
    assert listed_bonds(tmp_path) == pairs_within(positions(tmp_path), 1.75, 6.0)


@pytest.mark.parametrize("nprocs", [1, 4])
def test_bonds_in_a_tilted_box(run_lammps, nprocs):
    """a tilt by one spacing leaves the crystal as it is"""
    script = scripts.box(6, "p p p") + scripts.crystal()
    script += "change_box all triclinic\nchange_box all xy final 1.0 boundary p p p\n"
    script += scripts.elastic() + "potdem_bonds all 1 1.75\nrun 0\n" + scripts.result("pe", "bonds")
    energy, bonds = scripts.results(run_lammps(script, nprocs=nprocs).stdout)[0]
    assert bonds == 216 * 26 / 2
    assert energy == pytest.approx(0.0, abs=1e-20)


@pytest.mark.parametrize("nprocs", [1, 4])
def test_bonds_of_a_polydisperse_packing(run_lammps, tmp_path, nprocs):
    """r_infl in mean diameters of the pair"""
    rng = np.random.default_rng(7)
    x = rng.uniform(-3, 3, size=(150, 3))
    d = rng.uniform(0.4, 1.6, size=150)
    script = scripts.box(8) + scripts.particles(np.column_stack([x, d])) + scripts.elastic()
    run_lammps(script + "potdem_bonds all 1 1.3 diameters\n" + DUMP_BONDS, nprocs=nprocs)
    assert listed_bonds(tmp_path) == pairs_within(x, 1.3 * 0.5 * (d[:, None] + d[None, :]))


def test_order_of_the_commands_does_not_matter(run_lammps):
    """potdem_bonds before or after the styles: same energy of the same deformation"""
    def energy(first, second):
        script = scripts.box(5, "p p p") + scripts.crystal() + first + second
        script += "run 0\nchange_box all x scale 1.01 remap\nrun 0\n" + scripts.result("pe")
        return scripts.results(run_lammps(script).stdout)[0][0]

    styles, bonds = scripts.elastic(area="lattice"), "potdem_bonds all 1 2.0\n"
    assert energy(styles, bonds) == energy(bonds, styles) > 0


def test_two_bodies(run_lammps, tmp_path):
    """two bodies that touch, each with its bond type, share no bond"""
    script = scripts.box(6, bond_types=2) + "region low block -3 0 -3 3 -3 3\nregion high block 0 3 -3 3 -3 3\n"
    script += scripts.crystal() + "group low region low\ngroup high region high\n" + scripts.elastic()
    script += "potdem_bonds low 1 1.42\npotdem_bonds high 2 1.75\n" + DUMP_BONDS + scripts.write_dump("x.dump", "x y z")
    run_lammps(script, nprocs=2)
    x = positions(tmp_path)
    table = dumps.read(tmp_path / "bonds.dump")[-1]
    found = {kind: sorted(tuple(sorted((int(a), int(b)))) for a, b, t in
                          zip(table["c_ids[1]"], table["c_ids[2]"], table["c_ids[3]"]) if t == kind) for kind in (1, 2)}
    for kind, side, reach in ((1, x[:, 0] < 0, 1.42), (2, x[:, 0] > 0, 1.75)):
        expected = [(i, j) for i, j in pairs_within(x, reach) if side[i - 1] and side[j - 1]]
        assert found[kind] == expected


@pytest.mark.parametrize("reach, shell", [("2.0", 32), ("1.99", 26)])
def test_a_shell_at_the_reach_is_in_or_out_by_rule(run_lammps, reach, shell):
    """positions off by up to 2e-5 of the spacing and diameters that scatter: the shell of a cubic lattice at two spacings is
    all in with r_infl = 2 and all out with 1.99"""
    script = scripts.box(6, "p p p") + scripts.crystal() + scripts.elastic()
    script += "displace_atoms all random 2e-5 2e-5 2e-5 77 units box\nvariable d atom 0.9+0.2*random(0,1,5)\n"
    script += f"set group all diameter v_d\npotdem_bonds all 1 {reach}\n"
    assert bond_count(run_lammps(script).stdout) == [(216 * shell // 2, shell)]


def test_crack(run_lammps, tmp_path):
    """bonds that cross the half plane x = 0, z > 0 are not made, all others are"""
    script = scripts.box(6) + "region crack block -0.05 0.05 INF INF 0 INF\n" + scripts.crystal() + scripts.elastic()
    script += "potdem_bonds all 1 2.0 crack crack\n" + DUMP_BONDS + scripts.write_dump("x.dump", "x y z")
    run_lammps(script, nprocs=2)
    x = positions(tmp_path)
    kept = []
    for i, j in pairs_within(x, 2.0):
        a, b = x[i - 1], x[j - 1]
        # the piece of the bond within |x| < 0.05 reaches above z = 0
        crosses = a[0] * b[0] < 0 and max(a[2] + (b[2] - a[2]) * (s - a[0]) / (b[0] - a[0]) for s in (-0.05, 0.05)) > 0
        if not crosses:
            kept.append((i, j))
    assert listed_bonds(tmp_path) == kept
    assert len(kept) < len(pairs_within(x, 2.0))


# --- stiffness -----------------------------------------------------------------------------------------

def lattice_bonds(cell, edge, reach):
    """vectors from one site to all others within reach"""
    n = int(reach / edge) + 2
    steps = np.arange(-n, n + 1)
    grid = np.array(np.meshgrid(steps, steps, steps)).reshape(3, -1).T
    vectors = edge * (grid[:, None, :] + np.array(cell)[None, :, :]).reshape(-1, 3)
    length = np.linalg.norm(vectors, axis=1)
    return vectors[(length > 1e-9) & (length <= reach * (1 + 1e-6))]


CELLS = {"sc": [(0, 0, 0)], "bcc": [(0, 0, 0), (.5, .5, .5)],
         "fcc": [(0, 0, 0), (.5, .5, 0), (.5, 0, .5), (0, .5, .5)]}


def stiffness(lattice, edge, reach):
    """C11, C12 of the crystal with A E = 1"""
    bonds = lattice_bonds(CELLS[lattice], edge, reach)
    r = np.linalg.norm(bonds, axis=1)
    n2 = (bonds / r[:, None]) ** 2
    volume = edge**3 / len(CELLS[lattice])
    return np.sum(r * n2[:, 0] ** 2) / (2 * volume), np.sum(r * n2[:, 0] * n2[:, 1]) / (2 * volume)


def stress_of_uniaxial_strain(run_lammps, lattice, edge, reach, area, strain, nprocs=1, E=1000.0):
    """-(pxx, pyy, pzz) of a periodic crystal stretched along x; reach in units of the edge"""
    cells = 5 if reach <= 2 else 6    # more than twice the longest bond
    script = scripts.box(cells * edge, "p p p") + scripts.crystal(lattice, edge) + scripts.elastic(E, area)
    script += f"potdem_bonds all 1 {reach * edge:.17g}\nthermo_style custom step pe pxx pyy pzz\nrun 0\n"
    script += f"change_box all x scale {1 + strain:.17g} remap units box\nrun 0\n" + scripts.result("pxx", "pyy", "pzz")
    return -scripts.results(run_lammps(script, nprocs=nprocs).stdout)[0]


@pytest.mark.parametrize("lattice, reach", [("sc", 1.42), ("sc", 1.75), ("sc", 2.0), ("sc", 2.5),
                                            ("fcc", 0.71), ("fcc", 1.0), ("fcc", 1.42), ("bcc", 1.0), ("bcc", 1.42)])
def test_area_lattice_gives_the_modulus(run_lammps, lattice, reach):
    """small strain e along x: sxx = C11 e, syy = C12 e with C scaled so that E is the modulus in uniaxial
    stress. Terms of second order are of relative size e = 1e-7; rounding of the stress (sums of forces
    A E 1e-16) is 1e-9 of it"""
    strain, E = 1e-7, 1000.0
    sxx, syy, szz = stress_of_uniaxial_strain(run_lammps, lattice, 1.3, reach, "lattice", strain)
    c11, c12 = stiffness(lattice, 1.3, reach * 1.3)
    scale = E / (c11 - 2 * c12**2 / (c11 + c12))
    assert sxx == pytest.approx(scale * c11 * strain, rel=2e-6)
    assert syy == pytest.approx(scale * c12 * strain, rel=2e-6)
    assert szz == pytest.approx(syy, rel=1e-7)
    # and what it is for: E from the two constants measured
    m11, m12 = sxx / strain, syy / strain
    assert m11 - 2 * m12**2 / (m11 + m12) == pytest.approx(E, rel=4e-6)


@pytest.mark.parametrize("reach", [1.0, 1.5, 2.0])
def test_area_lattice_of_hexagonal_packing(run_lammps, tmp_path, reach):
    """the section that makes the modulus along the basal plane E. The two sublattices shift by u against each other:
    the energy of a cell is a quadratic form of (exx, eyy, ezz, u), and u and the lateral strains minimise it"""
    script = scripts.box((6, 4 * np.sqrt(3), 4 * np.sqrt(8 / 3)), "p p p")
    script += "lattice hcp 1.0 origin 0.1 0.1 0.1\ncreate_atoms 1 region box\nset group all diameter 1 density 1\n"
    script += scripts.elastic(area="lattice") + f"potdem_bonds all 1 {reach}\n"
    script += "compute a all bond/local b3\ndump a all local 1 a.dump c_a\ndump_modify a format float %.17g\nrun 0\n"
    script += scripts.write_dump("x.dump", "x y z")
    run_lammps(script, nprocs=2)
    areas = dumps.read(tmp_path / "a.dump")[-1]["c_a"]
    assert areas == pytest.approx(areas[0], rel=1e-15)

    x, box = positions(tmp_path), np.array([6, 4 * np.sqrt(3), 4 * np.sqrt(8 / 3)])
    d = x - x[0] - box * np.round((x - x[0]) / box)
    r = np.linalg.norm(d, axis=1)
    near = (r > 0.5) & (r < reach + 1e-6)
    d, r = d[near], r[near]
    other = np.round(d[:, 2] / np.sqrt(2 / 3)).astype(int) % 2    # every second plane is of the other kind
    stretch = np.hstack([d**2, other[:, None] * d]) / r[:, None]
    form = (stretch / r[:, None]).T @ stretch / (2 * np.sqrt(0.5))
    modulus = 1 / np.linalg.inv(form)[0, 0]
    assert areas[0] * modulus == pytest.approx(1.0, rel=1e-9)


def test_area_lattice_does_not_depend_on_ranks(run_lammps):
    one, four = (stress_of_uniaxial_strain(run_lammps, "sc", 1.0, 2.0, "lattice", 1e-4, nprocs) for nprocs in (1, 4))
    assert four == pytest.approx(one, rel=1e-11)    # order of summation, relative to forces 1e4 times larger


def test_area_factor(run_lammps):
    """stress in proportion to a, and equal to that of `area lattice` at the factor of the model's table"""
    def stress(area):
        return stress_of_uniaxial_strain(run_lammps, "sc", 1.0, 2.0, area, 1e-4)

    half, full, exact = stress("factor 0.25"), stress("factor 0.5"), stress("lattice")
    assert full == pytest.approx(2 * half, rel=1e-11)    # rounding 1e-16 of a strain of 1e-4
    c11, c12 = stiffness("sc", 1.0, 2.0)
    a = 4 / np.pi / (c11 - 2 * c12**2 / (c11 + c12))
    assert a == pytest.approx(0.281, abs=5e-4)
    assert exact == pytest.approx(full * a / 0.5, rel=1e-11)


def test_energy_of_a_finite_strain(run_lammps):
    """a periodic crystal under a uniform stretch of 20 %: the sum over one site's bonds"""
    strain, E, a = 0.2, 1000.0, 0.281
    script = scripts.box(5, "p p p") + scripts.crystal() + scripts.elastic(E, f"factor {a}")
    script += "potdem_bonds all 1 2.0\n"
    script += f"run 0\nchange_box all x scale {1 + strain} remap units box\nrun 0\n" + scripts.result("pe")
    energy = scripts.results(run_lammps(script).stdout)[0][0]
    bonds = lattice_bonds(CELLS["sc"], 1.0, 2.0)
    length = np.linalg.norm(bonds, axis=1)
    stretched = np.linalg.norm(bonds * [1 + strain, 1, 1], axis=1)
    modulus = E * formulas.section(1.0, a)
    per_site = 0.5 * sum(formulas.truss_energy(x, r, modulus) for x, r in zip(stretched / length, length))
    assert energy == pytest.approx(125 * per_site, rel=1e-12)


def test_overlapping_pair_across_a_crack_starts_from_no_force(run_lammps):
    """a crack through a packing made with overlap cuts bonds; the contacts that take their place start at the
    present distance, so that the crack does not spring open"""
    script = scripts.box(20) + scripts.particles([(0, 0, 0, 1.0), (0.8, 0, 0, 1.0), (0, 0.8, 0, 1.0)])
    script += scripts.elastic(1000.0, "factor 0.5") + "region crack block 0.35 0.45 INF INF -0.1 0.1\n"
    script += "potdem_bonds all 1 1.0 crack crack\nthermo_style custom step evdwl ebond bonds\n"
    for x in (0.8, 0.9, 0.7):
        script += f"set atom 2 x {x}\nrun 0\n" + scripts.result("fx[2]", "evdwl", "bonds")
    rows = scripts.results(run_lammps(script).stdout)
    assert np.all(rows[:2, :2] == 0.0)
    assert np.all(rows[:, 2] == 1)    # particles 1 and 3
    force = -formulas.truss_tension(0.7 / 0.8, 1000.0 * formulas.section(1.0, 0.5))
    assert rows[2, 0] == pytest.approx(force, rel=1e-12)


def test_a_second_network_leaves_bonded_pairs_alone(run_lammps, tmp_path):
    """potdem_bonds again with a longer reach adds the new shell only, with its own type"""
    script = scripts.box(6, "p p p", bond_types=2) + scripts.crystal() + scripts.elastic()
    script += "potdem_bonds all 1 1.1\nrun 1\npotdem_bonds all 2 1.42\n" + DUMP_BONDS
    script += scripts.write_dump("x.dump", "x y z")
    for nprocs in (1, 2):
        run = run_lammps(script, nprocs=nprocs)
        assert bond_count(run.stdout) == [(648, 6), (1296, 12)]
        assert listed_bonds(tmp_path) == pairs_within(positions(tmp_path), 1.42, 6.0)


def test_bonds_made_by_lammps_start_from_where_they_are(run_lammps):
    """create_bonds instead of potdem_bonds: the distance at the first run is the reference length"""
    script = scripts.box(20, newton="on off", room=1) + scripts.particles([(0, 0, 0, 1.0), (1.1, 0, 0, 1.4)])
    script += scripts.elastic(1000.0, "factor 0.5")
    script += "special_bonds lj 0 1 1 coul 0 1 1\ncreate_bonds single/bond 1 1 2\n"
    script += "thermo_style custom step ebond\nrun 0\n" + scripts.result("ebond") + "set atom 2 x 1.21\nrun 0\n"
    script += scripts.result("ebond")
    rest, stretched = scripts.results(run_lammps(script).stdout)[:, 0]
    assert rest == 0.0
    assert stretched == pytest.approx(formulas.truss_energy(1.1, 1.1, 1000.0 * formulas.section(1.2, 0.5)), rel=1e-12)


@pytest.mark.parametrize("nprocs", [1, 2])
def test_styles_run_before_there_are_bonds(run_lammps, nprocs):
    """a box without room for bonds: the particles are run as grains first, then bonded where they are"""
    script = scripts.box(20, newton="on off") + scripts.particles([(-0.5, 0, 0, 1.0), (0.6, 0, 0, 1.0)])
    script += scripts.elastic(1000.0, "factor 0.5") + "special_bonds lj 0 1 1 coul 0 1 1\nfix move all nve\n"
    script += "timestep 1e-6\nthermo_style custom step ebond bonds\nrun 2\n" + scripts.result("ebond", "bonds")
    script += "potdem_bonds all 1 1.2\nrun 0\n" + scripts.result("ebond", "bonds") + "set atom 2 x 0.71\nrun 0\n"
    script += scripts.result("ebond", "bonds")
    before, rest, stretched = scripts.results(run_lammps(script, nprocs=nprocs).stdout)
    assert before.tolist() == [0, 0] and rest.tolist() == [0, 1]
    expected = formulas.truss_energy(1.1, 1.1, 1000.0 * formulas.section(1.0, 0.5))
    assert stretched == pytest.approx([expected, 1], rel=1e-12)
