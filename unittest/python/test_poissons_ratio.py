# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""`nu x area body`: bonds and an energy of the change of volume. The solver of tools/area_constants.py gives sections and weights of the
bonds; what LAMMPS makes of them is compared with the formulas here, what they are worth with the elastic solid."""

import re

import area_constants
import numpy as np
import pytest
from test_area_body import HEAD, write_particles

from potdem import dumps, networks, scripts

E = 1000.0
REACH = 2.0


@pytest.fixture(scope="module")
def solver(tmp_path_factory):
    return area_constants.build(tmp_path_factory.mktemp("solver"), "g++")


def coeff(nu, more=""):
    return f"bond_style potdem/truss\nbond_coeff * {E} nu {nu} area body {more}\n"


def bonded(nu, more="density 1"):
    """particles.data as a solid"""
    return (HEAD + "pair_style zero 1.0\npair_coeff * *\n" + coeff(nu, more) + f"potdem_bonds all 1 {REACH} diameters\n"
            "compute_modify thermo_temp dynamic/dof no\nthermo_modify format float %.17g\nrun 0\n")


BODIES = {"cubic": networks.beam("sc", 4, 7), "random": networks.packing(5, 7, spread=0.2)}
SHAKEN = "\n".join(["displace_atoms all move v_v0 v_v1 v_v2 units box",
                    "compute sum all reduce sum fx fy fz", "thermo_style custom step ebond c_sum[*]", "run 0", ""])


def shaken(amplitude):
    return scripts.velocities_by_formula(amplitude).replace("velocity all set v_vx v_vy v_vz", "").replace(
        "variable vx", "variable v0").replace("variable vy", "variable v1").replace("variable vz", "variable v2") + SHAKEN


def energy_and_forces(start, now, pairs, area, dilatation):
    """bonds by Green's strain eps with the tension A E eps, and kappa/2 sum V theta^2 with theta = sum c eps"""
    line, before = now[pairs[:, 1]] - now[pairs[:, 0]], start[pairs[:, 1]] - start[pairs[:, 0]]
    r, length = np.linalg.norm(line, axis=1), np.linalg.norm(before, axis=1)
    x = r / length
    eps = 0.5 * (x**2 - 1)
    theta = sum(np.bincount(pairs[:, k], dilatation.weights[:, k] * eps, len(start)) for k in (0, 1))
    pressure = E * dilatation.kappa * dilatation.volumes * theta
    slope = (pressure[pairs] * dilatation.weights).sum(axis=1)
    pull = (E * area * eps / r + slope / length**2)[:, None] * line
    forces = np.zeros_like(now)
    np.add.at(forces, pairs[:, 0], pull)
    np.add.at(forces, pairs[:, 1], -pull)
    return (E * area * length * (x - 1)**2 * (x + 2) / 6).sum() + 0.5 * (pressure * theta).sum(), forces


@pytest.mark.every_style
@pytest.mark.parametrize("nprocs", [1, 3])
@pytest.mark.parametrize("nu", [0.1, 0.42])
@pytest.mark.parametrize("name", BODIES)
def test_energy_and_forces(run_lammps, tmp_path, solver, name, nu, nprocs):
    """of a body in large random-like displacements, by the formulas and the solver's sections and weights; the solver's iterations carry
    the rounding of other sums"""
    body = BODIES[name]
    write_particles(tmp_path, body.x - 0.5 * body.size, body.d, body.v)
    run = run_lammps(bonded(nu) + shaken(0.05) + scripts.write_dump("end.dump", "x y z fx fy fz") +
                     scripts.result("ebond", "c_sum[1]", "c_sum[2]", "c_sum[3]"), nprocs=nprocs)
    end = dumps.read(tmp_path / "end.dump")[-1]
    pairs = np.sort(body.pairs(REACH), axis=1)
    area, dilatation = area_constants.solve_solid(solver, body, pairs, nu)
    now = scripts.vectors(end, "x", "y", "z")
    assert np.abs(now - (body.x - 0.5 * body.size)).max() > 0.04
    energy, forces = energy_and_forces(body.x, now, pairs, area, dilatation)
    assert np.abs(scripts.vectors(end, "fx", "fy", "fz") - forces).max() < 1e-8 * np.abs(forces).max()
    (found, *net), = scripts.results(run.stdout)
    assert found == pytest.approx(energy, rel=1e-9)
    assert np.abs(net).max() < 1e-12 * np.abs(forces).sum()
