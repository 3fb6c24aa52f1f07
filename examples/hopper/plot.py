# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""plot.py FOLDER [FOLDER ...] PICTURE.png: the grains at the thesis's three instants, coloured by their downward
velocity; a column for each folder of a run (build/examples/hopper/<variant>.np<ranks>)."""

import sys

from potdem import picture

INSTANTS = (0.12, 0.36, 0.8)    # s, Figs 6.16 and 6.17
SCALE = picture.Scale("speed", 0.0, 2.0, "downward velocity, m/s", extend="both")
# left wall, upper ledge, lower ledge, right wall: x and z in m, as in in.hopper
WALLS = [(-0.008, 0.0, 0.0, 0.43), (0.0, 0.03, 0.31, 0.32), (0.04, 0.168, 0.0, 0.24), (0.16, 0.168, 0.24, 0.43)]


def draw(axis, frame):
    for wall in WALLS:
        picture.block(axis, *wall)
    picture.particles(axis, frame, SCALE(-frame["vz"]), picture.FRONT)


def words(variables):
    if float(variables["mu_grain"]):
        return "friction on walls\nand between grains"
    return "friction on walls" if float(variables["mu_wall"]) else "no friction"


FILM = picture.Film("dump.hopper", draw, SCALE, (-0.009, 0.169, 0.08, 0.43), (0.05, (0.08, 0, 0.12)), words=words)


def main(*arguments):
    *folders, path = arguments
    picture.save(FILM.at_instants(folders, INSTANTS)[0], path)


if __name__ == "__main__":
    main(*sys.argv[1:])
