# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Measures grains: the slope of a heap, the rate at which a bin empties, Beverloo's law."""

import numpy as np
from scipy.stats import theilslopes

LEFT_OUT = 3.0    # mean diameters at the foot and at the top of a slope that are not measured


def surface(frame, across, cell, long):
    """(x, height): the top of the grains in cells of this size, the median of those that lie side by side. frame: a dump of
    grains between x = 0 and `long` that is periodic in y, with the period `across`"""
    row = np.floor(frame["x"] / cell).astype(int)
    rows, columns = int(long / cell + 0.5), max(1, round(across / cell))
    column = np.floor(frame["y"] % across / across * columns).astype(int) % columns
    top = np.full((rows, columns), -np.inf)
    inside = (row >= 0) & (row < rows)
    np.maximum.at(top, (row[inside], column[inside]), (frame["z"] + frame["radius"])[inside])
    return (np.arange(rows) + 0.5) * cell, np.median(top, axis=1)


def solid_fraction(frame, across, long, low, high):
    """of the grains whose centres are in a layer, by their whole volume"""
    inside = (frame["z"] > low) & (frame["z"] < high)
    return float(4 / 3 * np.pi * (frame["radius"][inside] ** 3).sum() / (across * long * (high - low)))


def filled(frame, across, cell, long, solid):
    """(x, height) of the same grains as strips of the length `cell` that their volume fills with this solid fraction"""
    edges = np.arange(int(long / cell + 0.5) + 1) * cell
    volume, _ = np.histogram(frame["x"], edges, weights=4 / 3 * np.pi * frame["radius"] ** 3)
    return edges[:-1] + 0.5 * cell, volume / (cell * across * solid)


def slope(x, height, diameter):
    """(angle in degrees, height at x = 0, slope) of a surface that falls along x: the median of the slopes between all pairs of
    places, a few diameters from both ends left out"""
    chosen = (x > LEFT_OUT * diameter) & (x < x[-1] + 0.5 * (x[1] - x[0]) - LEFT_OUT * diameter)
    falls, start, *_ = theilslopes(height[chosen], x[chosen])
    return float(np.degrees(np.arctan(-falls))), float(start), float(falls)


def rate(time, mass, first, last):
    """(rate, largest deviation from it over the mass) while the bin empties from the share `first` to the share `last`"""
    share = mass / mass[0]
    chosen = (share < first) & (share > last)
    fit = np.polyfit(time[chosen], mass[chosen], 1)
    return float(-fit[0]), float(np.abs(np.polyval(fit, time[chosen]) - mass[chosen]).max() / mass[0])


def beverloo(widths, rates, power):
    """(factor, shift, largest relative deviation) of rate = factor (width - shift)^power"""
    widths, rates = np.asarray(widths), np.asarray(rates)
    grows, start = np.polyfit(widths, rates ** (1 / power), 1)
    factor, shift = grows**power, -start / grows
    return float(factor), float(shift), float(np.abs(factor * (widths - shift) ** power / rates - 1).max())
