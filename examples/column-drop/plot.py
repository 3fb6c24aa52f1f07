# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""plot.py FOLDER [FOLDER ...] PICTURE.png: the column before the left wall is gone, while it spreads and at the end, coloured by the
horizontal velocity; a column for each folder of a run (build/examples/column-drop/<variant>.np<ranks>)."""

import sys

from potdem import picture

RELEASED = 1.2                      # s, the left wall is gone
INSTANTS = (0.0, 0.2, 0.4, 1.5)     # s after that
SCALE = picture.Scale("speed", 0.0, 1.5, "velocity to the left, m/s", extend="both")
LEFT, RIGHT, BELOW, TOP = -1.35, 0.28, -0.085, 0.46    # m, what is seen


def draw(axis, frame):
    picture.block(axis, LEFT, RIGHT, -0.015, 0.0)
    picture.particles(axis, frame, SCALE(-frame["vx"]), picture.FRONT)


def words(variables):
    law = "\nfriction that remembers, grains roll" if variables.get("law") == "spring" else ""
    return f"diameters 18 ± {1e3 * float(variables['sd']):.3g} mm{law}"


FILM = picture.Film("dump.column-drop", draw, SCALE, (LEFT, RIGHT, BELOW, TOP), (0.2, (LEFT + 0.02, 0, -0.03)), words=words, zero=RELEASED)


def main(*arguments):
    *folders, path = arguments
    picture.save(FILM.at_instants(folders, INSTANTS)[0], path)


if __name__ == "__main__":
    main(*sys.argv[1:])
