# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""compute potdem/piece/atom against the connected components of the graph that the dumped bonds make."""

import re

import numpy as np
import pytest
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from potdem import dumps, scripts

RANKS = pytest.mark.parametrize("nprocs", [1, 2, 4])
BONDS = "compute ids all property/local batom1 batom2 btype\n"
PIECE = "compute piece all potdem/piece/atom\n" + BONDS


def shown(every, more=""):
    """pieces, bonds and the number of pieces, seen every so many steps"""
    return f"""
dump pieces all custom {every} piece.dump id c_piece {more}
dump_modify pieces sort id
dump bonds all local {every} bond.dump c_ids[*]
thermo {every}
thermo_style custom step bonds c_piece
"""


def pieces_of(ids, bonds, members):
    """the lowest ID of the component of each particle, 0 for those that are no members"""
    place = {int(tag): k for k, tag in enumerate(ids)}
    ends = np.array([(place[int(a)], place[int(b)]) for a, b, kind in bonds if kind > 0], dtype=int).reshape(-1, 2)
    ends = ends[members[ends].all(axis=1)]
    graph = coo_matrix((np.ones(len(ends)), ends.T), shape=(len(ids), len(ids)))
    count, label = connected_components(graph, directed=False)
    lowest = np.full(count, np.inf)
    np.minimum.at(lowest, label, ids)
    return np.where(members, lowest[label], 0)


def checked(run, folder, membership=None):
    """that every snapshot is right, and the scalar with it; the pieces of each snapshot. membership: the column that
    says who is in the group"""
    found = []
    snapshots = dumps.read(folder / "piece.dump"), dumps.read(folder / "bond.dump")
    for atoms, bonds, count in zip(*snapshots, run.thermo["c_piece"], strict=True):
        members = atoms[membership] > 0 if membership else np.ones(len(atoms["id"]), dtype=bool)
        ends = scripts.vectors(bonds, "c_ids[1]", "c_ids[2]", "c_ids[3]")
        assert np.array_equal(atoms["c_piece"], pieces_of(atoms["id"], ends, members)), f"step {atoms.step}"
        assert count == len(np.unique(atoms["c_piece"][members]))
        found.append(atoms["c_piece"])
    return found


def cube(n, spacing=1.0, diameter=None, boundary="f f f", reach=1.42, size=60, more=""):
    return scripts.box(size, boundary) + f"region body block 0 {n} 0 {n} 0 {n} units box\n" + scripts.crystal(
        spacing=spacing, region="body", diameter=diameter) + scripts.elastic() + f"potdem_bonds all 1 {reach} {more}\n"


@RANKS
def test_an_unbroken_body_and_a_particle_beside_it(run_lammps, tmp_path, nprocs):
    script = cube(6) + "create_atoms 1 single 10 10 10 units box\nset atom 217 diameter 1 density 1\n" + PIECE
    run = run_lammps(script + shown(1) + "run 0\n", nprocs=nprocs)
    (piece,) = checked(run, tmp_path)
    assert list(piece) == [1] * 216 + [217]


@RANKS
def test_a_body_torn_apart_in_the_middle_of_a_run(run_lammps, tmp_path, nprocs):
    """by its own motion: stiff bonds, velocities that differ from place to place"""
    script = cube(10) + "balance 1.0 shift xyz 10 1.05\n" + scripts.velocities_by_formula(8.0) + PIECE + """
fix move all nve
fix tear all potdem/failure 1 tension 40
timestep 1e-3
""" + shown(100)
    found = checked(run_lammps(script + "run 1500\n", nprocs=nprocs), tmp_path)
    numbers = [len(np.unique(piece)) for piece in found]
    assert numbers[0] == 1 and numbers[-1] > 100
    sizes = np.unique(found[-1], return_counts=True)[1]
    assert ((sizes > 1) & (sizes < 500)).sum() > 5


def snake(rows, length, shuffled):
    """a chain in rows along x, two spacings apart, one after another joined at alternating ends"""
    path = []
    for row in range(rows):
        along = range(length) if row % 2 == 0 else range(length - 1, -1, -1)
        path += [(x, 2 * row) for x in along]
        if row < rows - 1:
            path.append((path[-1][0], 2 * row + 1))
    if shuffled:
        np.random.default_rng(1).shuffle(path)
    return [(x - 0.5 * length, y - rows, 0, 1.0) for x, y in path]


@RANKS
@pytest.mark.parametrize("shuffled", [False, True])
@pytest.mark.parametrize("cut", [False, True])
def test_a_chain_that_doubles_back_over_the_ranks(run_lammps, tmp_path, nprocs, shuffled, cut):
    """12 rows across all slices of the box: the lowest ID has to cross their faces 36 times on 4 ranks"""
    script = "processors * 1 1\n" + scripts.box(40) + scripts.particles(snake(12, 24, shuffled)) + scripts.elastic()
    script += "region slit block 5.1 5.4 -1 1 INF INF units box\n"
    script += f"potdem_bonds all 1 1.1 {'crack slit' if cut else ''}\n" + PIECE
    (piece,) = checked(run_lammps(script + shown(1) + "run 0\n", nprocs=nprocs), tmp_path)
    assert len(np.unique(piece)) == (2 if cut else 1)


@RANKS
@pytest.mark.parametrize("reach, slits, pieces",
                         [(1.42, [], 1), (1.0, ["-0.1 0.1"], 1), (1.0, ["-0.1 0.1", "1.9 2.1"], 2)])
