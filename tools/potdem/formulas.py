# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""The laws as the pages in docs/ state them, written independently of the C++ code: energy, force (positive
repels) and stiffness. Everywhere the arguments may be arrays, and the units any that go together."""

import math
from dataclasses import dataclass
from typing import Callable

import numpy as np


def sphere_mass(diameter, density=1.0):
    return density * math.pi / 6.0 * diameter**3


# --- trusses; modulus: E A; x: the length over that at rest ---------------------------------------------------

def section(mean_diameter, a=1.0):
    """area of a truss of area factor a"""
    return a * math.pi / 4.0 * mean_diameter**2


def strain(x):
    """Green's"""
    return (x - 1) + (x - 1) ** 2 / 2


def penetration(x, m, normalized=False):
    """eq. 5.22 of the thesis; m = 0: none"""
    x = np.asarray(x, dtype=float)
    if m == 0:
        return np.ones_like(x)

    def c(y):
        return (1 + (1 + y) ** -float(m)) / (1 - (1 + y) ** -float(m))

    return c(x) / (c(1.0) if normalized else 1.0)


def penetration_slope(x, m):
    """its derivative"""
    return -m * (1 + x) ** -(m + 1) * (1 + penetration(x, m)) / (1 - (1 + x) ** -m) if m else 0 * x


def truss_tension(x, modulus, m=0, normalized=False):
    """axial force A E c eps of a truss, positive in tension"""
    return modulus * penetration(x, m, normalized) * strain(x)


def truss_energy(x, length, modulus, m=0, normalized=False):
    """integral of the tension from rest"""
    if m == 0:
        return modulus * length * ((x - 1) ** 2 / 2 + (x - 1) ** 3 / 6)
    return modulus * length * quadrature(lambda y: penetration(y, m, normalized) * strain(y), x)


def quadrature(function, x):
    """integral of the function from 1 to x > 0, in ln x, where a 1/x in it is smooth"""
    nodes, weights = np.polynomial.legendre.leggauss(100)
    half = np.log(x)[..., None] / 2
    points = np.exp(half * (1 + nodes))
    return (half * weights * points * function(points)).sum(axis=-1)


# --- laws of s or of the overlap: (energy, force, stiffness) ---------------------------------------------------

def lennard_jones_of(K0, R, n):
    """eqs 5.9 to 5.11 without the cut, of s"""
    depth = K0 * R**2 / (2 * n**2)

    def phi(s):
        return depth * ((R / s) ** (2 * n) - 2 * (R / s) ** n)

    def force(s):
        return depth * (2 * n * R ** (2 * n) / s ** (2 * n + 1) - 2 * n * R**n / s ** (n + 1))

    def stiffness(s):
        return depth * (2 * n * (2 * n + 1) * R ** (2 * n) / s ** (2 * n + 2)
                        - 2 * n * (n + 1) * R**n / s ** (n + 2))

    return phi, force, stiffness


def lennard_jones_cut(R, n):
    """s_d, where the attraction is strongest"""
    return R * (2 * n + 1) ** (1 / n) / (n + 1) ** (1 / n)


def granular_of(K0, first, n):
    """eqs 5.12 to 5.14 without the cut, of s; first: s at first contact"""
    c = K0 * first ** (n + 1) / n
    return lambda s: c / (n - 1) / s ** (n - 1), lambda s: c / s**n, lambda s: c * n / s ** (n + 1)


def granular_cut(n):
    """s over that at first contact where the force is a thousandth of that there"""
    return 1000 ** (1 / n)


def hertz_of(K):
    """of the overlap w, F = K w^1.5"""
    return lambda w: 2 / 5 * K * w**2.5, lambda w: K * w**1.5, lambda w: 1.5 * K * w**0.5


def hertz_prefactor(modulus, d1, d2):
    """K of two spheres of diameters d1 and d2; modulus: that of the contact, eq. 5.15b"""
    return 4 / 3 * modulus * np.sqrt(1 / (1 / d1 + 1 / d2) / 2)


# --- laws of the distance r, to be drawn and solved; p: the attributes of the particles and the law --------------

@dataclass
class Law:
    """what there is to know about a law to draw it"""

    title: str
    phi: Callable
    force: Callable
    stiffness: Callable
    ends: tuple                 # distances at which a branch begins or ends
    axis: str                   # label of the abscissa
    abscissa: Callable          # of r
    guide: tuple = ()           # (label, energy, force, stiffness) for comparison, or nothing
    tops: tuple = (None,) * 3   # highest values shown of energy, force, stiffness, where the law has no limit


def within(inside, value):
    """value where inside, 0 elsewhere; values that do not exist there are not looked at"""
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.where(inside, value, 0.0)


def lennard_jones(p):
    """eqs 5.9 to 5.11, cut at s_d"""
    core = (1 - p["alpha"]) * (p["d1"] + p["d2"]) / 2
    R, n, K0 = p["R"], p["n"], p["K0"]
    laws, cut = lennard_jones_of(K0, R, n), lennard_jones_cut(R, n)

    def cut_off(function):
        return lambda r: within(r - core < cut, function(r - core))

    def uncut(function):
        return lambda r: function(r - core)

    return Law(f"shifted Lennard-Jones, n = {n:g}", *map(cut_off, laws), (core + cut,),
               r"$s\,/\,R$", lambda r: (r - core) / R, ("without the cut", *map(uncut, laws)),
               (K0 * R**2 / (2 * n**2), 4 * K0 * R / (2 * n + 1), 4 * K0))


