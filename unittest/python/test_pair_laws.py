# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""potdem/lj, potdem/granular, potdem/hertz and potdem/truss in LAMMPS against the formulas of potdem.pair_laws:
forces, energies, virial, mixing, data and restart files, hybrid styles, neighbour lists, ranks."""

import re

import numpy as np
import pytest

from potdem import dumps, scripts
from potdem.pair_laws import Granular, Hertz, ShiftedLJ, Truss, by_sum
from potdem.text import replaced

ONE = {
    "lj": ShiftedLJ(300.0, 0.2, 3.0, 0.2),
    "lj general exponent": ShiftedLJ(300.0, 0.15, 4.3, 0.25),
    "lj half exponent": ShiftedLJ(300.0, 0.15, 2.5, 0.0),
    "lj long cut": ShiftedLJ(300.0, 0.1, 6.0, 0.3, 0.4),
    "granular": Granular(300.0, 3.0, 0.2),
    "granular general exponent": Granular(300.0, 5.7, 0.1),
    "granular short cut": Granular(300.0, 2.5, 0.3, 1.2),
    "hertz": Hertz(2000.0, 0.3),
    "truss": Truss(2000.0, 0.5),
}
# a second material for each style
OTHER = {
    "lj": ShiftedLJ(1200.0, 0.12, 3.0, 0.3),
    "granular": Granular(1200.0, 3.0, 0.3, 5.0),
    "hertz": Hertz(50000.0, 0.1),
    "truss": Truss(8000.0, 0.9),
}
STYLES = list(OTHER)


def outputs():
    return f"""
thermo_style custom step pe evdwl ke pxx pyy pzz pxy pxz pyz vol
thermo_modify format float {scripts.ALL_DIGITS}
"""


def two(d1, d2, types=1):
    return scripts.box(20, types=types) + "bond_style none\n" + scripts.particles(
        [(0, 0, 0, d1, 1), (1.4, 0, 0, d2, types)]) + outputs()


def distances_of(law, d1, d2):
    """from next to the core to beyond the cut"""
    dbar = 0.5 * (d1 + d2)
    places = [law.core(dbar) + k * law.scale(dbar) for k in (0.3, 0.6, 0.85, 0.99, 1.0, 1.02, 1.15, 1.4, 2.0)]
    return [*places, law.reach(dbar) * (1 - 1e-9), law.reach(dbar) * 1.01]


# the formula takes s from r as the style does, both rounded; a large exponent multiplies that
CLOSE = 1e-12


@pytest.mark.parametrize("diameters", [(1.0, 1.0), (1.0, 1.6), (0.3, 2.0)])
@pytest.mark.parametrize("name", ONE)
def test_force_energy_and_virial(run_lammps, name, diameters):
    """the loop (forces, thermo) and single() (compute pair/local)"""
    law, (d1, d2) = ONE[name], diameters
    distances = distances_of(law, d1, d2)
    script = two(d1, d2) + f"pair_style {law.style}\npair_coeff * * {law.coeff}\n"
    script += "compute p all pair/local dist eng force\n"
    script += "compute s all reduce sum c_p[1] c_p[2] c_p[3] inputs local\nthermo_style custom step pe c_s[*] pxx vol\n"
    for r in distances:
        script += f"set atom 2 x {r:.17g}\nrun 0\n"
        script += scripts.result("evdwl", "fx[1]", "fx[2]", "fy[2]", "pxx*vol", "c_s[1]", "c_s[2]", "c_s[3]")
    rows = scripts.results(run_lammps(script).stdout)
    assert len(rows) == len(distances)
    felt = 0
    for r, (evdwl, f1, f2, fy, virial, dist, local_energy, local_force) in zip(distances, rows):
        energy, force = law(r, d1, d2)
        slack = 1e-13 * 2000.0    # where the force starts from zero
        assert f2 == pytest.approx(force, rel=CLOSE, abs=slack)
        assert evdwl == pytest.approx(energy, rel=CLOSE, abs=slack)
        assert f1 == -f2 and fy == 0.0
        assert virial == pytest.approx(force * r, rel=CLOSE, abs=slack)
        if dist:    # within the cutoff
            assert dist == pytest.approx(r, rel=1e-15)
        assert local_energy == pytest.approx(evdwl, rel=1e-14)
        assert local_force == pytest.approx(f2, rel=1e-14)
        felt += force != 0.0
    assert 3 <= felt < len(distances)


def test_default_cuts(run_lammps):
    """without the keyword: the force's maximum for lj, a thousandth of the force at contact for granular"""
    n, R, alpha = 4.0, 0.2, 0.25
    s_d = R * ((2 * n + 1) / (n + 1)) ** (1 / n)
    x = 1000 ** (1 / n)
    for coeff, style, reach in ((f"100 {R} {n} {alpha}", "potdem/lj", 0.75 + s_d),
                                (f"100 {n} {alpha}", "potdem/granular", 0.75 + 0.25 * x)):
        script = two(1.0, 1.0) + f"pair_style {style}\npair_coeff * * {coeff}\n"
        for r in (reach * (1 - 1e-9), reach * (1 + 1e-9)):
            script += f"set atom 2 x {r:.17g}\nrun 0\n" + scripts.result("fx[2]")
        inside, outside = scripts.results(run_lammps(script).stdout)[:, 0]
        assert outside == 0.0 and inside != 0.0
        if style == "potdem/granular":
            assert inside == pytest.approx(1e-3 * 100 * alpha / n, rel=1e-7)    # 1e-9 from the cut
        else:
            assert inside == pytest.approx(ShiftedLJ(100, R, n, alpha).at(s_d)[1], rel=1e-7)


