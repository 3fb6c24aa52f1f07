# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Small networks of trusses at small displacements, by linear algebra, without LAMMPS: what a set of bond areas is worth.

Bodies are beams along x from x = 0, spacing (or mean diameter) 1, modulus 1, density 1. A bond of area A and length L
is a spring A/L along its line. Nothing here comes from the C++ code: the areas are given."""

import numpy as np
from scipy.linalg import cho_solve_banded, cholesky_banded
from scipy.sparse import coo_matrix, csc_matrix, diags, identity
from scipy.sparse.linalg import cg, eigsh
from scipy.spatial import cKDTree

from potdem.beams import Beam
from potdem.lattices import CELLS, SECTION, WITHIN, edge, sites, volume


def bonds(points, reach):
    """(bonds, 2): pairs of points up to `reach` apart"""
    return cKDTree(points).query_pairs(reach * WITHIN, output_type="ndarray")


def elongations(points, pairs):
    """matrix (bonds, 3 points) of the elongations of the bonds over the displacements, and the bonds' lengths"""
    along = points[pairs[:, 1]] - points[pairs[:, 0]]
    lengths = np.linalg.norm(along, axis=1)
    n = along / lengths[:, None]
    columns = 3 * pairs[:, :, None] + np.arange(3)
    rows = np.broadcast_to(np.arange(len(pairs))[:, None, None], columns.shape)
    entries = np.stack([-n, n], axis=1)
    return coo_matrix((entries.ravel(), (rows.ravel(), columns.ravel())), shape=(len(pairs), points.size)).tocsr(), lengths


def stiffness(points, pairs, axial):
    """matrix of the forces over the displacements, three rows for each point; axial: E A of each bond, or of all"""
    stretch, lengths = elongations(points, pairs)
    return stretch.T @ diags(np.broadcast_to(axial, lengths.shape) / lengths) @ stretch


def free_displacements(matrix, load):
    """(points, 3) of a body that nothing holds, under loads (points, 3) that are in equilibrium; conjugate gradients"""
    moved, problem = cg(matrix, load.ravel(), tol=1e-11, atol=0, maxiter=10000, M=diags(1 / matrix.diagonal()))
    if problem:
        raise ArithmeticError("conjugate gradients did not converge for a free body")
    return moved.reshape(-1, 3)


def axial_stiffness(points, matrix):
    """force over strain of a bar along x: its ends are pulled, and the strain of its middle third is taken"""
    x = points[:, 0]
    near, far = np.isclose(x, x.min()), np.isclose(x, x.max())
    load = np.zeros_like(points)
    load[far, 0], load[near, 0] = 1.0 / far.sum(), -1.0 / near.sum()
    moved = free_displacements(matrix, load)
    middle = np.abs(x - x.mean()) < np.ptp(x) / 6
    return 1.0 / np.polyfit(x[middle], moved[middle, 0], 1)[0]


def free_cube(lattice, cells, reach):
    """(a, nu) of a cube of cells^3 whose two opposite layers carry the stress 1, from the layers' mean displacements"""
    points = sites(lattice, *3 * [range(cells)])
    area = (cells * edge(lattice)) ** 2
    low = [points[:, k] < points[:, k].min() + 0.1 for k in range(2)]
    high = [points[:, k] > points[:, k].max() - 0.1 for k in range(2)]
    force = np.zeros_like(points)
    force[low[0], 0], force[high[0], 0] = -area / low[0].sum(), area / high[0].sum()
    moved = free_displacements(stiffness(points, bonds(points, reach), SECTION), force)
    span = np.ptp(points[:, 0])
    along, across = ((moved[high[k], k].mean() - moved[low[k], k].mean()) / span for k in range(2))
    return along, -across / along


class Body:
    """particles at x (particles, 3) with diameters d and volumes v (particles,) in a box of the given size (3,)"""

    def __init__(self, x, d, v, size):
        self.x, self.d, self.v, self.size = x, d, v, np.asarray(size, dtype=float)

    def pairs(self, reach):
        """pairs within `reach` mean diameters, the shell exactly there included"""
        near = bonds(self.x, reach * self.d.max())
        r = np.linalg.norm(self.x[near[:, 1]] - self.x[near[:, 0]], axis=1)
        return near[r <= reach * 0.5 * (self.d[near[:, 0]] + self.d[near[:, 1]]) * WITHIN]


