# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Stress at the particles by LAMMPS's own compute stress/atom, the bonds' virial over the particle's volume, as
docs/compute_potdem_strain_atom.md describes it."""

import itertools

import numpy as np
import pytest

from potdem import dumps, formulas, scripts

E, A = 1000.0, 0.3
COLUMNS = [f"c_virial[{k}]" for k in range(1, 7)]
STRESS = "compute virial all stress/atom NULL bond\n"
STRESS += f"dump stress all custom 6000 s.dump id x y z {' '.join(COLUMNS)}\n"
STRESS += f"dump_modify stress sort id format float {scripts.ALL_DIGITS}\n"


def stresses(tmp_path):
    """positions and stresses over the volume 1 of a cell: xx yy zz xy xz yz"""
    table = dumps.read(tmp_path / "s.dump")[-1]
    return scripts.vectors(table, "x", "y", "z"), scripts.vectors(table, *COLUMNS)


def lattice_stress(F, reach):
    """of the infinite cubic lattice of spacing 1 after the deformation F: half the sum over the bonds of a particle of
    tension times length times n n, over the deformed volume"""
    total = np.zeros((3, 3))
    for vector in itertools.product(range(-2, 3), repeat=3):
        rest = np.linalg.norm(vector)
        if 0 < rest < reach * (1 + 1e-6):
            now = F @ vector
            length = np.linalg.norm(now)
            tension = formulas.truss_tension(length / rest, E * formulas.section(1.0, A))
            total += 0.5 * tension * length * np.outer(now, now) / length**2
    return total / np.linalg.det(F)


@pytest.mark.parametrize("nprocs", [1, 4])
def test_uniform_strain_of_the_infinite_lattice(run_lammps, tmp_path, nprocs):
    """stretch along x and shear: each particle has the Cauchy stress of the lattice"""
    F = np.array([[1.05, 0.1, 0], [0, 0.98, 0], [0, 0, 1.01]])
    tilt = 6 * F[0, 1]
    script = scripts.box(6, "p p p") + scripts.crystal() + scripts.elastic(E, f"factor {A}") + "potdem_bonds all 1 1.75\n"
    script += "change_box all triclinic\n"
    script += f"change_box all x scale 1.05 y scale 0.98 z scale 1.01 xy final {tilt} remap units box\n"
    script += STRESS + "run 0\n"
    run_lammps(script, nprocs=nprocs)
    _, stress = stresses(tmp_path)
    expected = lattice_stress(F, 1.75)
    expected = expected[[0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]]
    # differences of squared lengths, 1e-16, over strains of 0.05
    assert np.abs(stress / np.linalg.det(F) - expected).max() < 1e-12 * np.abs(expected).max()


def test_bar_under_tension(run_lammps, tmp_path):
    """free bar of 24 x 4 x 4, pulled at its end layers: away from the ends the mean stress of a section is force over
    area"""
    load = 2e-3 * E
    script = scripts.box(40) + "region body block -12 12 -2 2 -2 2\n" + scripts.crystal(region="body")
    script += scripts.elastic(E, "lattice") + "potdem_bonds all 1 2.0\n" + f"""
region left block EDGE -11 EDGE EDGE EDGE EDGE
region right block 11 EDGE EDGE EDGE EDGE EDGE
group left region left
group right region right
set group all mass 1.0
timestep 0.01
fix move all nve
fix left left addforce $(-{load}/count(left):%.17g) 0 0
fix right right addforce $({load}/count(right):%.17g) 0 0
fix damp all potdem/damping 0.2
""" + STRESS + "run 6000\n"
    run_lammps(script)
    points, stress = stresses(tmp_path)
    order = np.argsort(points[:, 0], kind="stable")
    sections = stress[order].reshape(24, 16, 6).mean(axis=1)
    middle = sections[8:16]
    # Saint-Venant: what the ends do differently has decayed to less than this after two depths
    assert middle[:, 0] == pytest.approx(load / 16, rel=1e-3)
    assert np.abs(middle[:, 1:]).max() < 1e-3 * load / 16
    # virial theorem for the whole bar in equilibrium: the sum is that of the outer forces times their places
    span = points[order][-16:, 0].mean() - points[order][:16, 0].mean()
    assert stress[:, 0].sum() == pytest.approx(load * span, rel=1e-6)
