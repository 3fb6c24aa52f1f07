# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""reaction.py FOLDER PICTURE.png: the reaction of both supports against time for the four speeds, with failure and without;
FOLDER holds the runs (build/examples/concrete-beam)."""

import sys
from pathlib import Path

from potdem.picture import plt
from potdem.scenes.scene import beside

claims = beside(__file__, "claims")

COLOURS = ("#30507a", "#3d9a8b", "#d99b2b", "#b5402f")    # of the speeds
PANELS = (("", 0.3, 1.0, "N", "first pulse of the wave, with failure"),
          ("-unbroken", 3.0, 1e-3, "kN", "unbroken"),
          ("", 150.0, 1e-3, "kN", "with failure, mean over 1 ms"))


def draw(axis, folder, suffix, until, unit, smooth):
    for speed, colour in zip(claims.SPEEDS, COLOURS):
        reaction = claims.Reaction(folder / f"v{speed}{suffix}.np1")
        force = reaction.smooth() if smooth else reaction.force.sum(axis=1)
        shown = 1e3 * reaction.time < until
        axis.plot(1e3 * reaction.time[shown], unit * force[shown], color=colour, label=f"{speed} m/s", linewidth=1.3)


def main(folder, path):
    figure, axes = plt.subplots(1, len(PANELS), figsize=(14, 4), constrained_layout=True)
    for axis, (suffix, until, unit, name, title) in zip(axes, PANELS):
        draw(axis, Path(folder), suffix, until, unit, "mean" in title)
        axis.set(xlabel="t, ms", ylabel=f"reaction of both supports, {name}", title=title, xlim=(0, until))
        axis.legend(frameon=False)
    for distance in claims.DISTANCES:
        axes[0].axvline(1e3 * distance / claims.WAVE, color="grey", linestyle=":", linewidth=1)
    figure.savefig(path, dpi=90)


if __name__ == "__main__":
    main(*sys.argv[1:])