@pytest.mark.parametrize("name", ["lj", "lj long cut", "granular", "granular short cut", "hertz"])
def test_shift(run_lammps, name):
    """pair_modify shift yes: energy zero at the cut, same forces; in the loop and in single()"""
    law, d1, d2 = ONE[name], 1.0, 1.6
    distances = distances_of(law, d1, d2)
    script = two(d1, d2) + f"pair_style {law.style}\npair_modify shift yes\npair_coeff * * {law.coeff}\n"
    script += "compute p all pair/local eng\ncompute s all reduce sum c_p inputs local\n"
    script += "thermo_style custom step pe c_s\n"
    for r in distances:
        script += f"set atom 2 x {r:.17g}\nrun 0\n" + scripts.result("evdwl", "fx[2]", "c_s")
    for r, (evdwl, force, local) in zip(distances, scripts.results(run_lammps(script).stdout)):
        energy, expected = law(r, d1, d2, shift=True)
        assert force == pytest.approx(expected, rel=CLOSE, abs=2e-10)
        assert evdwl == pytest.approx(energy, rel=CLOSE, abs=2e-12)
        assert local == pytest.approx(evdwl, rel=1e-14)
    if name != "hertz":
        assert law(distances[0], d1, d2, shift=True)[0] != law(distances[0], d1, d2)[0]


@pytest.mark.parametrize("name", STYLES)
def test_mixing(run_lammps, name):
    """the pair 1 2 from 1 1 and 2 2, of different diameters"""
    a, b, (d1, d2) = ONE[name], OTHER[name], (1.0, 1.6)
    law = type(a).mixed(a, b)
    distances = distances_of(law, d1, d2)
    script = two(d1, d2, types=2) + f"pair_style {a.style}\npair_coeff 1 1 {a.coeff}\npair_coeff 2 2 {b.coeff}\n"
    for r in distances:
        script += f"set atom 2 x {r:.17g}\nrun 0\n" + scripts.result("evdwl", "fx[2]")
    for r, (evdwl, force) in zip(distances, scripts.results(run_lammps(script).stdout)):
        assert (evdwl, force) == pytest.approx(law(r, d1, d2), rel=CLOSE, abs=2e-10)


@pytest.mark.parametrize("name", STYLES)
def test_mixed_friction(run_lammps, name):
    """the smaller limit, the larger viscosity"""
    a, b, r = ONE[name], OTHER[name], 0.95
    push = type(a).mixed(a, b)(r, 1.0, 1.0)[1]
    if name == "lj":
        r = 0.9
        push = type(a).mixed(a, b)(r, 1.0, 1.0)[1]
    assert push > 0
    for speed, size in ((1e-3, 1e-3 * 5.0), (1e5, 0.2 * push)):
        script = two(1.0, 1.0, types=2) + f"pair_style {a.style}\n"
        script += f"pair_coeff 1 1 {a.coeff} friction 0.2 2.0\npair_coeff 2 2 {b.coeff} friction 0.7 5.0\n"
        script += f"set atom 2 x {r}\nvelocity all set 0 0 0\ngroup two id 2\nvelocity two set 0 {speed} 0\nrun 0\n"
        force = scripts.results(run_lammps(script + scripts.result("fx[2]", "fy[2]", "fy[1]")).stdout)[0]
        assert force == pytest.approx([push, -size, size], rel=1e-11)


