# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""dimension 2: the same laws in the plane z = 0, with masses that the script gives."""

import numpy as np
import pytest

from potdem import dumps, formulas, scripts
from potdem.pair_laws import Granular, Hertz, ShiftedLJ, Truss, by_sum

CLUSTER = [(0.0, 0.0, 0.0, 1.0, 1), (0.9, 0.2, 0.0, 1.2, 1), (0.3, -0.8, 0.0, 0.8, 1), (-0.7, 0.5, 0.0, 0.9, 1)]
OUTPUT = "f.dump", "fx fy fz"


def plane(particles="", lattice=""):
    return f"""
units si
dimension 2
atom_style bpm/sphere
boundary f f p
region box block -10 10 -10 10 -0.5 0.5 units box
create_box 1 box bond/types 1
neighbor 0.3 bin
{lattice}
""" + particles


@pytest.mark.parametrize("law", [Hertz(2000.0, 0.3), Truss(2000.0, 0.5), ShiftedLJ(300.0, 0.2, 3.0, 0.2),
                                 Granular(300.0, 3.0, 0.2)], ids=lambda law: law.style)
def test_contacts_in_the_plane(run_lammps, tmp_path, law):
    script = plane(scripts.particles(CLUSTER)) + f"""
bond_style none
pair_style {law.style}
pair_coeff * * {law.coeff}
run 0
""" + scripts.write_dump(*OUTPUT) + scripts.result("pe")
    energy = scripts.results(run_lammps(script).stdout)[0][0]
    force = scripts.vectors(dumps.read(tmp_path / "f.dump")[0], "fx", "fy", "fz")
    expected_energy, expected = by_sum(CLUSTER, lambda i, j: [law])
    assert np.abs(expected).max() > 1.0
    assert energy == pytest.approx(expected_energy, rel=1e-12)
    assert np.abs(force - expected).max() < 1e-12 * np.abs(expected).max()
    assert np.all(force[:, 2] == 0.0)


def stretched(area="factor 0.5"):
    """a sheet of 7 x 4 discs, stretched by 3 % along x and by -1 % along y after its bonds are made"""
    return plane(lattice="""
lattice sq 1.0
region body block 0 6 0 3 -0.1 0.1
create_atoms 1 region body
set group all diameter 1.0 mass 2.5
""") + scripts.elastic(E=1000.0, area=area, contact=0.5) + """
potdem_bonds all 1 1.5
compute s all potdem/strain/atom
run 0
variable x atom 1.03*x
variable y atom 0.99*y
set group all x v_x y v_y
fix flat all enforce2d
run 0
"""


def test_bonds_and_strain_in_the_plane(run_lammps, tmp_path):
    run_lammps(stretched() + scripts.write_dump("s.dump", "x y fx fy fz c_s[1] c_s[2] c_s[3] c_s[4] c_s[8]"))
    table = dumps.read(tmp_path / "s.dump")[0]
    x = scripts.vectors(table, "x", "y")
    start = x / [1.03, 0.99]
    force = np.zeros_like(x)
    for i in range(len(x)):
        for j in range(i):
            length, r = np.linalg.norm(start[i] - start[j]), np.linalg.norm(x[i] - x[j])
            if length < 1.5:
                pull = formulas.truss_tension(r / length, 1000.0 * formulas.section(1.0, 0.5)) * (x[j] - x[i]) / r
                force[i] += pull
                force[j] -= pull
    assert np.abs(force).max() > 1.0
    assert np.abs(scripts.vectors(table, "fx", "fy") - force).max() < 1e-11 * np.abs(force).max()
    assert np.all(table["fz"] == 0.0)
    # Green-Lagrange; of the six components the bonds in a plane see three, the others are zero
    assert table["c_s[1]"] == pytest.approx(0.5 * (1.03**2 - 1), rel=1e-12)
    assert table["c_s[2]"] == pytest.approx(0.5 * (0.99**2 - 1), rel=1e-12)
    assert np.abs(table["c_s[3]"]).max() < 1e-14 and np.abs(table["c_s[4]"]).max() < 1e-14
    assert np.all(table["c_s[8]"] == 3)


@pytest.mark.parametrize("area, message", [("lattice", "three dimensions"), ("body", "three dimensions")])
def test_areas_of_solids_are_refused(run_lammps, area, message):
    run_lammps(stretched(area), expect_error=message)
