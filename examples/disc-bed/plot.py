# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""plot.py FOLDER [FOLDER ...] PICTURE.png: disc and bed at the thesis's four instants, the grains of the bed in grey, the disc
coloured by the share of its bonds that a particle has lost; below, what happens against time. A column for each folder of a run
(build/examples/disc-bed/<variant>.np<ranks>)."""

import sys
from pathlib import Path

import numpy as np

from potdem import logs, picture
from potdem.scenes.scene import beside

scan = beside(__file__, "scan")

RELEASE = 0.1                          # s, when the disc is let go
INSTANTS = (0.03, 0.12, 0.66, 1.47)    # s after it, Fig. 6.27
EARLY = (0.03, 0.06, 0.12, 0.38)       # s, of shorter runs
LENGTH, HEIGHT, WALL = 1.45, 1.5, 0.02    # m, box, height seen, thickness of the walls in the picture
SCALE = picture.Scale("damage", 0.0, 1.0, "share of bonds lost (grey: bed)")
# bonds that are broken, particles in the largest piece, grains of the bed that have moved by more than a diameter
SHARES = {"broken bonds": "#c4553b", "largest piece": "#4a5568", "moved grains": "#b08a2e"}


def draw(axis, frame):
    picture.block(axis, -WALL, LENGTH + WALL, -WALL, HEIGHT, layer=-3)
    picture.block(axis, 0, LENGTH, 0, HEIGHT, "white")
    lost = frame["v_broken_bonds"] / np.maximum(frame["v_broken_bonds"] + frame["c_bonds"], 1)
    picture.particles(axis, frame, np.where((frame["type"] == 1)[:, None], SCALE(lost), picture.GRAINS), picture.FRONT)


def words(variables):
    whole = "\na disc that cannot break" if float(variables["strength"]) > 1e9 else ""
    return f"$E$ = {float(variables['E']) / 1e9:g} GPa, step {1e6 * float(variables['dt']):g} µs{whole}"


FILM = picture.Film("dump.disc-bed", draw, SCALE, (-WALL, LENGTH + WALL, -WALL, HEIGHT), (0.5, (0.05, 0, 1.42)), words=words, zero=RELEASE)


def draw_history(height, share, table):
    """height of the disc's centre of mass, and shares of what is broken and moved"""
    time = table["Time"] - RELEASE
    height.plot(time, table["v_height"], color="#3b6fc4")
    values = (table["v_broken"] / scan.BONDS, table["v_largest"] / table["v_largest"][0], table["v_far"] / scan.GRAINS)
    for (label, colour), value in zip(SHARES.items(), values):
        share.plot(time, 100 * value, color=colour, label=label)
    height.set(ylim=(0.0, 1.2))
    share.set(ylim=(0, 102), xlabel="time, s")


def main(*arguments):
    *folders, path = arguments
    tables = [logs.read_thermo(next(Path(folder).glob("log.*"))) for folder in folders]
    last = max(table["Time"][-1] for table in tables) - RELEASE
    figure, (heights, shares) = FILM.at_instants(folders, INSTANTS if last > 1 else EARLY, below=(1.6, 2.0))
    for height, share, table in zip(heights, shares, tables):
        draw_history(height, share, table)
        height.sharex(share)
        share.set_xlim(0, last)
    heights[0].set_ylabel("disc's centre, m")
    shares[0].set_ylabel("share, %")
    shares[0].legend(loc="best")
    picture.save(figure, path)


if __name__ == "__main__":
    main(*sys.argv[1:])