def test_friction_needs_a_push(run_lammps):
    """where Lennard-Jones attracts there is no contact that could rub"""
    law = ONE["lj"]
    script = two(1.0, 1.0) + f"pair_style {law.style}\npair_coeff * * {law.coeff} friction 0.5 10\n"
    script += "velocity all set 0 0 0\ngroup two id 2\nvelocity two set 0 1 0\n"
    for r in (0.9, 1.03):
        script += f"set atom 2 x {r}\nrun 0\n" + scripts.result("fx[2]", "fy[2]")
    (push, rub), (pull, nothing) = scripts.results(run_lammps(script).stdout)
    assert push > 0 > pull
    assert rub == pytest.approx(-min(10.0, 0.5 * push), rel=1e-12) and nothing == 0.0


@pytest.mark.parametrize("attract", ["no", "yes"])
def test_hertz_viscous(run_lammps, attract):
    """eq. 5.17, and its limit at separation"""
    law, H, r, d1, d2 = ONE["hertz"], 0.03, 0.9, 1.0, 1.3
    w = 0.5 * (d1 + d2) - r
    elastic = law(r, d1, d2)[1]
    script = two(d1, d2) + f"pair_style {law.style} attract {attract}\npair_coeff * * {law.coeff} viscous {H}\n"
    script += f"velocity all set 0 0 0\ngroup two id 2\nset atom 2 x {r}\n"
    speeds = (-2.0, 0.0, 1.0, 0.99 * w / H, 1.01 * w / H, 100.0)
    for speed in speeds:
        script += f"velocity two set {speed:.17g} 0.7 0\nrun 0\n" + scripts.result("fx[2]", "fy[2]", "evdwl")
    for speed, (force, across, energy) in zip(speeds, scripts.results(run_lammps(script).stdout)):
        expected = elastic * (1 - H * speed / w)
        if attract == "no":
            expected = max(0.0, expected)
        assert force == pytest.approx(expected, rel=1e-11, abs=1e-12 * elastic)
        assert across == 0.0 and energy == pytest.approx(law(r, d1, d2)[0], rel=CLOSE)


@pytest.mark.parametrize("name", ONE)
def test_pair_write(run_lammps, tmp_path, name):
    """the table is that of the first two particles' diameters"""
    law, d1, d2 = ONE[name], 1.0, 1.6
    distances = distances_of(law, d1, d2)
    script = two(d1, d2) + f"pair_style {law.style}\npair_coeff * * {law.coeff}\n"
    script += f"pair_write 1 1 50 r {distances[0]:.15g} {distances[-1]:.15g} pair.table LAW\n"
    run_lammps(script)
    rows = [line.split() for line in (tmp_path / "pair.table").read_text().splitlines()]
    rows = np.array([row for row in rows if len(row) == 4 and row[0].isdigit()], dtype=float)
    assert len(rows) == 50
    for _, r, energy, force in rows:
        # 15 digits of r and the values; next to the core the law multiplies those of r by 30
        assert (energy, force) == pytest.approx(law(r, d1, d2), rel=1e-12, abs=1e-10)


# --- many particles --------------------------------------------------------------------------------------

def cloud(seed=3, edge=3, small=0.8, large=1.05):
    """particles of two types on a shaken grid, most of them in touch with some neighbours"""
    rng = np.random.default_rng(seed)
    rows = []
    for place in np.ndindex(edge, edge, edge):
        x = 0.95 * (np.array(place) - 0.5 * (edge - 1)) + rng.uniform(-0.03, 0.03, 3)
        rows.append((*x, rng.uniform(small, large), int(rng.integers(1, 3))))
    return rows


def scene(rows, pair, newton=None, boundary="f f f", size=20):
    script = scripts.box(size, boundary, types=2, newton=newton) + "bond_style none\n" + scripts.particles(rows)
    return script + outputs() + pair


def coefficients(name, options=("", "")):
    a, b = ONE[name], OTHER[name]
    return f"""pair_style {a.style}
pair_coeff 1 1 {a.coeff} {options[0]}
pair_coeff 2 2 {b.coeff} {options[1]}
"""


