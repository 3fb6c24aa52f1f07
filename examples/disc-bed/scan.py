# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""How does the disc rebound and break, and what does the bed do, as a function of what the thesis does not state?

  scan.py NAME=VALUE[,VALUE ...] ...      e.g. scan.py damping=0,0.05 mu=0,0.3 time=0.4 picture=no
  scan.py FOLDER ...                      of finished runs

Runs in.disc-bed for every combination and prints what outcome() finds.
"""

import sys
from pathlib import Path

import numpy as np

from potdem import logs
from potdem.scenes import scanning

HERE = Path(__file__).resolve().parent

BONDS, PARTICLES, GRAINS, SPEED = 16466, 1260, 1581, 5.0


def after_impact(table):
    """the rows after the last one in which the disc falls with its first velocity or more"""
    first = np.flatnonzero(table["v_speed"] <= -SPEED)[-1] + 1
    return {name: values[first:] for name, values in table.items()}


def outcome(table):
    """what measure() prints; the disc with all its pieces rises from its lowest height so far; a largest piece of less than a tenth of the disc counts for no velocity and no depth"""
    late = after_impact(table)
    height = late["v_height"]
    whole = late["v_largest"] >= PARTICLES / 10
    return {"speed": max(late["v_vlarge"][whole], default=float("nan")), "speed_all": late["v_speed"].max(),
            "rise": (height - np.minimum.accumulate(height)).max(),
            "broken": late["v_broken"][-1], "pieces": late["v_pieces"][-1], "largest": late["v_largest"][-1],
            "single": late["v_n1"][-1], "depth": late["v_depth"][whole].max(initial=-1.0), "high": late["v_high"].max(),
            "far": late["v_far"].max(), "far_end": late["v_far"][-1]}


def measure(folder):
    found = outcome(logs.read_thermo(next(folder.glob("log.*"))))
    return ("upwards: largest piece {speed:.2f} m/s, disc {speed_all:.2f}, which rises {rise:.3f} m; {broken:.0f} broken, {pieces:.0f} pieces, largest "
            "{largest:.0f}, single {single:.0f}; depth {depth:.3f} m; highest grain {high:.2f} m; moved more than d: "
            "{far:.0f}, at the end {far_end:.0f}").format(**found)


if __name__ == "__main__":
    scanning.main(HERE, measure, sys.argv[1:])
