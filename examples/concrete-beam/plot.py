# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""plot.py FOLDER [FOLDER ...] PICTURE.png: the wave in the beam, and the beam at the thesis's instants, coloured by the bonds
that its particles have lost; a column for each folder of a run (build/examples/concrete-beam/<variant>.np<ranks>)."""

import sys
from pathlib import Path

import matplotlib
import numpy as np
from matplotlib.colors import Normalize, to_rgba

from potdem import dumps, picture

WAVE = 1.2e-4                            # s, Fig. 6.12a
INSTANTS = (0.125, 0.25, 0.375, 0.5)     # s after the impact, Figs 6.12b and 6.13
LATER = (0.045, 0.09, 0.135, 0.195)      # s, Fig. 6.14, whose times include 0.405 s of fall
HAMMER = to_rgba("#8a8f98")
SUPPORTS, RADIUS = (-0.595, 0.595), 0.05    # m
DUMP, WIDTH, HEIGHT = "dump.concrete-beam", 4.6, 3.3
SCALE, COLOURS = Normalize(0.0, 1.0), matplotlib.colormaps["inferno"]
SPEED_SCALE, SPEED_COLOURS = Normalize(-1.0, 1.0), matplotlib.colormaps["coolwarm"]


def show(axis, frame, shades):
    for x in SUPPORTS:
        axis.add_patch(matplotlib.patches.Circle((x, -RADIUS), RADIUS, color="#6f7f6a", zorder=-1))
    shades[frame["type"] == 2] = HAMMER
    points = np.column_stack([frame["x"], frame["y"], frame["z"]])
    near = (np.abs(frame["x"]) < 0.95) & (frame["z"] > -0.75)
    picture.spheres(axis, points[near], frame["radius"][near], shades[near], turn=0.0, tilt=4.0)
    axis.set_xlim(-0.9, 0.9)
    axis.set_ylim(-0.7, 0.67)


def draw(axis, frame):
    lost, kept = frame["v_broken_bonds"], frame["c_bonds"]
    show(axis, frame, COLOURS(SCALE(lost / np.maximum(lost + kept, 1))))


def draw_speed(axis, frame):
    show(axis, frame, SPEED_COLOURS(SPEED_SCALE(frame["vz"])))


FILM = picture.Film(DUMP, draw, SCALE, COLOURS, "share of a particle's bonds that have failed; grey: hammer", WIDTH, HEIGHT)
WAVE_FILM = picture.Film(DUMP, draw_speed, SPEED_SCALE, SPEED_COLOURS, "vertical velocity, m/s (first row)", WIDTH, HEIGHT)


def main(*arguments):
    *folders, path = arguments
    figure, axes = FILM.panels(len(INSTANTS) + 1, len(folders))
    for column, folder in zip(axes.T, folders):
        frames = FILM.frames(folder)
        variant = Path(folder).resolve().name.split(".")[0]
        films = [WAVE_FILM] + [FILM] * len(INSTANTS)
        for axis, film, instant in zip(column, films, (WAVE, *(LATER if variant.startswith("v4") else INSTANTS))):
            film.draw(axis, dumps.at(frames, instant))
            axis.text(0.0, 0.99, f"{variant}, t = {instant:g} s", transform=axis.transAxes, fontsize=11, va="top")
    for rows, film in ((axes[:1], WAVE_FILM), (axes[1:], FILM)):
        film.colour_bar(figure, rows.ravel(), shrink=0.6, pad=0.01, aspect=40)
    figure.savefig(path, dpi=90)


if __name__ == "__main__":
    main(*sys.argv[1:])
