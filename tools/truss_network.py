"""Statics and vibration of small networks of trusses, solved directly: what a set of bond areas is worth.

Bodies are beams along x from x = 0, spacing (or mean diameter) 1, modulus 1, density 1. A bond of area A and length L
is a spring A/L along its line. Nothing here comes from the package: the areas are given."""

import numpy as np
import scipy.sparse
import scipy.sparse.linalg
from scipy.linalg import cho_solve_banded, cholesky_banded
from scipy.spatial import cKDTree

# edges and sites of orthogonal cells, nearest neighbours at distance 1; the planes normal to each axis are
# evenly spaced, so that the free faces lie half a plane's distance outside the last sites
HALF = 0.5 * np.array([(0, 0, 0), (1, 1, 0), (1, 0, 1), (0, 1, 1)])
CELLS = {
    "cubic": (np.ones(3), np.zeros((1, 3))),
    "fcc": (np.sqrt(2.0) * np.ones(3), HALF),
    "bcc": (2 / np.sqrt(3.0) * np.ones(3), 0.5 * np.array([(0, 0, 0), (1, 1, 1)])),
    "hcp": (np.array([1.0, np.sqrt(3.0), np.sqrt(8 / 3)]),
            np.array([(0, 0, 0), (1 / 2, 1 / 2, 0), (1 / 2, 1 / 6, 1 / 2), (0, 2 / 3, 1 / 2)])),
}


class Body:
    """particles x with diameters d and volumes v in a box of the given size"""

    def __init__(self, x, d, v, size):
        self.x, self.d, self.v, self.size = x, d, v, np.asarray(size, dtype=float)

    def pairs(self, reach):
        """pairs within `reach` mean diameters, the shell exactly there included"""
        near = cKDTree(self.x).query_pairs(reach * self.d.max() * (1 + 1e-6), output_type="ndarray")
        r = np.linalg.norm(self.x[near[:, 1]] - self.x[near[:, 0]], axis=1)
        return near[r <= reach * 0.5 * (self.d[near[:, 0]] + self.d[near[:, 1]]) * (1 + 1e-6)]


def crystal(lattice, cells):
    """a block of whole cells"""
    edge, sites = CELLS[lattice]
    grid = np.stack(np.meshgrid(*[np.arange(n) for n in cells], indexing="ij"), -1).reshape(-1, 1, 3)
    x = ((grid + sites) * edge).reshape(-1, 3)
    size = edge * cells
    x += 0.5 * (size - x.min(axis=0) - x.max(axis=0))    # centred: half a plane's distance to each face
    return Body(x, np.ones(len(x)), np.full(len(x), size.prod() / len(x)), size)


def beam(lattice, depth, length):
    """as close to `depth` spacings square as whole cells allow"""
    edge = CELLS[lattice][0]
    return crystal(lattice, [max(1, round(n / e)) for n, e in zip((length, depth, depth), edge)])


def packing(depth, length, spread=0.0, fraction=0.62, seed=1):
    """random dense packing of spheres between the faces of the box, diameters uniform in 1 +- spread (about): random
    places, pushed apart until the overlaps are small; volumes in proportion to d^3"""
    rng = np.random.default_rng(seed)
    size = np.array([length, depth, depth], dtype=float)
    n = int(fraction * size.prod() / (np.pi / 6 * (1 + spread**2)))
    d = 1 + spread * rng.uniform(-1, 1, n)
    d *= np.cbrt(fraction * size.prod() / (np.pi / 6 * (d**3).sum()))
    x = rng.uniform(0, 1, (n, 3)) * size
    for _ in range(2000):
        near = cKDTree(x).query_pairs(d.max(), output_type="ndarray")
        line = x[near[:, 1]] - x[near[:, 0]]
        r = np.linalg.norm(line, axis=1)
        push = 0.3 * (np.maximum(0.5 * (d[near[:, 0]] + d[near[:, 1]]) - r, 0) / r)[:, None] * line
        np.add.at(x, near[:, 0], -push)
        np.add.at(x, near[:, 1], push)
        x += 0.5 * np.maximum(0.5 * d[:, None] - x, 0) - 0.5 * np.maximum(x + 0.5 * d[:, None] - size, 0)
    return Body(x, d, d**3 / (d**3).sum() * size.prod(), size)


