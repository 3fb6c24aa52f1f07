"""The laws as the pages in docs/ state them, written independently of the C++ code: energy, force (positive
repels) and stiffness as functions of the distance r, in SI units."""

from dataclasses import dataclass
from typing import Callable

import numpy as np


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
    depth = K0 * R**2 / (2 * n**2)
    cut = R * (2 * n + 1) ** (1 / n) / (n + 1) ** (1 / n)

    def phi(s):
        return depth * ((R / s) ** (2 * n) - 2 * (R / s) ** n)

    def force(s):
        return depth * (2 * n * R ** (2 * n) / s ** (2 * n + 1) - 2 * n * R**n / s ** (n + 1))

    def stiffness(s):
        return depth * (2 * n * (2 * n + 1) * R ** (2 * n) / s ** (2 * n + 2)
                        - 2 * n * (n + 1) * R**n / s ** (n + 2))

    def cut_off(function):
        return lambda r: within(r - core < cut, function(r - core))

    def uncut(function):
        return lambda r: function(r - core)

    return Law(f"shifted Lennard-Jones, n = {n:g}", *map(cut_off, (phi, force, stiffness)), (core + cut,),
               r"$s\,/\,R$", lambda r: (r - core) / R, ("without the cut", *map(uncut, (phi, force, stiffness))),
               (depth, 4 * K0 * R / (2 * n + 1), 4 * K0))


def granular(p):
    """eqs 5.12 to 5.14, cut where the force is a thousandth of that at first contact"""
    dbar = (p["d1"] + p["d2"]) / 2
    core, first = (1 - p["alpha"]) * dbar, p["alpha"] * dbar
    n, K0 = p["n"], p["K0"]
    c = K0 * first ** (n + 1) / n
    cut = 1000 ** (1 / n)

    def cut_off(function):
        return lambda r: within(r - core < cut * first, function(r - core))

    def ideal(function):
        return lambda r: within(r < dbar, function(dbar - r))

    laws = (lambda s: c / (n - 1) / s ** (n - 1), lambda s: c / s**n, lambda s: c * n / s ** (n + 1))
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
    reduced = 1 / (1 / p["d1"] + 1 / p["d2"])
    K = 4 / 3 * modulus(p) * np.sqrt(reduced / 2)

    def contact(function):
        return lambda r: within(r < dbar, function(np.maximum(dbar - r, 0)))

    return Law("Hertz", contact(lambda w: 2 / 5 * K * w**2.5), contact(lambda w: K * w**1.5),
               contact(lambda w: 1.5 * K * w**0.5), (dbar,), r"overlap $w\,/\,\bar d$", lambda r: (dbar - r) / dbar)


def truss(p, length, modulus, factor=None):
    """eqs 5.19 to 5.21, (energy, force, stiffness) of r; factor: (c, dc/dx) of x = r / length"""
    stress = modulus * p["area"] * np.pi / 4 * ((p["d1"] + p["d2"]) / 2) ** 2
    c, slope = factor or (lambda x: 1 + 0 * x, lambda x: 0 * x)

    def strain(x):
        return (x - 1) + (x - 1) ** 2 / 2

    def energy(x):
        if factor:
            return stress * length * quadrature(lambda y: c(y) * strain(y), x)
        return stress * length * ((x - 1) ** 2 / 2 + (x - 1) ** 3 / 6)

    return (lambda r: energy(r / length), lambda r: -stress * c(r / length) * strain(r / length),
            lambda r: stress / length * (c(r / length) * r / length + slope(r / length) * strain(r / length)))


def quadrature(function, x):
    """integral of the function from 1 to x > 0, in ln x, where a 1/x in it is smooth"""
    nodes, weights = np.polynomial.legendre.leggauss(100)
    half = np.log(x)[..., None] / 2
    points = np.exp(half * (1 + nodes))
    return (half * weights * points * function(points)).sum(axis=-1)


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

    def c(x):
        return (1 + (1 + x) ** -m) / (1 - (1 + x) ** -m)

    def slope(x):
        return -m * (1 + x) ** -(m + 1) * (1 + c(x)) / (1 - (1 + x) ** -m)

    return Law(f"truss bond with non-penetration, m = {m:g}", *truss(p, length, p["E1"], (c, slope)), (), r"$r\,/\,r_e$",
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

    bare = (lambda w: 2 / 5 * K * w**2.5, lambda w: K * w**1.5, lambda w: 1.5 * K * w**0.5)
    return Law(f"wall under a soft layer, m = {p['m']:g}", *map(contact, (phi, force, stiffness)),
               (radius + gamma, radius), r"$w\,/\,\gamma$", lambda z: (radius + gamma - z) / gamma,
               ("Hertz, no layer", *map(contact, bare)))


LAWS = {"lj": lennard_jones, "granular": granular, "hertz": hertz, "truss-contact": truss_contact, "bond": bond,
        "bond-far": bond, "bond-penetration": bond_penetration, "wall": wall}
