"""Truss networks by sparse linear algebra, without LAMMPS: what a network does at small displacements."""

import numpy as np
from scipy.sparse import coo_matrix, diags
from scipy.sparse.linalg import cg
from scipy.spatial import cKDTree

WITHIN = 1 + 1e-6    # a distance of exactly r_infl counts as inside


def bonds(points, reach):
    """pairs of points up to `reach` apart"""
    return cKDTree(points).query_pairs(reach * WITHIN, output_type="ndarray")


def stiffness(points, pairs, axial):
    """matrix of the forces over the displacements, three rows for each point; axial: E A of each bond, or of all"""
    along = points[pairs[:, 1]] - points[pairs[:, 0]]
    lengths = np.linalg.norm(along, axis=1)
    n = along / lengths[:, None]
    columns = 3 * pairs[:, [0, 0, 0, 1, 1, 1]] + np.array([0, 1, 2, 0, 1, 2])
    rows = np.repeat(np.arange(len(pairs)), 6)
    elongations = coo_matrix((np.hstack([-n, n]).ravel(), (rows, columns.ravel())), shape=(len(pairs), points.size)).tocsr()
    return elongations.T @ diags(np.broadcast_to(axial, lengths.shape) / lengths) @ elongations


def axial_stiffness(points, matrix):
    """force over strain of a bar along x: its ends are pulled, and the strain of its middle third is taken"""
    x = points[:, 0]
    near, far = np.isclose(x, x.min()), np.isclose(x, x.max())
    load = np.zeros_like(points)
    load[far, 0], load[near, 0] = 1.0 / far.sum(), -1.0 / near.sum()
    moved, problem = cg(matrix, load.ravel(), tol=1e-9, atol=0)
    if problem:
        raise ArithmeticError("no solution for the bar under tension")
    middle = np.abs(x - x.mean()) < np.ptp(x) / 6
    return 1.0 / np.polyfit(x[middle], moved.reshape(-1, 3)[middle, 0], 1)[0]
