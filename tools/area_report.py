#!/usr/bin/env python3
# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""What the areas of the trusses are worth: beams of several lattices and packings, their stiffness in tension, bending and torsion,
the tip deflection and the first frequency of the cantilever, over the exact values of the solid; free spheres cut from lattices; and beams
with a Poisson's ratio that is given (docs/area.md).

The areas of `area body` come from LAMMPS, with a given Poisson's ratio from the solver of tools/area_constants.py, which is the same;
those of the rejected formulations are found here. All networks are solved by potdem/networks.py.

Usage: tools/area_report.py [--lmp build/lmp] [--quick] [--only beams|spheres|poisson]       prints the tables of docs/area.md in Markdown
"""

import argparse
import os
import tempfile
from pathlib import Path

import area_constants
import numpy as np
import scipy.sparse
import scipy.sparse.linalg

from potdem import networks
from potdem.paths import LMP
from potdem.sections import areas_in_lammps


NAMES = {"sc": "cubic"}


class Bonds:
    """the ends, lengths and directions that the rejected formulations need"""

    def __init__(self, body, pairs):
        self.pairs, self.count = pairs, len(body.x)
        line = body.x[pairs[:, 1]] - body.x[pairs[:, 0]]
        self.length = np.linalg.norm(line, axis=1)
        self.n = line / self.length[:, None]

    def at_particles(self, values):
        """sum over the bonds of each particle"""
        return sum(np.bincount(self.pairs[:, k], values, self.count) for k in (0, 1))


def energy_match(body, bonds):
    """one factor per particle, a bond has the mean of its ends', so that each particle stores the energy of its volume, mean
    over all uniform strains (sum A L / 2 = 6 V for nu = 1/4): iterated scaling"""
    scale = np.ones(bonds.count)
    for _ in range(200):
        area = scale[bonds.pairs].mean(axis=1)
        scale *= np.sqrt(6 * body.v / (0.5 * bonds.at_particles(area * bonds.length)))
    return scale[bonds.pairs].mean(axis=1)


def patch(body, bonds):
    """a plain patch test with surfaces: least squares over the net force of each particle in the three uniaxial states that
    its own faces can carry, loads on the beam's ends; the first trial of the project without its linear states"""
    faces = np.abs(body.x - 0.5 * body.size) > 0.5 * body.size - 0.55
    faces[:, 0] = False
    start = np.full(len(bonds.pairs), 6 * body.v.sum() / (0.5 * bonds.at_particles(bonds.length).sum()))
    rows, columns, values, wanted = [], [], [], []
    for a in range(3):
        stretch = 1.25 * bonds.n[:, a]**2 - 0.25
        for k in range(3):
            for end, sign in ((0, 1.0), (1, -1.0)):
                at = bonds.pairs[:, end]
                live = ~faces[at, a]
                rows.append(bonds.count * len(wanted) + at[live])
                columns.append(np.flatnonzero(live))
                values.append((sign * start * stretch * bonds.n[:, k])[live])
            load = np.zeros(bonds.count)
            if a == k == 0:
                ends = np.abs(body.x[:, 0] - 0.5 * body.size[0]) > 0.5 * body.size[0] - 0.75
                load[ends] = np.sign(0.5 * body.size[0] - body.x[ends, 0]) * (
                    body.size[1] * body.size[2] / (0.5 * ends.sum()))
            wanted.append(load)
    matrix = scipy.sparse.csr_matrix((np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))),
                                     (3 * 3 * bonds.count, len(bonds.pairs)))
    rest = np.concatenate(wanted) - matrix @ np.ones(len(bonds.pairs))
    change = scipy.sparse.linalg.lsmr(matrix, rest, damp=0.005, maxiter=300)[0]
    return start * np.clip(1 + change, 0.1, 4.0)


