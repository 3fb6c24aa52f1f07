# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""plot.py FOLDER [FOLDER ...] PICTURE.png: the bed at the start and after 100 and 200 mm of the blade, the grains coloured by their
horizontal displacement, with the slip line; a row for each folder of a run (build/examples/blade-cut/<variant>.np<ranks>)."""

import sys
from pathlib import Path

import matplotlib
import numpy as np
from matplotlib.colors import Normalize

from potdem import picture
from potdem.scenes.scene import beside

slip_line = beside(__file__, "slip_line")

SCALE, COLOURS = Normalize(0.0, 200.0), matplotlib.colormaps["turbo"]
TOP, WALL = 0.28, 0.012    # m: of the picture; thickness of the walls in it


def box(axis, left, right, low, high, colour, layer):
    axis.fill([left, right, right, left], [low, low, high, high], color=colour, linewidth=0, zorder=layer)


def draw(axis, frame):
    box(axis, -WALL, slip_line.LENGTH + WALL, -WALL, TOP, "#b9c7b4", -3)
    box(axis, 0, slip_line.LENGTH, 0, TOP, "white", -2)
    points = np.column_stack([frame["x"], frame["y"], frame["z"]])
    picture.spheres(axis, points, frame["radius"], COLOURS(SCALE(1e3 * frame["c_moved[1]"])), turn=0.0, tilt=0.0)
    box(axis, slip_line.BACK + frame["way"], slip_line.BACK + frame["way"] + slip_line.THICK, slip_line.TIP, TOP, "#555555", 3)
    axis.plot([0, slip_line.LENGTH], [slip_line.BED, slip_line.BED], color="black", linewidth=1.0, linestyle=":", zorder=4)
    axis.set_xlim(-WALL, slip_line.LENGTH + WALL)
    axis.set_ylim(-WALL, TOP)


class BladeFilm(picture.Film):
    def frames(self, folder):
        return slip_line.read(folder)[0]


FILM = BladeFilm("dump.blade-cut", draw, SCALE, COLOURS, "horizontal displacement of the grains, mm", 6.2, 3.1)


def main(*arguments):
    *folders, path = arguments
    figure, axes = FILM.panels(len(folders), 1 + len(slip_line.WAYS))
    for row, folder in zip(axes, folders):
        frames, table = slip_line.read(folder)
        variant = Path(folder).resolve().name.split(".")[0]
        for axis, way in zip(row, (0.0, *slip_line.WAYS)):
            draw(axis, slip_line.at_way(frames, way))
            axis.set_title(f"{variant}: blade at {1e3 * way:.0f} mm", fontsize=13)
        for axis, way in zip(row[1:], slip_line.WAYS):
            axis.plot(*slip_line.state(frames, table, way).line.T, "o-", color="white", markeredgecolor="black", linewidth=2, markersize=5, zorder=5)
    FILM.colour_bar(figure, axes.ravel(), shrink=0.5, pad=0.02, aspect=40)
    figure.savefig(path, dpi=80)


if __name__ == "__main__":
    main(*sys.argv[1:])
