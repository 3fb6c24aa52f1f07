# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""lattice.py: prints the table of the infinite lattices of this scene, computed without LAMMPS."""

import itertools

from potdem import lattices

REACHES = (1.0, 1.42, 1.75, 2.0, 2.25, 2.5)

if __name__ == "__main__":
    print("lattice  r_infl/d  bonds        a       nu  E110/E100  E111/E100")
    for name, radius in itertools.product(("sc", "fcc"), REACHES):
        print(f"{name:7}  {radius:8.2f}  {{:5}}  {{:7.4f}}  {{:7.4f}}  {{:9.4f}}  {{:9.4f}}".format(*lattices.infinite(name, radius)))