def granular(p):
    """eqs 5.12 to 5.14, cut where the force is a thousandth of that at first contact"""
    dbar = (p["d1"] + p["d2"]) / 2
    core, first = (1 - p["alpha"]) * dbar, p["alpha"] * dbar
    n, K0 = p["n"], p["K0"]
    laws, cut = granular_of(K0, first, n), granular_cut(n)

    def cut_off(function):
        return lambda r: within(r - core < cut * first, function(r - core))

    def ideal(function):
        return lambda r: within(r < dbar, function(dbar - r))

    linear = (lambda w: K0 * w**2 / 2, lambda w: K0 * w, lambda w: K0 + 0 * w)
    return Law(f"regularised granular law, n = {n:g}", *map(cut_off, laws), (core + cut * first,),
               r"$s\,/\,2\delta$", lambda r: (r - core) / first, ("linear contact", *map(ideal, linear)),
               tuple(4 * law(first) for law in laws))


def modulus(p):
    """eq. 5.15b"""
    return 1 / ((1 - p["nu1"] ** 2) / p["E1"] + (1 - p["nu2"] ** 2) / p["E2"])


def hertz(p):
    """eqs 5.15 and 5.16"""
    dbar = (p["d1"] + p["d2"]) / 2
    laws = hertz_of(hertz_prefactor(modulus(p), p["d1"], p["d2"]))

    def contact(function):
        return lambda r: within(r < dbar, function(np.maximum(dbar - r, 0)))

    return Law("Hertz", *map(contact, laws), (dbar,), r"overlap $w\,/\,\bar d$", lambda r: (dbar - r) / dbar)


def truss(p, length, modulus, m=0):
    """eqs 5.19 to 5.21 and, with m, 5.22 and 5.23a on the force: (energy, force, stiffness) of r"""
    stress = modulus * p["area"] * np.pi / 4 * ((p["d1"] + p["d2"]) / 2) ** 2
    return (lambda r: truss_energy(r / length, length, stress, m), lambda r: -truss_tension(r / length, stress, m),
            lambda r: stress / length * (penetration(r / length, m) * r / length + penetration_slope(r / length, m) * strain(r / length)))


def truss_contact(p):
    """eq. 5.20 between particles that are not bonded; the two are springs in series (eq. 3.8)"""
    dbar = (p["d1"] + p["d2"]) / 2
    laws = truss(p, dbar, 2 / (1 / p["E1"] + 1 / p["E2"]))

    def contact(function):
        return lambda r: within(r < dbar, function(r))

    return Law("truss contact", *map(contact, laws), (dbar,), r"$r\,/\,\bar d$", lambda r: r / dbar)


def bond(p):
    length = p["rest"]
    dbar = (p["d1"] + p["d2"]) / 2
    times = f"{length / dbar:g}" if length != dbar else ""
    title = rf"truss bond, rest length ${times}\,\bar d$"
    return Law(title, *truss(p, length, p["E1"]), (), r"$r\,/\,r_e$", lambda r: r / length)


def bond_penetration(p):
    """eqs 5.22 and 5.23a, on the force"""
    m, length = p["m"], p["rest"]
    return Law(f"truss bond with non-penetration, m = {m:g}", *truss(p, length, p["E1"], m), (), r"$r\,/\,r_e$",
               lambda r: r / length, ("without non-penetration", *truss(p, length, p["E1"])))


def wall(p):
    """eqs 5.25 to 5.28 under a soft layer"""
    radius = p["d2"] / 2
    gamma = p["layer"] * radius
    q = 1 / p["m"]
    K = 4 / 3 * modulus(p) * np.sqrt(radius)

    def phi(w):
        soft = K * gamma**-q * np.minimum(w, gamma) ** (2.5 + q) / (2.5 + q)
        return soft + np.where(w > gamma, 2 / 5 * K * (w**2.5 - gamma**2.5), 0.0)

    def force(w):
        return K * w**1.5 * np.minimum(1, w / gamma) ** q

    def stiffness(w):
        return np.where(w < gamma, (1.5 + q) * K * gamma**-q * w ** (0.5 + q), 1.5 * K * w**0.5)

    def contact(function, start=radius + gamma):
        return lambda z: within(z < start, function(np.maximum(start - z, 0)))

    return Law(f"wall under a soft layer, m = {p['m']:g}", *map(contact, (phi, force, stiffness)),
               (radius + gamma, radius), r"$w\,/\,\gamma$", lambda z: (radius + gamma - z) / gamma,
               ("Hertz, no layer", *map(contact, hertz_of(K))))


LAWS = {"lj": lennard_jones, "granular": granular, "hertz": hertz, "truss-contact": truss_contact, "bond": bond,
        "bond-far": bond, "bond-penetration": bond_penetration, "wall": wall}
