# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""plot.py FOLDER [FOLDER ...] PICTURE.png: disc and bed at the thesis's four instants, in the plane of the disc, the bed
grey, the disc coloured by the share of its bonds that a particle has lost; below, what happens against time. A column for
each folder of a run (build/examples/disc-bed/<variant>.np<ranks>)."""

import sys
from pathlib import Path

import matplotlib
import numpy as np
from matplotlib.colors import Normalize

from potdem import dumps, logs, picture

RELEASE = 0.1                          # s, when the disc is let go
INSTANTS = (0.03, 0.12, 0.66, 1.47)    # s after it, Fig. 6.27
EARLY = (0.03, 0.06, 0.12, 0.4)        # s, of the disc that cannot break
SCALE, COLOURS = Normalize(0.0, 1.0), matplotlib.colormaps["turbo"]
LENGTH, HEIGHT = 1.45, 1.5             # m, box, and height seen
GREY = (0.72, 0.70, 0.66, 1.0)


def lost(frame):
    """share of its bonds that a particle of the disc has lost"""
    return frame["v_broken_bonds"] / np.maximum(frame["v_broken_bonds"] + frame["c_bonds"], 1)


def draw(axis, frame):
    points = np.column_stack([frame["x"], frame["y"], frame["z"]])
    colours = np.where((frame["type"] == 1)[:, None], COLOURS(SCALE(lost(frame))), GREY)
    picture.spheres(axis, points, frame["radius"], colours, turn=0.0, tilt=0.0)
    axis.plot([0, 0, LENGTH, LENGTH], [HEIGHT, 0, 0, HEIGHT], color="#4a5568", linewidth=1.5)
    axis.set_xlim(-0.03, LENGTH + 0.03)
    axis.set_ylim(-0.03, HEIGHT)


FILM = picture.Film("dump.disc-bed", draw, SCALE, COLOURS, "share of its bonds that a particle of the disc has lost; grey: bed",
                    4.2, 4.4)


def draw_history(axis, table):
    time = table["Time"] - RELEASE
    axis.set_aspect("auto")
    axis.axis("on")
    axis.plot(time, table["v_broken"] / table["v_broken"].max(initial=1.0), color="#c4553b", label="broken bonds / most")
    axis.plot(time, table["v_largest"] / table["v_largest"][0], color="#4a5568", label="largest piece / disc")
    axis.plot(time, table["v_far"] / 1581, color="#b08a2e", label="grains moved by more than d / all")
    axis.plot(time, table["v_speed"] / 5.0, color="#3b6fc4", label="velocity of the disc / 5 m/s, upwards")
    axis.axhline(0.0, color="black", linewidth=0.5)
    axis.set_xlim(0.0, time[-1])
    axis.set_ylim(-1.15, 1.1)
    axis.set_xlabel("t, s")
    axis.legend(loc="lower right", fontsize=8)


def main(*arguments):
    *folders, path = arguments
    figure, axes = FILM.panels(len(folders), len(INSTANTS) + 1)
    for row, folder in zip(axes, folders):
        frames = FILM.frames(folder)
        variant = Path(folder).resolve().name.split(".")[0]
        for axis, instant in zip(row, EARLY if variant == "unbreakable" else INSTANTS):
            draw(axis, dumps.at(frames, RELEASE + instant))
            axis.set_title(f"{variant}, t = {instant:g} s", fontsize=11)
        draw_history(row[-1], logs.read_thermo(next(Path(folder).glob("log.*"))))
    FILM.colour_bar(figure, axes[:, :-1].ravel(), shrink=0.4, pad=0.02)
    figure.savefig(path, dpi=90)


if __name__ == "__main__":
    main(*sys.argv[1:])
