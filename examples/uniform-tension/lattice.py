#!/usr/bin/python3
"""What the truss networks of this scene should give, computed without LAMMPS: lattice sums for the infinite
lattice, and the static equilibrium of a free cube by sparse linear algebra. E = d = 1 and the section is pi/4.

  lattice.py      prints the table of the infinite lattices
"""

import itertools
import sys
from pathlib import Path

import numpy as np
from scipy.sparse import diags
from scipy.sparse.linalg import cg

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "harness"))
import network  # noqa: E402

SECTION = np.pi / 4
CELL = {"sc": 1.0, "fcc": np.sqrt(2.0)}    # edge of the cube cell over the nearest distance
BASIS = {"sc": [(0, 0, 0)], "fcc": [(0, 0, 0), (0, 0.5, 0.5), (0.5, 0, 0.5), (0.5, 0.5, 0)]}
REACHES = (1.0, 1.42, 1.75, 2.0, 2.25, 2.5)


def sites(lattice, cells):
    corners = np.array(list(itertools.product(cells, repeat=3)), dtype=float)
    return CELL[lattice] * (corners[:, None, :] + np.array(BASIS[lattice])).reshape(-1, 3)


def shells(lattice, reach):
    """lengths and directions of the bonds of one particle"""
    far = int(reach / CELL[lattice]) + 2
    vectors = sites(lattice, range(-far, far + 1))
    lengths = np.linalg.norm(vectors, axis=1)
    bonded = (lengths > 0) & (lengths <= reach * network.WITHIN)
    return lengths[bonded], vectors[bonded] / lengths[bonded, None]


def stiffness(lattice, reach):
    """C11 and C12 with the area factor 1: (1/2V) sum of A E r n n n n over the bonds of one particle"""
    lengths, n = shells(lattice, reach)
    volume = CELL[lattice] ** 3 / len(BASIS[lattice])
    weights = SECTION * lengths / (2 * volume)
    return weights @ n[:, 0] ** 4, weights @ (n[:, 0] ** 2 * n[:, 1] ** 2)


def infinite(lattice, reach):
    """(bonds, a, nu) for tension along a cube axis, and the moduli along [110] and [111] over that along [100]"""
    c11, c12 = stiffness(lattice, reach)
    c44 = c12    # central forces
    nu = c12 / (c11 + c12)
    modulus = c11 - 2 * c12 * nu
    s11, s12 = 1 / modulus, -nu / modulus
    with np.errstate(divide="ignore"):
        excess = 2 * (s11 - s12) - 1 / np.float64(c44)
    # 1/E(n) = s11 - excess (nx^2 ny^2 + ny^2 nz^2 + nz^2 nx^2)
    ratios = [s11 / (s11 - excess * product) for product in (1 / 4, 1 / 3)]
    return len(shells(lattice, reach)[0]), 1 / modulus, nu, *ratios


def free_cube(lattice, cells, reach):
    """(a, nu) of a cube whose two opposite layers carry the stress 1, from the layers' mean displacements"""
    points = sites(lattice, range(cells))
    area = (cells * CELL[lattice]) ** 2
    low = [points[:, k] < points[:, k].min() + 0.1 for k in range(2)]
    high = [points[:, k] > points[:, k].max() - 0.1 for k in range(2)]
    force = np.zeros_like(points)
    force[low[0], 0], force[high[0], 0] = -area / low[0].sum(), area / high[0].sum()
    matrix = network.stiffness(points, network.bonds(points, reach), SECTION)
    moved, stopped = cg(matrix, force.ravel(), tol=1e-11, atol=0, maxiter=10000, M=diags(1 / matrix.diagonal()))
    if stopped:
        raise ArithmeticError(f"free cube, {lattice}, {cells}, {reach}: conjugate gradients did not converge")
    moved = moved.reshape(-1, 3)
    span = np.ptp(points[:, 0])
    along, across = ((moved[high[k], k].mean() - moved[low[k], k].mean()) / span for k in range(2))
    return along, -across / along


if __name__ == "__main__":
    print("lattice  r_infl/d  bonds        a       nu  E110/E100  E111/E100")
    for name, radius in itertools.product(CELL, REACHES):
        print(f"{name:7}  {radius:8.2f}  {{:5}}  {{:7.4f}}  {{:7.4f}}  {{:9.4f}}  {{:9.4f}}".format(*infinite(name, radius)))
