# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Where does the clamp act? Static deflection of the truss network of this scene under a load on its end layer, by
sparse linear algebra (no LAMMPS), all bonds with the same section. The curvature and the shear of the middle third
give the bending stiffness E I and the shear stiffness of the network, and the clamp is put where a Timoshenko
beam with these has the deflection of the end layer. Prints E I over the exact one, and the place of the clamp,
in d from the plane midway between the last clamped and the first free layer (the last clamped layer is at -0.5).
"""

import numpy as np
from scipy.optimize import brentq

from potdem import lattices, networks

SIDE, LENGTH, CLAMPED = 5, 48, 2    # layers
REACHES = (1.42, 1.75, 2.0, 2.5)


def deflected(reach):
    """positions and displacements (layers, particles of a layer, 3) of the free particles under a unit load across the end layer; E = d = 1, area factor 1"""
    layers = np.arange(-CLAMPED, LENGTH) + 0.5
    across = np.arange(SIDE) - (SIDE - 1) / 2
    points = np.stack(np.meshgrid(layers, across, across, indexing="ij"), axis=-1).reshape(-1, 3)
    free = points[:, 0] > 0
    network = networks.Network(points, networks.bonds(points, reach), lattices.SECTION, ~free)
    load = np.zeros_like(points)
    load[points[:, 0] > LENGTH - 1, 2] = 1 / SIDE**2
    shape = (LENGTH, SIDE**2, 3)
    return points[free].reshape(shape), network.displacement(load)[free].reshape(shape)


def measure(reach):
    """E I, and the place of the clamp"""
    points, moved = deflected(reach)
    x, z = points[:, 0, 0], points[0, :, 2]
    w = moved[:, :, 2].mean(axis=1)
    theta = -moved[:, :, 0] @ z / (z @ z)    # rotation of the layers
    middle = (x > LENGTH / 3) & (x < 2 * LENGTH / 3)
    bending = np.mean(((x[-1] - x) / np.gradient(theta, x))[middle])
    shear = np.mean((np.gradient(w, x) - theta)[middle])

    def excess(start):
        span = x[-1] - start
        return span**3 / (3 * bending) + span * shear - w[-1]

    return bending, brentq(excess, -5, 5)


if __name__ == "__main__":
    print("r_infl/d   EI, factor 0.4   EI, lattice   clamp")
    for radius in REACHES:
        found, place = measure(radius)
        relative = found / (SIDE**4 / 12)
        print(f"{radius:8.2f} {0.4 * relative:16.3f} {lattices.infinite('sc', radius)[1] * relative:13.3f} {place:7.2f}")
