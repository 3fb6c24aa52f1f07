# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Which strength must the bonds have, so that a bar breaks at 3 MPa? SciPy asks in.pull until it knows.

tools/python examples/recipes/calibrate.py [--strength 3e6] [--size 5]"""

import argparse
import os
import shutil
import tempfile
from pathlib import Path

from potdem.simulation import Simulation
from scipy.optimize import brentq

RECIPES = Path(__file__).resolve().parent
E = 3e10


def strength_of_bar(of_bonds, size):
    """the largest stress of in.pull, in steps of a hundredth of the strain at which bonds fail"""
    at_failure = of_bonds / E
    with Simulation("in.pull", size=size, tension=of_bonds, strain=0.2 * at_failure) as bar:
        steps = int(0.01 * at_failure / (0.1 * bar.thermo("dt")))
        stress = [0.0]
        while len(stress) < 150 and stress[-1] > 0.5 * max(stress[:-1], default=-1.0):
            bar.run(steps)
            stress.append(bar.variable("stress"))
        print(f"bonds of {of_bonds:.4g} Pa: the bar breaks at {max(stress):.4g} Pa, {len(bar.cracks('cracks')['step'])} bonds", flush=True)
    return max(stress)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--strength", type=float, default=3e6, help="that the bar is to have, Pa (default %(default)g)")
    parser.add_argument("--size", type=int, default=5, help="particles across (default %(default)s)")
    arguments = parser.parse_args()
    wanted = arguments.strength
    with tempfile.TemporaryDirectory() as folder:    # for the bar's dumps
        for name in ("in.pull", "pull.lmp"):
            shutil.copy(RECIPES / name, folder)
        os.chdir(folder)
        found = brentq(lambda of_bonds: strength_of_bar(of_bonds, arguments.size) - wanted, 0.9 * wanted, 1.6 * wanted, rtol=2e-3)
        os.chdir(RECIPES)
    print(f"bonds of {found:.4g} Pa give the bar {wanted:.4g} Pa")


if __name__ == "__main__":
    main()
