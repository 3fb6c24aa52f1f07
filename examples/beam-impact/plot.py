# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""plot.py FOLDER [FOLDER ...] PICTURE.png: the beam and the block at the thesis's instants, coloured by the strain along the
beam; a column for each folder of a run (build/examples/beam-impact/<variant>.np<ranks>)."""

import sys

from potdem import picture

INSTANTS = (0.016, 0.2, 0.4)             # s, Figs 6.3 to 6.6 and 6.10
UNBROKEN = (0.024, 0.24, 0.42, 0.6)      # s, Figs 6.7 and 6.8
SCALE = picture.Scale("strain", -0.06, 0.06, "strain along the beam (yellow: loose particles; grey: block)", extend="both")
FLOOR = [(-0.05, -0.06, 0.0), (0.33, -0.06, 0.0), (0.33, 0.085, 0.0), (-0.05, 0.085, 0.0)]
POSITIONS = {"i": "at the end", "ii": "half the width, mid-span", "iii": "half the width, at the end"}


def draw(axis, frame):
    picture.floor(axis, FLOOR)
    colours = SCALE(frame["c_strain[1]"])
    colours[frame["c_bonds"] == 0] = picture.LOOSE    # debris has no strain
    colours[frame["type"] == 2] = picture.BODY
    picture.particles(axis, frame, colours)


def unbroken(variables):
    return variables.get("breakable") == "no"


def words(variables):
    parts = [f"{variables['speed']} m/s", POSITIONS[variables["position"]]]
    if unbroken(variables):
        parts.append("bonds never break")
    if variables["crack"] == "yes":
        parts.append("cracked beam")
    return ", ".join(parts)


FILM = picture.Film("dump.beam-impact", draw, SCALE, (-0.07, 0.35, -0.035, 0.145), (0.05, (0.0, -0.05, 0.0)), picture.SLANTED, words)


def main(*arguments):
    *folders, path = arguments
    whole = unbroken(picture.settings(folders[0]))
    picture.save(FILM.at_instants(folders, UNBROKEN if whole else INSTANTS)[0], path)


if __name__ == "__main__":
    main(*sys.argv[1:])