def law_of(name):
    a, b = ONE[name], OTHER[name]
    laws = {(1, 1): [a], (2, 2): [b], (1, 2): [type(a).mixed(a, b)]}
    return lambda i, j: laws[i, j]


FORCES = "run 0\n" + scripts.write_dump("f.dump", "x y z fx fy fz")


def forces(tmp_path, file="f.dump"):
    return scripts.vectors(dumps.read(tmp_path / file)[0], "fx", "fy", "fz")


@pytest.mark.parametrize("name", STYLES)
def test_cloud(run_lammps, tmp_path, name):
    """against the sum over all pairs"""
    rows = cloud()
    run = run_lammps(scene(rows, coefficients(name)) + FORCES)
    energy, expected = by_sum(rows, law_of(name))
    scale = np.abs(expected).max()
    assert scale > 1.0
    assert np.abs(forces(tmp_path) - expected).max() < 1e-11 * scale    # up to 26 neighbours, rounding of s
    assert run.thermo["PotEng"][0] == pytest.approx(energy, rel=1e-11)


@pytest.mark.parametrize("name", STYLES)
def test_virial(run_lammps, tmp_path, name):
    """pressure and the sum of stress/atom are sum x_k f_l, friction included"""
    pair = coefficients(name, ("friction 0.3 2.0", "friction 0.5 5.0")) + scripts.velocities_by_formula(1.0)
    pair += "compute v all pressure NULL virial\ncompute a all stress/atom NULL virial\n"
    pair += "compute s all reduce sum c_a[1] c_a[2] c_a[3] c_a[4] c_a[5] c_a[6]\n"
    pair += "thermo_style custom step vol c_v[*] c_s[*]\n" + FORCES
    pair += scripts.result(*(f"c_v[{k}]*vol" for k in range(1, 7)), *(f"c_s[{k}]" for k in range(1, 7)))
    row = scripts.results(run_lammps(scene(cloud(), pair)).stdout)[0]
    columns = dumps.read(tmp_path / "f.dump")[0]
    tensor = scripts.vectors(columns, "x", "y", "z").T @ forces(tmp_path)
    expected = np.array([tensor[k, m] for k, m in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))])
    assert np.abs(expected).min() > 0.01
    scale = np.abs(expected).max()
    assert row[:6] == pytest.approx(expected, rel=0, abs=1e-11 * scale)
    assert row[6:] == pytest.approx(-expected, rel=0, abs=1e-11 * scale)


@pytest.mark.parametrize("name", STYLES)
@pytest.mark.parametrize("kind", ["ii", "ij"])
def test_data_file(run_lammps, tmp_path, name, kind):
    """write_data pair ii|ij and read_data give the same forces, friction included; with ij the mixed pairs are
    written and need no mixing"""
    options = "friction 0.3 2.5", "friction 0.1 0.5"
    script = scene(cloud(), coefficients(name, options) + scripts.velocities_by_formula(0.5))
    run_lammps(script + FORCES + f"write_data cloud.data pair {kind}\n")
    expected = forces(tmp_path)
    (tmp_path / "f.dump").unlink()
    assert ("PairIJ Coeffs" in (tmp_path / "cloud.data").read_text()) == (kind == "ij")
    again = f"units si\natom_style bpm/sphere\nboundary f f f\nneighbor 0.3 bin\npair_style {ONE[name].style}\n"
    run_lammps(again + "bond_style none\nread_data cloud.data\n" + FORCES)
    # hertz writes E and nu, from which the modulus is worked out again
    assert np.abs(forces(tmp_path) - expected).max() < 1e-13 * np.abs(expected).max()


MOVE = f"""
fix move all nve/sphere
timestep 1e-3
thermo 25
"""


def end(tmp_path):
    table = dumps.read(tmp_path / "end.dump")[0]
    return scripts.vectors(table, "x", "y", "z", "vx", "vy", "vz", "omegax", "omegay", "omegaz")


END = scripts.write_dump("end.dump", "x y z vx vy vz omegax omegay omegaz")


