# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""How does the cylinder break, as a function of what the thesis does not state?

  scan.py NAME=VALUE[,VALUE ...] ...      e.g. scan.py strength=2e5,4e5,1e6 damping=0,0.05,0.2
  scan.py FOLDER ...                      of finished runs

Runs in.cylinder-impact for every combination and prints: when the cylinder leaves the plane, and, at 0.2 s, 0.4 s and
at the end, the broken bonds, the pieces, and the share of the particles in pieces of 1, of 2 to 99, and in the
largest.
"""

import sys
from pathlib import Path

import numpy as np

from potdem import logs
from potdem.scenes import scanning

HERE = Path(__file__).resolve().parent

SIZES = ("v_n1", "v_n2", "v_n10", "v_n100")    # particles in pieces of 1, 2 to 9, 10 to 99, 100 and more
INSTANTS = (0.2, 0.4, 0.8)    # s


def at(table, instant):
    """the row of the thermo output nearest to an instant"""
    row = np.argmin(np.abs(table["Time"] - instant))
    return {name: values[row] for name, values in table.items()}


def share(row, *names):
    """per cent of the particles"""
    return 100 * sum(row[name] for name in names) / sum(row[name] for name in SIZES)


def rebound(table):
    """(time, speed) of the first row after which the plane does not push again, or None"""
    free = np.flatnonzero(table["v_force"] > 0)[-1] + 1
    return (table["Time"][free], table["v_speed"][free]) if free < table["Time"].size else None


def measure(folder):
    table = logs.read_thermo(next(folder.glob("log.*")))
    leaves = rebound(table)
    words = ["leaves at %.3f s with %.2f m/s" % leaves if leaves else "stays"]
    for instant in (t for t in INSTANTS if t <= table["Time"][-1] + 1e-9):
        row = at(table, instant)
        words.append(f"{instant} s: {row['v_broken']:.0f} broken, {row['v_pieces']:.0f} pieces, {share(row, 'v_n1'):.1f} "
                     f"{share(row, 'v_n2', 'v_n10'):.1f} {share(row, 'v_largest'):.1f} %")
    return "; ".join(words)


if __name__ == "__main__":
    scanning.main(HERE, measure, sys.argv[1:])
