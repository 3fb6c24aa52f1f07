# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""plot.py FOLDER [FOLDER ...] PICTURE.png: the cylinder at the thesis's four instants, coloured by the vertical
velocity, and the sizes of its pieces against time; a column for each folder of a run
(build/examples/cylinder-impact/<variant>.np<ranks>)."""

import sys
from pathlib import Path

import matplotlib
import numpy as np
from matplotlib.colors import Normalize

from potdem import dumps, logs, picture

INSTANTS = (0.04, 0.2, 0.4, 0.8)            # s, Figs 6.19 and 6.20
ELASTIC_INSTANTS = (0.02, 0.1, 0.2, 0.4)    # s, Fig. 6.21
SPEED = 10.0                                # m/s, at the start
SCALE, COLOURS = Normalize(-SPEED, SPEED), matplotlib.colormaps["coolwarm"]
WIDTH, HEIGHT = 8.5, 8.0                    # m, half the width seen, and the height
FLOOR = [(-12.0, -3.0, 0.0), (12.0, -3.0, 0.0), (12.0, 5.0, 0.0), (-12.0, 5.0, 0.0)]
SIZES = {"v_n100": ("100 and more", "#4a5568"), "v_n10": ("10 to 99", "#8aa0bd"), "v_n2": ("2 to 9", "#e6b566"),
         "v_n1": ("single", "#c4553b")}


def draw(axis, frame):
    picture.floor(axis, FLOOR)
    points = np.column_stack([frame["x"], frame["y"], frame["z"]])
    near = (np.abs(frame["x"]) < 1.2 * WIDTH) & (np.abs(frame["y"]) < 6.0)
    picture.spheres(axis, points[near], frame["radius"][near], COLOURS(SCALE(frame["vz"][near])))
    axis.set_xlim(-WIDTH, WIDTH)
    axis.set_ylim(-1.2, HEIGHT)


FILM = picture.Film("dump.cylinder-impact", draw, SCALE, COLOURS, "vertical velocity, m/s", 5.0, 2.7)


def draw_sizes(axis, table):
    axis.set_aspect("auto")
    axis.axis("on")
    axis.stackplot(table["Time"], [table[name] for name in SIZES], labels=[label for label, _ in SIZES.values()],
                   colors=[colour for _, colour in SIZES.values()])
    axis.set_xlim(0.0, 0.8)
    axis.set_ylim(0.0, table["v_n100"][0])
    axis.set_xlabel("t, s")
    axis.set_ylabel("particles")
    axis.legend(title="in pieces of", loc="lower left", fontsize=8)


def main(*arguments):
    *folders, path = arguments
    figure, axes = FILM.panels(len(INSTANTS) + 1, len(folders))
    for column, folder in zip(axes.T, folders):
        frames = FILM.frames(folder)
        strength = Path(folder).resolve().name.split(".")[0]
        for axis, instant in zip(column, ELASTIC_INSTANTS if strength == "2e8" else INSTANTS):
            draw(axis, dumps.at(frames, instant))
            axis.text(0.0, 0.98, f"$f_t$ = {strength} Pa, t = {instant:g} s", transform=axis.transAxes, fontsize=11, va="top")
        draw_sizes(column[-1], logs.read_thermo(next(Path(folder).glob("log.*"))))
    FILM.colour_bar(figure, axes[:-1].ravel(), shrink=0.4, pad=0.01)
    figure.savefig(path, dpi=100)


if __name__ == "__main__":
    main(*sys.argv[1:])