@pytest.mark.parametrize("name", STYLES)
def test_restart(run_lammps, tmp_path, name):
    """coefficients, shift, rotation and friction come back, without a line of pair_style in the script; the same
    trajectory to the last bit but for the order of sums"""
    viscous = " viscous 0.01" if name == "hertz" else ""
    pair = coefficients(name, (viscous + " friction 0.3 auto", viscous + " friction 0.1 0.5"))
    pair = replaced(pair, ONE[name].style, ONE[name].style + " rotation yes\npair_modify shift yes", 1)
    script = scene(cloud(), pair) + scripts.velocities_by_formula(0.5) + MOVE
    run = run_lammps(script + "run 50\nwrite_restart half.restart\nrun 50\n" + END)
    expected = end(tmp_path)
    assert np.abs(expected[:, 6:]).max() > 0.01    # they turn
    (tmp_path / "end.dump").unlink()
    again = run_lammps("read_restart half.restart\n" + outputs() + MOVE + "run 50\n" + END)
    assert np.abs(end(tmp_path) - expected).max() < 1e-10 * np.abs(expected).max()
    assert again.thermo["PotEng"][-1] == pytest.approx(run.thermo["PotEng"][-1], rel=1e-10)


@pytest.mark.parametrize("name", STYLES)
def test_ranks_and_newton(run_lammps, tmp_path, name):
    """friction, rotation, viscosity: the same trajectory, 1e-10 for the rounding grown over 100 steps"""
    viscous = " viscous 0.01" if name == "hertz" else ""
    pair = coefficients(name, (viscous + " friction 0.3 0.4", viscous + " friction 0.1 0.5"))
    pair = replaced(pair, ONE[name].style, ONE[name].style + " rotation yes", 1)
    more = scripts.velocities_by_formula(0.5) + MOVE + "run 100\n" + END
    run_lammps(scene(cloud(), pair) + more)
    one = end(tmp_path)
    assert np.abs(one[:, 6:]).max() > 0.01
    for nprocs, newton in ((2, None), (4, None), (1, "off"), (4, "off")):
        run_lammps(scene(cloud(), pair, newton=newton) + more, nprocs=nprocs)
        assert np.abs(end(tmp_path) - one).max() < 1e-10 * np.abs(one).max(), (nprocs, newton)


@pytest.mark.parametrize("nprocs", [1, 4])
@pytest.mark.parametrize("name", ["lj", "hertz"])
def test_periodic(run_lammps, tmp_path, name, nprocs):
    """moving the whole cloud across the periodic boundaries changes nothing"""
    rows = cloud()
    pair = coefficients(name, ("friction 0.3 1.0", "friction 0.3 1.0")) + scripts.velocities_by_formula(0.5)
    run_lammps(scene(rows, pair) + FORCES)
    expected = forces(tmp_path)
    moved = scene(rows, pair, boundary="p p p", size=8) + "displace_atoms all move 3.7 4.2 -3.9 units box\n"
    run_lammps(moved + FORCES, nprocs=nprocs)
    # the displacement is rounded, 1e-15 of the overlaps
    assert np.abs(forces(tmp_path) - expected).max() < 1e-11 * np.abs(expected).max()


def mixture(large=2.0, small=0.2, count=250):
    """small particles around and between a few large ones, ten times smaller"""
    rng = np.random.default_rng(7)
    rows = [(x, y, 0.0, large, 1) for x in (-0.99, 0.99) for y in (-0.99, 0.99)]
    while len(rows) < count:
        x = rng.uniform(-2.1, 2.1, 3)
        gaps = [np.linalg.norm(x - np.array(r[:3])) - 0.5 * (small + r[3]) for r in rows]
        if -0.03 < min(gaps) < 0.05:
            rows.append((*x, small, 2))
    return rows


@pytest.mark.parametrize("collections", ["", "neigh_modify collection/type 2 1 2\n",
                                         "neigh_modify collection/interval 2 0.5 2.5\n"])
