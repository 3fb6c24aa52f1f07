# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Timoshenko's beam, clamped at one end and free at the other: static deflection, natural modes, and its exact response to a
force on one of its sections, as a sum over the modes.

  rho A w_tt     = (kappa G A (w_x - theta))_x
  rho I theta_tt = (E I theta_x)_x + kappa G A (w_x - theta)

In a mode of frequency omega the deflection is a sum of exp(-p x), exp(-p (L-x)), cos(q x) and sin(q x). The conditions
w = theta = 0 at the clamp and theta_x = w_x - theta = 0 at the free end are four homogeneous equations for the four
amplitudes, and the frequencies are the zeros of their determinant. Below the cut-off sqrt(kappa G A / (rho I)) p is
real; the modes above it, shear across the depth, are left out (20 kHz for the beam of beam-impulse).
"""

from dataclasses import dataclass

import numpy as np
from scipy.linalg import null_space
from scipy.optimize import brentq


@dataclass
class Beam:
    """rectangular section, any consistent units. shear_factor: kappa, of a rectangle by Cowper if it is not given"""

    length: float
    width: float
    depth: float
    modulus: float = 1.0
    poisson: float = 0.25
    density: float = 1.0
    shear_factor: "float | None" = None

    @property
    def area(self):
        return self.width * self.depth

    @property
    def inertia(self):
        return self.width * self.depth**3 / 12

    @property
    def torsion_constant(self):
        """J: torque over shear modulus and twist (Timoshenko and Goodier, Theory of Elasticity, 1951, article 94)"""
        long, short = max(self.width, self.depth), min(self.width, self.depth)
        k = np.arange(1, 40, 2)
        series = (np.tanh(k * np.pi * long / (2 * short)) / k**5).sum()
        return long * short**3 * (1 / 3 - 64 * short / (np.pi**5 * long) * series)

    @property
    def shear_modulus(self):
        """kappa G"""
        kappa = self.shear_factor or 10 * (1 + self.poisson) / (12 + 11 * self.poisson)
        return kappa * self.modulus / (2 * (1 + self.poisson))

    @property
    def cut_off(self):
        return np.sqrt(self.shear_modulus * self.area / (self.density * self.inertia))

    def static(self, x, loaded=None):
        """deflection of the section x under a unit force on it, or on the section `loaded` beyond it"""
        loaded = x if loaded is None else loaded
        return (loaded * x**2 / 2 - x**3 / 6) / (self.modulus * self.inertia) + x / (self.shear_modulus * self.area)

    def length_with_tip(self, deflection):
        """how far from the clamp a unit force makes the deflection below it"""
        return brentq(lambda x: self.static(x) - deflection, 0.0, 1e3 * self.length)

    def first_frequency(self):
        """circular"""
        return next(frequencies(self))


class Waves:
    """the four parts of the deflection at one frequency"""

    def __init__(self, beam, omega):
        self.length = beam.length
        bending, shear = (beam.density * omega**2 / modulus for modulus in (beam.modulus, beam.shear_modulus))
        root = np.sqrt((bending - shear) ** 2 / 4 + bending * beam.area / beam.inertia)
        self.p = np.sqrt(root - (bending + shear) / 2)
        self.q = np.sqrt(root + (bending + shear) / 2)
        # theta over w of the exponentials and of the sines
        self.k, self.m = self.p + shear / self.p, self.q - shear / self.q

    def at(self, x):
        """w, theta, theta_x and w_x - theta"""
        p, q, k, m = self.p, self.q, self.k, self.m
        near, far = np.exp(-p * x), np.exp(-p * (self.length - x))
        cos, sin = np.cos(q * x), np.sin(q * x)
        return (np.array([near, far, cos, sin]), np.array([-k * near, k * far, -m * sin, m * cos]),
                np.array([k * p * near, k * p * far, -m * q * cos, -m * q * sin]),
                np.array([(k - p) * near, (p - k) * far, (m - q) * sin, (q - m) * cos]))

    def conditions(self):
        """those of the clamp and of the free end on the amplitudes, scaled to order one"""
        clamped, free = self.at(0.0), self.at(self.length)
        return np.array([clamped[0], clamped[1] / self.q, free[2] / self.q**2, free[3] / (self.k - self.p)])


class Mode:
    """a natural mode and its mass"""

    def __init__(self, beam, omega):
        self.omega, self.waves = omega, Waves(beam, omega)
        (self.amplitudes,) = null_space(self.waves.conditions(), rcond=1e-9).T
        nodes, weights = np.polynomial.legendre.leggauss(200)
        w, theta = (np.tensordot(self.amplitudes, part, 1) for part in self.waves.at(beam.length * (nodes + 1) / 2)[:2])
        self.mass = beam.length / 2 * beam.density * weights @ (beam.area * w**2 + beam.inertia * theta**2)

    def deflection(self, x):
        return self.amplitudes @ self.waves.at(x)[0]

    def flexibility(self, x):
        """share of the mode in the static deflection of x under a unit force"""
        return self.deflection(x) ** 2 / (self.mass * self.omega**2)


def frequencies(beam):
    """circular frequencies of the modes below the cut-off, one after the other"""
    def determinant(omega):
        return np.linalg.det(Waves(beam, omega).conditions())

    # frequencies grow at most with the square of their number, and the first is about 3.5 of the unit
    unit = np.sqrt(beam.modulus * beam.inertia / (beam.density * beam.area)) / beam.length**2
    grid = np.append(np.arange(0.5, np.sqrt(0.999 * beam.cut_off / unit), 0.05) ** 2 * unit, 0.999 * beam.cut_off)
    before = determinant(grid[0])
    for low, high in zip(grid, grid[1:]):
        after = determinant(high)
        if before * after < 0:
            yield brentq(determinant, low, high, xtol=1e-9, rtol=1e-14)
        before = after


def modes(beam):
    """all below the cut-off"""
    return [Mode(beam, omega) for omega in frequencies(beam)]


def amplification(omega, pulse, t):
    """deflection of an oscillator over its static one: pulse is a list of (time, step, change of slope)"""
    total = np.zeros_like(t)
    for start, step, slope in pulse:
        after = np.maximum(t - start, 0.0)
        total += step * (1 - np.cos(omega * after)) + slope * (after - np.sin(omega * after) / omega)
    return total


def deflection(beam, x, force, pulse, t):
    """of the section x under force times pulse on it"""
    return force * sum(mode.flexibility(x) * amplification(mode.omega, pulse, t) for mode in modes(beam))