def crystal(lattice, cells):
    """a block of whole cells; the planes of a lattice are evenly spaced, so that its free faces lie half a plane's distance
    outside the last sites"""
    x = sites(lattice, *map(range, cells))
    size = CELLS[lattice][0] * cells
    x += 0.5 * (size - x.min(axis=0) - x.max(axis=0))    # centred: half a plane's distance to each face
    return Body(x, np.ones(len(x)), np.full(len(x), size.prod() / len(x)), size)


def beam(lattice, depth, length):
    """as close to `depth` spacings square as whole cells allow"""
    return crystal(lattice, [max(1, round(n / size)) for n, size in zip((length, depth, depth), CELLS[lattice][0])])


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


def sphere(lattice, radius):
    """the sites of a lattice within a radius about one of them, moved to positive coordinates; radius of the sphere of the same
    volume: (3 sum v / 4 pi)^(1/3)"""
    n = int(np.ceil(radius / CELLS[lattice][0].min()))
    x = sites(lattice, *3 * [range(-n, n + 1)])
    x = x[np.linalg.norm(x, axis=1) <= radius * WITHIN]
    return Body(x + radius + 0.5, np.ones(len(x)), np.full(len(x), volume(lattice)), 3 * [2 * radius + 1])


# lowest modes of a free sphere with nu = 1/4, twisted and flattened, circular frequency times radius over the speed of shear waves:
# H. Lamb, On the vibrations of an elastic sphere, 1882 (in A. Love, Mathematical Theory of Elasticity, article 196)
SPHERE = (2.5011, 2.640)


def sphere_modes(body, pairs, area):
    """circular frequencies of a free sphere times its radius over the speed of shear waves (nu = 1/4): means of its lowest mode that
    twists it and of its lowest one that flattens it, of five shapes each, which a lattice tells apart"""
    shift = -1e-3    # below zero, where the motions of the rigid body are
    squares, shapes = eigsh(stiffness(body.x, pairs, area), 24, M=diags(np.repeat(body.v, 3)), sigma=shift)
    order = np.argsort(squares)[6:]
    radial = body.x - body.x.mean(axis=0)
    radial /= np.maximum(np.linalg.norm(radial, axis=1), 1e-9)[:, None]
    moved = shapes.T[order].reshape(len(order), -1, 3)
    outward = ((moved * radial).sum(axis=2) ** 2).sum(axis=1) / (moved**2).sum(axis=(1, 2))
    twists = outward < 0.05
    scaled = np.sqrt(squares[order]) * np.cbrt(3 * body.v.sum() / (4 * np.pi)) / np.sqrt(0.4)
    return scaled[twists][:5].mean(), scaled[~twists][:5].mean()


def quarter_fields(x):
    """all displacement fields of a body with the mirror planes y = 0 and z = 0 that bend it along z: even in y, odd in z
    (u_z even). One column for each unknown, which is that of a particle with y, z >= 0"""
    folded = np.column_stack([x[:, 0], np.abs(x[:, 1:])])
    _, first, place = np.unique(np.round(folded, 6), axis=0, return_index=True, return_inverse=True)
    side = np.sign(np.round(x, 6))
    value = np.column_stack([side[:, 2], side[:, 1] * side[:, 2], np.ones(len(x))])
    column = 3 * first[place.ravel()][:, None] + np.arange(3)
    return csc_matrix((value.ravel(), (np.arange(3 * len(x)), column.ravel())),
                                   (3 * len(x), 3 * len(x)))


class Dilatation:
    """energy kappa / 2 sum_i v_i theta_i^2 of the dilatations theta_i = sum over the bonds of i of c_ib eps_b. weights: (bonds, 2),
    c of each bond at its first and at its second end"""

    def __init__(self, kappa, volumes, weights):
        self.kappa, self.volumes, self.weights = kappa, volumes, weights

    @classmethod
    def of_solid(cls, poisson, volumes, weights):
        """E = 1: kappa is Lame's constant less the shear modulus"""
        return cls(poisson / ((1 + poisson) * (1 - 2 * poisson)) - 0.5 / (1 + poisson), volumes, weights)

    def stiffness(self, pairs, stretch, lengths):
        """what it adds to the stiffness; stretch, lengths: of elongations(), the first perhaps times fields"""
        change = self.roots(pairs, lengths) @ stretch
        return np.sign(self.kappa) * change.T @ change

    def roots(self, pairs, lengths):
        """(particles, bonds): roots of v_i |kappa| times the dilatations, over the elongations"""
        entries = np.sqrt(abs(self.kappa) * self.volumes[pairs]) * self.weights / lengths[:, None]
        columns = np.broadcast_to(np.arange(len(pairs))[:, None], pairs.shape)
        return coo_matrix((entries.ravel(), (pairs.ravel(), columns.ravel())), shape=(len(self.volumes), len(pairs))).tocsr()


