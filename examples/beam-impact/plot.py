# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""plot.py FOLDER [FOLDER ...] PICTURE.png: the beam and the block at the thesis's three instants, coloured by the
strain along the beam; a column for each folder of a run (build/examples/beam-impact/<variant>.np<ranks>)."""

import sys

import matplotlib
import numpy as np
from matplotlib.colors import Normalize, to_rgba

from potdem import picture

INSTANTS = (0.016, 0.2, 0.4)    # s, Figs 6.3 and 6.4
STRAIN_LIMIT = 0.06             # the bonds break at 0.067 (f_t / E)
BLOCK = to_rgba("#8a8f98")
SCALE, COLOURS = Normalize(-STRAIN_LIMIT, STRAIN_LIMIT), matplotlib.colormaps["coolwarm"]
FLOOR = [(-0.05, -0.06, 0.0), (0.30, -0.06, 0.0), (0.30, 0.085, 0.0), (-0.05, 0.085, 0.0)]


def colours(frame):
    shades = COLOURS(SCALE(frame["c_strain[1]"]))
    shades[frame["c_bonds"] == 0] = to_rgba("#c9b458")    # debris has no strain
    shades[frame["type"] == 2] = BLOCK
    return shades


def draw(axis, frame):
    picture.floor(axis, FLOOR)
    points = np.column_stack([frame["x"], frame["y"], frame["z"]])
    picture.spheres(axis, points, frame["radius"], colours(frame))
    axis.set_xlim(-0.065, 0.315)
    axis.set_ylim(-0.035, 0.135)


FILM = picture.Film("dump.beam-impact", draw, SCALE, COLOURS,
                    "strain along the beam (bonds break at 0.067); yellow: loose particles, grey: block")


def main(*arguments):
    *folders, path = arguments
    figure = FILM.at_instants(folders, INSTANTS, lambda variant, instant: (0.0, 0.98, f"{variant}, t = {instant:g} s"), shrink=0.4, pad=0.02)
    figure.savefig(path, dpi=110)


if __name__ == "__main__":
    main(*sys.argv[1:])
