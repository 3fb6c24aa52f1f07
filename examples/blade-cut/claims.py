# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Claim 9 measured: how high the grains heap in front of the blade, and where the slip line from its tip meets the surface.

  claims.py FOLDER ...                     of examples/run: build/examples/blade-cut/<variant>.np<ranks>
  claims.py NAME=VALUE[,VALUE ...] ...     new runs, e.g. claims.py mu=0.05,0.1,0.2

For each run, after 100 and 200 mm of the blade: the height of the heap over the first surface; how far in front of the blade
the slip line meets the surface, and its angle from the tip to there; the mean share of the blade's way, over the last 10 mm,
that the grains over and beyond the line have gone; the mean force on the blade over the last 20 mm.
"""

import sys
from pathlib import Path

from potdem.scenes import scanning
from potdem.scenes.claim import Claim
from potdem.scenes.scene import beside

slip_line = beside(__file__, "slip_line")

HERE = Path(__file__).resolve().parent


def measure(folder):
    return "; ".join(f"{1e3 * s.way:.0f} mm: heap {1e3 * s.heap:.0f} mm, slip line {1e3 * s.meets:.0f} mm ahead, {s.angle:.0f} deg, "
                     f"{s.over:.2f} over, {s.beyond:.2f} beyond, {s.force:.1f} N" for s in slip_line.states(folder))


def heaps(first, second):
    """over one diameter, and more of it later"""
    return slip_line.D < first.heap < second.heap


def slips(one):
    """a line that rises away from the blade and meets the surface before the last column at the wall, with a block over it"""
    return 0 < one.meets < slip_line.LENGTH - slip_line.D - slip_line.BACK - slip_line.THICK - one.way and one.over > 2 * one.beyond


def claims(folder_of):
    """for the table of examples/run all"""
    runs = {name: slip_line.states(folder_of(name)) for name in ("fast", "slow")}
    measured = "; ".join(
        f"{name}: heap {1e3 * a.heap:.0f} and {1e3 * b.heap:.0f} mm, slip line meets the surface {1e3 * a.meets:.0f} and "
        f"{1e3 * b.meets:.0f} mm ahead of the blade, at {a.angle:.0f} and {b.angle:.0f} degrees" for name, (a, b) in runs.items())
    held = [heaps(*both) for both in runs.values()] + [slips(one) for both in runs.values() for one in both]
    verdict = "yes" if all(held) else "partly" if any(held) else "no"
    return [Claim("9", "blade: the surface heaps in front of the blade, over a slip line from its tip", "as in its reference [2]",
                  measured, verdict)]


if __name__ == "__main__":
    scanning.main(HERE, measure, sys.argv[1:])