def quarter_fields(x):
    """all displacement fields of a body with the mirror planes y = 0 and z = 0 that bend it along z: even in y, odd in z
    (u_z even). One column for each unknown, which is that of a particle with y, z >= 0"""
    folded = np.column_stack([x[:, 0], np.abs(x[:, 1:])])
    _, first, place = np.unique(np.round(folded, 6), axis=0, return_index=True, return_inverse=True)
    side = np.sign(np.round(x, 6))
    value = np.column_stack([side[:, 2], side[:, 1] * side[:, 2], np.ones(len(x))])
    column = 3 * first[place.ravel()][:, None] + np.arange(3)
    return scipy.sparse.csc_matrix((value.ravel(), (np.arange(3 * len(x)), column.ravel())),
                                   (3 * len(x), 3 * len(x)))


class Network:
    """displacements under forces, `held` particles fixed; Cholesky factor of the banded stiffness matrix. fields: columns of
    which a displacement is made, one for each component of each particle or none (all there are, if not given)"""

    def __init__(self, x, pairs, area, held, fields=None):
        line = x[pairs[:, 1]] - x[pairs[:, 0]]
        r = np.linalg.norm(line, axis=1)
        n = line / r[:, None]
        columns = 3 * pairs[:, :, None] + np.arange(3)
        rows = np.broadcast_to(np.arange(len(pairs))[:, None, None], columns.shape)
        stretch = scipy.sparse.csr_matrix((np.stack([-n, n], 1).ravel(), (rows.ravel(), columns.ravel())), (len(pairs), 3 * len(x)))
        fields = scipy.sparse.identity(3 * len(x), format="csc") if fields is None else fields
        order = np.argsort(x[:, 0], kind="stable")
        order = (3 * order[~held[order], None] + np.arange(3)).ravel()
        present = order[np.asarray(abs(fields).sum(axis=0)).ravel()[order] > 0]
        self.fields = fields[:, present]
        reduced = stretch @ self.fields
        matrix = (reduced.T @ scipy.sparse.diags(area / r) @ reduced).tocoo()
        lower = matrix.row >= matrix.col
        row, column, value = matrix.row[lower], matrix.col[lower], matrix.data[lower]
        banded = np.zeros(((row - column).max() + 1, len(present)))
        banded[row - column, column] = value
        self.factor = cholesky_banded(banded, lower=True, overwrite_ab=True)

    def displacement(self, force):
        return (self.fields @ cho_solve_banded((self.factor, True), self.fields.T @ force.ravel())).reshape(-1, 3)

    def first_frequency(self, mass, axis):
        """circular; inverse iteration from a shape along the axis"""
        v = np.zeros((len(mass), 3))
        v[:, axis] = (self.fields @ np.arange(self.fields.shape[1])).reshape(-1, 3)[:, axis]
        for _ in range(40):
            w = self.displacement(mass[:, None] * v)
            square = (v * mass[:, None] * v).sum() / (v * mass[:, None] * w).sum()
            v = w / np.sqrt((w * mass[:, None] * w).sum())
        return np.sqrt(square)


