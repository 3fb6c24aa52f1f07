# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""plot.py FOLDER PICTURE.png: the bar after it has parted, motion enlarged, coloured by the axial stress, and stress
against strain until then, for a run (build/examples/bar-strength/<variant>.np<ranks>)."""

import sys
from pathlib import Path

import matplotlib
import numpy as np
from matplotlib import pyplot
from matplotlib.colors import Normalize

from potdem import dumps, picture
from potdem.scenes.scene import beside

strengths = beside(__file__, "strengths")

LARGER = 60    # times the motion is shown
SCALE, COLOURS = Normalize(-0.5, 0.5), matplotlib.colormaps["coolwarm"]


def draw(axis, start, end, strength):
    points = {k: start[k] + LARGER * (end[k] - start[k]) for k in "xyz"}
    stress = -end["c_virial[1]"] / end["mass"] / strength
    picture.spheres(axis, np.column_stack(list(points.values())), end["radius"], COLOURS(SCALE(-stress)), turn=0.0)
    axis.set_aspect("equal")
    axis.axis("off")
    axis.margins(0.05)
    axis.autoscale_view()


def main(folder, path):
    log = next(Path(folder).glob("log*"))
    given, _, peak, _, curve = strengths.measured(log)
    start, end = dumps.read(Path(folder) / "dump.bar-strength")
    figure, (top, bottom) = pyplot.subplots(2, 1, figsize=(9, 6), height_ratios=[1, 1.6], layout="constrained")
    draw(top, start, end, float(given["ft"]))
    figure.colorbar(matplotlib.cm.ScalarMappable(SCALE, COLOURS), ax=top, label="axial stress over $f_t$", shrink=0.9)
    bottom.plot(*curve, color="#20516e")
    bottom.plot(curve[0][-1], peak, "o", color="#d1495b", label=f"strength {peak:.3f} $f_t$")
    expected = strengths.formula(given)
    if expected:
        bottom.axhline(expected, color="black", lw=1, ls="--", label=f"by the bonds' directions: {expected:.3f} $f_t$")
    bottom.set(xlabel=r"strain $\times\,E/f_t$", ylabel="stress over $f_t$", ylim=(0.5, 1.25))
    bottom.spines[["top", "right"]].set_visible(False)
    bottom.legend(frameon=False, loc="lower right")
    top.set_title(f"{strengths.variant(log)}: the bar has parted (motion {LARGER} times enlarged)")
    figure.savefig(path, dpi=100)


if __name__ == "__main__":
    main(*sys.argv[1:])
