# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Crystal lattices: sites and bonds, and what networks of trusses on them do, by lattice sums and plane waves.

Nearest neighbours are at distance d = 1, E = 1, and the section of a bond with the area factor 1 is pi/4."""

import itertools

import numpy as np
from scipy.optimize import minimize

SECTION = np.pi / 4
WITHIN = 1 + 1e-6    # a distance of exactly r_infl counts as inside
# edges and sites of orthogonal cells; the planes normal to each axis are evenly spaced
CELLS = {
    "sc": (np.ones(3), np.zeros((1, 3))),
    "fcc": (np.sqrt(2.0) * np.ones(3), 0.5 * np.array([(0, 0, 0), (1, 1, 0), (1, 0, 1), (0, 1, 1)])),
    "bcc": (2 / np.sqrt(3.0) * np.ones(3), 0.5 * np.array([(0, 0, 0), (1, 1, 1)])),
    "hcp": (np.array([1.0, np.sqrt(3.0), np.sqrt(8 / 3)]),
            np.array([(0, 0, 0), (1 / 2, 1 / 2, 0), (1 / 2, 1 / 6, 1 / 2), (0, 2 / 3, 1 / 2)])),
}

# docs/report and the README, with exact critical steps: lattice, r_infl/d, critical step and sqrt(m/K), both times c/d
CRITICAL_STEPS = [("sc", 1.42, 0.931, 1.447), ("sc", 1.75, 0.840, 1.499), ("sc", 2.00, 1.193, 2.128), ("sc", 2.50, 1.579, 3.674),
                  ("fcc", 1.00, 0.577, 0.816), ("fcc", 1.42, 0.910, 1.498), ("fcc", 2.00, 1.120, 2.449)]


def edge(lattice):
    """of a cubic cell"""
    return CELLS[lattice][0][0]


def volume(lattice):
    """of one site"""
    size, basis = CELLS[lattice]
    return size.prod() / len(basis)


def sites(lattice, *cells):
    """(sites, 3): those of the cells whose numbers along x, y and z are given as three ranges"""
    size, basis = CELLS[lattice]
    corners = np.array(list(itertools.product(*cells)), dtype=float)
    return ((corners[:, None, :] + basis) * size).reshape(-1, 3)


def shells(lattice, reach):
    """lengths (bonds,) and directions (bonds, 3) of the bonds of one particle"""
    far = [int(reach / size) + 2 for size in CELLS[lattice][0]]
    vectors = sites(lattice, *(range(-n, n + 1) for n in far))
    lengths = np.linalg.norm(vectors, axis=1)
    bonded = (lengths > 0) & (lengths <= reach * WITHIN)
    return lengths[bonded], vectors[bonded] / lengths[bonded, None]


def stiffness(lattice, reach):
    """C11 and C12 with the area factor 1: (1/2V) sum of A E r n n n n over the bonds of one particle"""
    lengths, n = shells(lattice, reach)
    weights = SECTION * lengths / (2 * volume(lattice))
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


def largest_frequency2(lattice, reach, mass, modulus, strain=0.0):
    """square of the largest circular frequency of all plane waves; each bond, of E A = modulus, at its own stretch, with the
    stiffness that its force has across it"""
    rest, n = shells(lattice, reach)
    bonds = rest[:, None] * n
    x = 1.0 + strain
    along = modulus / rest * x
    across = modulus / rest * 0.5 * (x * x - 1.0) / x
    tensors = np.einsum("b,bi,bj->bij", along - across, n, n) + across[:, None, None] * np.eye(3)

    def minus_largest(q):
        return -np.linalg.eigvalsh(np.einsum("b,bij->ij", 1.0 - np.cos(bonds @ q), tensors))[-1] / mass

    starts = np.random.default_rng(1).uniform(-np.pi / edge(lattice), np.pi / edge(lattice), (40, 3))
    return -min(minimize(minus_largest, start, tol=1e-12).fun for start in starts)
