# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""packing.py [SEED]: writes random.data, a random packing (62 % dense, diameters within 20 %) in a box of 32 x 6 x 6 mean
diameters, for in.bar-strength. The mass of a particle is its share of the box."""

import sys
from pathlib import Path

import numpy as np

from potdem import networks

HERE = Path(__file__).resolve().parent


def main(seed=1):
    body = networks.packing(6, 32, spread=0.2, seed=seed)
    lines = [f"random packing, seed {seed}\n\n{len(body.x)} atoms\n1 atom types\n1 bond types\n150 extra bond per atom\n"
             "150 extra special per atom\n"]
    lines += [f"{-edge / 2 - 3:g} {edge / 2 + 3:g} {k}lo {k}hi" for k, edge in zip("xyz", body.size)] + ["\nAtoms # bpm/sphere\n"]
    for i, (x, d, v) in enumerate(zip(body.x - 0.5 * body.size, body.d, body.v), start=1):
        lines.append(f"{i} 0 1 {d:.4f} {v / (np.pi / 6 * round(d, 4)**3):.6f} " + " ".join(f"{c:.5f}" for c in x))
    (HERE / "random.data").write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
