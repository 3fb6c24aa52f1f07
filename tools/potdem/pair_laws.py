# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""The pair laws as pair_coeff has them, with mixing, and the forces of a handful of particles by a sum over all pairs.

A law is called with the distance and the two diameters and returns energy and force; positive repels."""

from dataclasses import dataclass

import numpy as np

from potdem import formulas


@dataclass
class ShiftedLJ:
    """eqs 5.9 to 5.11"""

    K0: float
    R: float
    n: float
    alpha: float
    cut: float = 0.0
    style = "potdem/lj"

    def __post_init__(self):
        self.cut = self.cut or formulas.lennard_jones_cut(self.R, self.n)

    @property
    def coeff(self):
        return f"{self.K0:.17g} {self.R:.17g} {self.n:.17g} {self.alpha:.17g} cut {self.cut:.17g}"

    def reach(self, dbar):
        return self.core(dbar) + self.cut

    def core(self, dbar):
        return (1 - self.alpha) * dbar

    def scale(self, _):
        return self.R

    def at(self, s):
        """energy and force without the cut"""
        phi, force, _ = formulas.lennard_jones_of(self.K0, self.R, self.n)
        return phi(s), force(s)

    def __call__(self, r, d1, d2, shift=False):
        s = r - self.core(mean(d1, d2))
        if s >= self.cut:
            return 0.0, 0.0
        energy, force = self.at(s)
        return energy - (self.at(self.cut)[0] if shift else 0.0), force

    @staticmethod
    def mixed(a, b):
        return ShiftedLJ(series(a.K0, b.K0), mean(a.R, b.R), a.n, mean(a.alpha, b.alpha), mean(a.cut, b.cut))


@dataclass
class Granular:
    """eqs 5.12 to 5.14"""

    K0: float
    n: float
    alpha: float
    cut: float = 0.0
    style = "potdem/granular"

    def __post_init__(self):
        self.cut = self.cut or formulas.granular_cut(self.n)

    @property
    def coeff(self):
        return f"{self.K0:.17g} {self.n:.17g} {self.alpha:.17g} cut {self.cut:.17g}"

    def reach(self, dbar):
        return self.core(dbar) + self.cut * self.scale(dbar)

    def core(self, dbar):
        return (1 - self.alpha) * dbar

    def scale(self, dbar):
        return self.alpha * dbar

    def __call__(self, r, d1, d2, shift=False):
        first, s = self.scale(mean(d1, d2)), r - self.core(mean(d1, d2))
        if s >= self.cut * first:
            return 0.0, 0.0
        phi, force, _ = formulas.granular_of(self.K0, first, self.n)
        return phi(s) - (phi(self.cut * first) if shift else 0.0), force(s)

    @staticmethod
    def mixed(a, b):
        return Granular(series(a.K0, b.K0), a.n, mean(a.alpha, b.alpha), max(a.cut, b.cut))


class Touching:
    """a law that ends at the mean diameter and has no core"""

    def reach(self, dbar):
        return dbar

    def core(self, _):
        return 0.0

    def scale(self, dbar):
        return dbar


@dataclass
class Hertz(Touching):
    """eqs 5.15 and 5.16; modulus: of the contact, 1/((1-nu_i^2)/E_i + (1-nu_j^2)/E_j)"""

    E: float
    nu: float
    modulus: float = 0.0
    style = "potdem/hertz"

    def __post_init__(self):
        self.modulus = self.modulus or self.E / (2 * (1 - self.nu**2))

    @property
    def coeff(self):
        return f"{self.E:.17g} {self.nu:.17g}"

    def prefactor(self, d1, d2):
        """K of F = K w^1.5"""
        return formulas.hertz_prefactor(self.modulus, d1, d2)

    def __call__(self, r, d1, d2, shift=False):
        phi, force, _ = formulas.hertz_of(self.prefactor(d1, d2))
        w = max(0.0, 0.5 * (d1 + d2) - r)
        return phi(w), force(w)

    @staticmethod
    def mixed(a, b):
        return Hertz(0.0, 0.0, 1 / ((1 - a.nu**2) / a.E + (1 - b.nu**2) / b.E))


@dataclass
class Truss(Touching):
    """eq. 5.20 without the factor"""

    E: float
    a: float
    style = "potdem/truss"

    @property
    def coeff(self):
        return f"{self.E:.17g} {self.a:.17g}"

    def __call__(self, r, d1, d2, shift=False):
        length = 0.5 * (d1 + d2)
        if r >= length:
            return 0.0, 0.0
        modulus = self.E * formulas.section(length, self.a)
        return formulas.truss_energy(r / length, length, modulus), -formulas.truss_tension(r / length, modulus)

    @staticmethod
    def mixed(a, b):
        return Truss(series(a.E, b.E), mean(a.a, b.a))


def series(a, b):
    return 2 / (1 / a + 1 / b)


def mean(a, b):
    return 0.5 * (a + b)


def by_sum(rows, law_of, bonded=lambda i, j: False):
    """energy and forces of particles (x, y, z, diameter, type); law_of(type, type) -> list of laws"""
    x = np.array([row[:3] for row in rows], dtype=float)
    energy, force = 0.0, np.zeros_like(x)
    for i in range(len(rows)):
        for j in range(i):
            if bonded(i, j):
                continue
            r = np.linalg.norm(x[i] - x[j])
            for law in law_of(*sorted((rows[i][4], rows[j][4]))):
                e, f = law(r, rows[i][3], rows[j][3])
                energy += e
                force[i] += f * (x[i] - x[j]) / r
                force[j] -= f * (x[i] - x[j]) / r
    return energy, force
