# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""plot.py FOLDER [FOLDER ...] PICTURE.png: the cylinder at the thesis's instants, its particles coloured by their vertical velocity,
and below, where it breaks, the sizes of its pieces against time; a column for each folder of a run
(build/examples/cylinder-impact/<variant>.np<ranks>)."""

import sys
from dataclasses import replace
from pathlib import Path

import numpy as np

from potdem import logs, picture

INSTANTS = (0.04, 0.2, 0.4, 0.8)            # s, Figs 6.19 and 6.20
ELASTIC = (0.02, 0.1, 0.2, 0.4)             # s, Fig. 6.21
SPEED = 10.0                                # m/s, at the start
SCALE = picture.Scale("velocity", -SPEED, SPEED, "vertical velocity, m/s", extend="both")
DIRECTION = (-55.0, 9.0)                    # turn, tilt
HALF, HEIGHT, OF_DISC = 6.5, 5.5, 8.0       # m, half the width that is seen, and the height (of a disc of 6 m)
SEEN = 9.5                                  # m from the middle: what lies beyond is left out
FLOOR = [(-SEEN, -SEEN, 0.0), (SEEN, -SEEN, 0.0), (SEEN, SEEN, 0.0), (-SEEN, SEEN, 0.0)]
COLUMNS = ("v_n100", "v_n10", "v_n2", "v_n1")    # of the log, in the order of picture.PIECES


def draw(axis, frame):
    picture.floor(axis, FLOOR, *DIRECTION)
    near = (np.abs(frame["x"]) < SEEN) & (np.abs(frame["y"]) < SEEN)
    picture.particles(axis, {name: frame[name][near] for name in ("x", "y", "z", "radius")}, SCALE(frame["vz"][near]), DIRECTION)


def is_disc(variables):
    return bool(variables) and float(variables["D"]) > float(variables["length"])


def words(variables):
    parts = [f"{float(variables['strength']) / 1e6:g} MPa"]
    if "penetration" in variables["options"]:
        parts.append("non-penetration factor")
    if is_disc(variables):
        parts.append(f"a disc of {variables['D']} m")
    return ", ".join(parts)


FILM = picture.Film("dump.cylinder-impact", draw, SCALE, (-HALF, HALF, -1.5, HEIGHT), (2.0, (-1.0, -7.0, 0)), DIRECTION, words)


def draw_sizes(axis, table, last):
    sizes = np.array([table[name] for name in COLUMNS])
    axis.stackplot(table["Time"], 100 * sizes / sizes.sum(axis=0), labels=list(picture.PIECES), colors=list(picture.PIECES.values()))
    axis.set(xlim=(0.0, last), ylim=(0.0, 100.0), xlabel="time, s")


def main(*arguments):
    *folders, path = arguments
    tables = [logs.read_thermo(next(Path(folder).glob("log.*"))) for folder in folders]
    last = max(table["Time"][-1] for table in tables)
    breaks = any(table["v_broken"][-1] for table in tables)
    film = replace(FILM, window=(*FILM.window[:3], OF_DISC)) if is_disc(picture.settings(folders[0])) else FILM
    figure, sizes = film.at_instants(folders, INSTANTS if last > ELASTIC[-1] else ELASTIC, below=(2.0,) if breaks else ())
    if breaks:
        for axis, table in zip(sizes[0], tables):
            draw_sizes(axis, table, last)
        sizes[0][0].set_ylabel("particles, %")
        sizes[0][0].legend(title="in pieces of", title_fontsize=picture.FONT - 2, loc="lower left", frameon=True)
    picture.save(figure, path)


if __name__ == "__main__":
    main(*sys.argv[1:])
