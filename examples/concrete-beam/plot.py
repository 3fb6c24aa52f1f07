# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""plot.py FOLDER [FOLDER ...] PICTURE.png: the wave in the beam, and the beam at four instants, coloured by the share of their bonds
that its particles have lost; a column for each folder of a run (build/examples/concrete-beam/<variant>.np<ranks>)."""

import sys

import numpy as np
from matplotlib.patches import Circle

from potdem import picture

WAVE = 1.2e-4                            # s after the impact, Fig. 6.12a
INSTANTS = (0.045, 0.125, 0.195, 0.25)   # s, of Fig. 6.13 (0.125 and 0.25) and of Fig. 6.14, whose times include 0.405 s of fall
SUPPORTS, RADIUS = (-0.595, 0.595), 0.05    # m
DAMAGE = picture.Scale("damage", 0.0, 1.0, "share of bonds lost (grey: hammer)")
SPEED = picture.Scale("velocity", -1.0, 1.0, "vertical velocity, m/s", extend="both")
DIRECTION = (0.0, 4.0)    # turn, tilt
LEFT, RIGHT, LOW, TOP = -0.95, 0.95, -0.62, 0.66    # m, what is seen


def show(axis, frame, shades):
    for x in SUPPORTS:
        axis.add_patch(Circle((x, -RADIUS), RADIUS, color=picture.STEEL, linewidth=0, zorder=-1))
    shades[frame["type"] == 2] = picture.BODY
    picture.particles(axis, frame, shades, DIRECTION)


def draw(axis, frame):
    lost, kept = frame["v_broken_bonds"], frame["c_bonds"]
    show(axis, frame, DAMAGE(lost / np.maximum(lost + kept, 1)))


def draw_speed(axis, frame):
    show(axis, frame, SPEED(frame["vz"]))


def words(variables):
    unbroken = ", bonds never break" if float(variables["ft"]) > 1e9 else ""
    return f"{float(variables['speed']):g} m/s{unbroken}"


def film(how, scale):
    return picture.Film("dump.concrete-beam", how, scale, (LEFT, RIGHT, LOW, TOP), (0.3, (LEFT + 0.02, 0, -0.5)), DIRECTION, words)


FILM, WAVE_FILM = film(draw, DAMAGE), film(draw_speed, SPEED)


def main(*arguments):
    *folders, path = arguments
    runs = [FILM.frames(folder) for folder in folders]
    instants = FILM.reached(runs, INSTANTS)
    figure, axes, _ = FILM.panels(1 + len(instants), len(folders))
    for column, folder, frames in zip(axes.T, folders, runs):
        WAVE_FILM.column(column[:1], frames, [WAVE])
        FILM.column(column[1:], frames, instants)
        picture.header(column[0], FILM.name(folder))
    SPEED.bar(figure, axes[:1])
    if instants:
        DAMAGE.bar(figure, axes[1:])
    picture.save(figure, path)


if __name__ == "__main__":
    main(*sys.argv[1:])
