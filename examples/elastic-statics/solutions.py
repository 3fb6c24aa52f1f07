# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""The exact answers, with E = d = 1 and loads of the order `small`."""

from dataclasses import dataclass
from typing import Callable

import numpy as np

from potdem.beams import Beam


@dataclass
class Solution:
    """what plot.py draws: a mean over layers of particles against the place of the layers"""

    title: str
    across: str                  # the coordinate of the layers
    moved: str                   # the displacement's direction
    exact: Callable              # of the coordinate


def bar(p):
    return Solution("bar in tension", "x", "x", lambda x: p["small"] * (x - 24))


def shear(p):
    return Solution("simple shear", "z", "x", lambda z: p["small"] * z)


def weight(p):
    n, g = p["n"], p["small"] / p["n"]
    # from the lowest layer, at half a spacing
    return Solution("cube under its own weight", "z", "z", lambda z: -g * (n * (z - 0.5) - (z**2 - 0.25) / 2))


def tip(p):
    n, nu, l = p["n"], p["nu"], 47.5
    load = p["small"] * n**3 / 48**2
    beam = Beam(l, n, n, poisson=nu)

    def deflection(x):
        return np.where(x > 0, load * beam.static(x, l), 0.0)

    return Solution("cantilever with a load at its end", "x", "z", deflection)


def kirsch(r, theta):
    """stress along the tension, over the tension, in an infinite plate with a hole of radius 1"""
    c2, c4 = np.cos(2 * theta), np.cos(4 * theta)
    return 1 - (1.5 * c2 + c4) / r**2 + 1.5 * c4 / r**4


SOLUTIONS = {"bar": bar, "shear": shear, "weight": weight, "tip": tip}
