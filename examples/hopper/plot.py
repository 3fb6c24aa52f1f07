# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""plot.py FOLDER [FOLDER ...] PICTURE.png: the grains at the thesis's three instants, coloured by their downward
velocity; a row for each folder of a run (build/examples/hopper/<variant>.np<ranks>)."""

import sys

import matplotlib
import numpy as np
from matplotlib.colors import Normalize

from potdem import picture

INSTANTS = (0.12, 0.36, 0.8)    # s, Figs 6.16 and 6.17
SCALE, COLOURS = Normalize(0.0, 2.0), matplotlib.colormaps["turbo"]
# left wall, upper ledge, lower ledge, right wall: x and z in m, as in in.hopper
WALLS = [(-0.008, 0.0, -0.05, 0.43), (0.0, 0.03, 0.31, 0.32), (0.04, 0.168, -0.05, 0.24), (0.16, 0.168, 0.24, 0.43)]


def draw(axis, frame):
    for left, right, low, high in WALLS:
        axis.fill([left, right, right, left], [low, low, high, high], color="#b9c7b4", linewidth=0, zorder=-2)
    points = np.column_stack([frame["x"], frame["y"], frame["z"]])
    picture.spheres(axis, points, frame["radius"], COLOURS(SCALE(-frame["vz"])), turn=0.0, tilt=0.0)
    axis.set_xlim(-0.01, 0.17)
    axis.set_ylim(-0.05, 0.43)


FILM = picture.Film("dump.hopper", draw, SCALE, COLOURS, "downward velocity, m/s", 2.4, 5.6)


def main(*arguments):
    *folders, path = arguments
    figure = FILM.at_instants(folders, INSTANTS, lambda variant, instant: (0.5, 0.3, f"{variant}\nt = {instant:g} s"), by_rows=True,
                              shrink=0.7, pad=0.02, extend="both")
    figure.savefig(path, dpi=100)


if __name__ == "__main__":
    main(*sys.argv[1:])
