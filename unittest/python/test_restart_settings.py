# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""What a restart must bring back of a pair style's settings."""

import struct

import pytest

from potdem import scripts
from potdem.text import replaced

MATERIAL = "1000 0.3 viscous 1.0 friction 0.3 1.0"


def pair(kinds):
    return scripts.box(20, types=2) + "bond_style none\n" + scripts.particles(
        [(0, 0, 0, 1.0, kinds[0]), (0.9, 0, 0, 1.0, kinds[1])])


def before_and_after(run_lammps, script, velocity, again=""):
    show = "compute t all property/atom tqz\nrun 0\n" + scripts.result("fx[1]", "fy[1]", "C_t[1]")
    script += f"group two id 2\nvelocity all set 0 0 0\nvelocity two set {velocity}\n" + show
    script += "write_restart now.restart\nclear\nread_restart now.restart\n" + again + show
    before, after = scripts.results(run_lammps(script).stdout)
    return before, after


@pytest.mark.parametrize("kinds", [(1, 2), (2, 1)])
def test_friction_of_an_explicit_pair(run_lammps, kinds):
    script = pair(kinds) + "pair_style potdem/hertz\npair_coeff 1 1 1000 0.3\npair_coeff 2 2 1000 0.3\n"
    before, after = before_and_after(run_lammps, script + "pair_coeff 1 2 1000 0.3 friction 0.3 1.0\n", "0 1 0")
    assert before[1] == pytest.approx(1.0)
    assert after == pytest.approx(before)


@pytest.mark.parametrize("style", ["", "hybrid ", "hybrid/overlay "])
@pytest.mark.parametrize("kinds", [(1, 1), (1, 2)])
def test_rotation_and_attract(run_lammps, style, kinds):
    """hybrid styles want their pair_coeff again, not their settings"""
    name = "potdem/hertz" if style else ""
    coeff = f"pair_coeff 1 1 {name} {MATERIAL}\npair_coeff 2 2 {name} {MATERIAL}\n"
    if style:
        coeff += f"pair_coeff 1 2 {name} {MATERIAL}\n"
    script = pair(kinds) + f"pair_style {style}potdem/hertz rotation yes attract yes\n" + coeff
    for velocity in ("1 0 0", "-1 1 0"):
        before, after = before_and_after(run_lammps, script, velocity, coeff if style else "")
        assert before[0] > 0 if velocity == "1 0 0" else before[2] != 0.0
        assert after == pytest.approx(before)


# --- the form of the file ---------------------------------------------------------------------------------------------

MARK = b"PTDM"
BONDED = scripts.box(20) + scripts.particles([(0, 0, 0, 1.0), (1.05, 0, 0, 1.0), (0, 0.9, 0, 1.0)])
BONDED += "pair_style potdem/hertz attract yes\npair_coeff * * 1000 0.3 viscous 0.5\n"
BONDED += "bond_style potdem/truss\nbond_coeff * 1000 area factor 0.5 damping 0.01\npotdem_bonds all 1 1.1\nthermo_style custom step pe\nrun 0\nwrite_restart now.restart\n"
READ = "read_restart now.restart\nthermo_style custom step pe\nrun 0\n"


def checksum(text):
    """FNV-1a (Fowler, Noll and Vo), of 64 bits the lower 32"""
    total = 14695981039346656037
    for byte in text:
        total = (total ^ byte) * 1099511628211 % 2**64
    return total % 2**32


def with_checksums(data):
    """as the version that wrote these texts would have written them"""
    start = data.find(MARK)
    while start >= 0:
        length, = struct.unpack_from("i", data, start + 8)
        sum_now = struct.pack("I", checksum(data[start + 16:start + 16 + length]))
        data = data[:start + 12] + sum_now + data[start + 16:]
        start = data.find(MARK, start + 16 + length)
    return data


def test_the_checksum_is_the_known_one(run_lammps, tmp_path):
    """of 'foobar' by the authors' list of test vectors; a file as it is has the right ones"""
    assert checksum(b"foobar") == 0x85944171f73967e8 % 2**32
    run_lammps(BONDED)
    data = (tmp_path / "now.restart").read_bytes()
    assert data.count(MARK) >= 3 and with_checksums(data) == data


def changed(run_lammps, tmp_path, change, **how):
    """a restart file in which bytes were changed, as a file of another version would have them, and what is read from it"""
    run_lammps(BONDED)
    path = tmp_path / "now.restart"
    data = change(path.read_bytes())
    assert data != path.read_bytes()
    path.write_bytes(data)
    return run_lammps(READ, **how)


def blank(text):
    """without a keyword, as a file from before it"""
    return lambda data: with_checksums(replaced(data, text, b" " * len(text)))


@pytest.mark.parametrize("nprocs", [1, 2])
@pytest.mark.parametrize("text", [b" viscous 0.5", b" attract yes", b" damping 0.01"])
def test_a_file_from_before_a_keyword_reads(run_lammps, tmp_path, text, nprocs):
    run = changed(run_lammps, tmp_path, blank(text), nprocs=nprocs)
    assert run.thermo["PotEng"][-1] == pytest.approx(run_lammps(BONDED).thermo["PotEng"][-1], rel=1e-14)


def test_a_file_that_knows_more_is_refused_by_name(run_lammps, tmp_path):
    message = changed(run_lammps, tmp_path, lambda data: with_checksums(replaced(data, b" damping ", b" dumping ")), expect_error="").error
    assert "bond_style potdem/truss" in message and "restart file" in message and "'dumping'" in message


@pytest.mark.parametrize("nprocs", [1, 2])
@pytest.mark.parametrize("old, new", [(MARK, b"\0" * 4), (MARK + b"\2", MARK + b"\7"), (MARK + b"\2", MARK + b"\1")])
def test_a_file_of_another_form(run_lammps, tmp_path, old, new, nprocs):
    message = changed(run_lammps, tmp_path, lambda data: replaced(data, old, new), expect_error="", nprocs=nprocs).error
    assert "pair_style potdem/hertz" in message and "another version of POTDEM" in message


def test_viscosity_without_friction_comes_back(run_lammps):
    """a friction that fix adapt switches on later finds its eta"""
    script = pair((1, 1)) + "pair_style potdem/hertz\npair_coeff * * 1000 0.3 friction 0 2.0\n"
    rub = "variable mu equal 0.5\nfix rub all adapt 1 pair potdem/hertz mu * * v_mu\n"
    before, after = before_and_after(run_lammps, script + rub, "0 1 0", rub)
    assert before[1] == pytest.approx(2.0)
    assert after == pytest.approx(before)
