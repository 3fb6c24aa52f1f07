# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""reaction.py FOLDER PICTURE.png: the reaction of both supports against time for the four speeds, with failure and without;
FOLDER holds the runs (build/examples/concrete-beam)."""

import sys
from pathlib import Path

from potdem import picture
from potdem.scenes.scene import beside

claims = beside(__file__, "claims")

PANELS = (("", 0.3, 1.0, "N", "first pulse, with failure"),
          ("-unbroken", 3.0, 1e-3, "kN", "unbroken"),
          ("", 150.0, 1e-3, "kN", "with failure, means of 1 ms"))


def draw(axis, folder, suffix, until, unit, smooth):
    for speed, colour in zip(claims.SPEEDS, picture.ordered(len(claims.SPEEDS))):
        reaction = claims.Reaction(folder / f"v{speed}{suffix}.np1")
        force = reaction.smooth() if smooth else reaction.force.sum(axis=1)
        shown = 1e3 * reaction.time < until
        axis.plot(1e3 * reaction.time[shown], unit * force[shown], color=colour, label=f"{speed} m/s")


def main(folder, path):
    figure, (axes,) = picture.curves(1, len(PANELS), 3.6)
    for axis, (suffix, until, unit, name, title) in zip(axes, PANELS):
        draw(axis, Path(folder), suffix, until, unit, "mean" in title)
        axis.set(xlabel="time, ms", ylabel=f"reaction of both supports, {name}", title=title, xlim=(0, until))
    for distance in claims.DISTANCES:
        axes[0].axvline(1e3 * distance / claims.WAVE, color="grey", linestyle=":", linewidth=1)
    axes[0].legend()
    picture.save(figure, path)


if __name__ == "__main__":
    main(*sys.argv[1:])