@pytest.mark.parametrize("name", ["hertz", "lj"])
def test_polydisperse_with_neighbor_multi(run_lammps, tmp_path, name, collections):
    """diameters 1:10; against the sum over all pairs, and the trajectory against neighbor bin on one rank"""
    rows = mixture()
    if name == "lj":
        laws = {(1, 1): [ShiftedLJ(300.0, 0.1, 3.0, 0.05)], (2, 2): [ShiftedLJ(300.0, 0.1, 3.0, 0.5)],
                (1, 2): [ShiftedLJ(300.0, 0.1, 3.0, 0.1)]}
    else:
        laws = {(1, 1): [ONE[name]], (2, 2): [OTHER[name]], (1, 2): [Hertz(1000.0, 0.2)]}
    pair = f"pair_style {laws[1, 1][0].style}\n"
    pair += "".join(f"pair_coeff {i} {j} {law.coeff}\n" for (i, j), (law,) in laws.items())
    move = scripts.velocities_by_formula(0.3) + replaced(MOVE, "1e-3", "2e-4") + "run 100\n" + END
    run_lammps(replaced(scene(rows, pair), "neighbor 0.3 bin", "neighbor 0.05 bin") + FORCES + move)
    expected, trajectory = by_sum(rows, lambda i, j: laws[i, j])[1], end(tmp_path)
    assert np.abs(forces(tmp_path) - expected).max() < 1e-11 * np.abs(expected).max()
    multi = replaced(scene(rows, pair), "neighbor 0.3 bin", "neighbor 0.05 multi\ncomm_modify mode multi\n" + collections)
    for nprocs in (1, 4):
        run_lammps(multi + FORCES + move, nprocs=nprocs)
        assert np.abs(forces(tmp_path) - expected).max() < 1e-11 * np.abs(expected).max()
        assert np.abs(end(tmp_path) - trajectory).max() < 1e-10 * np.abs(trajectory).max()


# --- hybrid ----------------------------------------------------------------------------------------------

@pytest.mark.parametrize("nprocs", [1, 4])
def test_hybrid(run_lammps, tmp_path, nprocs):
    """hertz among type 1, lj among type 2, granular between them"""
    laws = {(1, 1): [ONE["hertz"]], (2, 2): [ONE["lj"]], (1, 2): [ONE["granular"]]}
    pair = "pair_style hybrid potdem/hertz potdem/lj potdem/granular\n"
    pair += "".join(f"pair_coeff {i} {j} {law.style} {law.coeff}\n" for (i, j), (law,) in laws.items())
    rows = cloud()
    run = run_lammps(scene(rows, pair) + FORCES, nprocs=nprocs)
    energy, expected = by_sum(rows, lambda i, j: laws[i, j])
    assert np.abs(forces(tmp_path) - expected).max() < 1e-11 * np.abs(expected).max()
    assert run.thermo["PotEng"][0] == pytest.approx(energy, rel=1e-11)


@pytest.mark.parametrize("nprocs", [1, 4])
def test_hybrid_overlay(run_lammps, tmp_path, nprocs):
    """forces add up, and one of them is shifted"""
    laws = [ONE["hertz"], ONE["lj"], ONE["truss"]]
    pair = "pair_style hybrid/overlay potdem/hertz potdem/lj potdem/truss\n"
    pair += "".join(f"pair_coeff * * {law.style} {law.coeff}\n" for law in laws)
    rows = cloud()
    script = scene(rows, pair) + FORCES + "pair_modify pair potdem/lj shift yes\nrun 0\n"
    text = run_lammps(script + scripts.result("pe"), nprocs=nprocs).stdout
    energy, expected = by_sum(rows, lambda i, j: laws)
    assert np.abs(forces(tmp_path) - expected).max() < 1e-11 * np.abs(expected).max()

    def shifted(r, d1, d2):
        return laws[1](r, d1, d2, shift=True)

    energy = by_sum(rows, lambda i, j: [laws[0], shifted, laws[2]])[0]
    assert scripts.results(text)[0][0] == pytest.approx(energy, rel=1e-11)


# --- bonded bodies ---------------------------------------------------------------------------------------

def bodies(pair):
    """two bodies, each of eight particles that overlap, bonded; they touch each other"""
    rows = [(x, y, z + lift, 1.2, kind) for kind, lift in ((1, 0.0), (2, 2.05)) for x in (0, 1) for y in (0, 1)
            for z in (0, 1)]
    script = scripts.box(20, types=2) + scripts.particles(rows) + pair + outputs()
    script += "bond_style potdem/truss\nbond_coeff * 1000 area factor 0.5\n"
    script += "group low type 1\ngroup high type 2\npotdem_bonds low 1 1.5\npotdem_bonds high 1 1.5\n"
    return rows, script


@pytest.mark.parametrize("nprocs", [1, 2])
@pytest.mark.parametrize("name", STYLES)
def test_contact_between_bonded_bodies(run_lammps, tmp_path, name, nprocs):
    """bonds are at rest: what is left is the contact of the two bodies; bonded pairs do not touch, but for the
    diagonals of the cubes, which have no bond"""
    rows, script = bodies(coefficients(name))
    run_lammps(script + FORCES, nprocs=nprocs)

    def bonded(i, j):
        return rows[i][4] == rows[j][4] and np.linalg.norm(np.subtract(rows[i][:3], rows[j][:3])) < 1.5

    expected = by_sum(rows, law_of(name), bonded)[1]
    assert np.abs(expected).max() > 1.0
    assert np.abs(forces(tmp_path) - expected).max() < 1e-11 * np.abs(expected).max()


