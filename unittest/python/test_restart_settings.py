# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""What a restart must bring back of a pair style's settings."""

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
    return lambda data: replaced(data, text, b" " * len(text))


@pytest.mark.parametrize("nprocs", [1, 2])
@pytest.mark.parametrize("text", [b" viscous 0.5", b" attract yes", b" damping 0.01"])
def test_a_file_from_before_a_keyword_reads(run_lammps, tmp_path, text, nprocs):
    run = changed(run_lammps, tmp_path, blank(text), nprocs=nprocs)
    assert run.thermo["PotEng"][-1] == pytest.approx(run_lammps(BONDED).thermo["PotEng"][-1], rel=1e-14)


def test_a_file_that_knows_more_is_refused_by_name(run_lammps, tmp_path):
    message = changed(run_lammps, tmp_path, lambda data: replaced(data, b" damping ", b" dumping "), expect_error="").error
    assert "bond_style potdem/truss" in message and "restart file" in message and "'dumping'" in message


@pytest.mark.parametrize("nprocs", [1, 2])
def test_a_file_of_an_older_form(run_lammps, tmp_path, nprocs):
    message = changed(run_lammps, tmp_path, lambda data: replaced(data, MARK, b"\0" * 4), expect_error="", nprocs=nprocs).error
    assert "pair_style potdem/hertz" in message and "as text" in message


def test_a_file_of_a_newer_form(run_lammps, tmp_path):
    message = changed(run_lammps, tmp_path, lambda data: replaced(data, MARK + b"\1", MARK + b"\7"), expect_error="").error
    assert "newer version of POTDEM (form 7, this one reads up to 1)" in message


def test_viscosity_without_friction_comes_back(run_lammps):
    """a friction that fix adapt switches on later finds its eta"""
    script = pair((1, 1)) + "pair_style potdem/hertz\npair_coeff * * 1000 0.3 friction 0 2.0\n"
    rub = "variable mu equal 0.5\nfix rub all adapt 1 pair potdem/hertz mu * * v_mu\n"
    before, after = before_and_after(run_lammps, script + rub, "0 1 0", rub)
    assert before[1] == pytest.approx(2.0)
    assert after == pytest.approx(before)