def test_periodic_boundaries(run_lammps, tmp_path, nprocs, reach, slits, pieces):
    """one cut through a periodic body leaves it whole, two make two pieces, one of them across the boundary"""
    script = scripts.box(6, "p p p") + scripts.crystal() + scripts.elastic()
    script += "".join(f"region slit{k} block {slit} INF INF INF INF units box\n" for k, slit in enumerate(slits))
    script += "region both union 2 slit0 slit1\n" if len(slits) == 2 else ""
    script += f"potdem_bonds all 1 {reach} {['', 'crack slit0', 'crack both'][len(slits)]}\n"
    (piece,) = checked(run_lammps(script + PIECE + shown(1) + "run 0\n", nprocs=nprocs), tmp_path)
    assert len(np.unique(piece)) == pieces


@RANKS
def test_a_group_smaller_than_the_body(run_lammps, tmp_path, nprocs):
    """the two ends of a bar: what joins them is not in the group"""
    script = cube(8) + """
region left block INF 2.9 INF INF INF INF units box
region right block 4.9 INF INF INF INF INF units box
region ends union 2 left right
group ends region ends
variable member atom gmask(ends)
compute piece ends potdem/piece/atom
""" + BONDS
    run = run_lammps(script + shown(1, more="v_member") + "run 0\n", nprocs=nprocs)
    (piece,) = checked(run, tmp_path, "v_member")
    assert len(np.unique(piece)) == 3 and piece.min() == 0 and run.thermo["c_piece"][0] == 2


@RANKS
def test_a_dynamic_group(run_lammps, tmp_path, nprocs):
    """members by place: a body that flies through a window; ghosts do not know of it by themselves"""
    script = cube(8, size=40) + """
velocity all set 10 0 0
region window block 5 INF INF INF INF INF units box
region gap block 8 9 INF INF INF INF units box side out
region seen intersect 2 window gap
group seen dynamic all region seen every 1
compute piece seen potdem/piece/atom
variable member atom gmask(seen)
fix move all nve
timestep 0.001
neigh_modify every 1 delay 0 check yes
""" + BONDS
    run = run_lammps(script + shown(10, more="v_member") + "run 500\n", nprocs=nprocs)
    checked(run, tmp_path, "v_member")
    assert {1, 2} <= set(run.thermo["c_piece"])


# a crack through particles that overlap
TOUCHING = scripts.box(20) + "region body block -3 3 -3 3 -3 3 units box\n" + scripts.crystal(
    region="body", diameter=1.05) + scripts.elastic() + """
region slit block -0.1 0.1 INF INF INF INF units box
potdem_bonds all 1 1.0 crack slit
"""


@RANKS
def test_pieces_that_touch(run_lammps, tmp_path, nprocs):
    """two pieces, for LAMMPS's aggregate/atom too, which looks at nothing but LAMMPS's list of bonds"""
    script = TOUCHING + PIECE + """
compute other all aggregate/atom 1e-9
variable first atom id==c_other
compute others all reduce sum v_first
""" + shown(1) + "thermo_style custom step c_piece c_others\nfix move all nve\nrun 2\n"
    run = run_lammps(script, nprocs=nprocs)
    assert set(len(np.unique(piece)) for piece in checked(run, tmp_path)) == {2}
    assert set(run.thermo["c_piece"]) == {2}
    assert set(run.thermo["c_others"]) == {2}


@RANKS
def test_eighty_bonds_each(run_lammps, tmp_path, nprocs):
    script = cube(8, reach=2.5) + "fix move all nve\nfix tear all potdem/failure 1 tension 30\ntimestep 1e-3\n"
    script += scripts.velocities_by_formula(8.0) + PIECE + shown(100) + "run 800\n"
    found = checked(run_lammps(script, nprocs=nprocs), tmp_path)
    bonds = dumps.read(tmp_path / "bond.dump")[0]
    assert np.bincount(np.concatenate([bonds["c_ids[1]"], bonds["c_ids[2]"]]).astype(int)).max() == 80
    assert len(np.unique(found[-1])) > 1


@RANKS
def test_more_bonds_than_fragment_can_take(run_lammps, tmp_path, nprocs):
    """40460 particles, 17 bonds each on the average, cut in two across the ranks"""
    script = scripts.box(60) + "region body block -17 17 -17 17 -17 18 units box\n"
    script += "region slit block INF INF -0.1 0.1 INF INF units box\n"
    script += scripts.crystal(region="body") + scripts.elastic() + "potdem_bonds all 1 1.42 crack slit\n" + PIECE
    run = run_lammps(script + shown(1) + "run 0\n", nprocs=nprocs)
    (piece,) = checked(run, tmp_path)
    assert len(piece) == 34 * 34 * 35
    assert list(np.unique(piece, return_counts=True)[1]) == [20230, 20230]


def test_it_goes_on_after_a_restart(run_lammps, tmp_path):
    """with failed pairs that still overlap"""
    run_lammps(TOUCHING + "run 0\nwrite_restart r\n")
    run = run_lammps("read_restart r\n" + PIECE + shown(1) + "run 0\n", nprocs=2)
    assert len(np.unique(checked(run, tmp_path)[0])) == 2


def test_no_neighbour_list_is_asked_for(run_lammps):
    """the only list is that of the pair style"""
    run = run_lammps(cube(4) + PIECE + "thermo_style custom step c_piece\nrun 0\n")
    assert re.search(r"(\d+) neighbor lists, perpetual/occasional/extra = 1 0 0", run.log).group(1) == "1"