def failed_pair(law, options=""):
    """bonded at 0.8 diameters, thrown at each other: the bond fails at the strain -0.06, r = 0.75"""
    script = scripts.box(20) + scripts.particles([(0, 0, 0, 1.0), (0.8, 0, 0, 1.0)]) + outputs()
    return script + f"""
bond_style potdem/truss
bond_coeff * 1000 area factor 0.5
pair_style {law.style} {options}
pair_coeff * * {law.coeff}
potdem_bonds all 1 1.0
fix failure all potdem/failure 1 compression 60
group two id 2
velocity all set 1.5 0 0
velocity two set -1.5 0 0
fix move all nve
timestep 1e-5
thermo 500
thermo_style custom step pe ke etotal f_failure f_failure[1]
run 2500
"""


def test_hertz_of_a_pair_that_failed_while_overlapping(run_lammps):
    """contact starts from zero at the distance of failure"""
    law = ONE["hertz"]
    script = failed_pair(law) + "unfix move\nset atom 1 x 0\n"
    places = (0.9, 0.753, 0.7, 0.5, 0.3)
    for r in places:
        script += f"set atom 2 x {r}\nrun 0\n" + scripts.result("f_failure", "fx[2]", "evdwl")
    rows = scripts.results(run_lammps(script).stdout)
    assert np.all(rows[:, 0] == 1)
    assert np.all(rows[:2, 1:] == 0.0)
    K = law.prefactor(1.0, 1.0)
    contact = 0.5 + (rows[3, 1] / K) ** (2 / 3)
    # the strain is -0.06 at the distance of failure, passed by at most one step's way, 3e-5
    assert contact == pytest.approx(0.8 * np.sqrt(1 - 2 * 0.06), abs=4e-5)
    for r, (_, force, energy) in zip(places[2:], rows[2:]):
        assert (force, energy) == pytest.approx((K * (contact - r) ** 1.5, 0.4 * K * (contact - r) ** 2.5), rel=1e-10)


def test_failure_while_overlapping_makes_no_energy(run_lammps):
    """kinetic, bond and fracture energy of the pair with Hertz contact: constant through the failure"""
    run = run_lammps(failed_pair(ONE["hertz"]))
    total = run.thermo["TotEng"] + run.thermo["f_failure[1]"]
    assert run.thermo["f_failure"][-1] == 1
    # second order in the step, 1e-5 of periods of 0.1
    assert np.abs(total - total[0]).max() < 1e-5 * run.thermo["KinEng"][0]


def test_collections_by_size_find_the_same_pairs(run_lammps, tmp_path):
    """neighbor multi with collections by diameter, one type, ratio 1:20: the same forces with fewer ghosts"""
    script = """
units lj
boundary p p p
atom_style sphere
region box block 0 60 0 60 0 60
create_box 1 box
create_atoms 1 random 3000 1234 NULL
create_atoms 1 random 12 777 NULL
group big id > 3000
set group all diameter 1.0
set group big diameter 20.0
set group all density 1.0
pair_style potdem/hertz
pair_coeff * * 10 0.3
"""
    ordinary = run_lammps(script + "neighbor 0.3 bin\n" + "run 0\n" + scripts.write_dump("f.dump", "fx fy fz"))
    force = dumps.read(tmp_path / "f.dump")[0]
    multi = "neighbor 0.3 multi\nneigh_modify collection/interval 2 1.0 20.0\ncomm_modify mode multi\n"
    sorted_by_size = run_lammps(script + multi + "run 0\n" + scripts.write_dump("f.dump", "fx fy fz"))
    force_multi = dumps.read(tmp_path / "f.dump")[0]
    for column in ("fx", "fy", "fz"):
        assert np.abs(force_multi[column] - force[column]).max() < 1e-12 * np.abs(force[column]).max()
    assert ghosts(sorted_by_size) < 0.7 * ghosts(ordinary)


def ghosts(run):
    return float(re.search(r"Nghost: +(\S+) ave", run.log).group(1))