class Timoshenko:
    """cantilever of E = density = 1, shear factor 5/6"""

    def __init__(self, depth, width, nu=0.25):
        self.area, self.inertia, self.shear = depth * width, width * depth**3 / 12, 5 / 6 * depth * width / (2 + 2 * nu)

    def tip(self, length):
        return length**3 / (3 * self.inertia) + length / self.shear

    def length_with_tip(self, deflection):
        low, high = 0.0, 1e6
        for _ in range(200):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if self.tip(middle) < deflection else (low, middle)
        return low

    def first_frequency(self, length, n=400):
        """circular; linear elements of reduced integration, lumped masses: error below 1e-4 with n = 400"""
        h = length / n
        bend, shear = np.array([0, -1, 0, 1.0]), np.array([-1, -h / 2, 1, -h / 2])
        element = self.inertia / h * np.outer(bend, bend) + self.shear / h * np.outer(shear, shear)
        mass = np.zeros(2 * n + 2)
        rows, columns, values = [], [], []
        for e in range(n):
            at = 2 * e + np.arange(4)
            rows += list(np.repeat(at, 4))
            columns += list(np.tile(at, 4))
            values += list(element.ravel())
            mass[at] += np.array([self.area, self.inertia, self.area, self.inertia]) * h / 2
        stiffness = scipy.sparse.csc_matrix((values, (rows, columns)))[2:, 2:]
        lumped = scipy.sparse.diags(mass[2:]).tocsc()
        return np.sqrt(scipy.sparse.linalg.eigsh(stiffness, 1, lumped, sigma=0)[0][0])


def clamp_depth(body, reach):
    """length of the beam that is held: whole layers, as deep as a bond is long"""
    layers = np.unique(np.round(body.x[:, 0], 6))
    step = layers[1] - layers[0] if len(layers) < len(body.x) / 4 else 1.0
    return np.ceil(reach / step - 1e-6) * step


def measure(body, pairs, area, reach, axis=2):
    """ratios to the exact values: axial and bending stiffness (from the middle of the beam under end loads), tip
    deflection and first frequency of the cantilever that starts at the plane between held and free particles; and how far
    behind that plane a clamp would have to be for the tip deflection to be exact (spacings)"""
    x = body.x - [0, 0.5 * body.size[1], 0.5 * body.size[2]]
    length, start = body.size[0], clamp_depth(body, reach)
    depth, width = body.size[axis], body.size[3 - axis]
    exact = Timoshenko(depth, width)
    network = Network(x, pairs, area, x[:, 0] < start)
    free = length - start
    middle = (x[:, 0] > start + 0.3 * free) & (x[:, 0] < start + 0.75 * free)

    def fit(u, degree):
        """coefficients of a polynomial in x; terms over the section take lateral strain out"""
        y, z = x[middle, 1], x[middle, 2]
        columns = [x[middle, 0]**k for k in range(degree + 1)] + [y, z, y * z, y * y, z * z]
        return np.linalg.lstsq(np.stack(columns, 1), u[middle], rcond=None)[0]

    def loaded(where, along, load):
        force = np.zeros_like(x)
        force[where, along] = body.v[where] * load
        return force

    end = x[:, 0] > length - max(1.0, 0.5 * reach)
    share = 1 / body.v[end].sum()
    stretch = fit(network.displacement(loaded(end, 0, share))[:, 0], 1)[1]
    lever = x[end, axis] - np.average(x[end, axis], weights=body.v[end])
    moment = loaded(end, 0, -lever)
    moment /= -(moment[end, 0] * x[end, axis]).sum()
    curvature = 2 * fit(network.displacement(moment)[:, axis], 2)[2]
    tip = x[:, 0] > length - 1.0
    deflection = network.displacement(loaded(tip, axis, 1 / body.v[tip].sum()))[:, axis]
    deflection = np.average(deflection[tip], weights=body.v[tip])
    arm = np.average(x[tip, 0], weights=body.v[tip]) - start
    return {
        "axial": 1 / (stretch * exact.area),
        "bending": 1 / (curvature * exact.inertia),
        "tip": deflection / exact.tip(arm),
        "frequency": network.first_frequency(body.v, axis) / exact.first_frequency(free),
        "clamp": exact.length_with_tip(deflection) - arm,
    }
