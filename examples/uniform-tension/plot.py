# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""plot.py FOLDER [FOLDER ...] PICTURE.png: area factor and Poisson's ratio against the influence radius, as in the
thesis's Fig. 5.8, for the runs in the folders (build/examples/uniform-tension/<variant>.np<ranks>), over the exact
staircase of the infinite lattice. Prints how far LAMMPS is from theory, and ends with an error where that is more
than the tolerance."""

import sys
from pathlib import Path

import numpy as np

from potdem import lattices, logs, networks, picture

TOLERANCE = 1e-5    # strains are up to 1e-6, and a truss is linear only to first order
NAMES = {"sc": "cubic", "fcc": "close-packed (fcc)"}
MARKS = {"sc": "o", "fcc": "s"}
INK = {"sc": "#20516e", "fcc": "#b5651d"}
SIZES = {5: "#d1495b", 10: "#66a182", 20: "#8d6cab"}
FINE = np.linspace(1.0, 2.55, 1551)


class Result:
    """the equilibrium states of one run"""

    def __init__(self, folder):
        log = next(Path(folder).glob("log*"))
        given = logs.parameters(log.read_text(encoding="utf-8"))
        self.lattice, self.cells, self.bulk = given["lattice"], int(given["cells"]), given["body"] == "bulk"
        table = logs.read_thermo(log)
        rows = table["Step"] > 0
        columns = ("v_r_infl", "v_a", "v_a_edge", "v_nu")
        self.reach, self.a, self.a_edge, self.nu = (table[name][rows] for name in columns)

    @property
    def size(self):
        return self.cells * lattices.edge(self.lattice)

    @property
    def label(self):
        return "infinite" if self.bulk else f"free cube, $l/d$ = {self.size:.3g}"

    def deviation(self):
        """the largest relative one of a and nu from theory"""
        if self.bulk:
            expected = [lattices.infinite(self.lattice, reach)[1:3] for reach in self.reach]
        else:
            expected = [networks.free_cube(self.lattice, self.cells, reach) for reach in self.reach]
        difference = np.abs(np.column_stack([self.a, self.nu]) - expected)
        return float(np.max(difference / np.maximum(np.abs(expected), TOLERANCE)))

    def colour(self):
        return INK[self.lattice] if self.bulk else SIZES[min(SIZES, key=lambda size: abs(size - self.size))]


def staircase(axis, lattice, column):
    """exact values; the area factor jumps where a shell of neighbours joins"""
    values = np.array([lattices.infinite(lattice, reach)[column] for reach in FINE])
    axis.plot(2 * FINE, values, color=INK[lattice], lw=1.4, label=f"exact, infinite {NAMES[lattice]}")


def areas(axis, lattice, results):
    staircase(axis, lattice, 1)
    for result in results:
        style = {"ls": "none", "marker": MARKS[lattice], "color": result.colour(), "ms": 6}
        axis.plot(2 * result.reach, result.a, **style, label=result.label)
        if not result.bulk:
            axis.plot(2 * result.reach, result.a_edge, **style, mfc="none")
    axis.plot([], [], ls="none", marker=MARKS[lattice], color="grey", mfc="none", ms=6,
              label="... elongation over the whole edge")
    axis.plot(4, 0.4, "x", color="black", ms=8, mew=2, label="thesis: 0.4")
    axis.set_ylim(0, 0.75)
    axis.set_title(f"{NAMES[lattice]}: area factor $a$")


def ratios(axis, results):
    for lattice in NAMES:
        staircase(axis, lattice, 2)
    for result in results:
        axis.plot(2 * result.reach, result.nu, MARKS[result.lattice], color=result.colour(), ms=6)
    axis.axhline(1 / 3, color="black", lw=1, ls=(0, (4, 3)), label="thesis: tends to 1/3")
    axis.set_ylim(0, 0.36)
    axis.set_title(r"Poisson's ratio $\nu$")


def main(*arguments):
    *folders, path = arguments
    results = [Result(folder) for folder in folders]
    figure, (axes,) = picture.curves(1, 3, 4.2)
    for axis, lattice in zip(axes, NAMES):
        areas(axis, lattice, [result for result in results if result.lattice == lattice])
    ratios(axes[2], results)
    for axis in axes:
        axis.set_xlim(2.75, 5.15)
        axis.set_xlabel(r"$r_{\mathrm{infl}}\,/\,r$")
        axis.legend(fontsize=picture.FONT - 3)
    picture.save(figure, path)

    worst = [result.deviation() for result in results]
    for result, value in zip(results, worst):
        print(f"{NAMES[result.lattice]}, {result.label}: largest relative deviation from theory {value:.1e}")
    if not max(worst) < TOLERANCE:
        sys.exit(f"LAMMPS and theory differ by more than {TOLERANCE:g}")


if __name__ == "__main__":
    main(*sys.argv[1:])
