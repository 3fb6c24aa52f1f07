# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""plot.py FOLDER [FOLDER ...] PICTURE.png: the bed at the start and after 100 and 200 mm of the blade, the grains coloured by their
horizontal displacement, with the slip line; a column for each folder of a run (build/examples/blade-cut/<variant>.np<ranks>)."""

import sys

from potdem import picture
from potdem.scenes.scene import beside

slip_line = beside(__file__, "slip_line")

SCALE = picture.Scale("way", 0.0, 200.0, "horizontal displacement of the grains, mm", extend="max")
TOP, WALL = 0.28, 0.012    # m: of the picture; thickness of the walls in it


def draw(axis, frame):
    picture.block(axis, -WALL, slip_line.LENGTH + WALL, -WALL, TOP, layer=-3)
    picture.block(axis, 0, slip_line.LENGTH, 0, TOP, "white")
    picture.particles(axis, frame, SCALE(1e3 * frame["c_moved[1]"]), picture.FRONT)
    back = slip_line.BACK + frame["way"]
    picture.block(axis, back, back + slip_line.THICK, slip_line.TIP, TOP, picture.STEEL, layer=3)
    axis.plot([0, slip_line.LENGTH], [slip_line.BED, slip_line.BED], color="black", linewidth=1.0, linestyle=":", zorder=4)


class BladeFilm(picture.Film):
    def frames(self, folder):
        return slip_line.read(folder)[0]

    def title(self, frame):
        return f"blade moved by {1e3 * frame['way']:.0f} mm"

    def column(self, column, frames, instants):
        super().column(column, frames, instants)
        for axis, way in zip(column, instants):
            if way in slip_line.WAYS:
                frame, share = slip_line.shares(frames, way)
                line = slip_line.slip_line(frame, share >= slip_line.MOVING)
                axis.plot(*line.T, color="black", linewidth=3.5, zorder=5)
                axis.plot(*line.T, "o-", color="white", markeredgecolor="black", markersize=5, zorder=5)


def words(variables):
    return f"{1e3 * float(variables['speed']):g} mm/s"


FILM = BladeFilm("dump.blade-cut", draw, SCALE, (-WALL, slip_line.LENGTH + WALL, -WALL, TOP), (0.1, (0.44, 0, 0.255)), words=words,
                 by="way")


def main(*arguments):
    *folders, path = arguments
    picture.save(FILM.at_instants(folders, (0.0, *slip_line.WAYS))[0], path)


if __name__ == "__main__":
    main(*sys.argv[1:])
