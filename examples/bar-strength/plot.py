# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""plot.py FOLDER PICTURE.png: the bar after it has parted, motion enlarged, coloured by the axial stress, and stress
against strain until then, for a run (build/examples/bar-strength/<variant>.np<ranks>)."""

import sys
from pathlib import Path

import numpy as np

from potdem import dumps, picture
from potdem.scenes.scene import beside

strengths = beside(__file__, "strengths")

LARGER = 60    # times the motion is shown
SCALE = picture.Scale("stress", -0.5, 0.5, "axial stress over $f_t$", extend="both")


def draw(axis, start, end, strength):
    points = {k: start[k] + LARGER * (end[k] - start[k]) for k in "xyz"}
    stress = end["c_virial[1]"] / end["mass"] / strength
    picture.spheres(axis, np.column_stack(list(points.values())), end["radius"], SCALE(stress), *picture.FRONT)
    picture.length_bar(axis, (0, points["y"].min(), points["z"].min() - 2), 5, text="5 $d$")
    axis.set(aspect="equal", xlim=(points["x"].min() - 1, points["x"].max() + 1), ylim=(points["z"].min() - 4.5, points["z"].max() + 2.5))
    axis.axis("off")


def main(folder, path):
    log = next(Path(folder).glob("log*"))
    given, _, peak, _, curve = strengths.measured(log)
    start, end = dumps.read(Path(folder) / "dump.bar-strength")
    figure, ((top,), (bottom,)) = picture.curves(2, 1, 3.0, height_ratios=[1.1, 1])
    draw(top, start, end, float(given["ft"]))
    SCALE.bar(figure, top)
    bottom.plot(*curve, color=picture.INK)
    bottom.plot(curve[0][-1], peak, "o", color=picture.POINT, label=f"strength {peak:.3f} $f_t$")
    expected = strengths.formula(given)
    if expected:
        bottom.axhline(expected, color="black", lw=1, ls="--", label=f"by the bonds' directions: {expected:.3f} $f_t$")
    bottom.set(xlabel=r"strain $\times\,E/f_t$", ylabel="stress over $f_t$", ylim=(0.5, 1.25))
    bottom.legend(loc="lower right")
    top.set_title(f"{strengths.words(strengths.variant(log))}: the bar has parted (motion {LARGER} times enlarged)")
    picture.save(figure, path)


if __name__ == "__main__":
    main(*sys.argv[1:])
