#!/usr/bin/env python3
"""What the areas of the trusses are worth: beams of several lattices and packings, their stiffness in tension and bending,
the tip deflection and the first frequency of the cantilever, over the exact values of the solid (docs/area.md).

The areas of `area body` come from LAMMPS, those of the rejected formulations are found here; all networks are solved by
truss_network.py.

Usage: tools/area_report.py [--lmp build/lmp] [--quick]       prints the table of docs/area.md in Markdown
"""

import argparse
import subprocess
import tempfile
from pathlib import Path

import numpy as np
import scipy.sparse
import scipy.sparse.linalg
import truss_network as networks

ROOT = Path(__file__).resolve().parent.parent
SCRIPT = """units si
newton on off
atom_style bpm/sphere
boundary f f f
read_data particles.data
potdem_bonds all 1 {reach:.17g} diameters
pair_style potdem/truss
pair_coeff * * 1 0.5
bond_style potdem/truss
bond_coeff * 1 area {area}
compute ends all property/local batom1 batom2
compute areas all bond/local b3
dump areas all local 1 areas.dump c_ends[1] c_ends[2] c_areas
dump_modify areas format float %.17g
run 0
"""


def areas_in_lammps(lmp, body, pairs, reach, area):
    """the sections of the pairs, in their order; None where the package refuses"""
    density = body.v / (np.pi / 6 * body.d**3)    # mass = volume of the solid
    low, high = body.x.min() - 1.0, body.x.max() + 1.0
    lines = [f"particles\n\n{len(body.x)} atoms\n1 atom types\n1 bond types\n200 extra bond per atom\n"
             "200 extra special per atom\n"]
    lines += [f"{low} {high} {k}lo {k}hi" for k in "xyz"] + ["\nAtoms # bpm/sphere\n"]
    lines += [f"{i + 1} 0 1 {d:.17g} {rho:.17g} {x[0]:.17g} {x[1]:.17g} {x[2]:.17g}"
              for i, (x, d, rho) in enumerate(zip(body.x, body.d, density))]
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        (folder / "particles.data").write_text("\n".join(lines) + "\n")
        (folder / "in.areas").write_text(SCRIPT.format(reach=reach, area=area))
        done = subprocess.run([lmp, "-in", "in.areas", "-log", "none"], cwd=folder, capture_output=True, text=True, check=False)
        if done.returncode:
            return None
        text = (folder / "areas.dump").read_text().split("ITEM: ENTRIES")[1].splitlines()[1:]
    found = {}
    for line in text:
        i, j, section = line.split()
        found[tuple(sorted((int(i) - 1, int(j) - 1)))] = float(section)
    return np.array([found[tuple(sorted(pair))] for pair in pairs.tolist()])


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
    for lattice, depths in (("cubic", (5, 10)), ("fcc", (5.6, 9.9)), ("hcp", (5, 10)), ("bcc", (4.6, 9.2))):
        for k, depth in enumerate(depths):
            body = networks.beam(lattice, depth, 50 if k == 0 else 80)
            for reach in reaches if k == 0 and lattice in ("cubic", "fcc") else (2.0,):
                yield lattice, reach, body
    for depth in (6, 10):
        yield "random", 2.0, networks.packing(depth, 8 * depth, spread=0.2)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--lmp", default=ROOT / "build" / "lmp", type=lambda name: Path(name).resolve())
    parser.add_argument("--quick", action="store_true", help="r_infl = 2 d only")
    arguments = parser.parse_args()
    print("| body | depth | $r_{\\mathrm{infl}}/d$ | area | axial | bending | tip | frequency | clamp |")
    print("|---|---|---|---|---|---|---|---|---|")
    for name, reach, body in bodies(arguments.quick):
        pairs = body.pairs(reach)
        bonds = Bonds(body, pairs)
        candidates = [(f"`{area.split(' density')[0]}`", areas_in_lammps(arguments.lmp, body, pairs, reach, area))
                      for area in ("factor 0.4", "lattice", "body density 1")]
        if reach == 2.0:
            candidates += [("energy match", energy_match(body, bonds)), ("patch", patch(body, bonds))]
        for label, area in candidates:
            if area is None:
                continue
            ratio = networks.measure(body, pairs, area, reach)
            print(f"| {name} | {body.size[2]:.3g} | {reach} | {label} | " +
                  " | ".join(f"{ratio[k]:.3f}" for k in ("axial", "bending", "tip", "frequency")) +
                  f" | {ratio['clamp']:.2f} |", flush=True)


if __name__ == "__main__":
    main()
