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

PARTICLES = 2275
INSTANTS = (0.2, 0.4, 0.8)    # s


def at(table, instant):
    """the row of the thermo output nearest to an instant"""
    row = np.argmin(np.abs(table["Time"] - instant))
    return {name: values[row] for name, values in table.items()}


def rebound(table):
    """(time, speed) at which the plane no longer pushes, or None"""
    free = np.flatnonzero((table["v_force"] == 0) & (table["v_speed"] > 0))
    return (table["Time"][free[0]], table["v_speed"][free[0]]) if free.size else None


def measure(folder):
    table = logs.read_thermo(next(folder.glob("log.*")))
    leaves = rebound(table)
    words = ["leaves at %.3f s with %.2f m/s" % leaves if leaves else "stays"]
    for instant in (t for t in INSTANTS if t <= table["Time"][-1] + 1e-9):
        row = at(table, instant)
        single, between, largest = (100 * row[n] / PARTICLES for n in ("v_n1", "v_n2", "v_largest"))
        between += 100 * row["v_n10"] / PARTICLES
        words.append(f"{instant} s: {row['v_broken']:.0f} broken, {row['v_pieces']:.0f} pieces, "
                     f"{single:.1f} {between:.1f} {largest:.1f} %")
    return "; ".join(words)


if __name__ == "__main__":
    scanning.main(HERE, measure, sys.argv[1:])