def bodies(quick):
    """(name, r_infl, depth, body)"""
    reaches = (2.0,) if quick else (1.42, 1.75, 2.0, 2.5)
    for lattice, depths in (("sc", (5, 10)), ("fcc", (5.6, 9.9)), ("hcp", (5, 10)), ("bcc", (4.6, 9.2))):
        for k, depth in enumerate(depths):
            body = networks.beam(lattice, depth, 50 if k == 0 else 80)
            for reach in reaches if k == 0 and lattice in ("sc", "fcc") else (2.0,):
                yield NAMES.get(lattice, lattice), reach, body
    for depth in (6, 10):
        yield "random", 2.0, networks.packing(depth, 8 * depth, spread=0.2)


def print_spheres(lmp, _quick):
    """lowest modes, over those of the solid sphere of the same volume"""
    print("| sphere | across | area | twisted | flattened |")
    print("|---|---|---|---|---|")
    for lattice, radii in (("sc", (4, 6, 8, 11)), ("fcc", (4, 5, 8))):
        for radius in radii:
            body = networks.sphere(lattice, radius)
            pairs = body.pairs(2.0)
            for area in ("lattice", "body"):
                modes = networks.sphere_modes(body, pairs, areas_in_lammps(lmp, body, pairs, 2.0, area))
                print(f"| {NAMES.get(lattice, lattice)} | {2 * radius} | `{area}` | " +
                      " | ".join(f"{found / exact:.3f}" for found, exact in zip(modes, networks.SPHERE)) + " |", flush=True)


def print_beams(lmp, quick):
    print("| body | depth | $r_{\\mathrm{infl}}/d$ | area | tension | bending | torsion | tip | frequency | clamp |")
    print("|---|---|---|---|---|---|---|---|---|---|")
    for name, reach, body in bodies(quick):
        pairs = body.pairs(reach)
        bonds = Bonds(body, pairs)
        candidates = [(f"`{area.split(' density')[0]}`", areas_in_lammps(lmp, body, pairs, reach, area))
                      for area in ("factor 0.4", "lattice", "body density 1")]
        if reach == 2.0:
            candidates += [("energy match", energy_match(body, bonds)), ("patch", patch(body, bonds))]
        for label, area in candidates:
            if area is None:
                continue
            ratio = networks.measure(body, pairs, area, reach)
            print(f"| {name} | {body.size[2]:.3g} | {reach} | {label} | " +
                  " | ".join(f"{ratio[k]:.3f}" for k in ("axial", "bending", "torsion", "tip", "frequency")) +
                  f" | {ratio['clamp']:.2f} |", flush=True)


RATIOS = (0.0, 0.1, 0.18, 0.25, 0.33, 0.42, 0.49)


def print_poisson(_lmp, quick):
    """with `nu x area body`"""
    print("| body | depth | nu | tension | bending | torsion | tip | frequency | nu found |")
    print("|---|---|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        solver = area_constants.build(Path(folder), os.environ.get("CXX", "g++"))
        for name, lattice, depth in (("cubic", "sc", 5), ("cubic", "sc", 10), ("fcc", "fcc", 5.6), ("random", None, 6)):
            if quick and depth > 6:
                continue
            body = networks.beam(lattice, depth, 8 * depth if depth > 6 else 50) if lattice else networks.packing(depth, 8 * depth, 0.2)
            pairs = np.sort(body.pairs(2.0), axis=1)
            for nu in RATIOS:
                area, dilatation = area_constants.solve_solid(solver, body, pairs, nu)
                ratio = networks.measure(body, pairs, area, 2.0, poisson=nu, dilatation=dilatation if nu != 0.25 else None)
                print(f"| {name} | {body.size[2]:.3g} | {nu} | " +
                      " | ".join(f"{ratio[k]:.3f}" for k in ("axial", "bending", "torsion", "tip", "frequency", "poisson")) + " |",
                      flush=True)


TABLES = {"beams": print_beams, "spheres": print_spheres, "poisson": print_poisson}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--lmp", default=LMP, type=lambda name: Path(name).resolve())
    parser.add_argument("--quick", action="store_true", help="r_infl = 2 d only")
    parser.add_argument("--only", choices=TABLES, help="one of the tables")
    arguments = parser.parse_args()
    for name, table in TABLES.items():
        if arguments.only in (None, name):
            table(arguments.lmp, arguments.quick)


if __name__ == "__main__":
    main()
