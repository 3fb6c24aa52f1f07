# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""plot.py FOLDER [FOLDER ...] PICTURE.png: the column before the left wall is gone, while it spreads and at the end, coloured by the
horizontal velocity; a column for each folder of a run (build/examples/column-drop/<variant>.np<ranks>)."""

import sys

import matplotlib
import numpy as np
from matplotlib.colors import Normalize

from potdem import picture

RELEASED = 1.2                      # s, the left wall is gone
INSTANTS = (1.2, 1.4, 1.6, 2.7)     # s
SCALE, COLOURS = Normalize(-1.5, 0.0), matplotlib.colormaps["viridis"]
LEFT, RIGHT, TOP = -1.0, 0.28, 0.48    # m, what is seen


def draw(axis, frame):
    axis.fill([LEFT, RIGHT, RIGHT, LEFT], [-0.015, -0.015, 0.0, 0.0], color="#b9c7b4", linewidth=0, zorder=-2)
    points = np.column_stack([frame["x"], frame["y"], frame["z"]])
    picture.spheres(axis, points, frame["radius"], COLOURS(SCALE(frame["vx"])), turn=0.0, tilt=0.0)
    axis.set_xlim(LEFT, RIGHT)
    axis.set_ylim(-0.02, TOP)


FILM = picture.Film("dump.column-drop", draw, SCALE, COLOURS, "horizontal velocity, m/s (to the left)", 5.4, 2.3)


def main(*arguments):
    *folders, path = arguments
    figure = FILM.at_instants(folders, INSTANTS,
                              lambda variant, instant: (0.02, 0.95, f"{variant}\n{instant - RELEASED:g} s after the wall is gone"),
                              shrink=0.5, pad=0.02, extend="both")
    figure.savefig(path, dpi=90)


if __name__ == "__main__":
    main(*sys.argv[1:])
