# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Loops are compiled for registers of several widths, and do the same operations in the same order in all of them: a body that breaks, its
energy and its strain, and grains that rub end in the same bits. POTDEM_WIDTH chooses by hand."""

import pytest

from potdem import scripts

WIDTHS = ("plain", "avx2", "avx512")    # those that the machine does not have run as the widest that it has

STATE = "x y z vx vy vz"

# bonds of two types, damped, with the factor, which fail as the body is torn apart; some particles have one type of bond, some both
BROKEN = scripts.box(24, bond_types=2) + "region body block -3 3 -2 2 -2 2\n" + scripts.crystal(region="body") + """
region half block INF 0.1 INF INF INF INF
region rest block -0.1 INF INF INF INF INF
group half region half
group rest region rest
potdem_bonds half 1 2.0
potdem_bonds rest 2 1.42
bond_style potdem/truss
bond_coeff 1 100.0 area factor 0.5 {options}
bond_coeff 2 120.0 area factor 0.4 damping 0.01
pair_style potdem/truss
pair_coeff 1 1 100.0 0.3
fix fail all potdem/failure 1 tension 4.0 {scatter}
compute strain all potdem/strain/atom
variable pull atom 0.6*x
velocity all set v_pull NULL NULL
fix move all nve
timestep 0.02
run 300
""" + scripts.result("f_fail", "pe", "pxx", "pyz") + scripts.write_dump(
    "end.dump", STATE + " " + " ".join(f"c_strain[{k}]" for k in range(1, 9)))

# a cube of grains of two types that is thrown into a corner
RUBBING = scripts.box(24, types=2) + "region body block -3 3 -3 3 -3 3\n" + scripts.crystal(region="body") + """
region some block INF 0 INF INF INF INF
group some region some
set group some type 2
set group all diameter 1.02
pair_style potdem/hertz rotation yes
pair_coeff 1 1 1000.0 0.3 {law}
pair_coeff 2 2 2000.0 0.2 {law}
variable in atom -0.3*x+0.2*y
variable round atom 0.2*z*x
velocity all set v_in v_round v_in
fix move all nve/sphere
timestep 0.005
run 300
""" + scripts.write_dump("end.dump", STATE + " omegax omegay omegaz")


def ends(run_lammps, tmp_path, monkeypatch, script):
    """the last run, and what the dumps say, one a width"""
    texts = []
    for width in WIDTHS:
        monkeypatch.setenv("POTDEM_WIDTH", width)
        run = run_lammps(script)
        texts.append((tmp_path / "end.dump").read_text() + str(scripts.results(run.stdout).tolist()))
    return run, texts


@pytest.mark.parametrize("options, scatter", [("", ""), ("penetration 4 damping 0.01", "scatter weibull 8 3")])
def test_a_body_that_breaks(run_lammps, tmp_path, monkeypatch, options, scatter):
    run, texts = ends(run_lammps, tmp_path, monkeypatch, BROKEN.format(options=options, scatter=scatter))
    assert scripts.results(run.stdout)[0][0] > 20    # failed
    assert texts[0] == texts[1] == texts[2]


@pytest.mark.parametrize("law", ["friction 0.3 mindlin", "viscous 1e-3 friction 0.3 spring 0.8 damping 0.1",
                                 "restitution 0.6 friction 0.3 mindlin rolling 0.1 0.5 0.1"])
def test_grains_that_rub(run_lammps, tmp_path, monkeypatch, law):
    _, texts = ends(run_lammps, tmp_path, monkeypatch, RUBBING.format(law=law))
    assert texts[0] == texts[1] == texts[2]


def test_a_width_that_is_none(run_lammps, monkeypatch):
    monkeypatch.setenv("POTDEM_WIDTH", "wide")
    run_lammps(scripts.box(4) + "pair_style potdem/hertz\n", expect_error="POTDEM_WIDTH is 'wide', and may be plain, avx2 or avx512")