class Network:
    """displacements under forces, `held` particles fixed; Cholesky factor of the banded stiffness matrix. fields: columns of
    which a displacement is made, one for each component of each particle or none (all there are, if not given); dilatation: a
    Dilatation, or none"""

    def __init__(self, x, pairs, area, held, fields=None, dilatation=None):
        stretch, r = elongations(x, pairs)
        fields = identity(3 * len(x), format="csc") if fields is None else fields
        order = np.argsort(x[:, 0], kind="stable")
        order = (3 * order[~held[order], None] + np.arange(3)).ravel()
        present = order[np.asarray(abs(fields).sum(axis=0)).ravel()[order] > 0]
        self.fields = fields[:, present]
        reduced = stretch @ self.fields
        matrix = reduced.T @ diags(area / r) @ reduced
        if dilatation:
            matrix = matrix + dilatation.stiffness(pairs, reduced, r)
        matrix = matrix.tocoo()
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


def clamp_depth(body, reach):
    """length of the beam that is held: whole layers, as deep as a bond is long"""
    layers = np.unique(np.round(body.x[:, 0], 6))
    step = layers[1] - layers[0] if len(layers) < len(body.x) / 4 else 1.0
    return np.ceil(reach / step - 1e-6) * step


def rotation(x, u):
    """rate at which sections at x rotate about the axis y = z = 0, u_y = -(rate x + c) z, u_z = (rate x + c) y, beside a bending of
    the axis"""
    none, one = np.zeros(len(x)), np.ones(len(x))
    along, y, z = x.T
    columns = np.array([np.concatenate(part) for part in
                        ((-along * z, along * y), (-z, y), (one, none), (none, one), (along, none), (none, along))])
    return np.linalg.lstsq(columns.T, np.concatenate([u[:, 1], u[:, 2]]), rcond=None)[0][0]


def measure(body, pairs, area, reach, axis=2, poisson=0.25, dilatation=None):
    """ratios to the exact values: stiffness in tension, bending and torsion (from the middle of the beam under end loads), tip
    deflection and first frequency of the cantilever that starts at the plane between held and free particles; and how far
    behind that plane a clamp would have to be for the tip deflection to be exact (spacings)"""
    x = body.x - [0, 0.5 * body.size[1], 0.5 * body.size[2]]
    length, start = body.size[0], clamp_depth(body, reach)
    depth, width = body.size[axis], body.size[3 - axis]
    network = Network(x, pairs, area, x[:, 0] < start, dilatation=dilatation)
    free = length - start
    exact = Beam(free, width, depth, poisson=poisson, shear_factor=5 / 6)
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
    pulled = network.displacement(loaded(end, 0, share))
    stretch = fit(pulled[:, 0], 1)[1]
    lever = x[end, axis] - np.average(x[end, axis], weights=body.v[end])
    moment = loaded(end, 0, -lever)
    moment /= -(moment[end, 0] * x[end, axis]).sum()
    curvature = 2 * fit(network.displacement(moment)[:, axis], 2)[2]
    torque = np.zeros_like(x)
    torque[end, 1:] = body.v[end, None] * x[end][:, [2, 1]] * [-1, 1]
    torque /= (x[:, 1] * torque[:, 2] - x[:, 2] * torque[:, 1]).sum()
    twist = rotation(x[middle], network.displacement(torque)[middle])
    tip = x[:, 0] > length - 1.0
    deflection = network.displacement(loaded(tip, axis, 1 / body.v[tip].sum()))[:, axis]
    deflection = np.average(deflection[tip], weights=body.v[tip])
    arm = np.average(x[tip, 0], weights=body.v[tip]) - start
    return {
        "axial": 1 / (stretch * exact.area),
        "poisson": -fit(pulled[:, axis], 1)[3 if axis == 2 else 2] / stretch,
        "bending": 1 / (curvature * exact.inertia),
        "torsion": 1 / (twist * exact.torsion_constant * exact.modulus / (2 * (1 + exact.poisson))),
        "tip": deflection / exact.static(arm),
        "frequency": network.first_frequency(body.v, axis) / exact.first_frequency(),
        "clamp": exact.length_with_tip(deflection) - arm,
    }
