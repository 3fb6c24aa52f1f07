#!/usr/bin/env python3
# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Convergence of a cantilever with the number of particles through the depth, r_infl/d fixed: tip deflection and first
frequency against Timoshenko's beam, for the three area modes and the two places where the clamp may be taken to act.

LAMMPS finds the areas; the quarter of the beam that symmetry leaves is solved by potdem/networks.py.

Usage: tools/convergence.py [--lmp build/lmp] [--depths 3 5 7 ...]      writes docs/convergence.md and docs/convergence.png
"""

import argparse
from pathlib import Path

import matplotlib
import numpy as np

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

from potdem import networks  # noqa: E402
from potdem.beams import Beam  # noqa: E402
from potdem.paths import DOCS, LMP  # noqa: E402
from potdem.sections import areas_in_lammps  # noqa: E402

DEPTHS = (3, 5, 7, 10, 14, 20)
SLENDERNESS, REACH, HELD = 10, 2.0, 2
FLOOR = 0.5    # %, to which Timoshenko's beam stands for the three-dimensional solid
MODES = {"factor 0.4": "#8f8f8f", "lattice": "#d1495b", "body": "#20516e"}
CLAMPS = {"plane": 0.0, "layer": 0.5}    # how far behind the plane between held and free layers, in d
PAGE = """# Convergence with the number of particles through the depth

This page is made by `tools/convergence.py`. It has cantilevers of simple cubic packing, $r_{{\\mathrm{{infl}}}}=2d$, {slenderness} depths
long and square in section, with two more layers held. The sections come from LAMMPS. The small displacements under a load on the last layer
and the first mode are solved directly (`tools/potdem/networks.py`) in the quarter of the beam that the two planes of symmetry leave, 80 000
particles for 20 through the depth; the quarter has the deflection of the whole within 3·10⁻⁵.

![Errors against the number of particles](convergence.png)

The table has the error in per cent against Timoshenko's beam (shear factor 5/6, $\\nu=\\frac14$), which is clamped in the *plane* midway
between the last held and the first free layer, or in the last held *layer* ([where the clamp acts](area.md#where-the-clamp-acts)):

{table}

Order: slope of $\\log|\\text{{error}}|$ over $\\log n$, least squares over all depths; in brackets between the last two.

* **`body`, clamp in the plane**: the error falls with first order until it is as small as that of the beam theory, which has the opposite
  sign (hence the steeper slope at the end). The remaining error is the position of the clamp, about 0.4 $d$ behind the plane, a length proportional to $d$.
* **`body`, clamp in the last held layer**: {best}, and no further: both clamps tend to −0.4 to −0.5 % of the deflection. Below about {floor} %
  the beam theory is no reference. A clamp also hinders lateral strain and warping, which makes the solid stiffer than the theory's beam: finite elements
  of [beam-impulse](../examples/beam-impulse/README.md#references) are 0.2 to 0.3 % below it, with a smaller ν. An order has no meaning there.
* **`lattice`** converges with first order, because the layers that lack bonds are a share of $1/n$ of the section: {lattice}. With
  20 particles through the depth it is not yet as accurate as `body` with 5.
* **`factor 0.4`** does not converge to the solid: it tends to a solid that is 0.4/0.281 = 1.42 times too stiff. It crosses the right value between
  three and five particles through the depth, near the thesis's five.
"""


def errors(lmp, n, area):
    """{(what, clamp): error} of a cantilever of n particles through the depth"""
    body = networks.beam("sc", n, SLENDERNESS * n + HELD)
    pairs = body.pairs(REACH)
    sections = areas_in_lammps(lmp, body, pairs, REACH, area)
    x = body.x - [HELD, 0.5 * body.size[1], 0.5 * body.size[2]]
    network = networks.Network(x, pairs, sections, x[:, 0] < 0, networks.quarter_fields(x))
    tip = x[:, 0] > SLENDERNESS * n - 1
    force = np.zeros_like(x)
    force[tip, 2] = 1 / tip.sum()
    deflection = network.displacement(force)[tip, 2].mean()
    frequency = network.first_frequency(body.v, 2)
    length = SLENDERNESS * n
    found = {}
    for clamp, behind in CLAMPS.items():
        exact = Beam(length + behind, n, n, shear_factor=5 / 6)
        found["tip", clamp] = deflection / exact.static(length - 0.5 + behind) - 1
        found["frequency", clamp] = frequency / exact.first_frequency() - 1
    return found


def order(depths, values):
    """of all depths, and between the last two"""
    x, y = np.log(depths), np.log(np.abs(values))
    return -np.polyfit(x, y, 1)[0], -(y[-1] - y[-2]) / (x[-1] - x[-2])


def judgement(depths, values):
    slope = order(depths, values)[0]
    if slope > 0.5:
        return f"order {slope:.1f}"
    return "at the limit of the beam theory" if values[-1] < FLOOR else "does not converge"


def draw(depths, results, path):
    figure, axes = pyplot.subplots(1, 2, figsize=(11, 5.6), sharey=True, layout="constrained")
    for axis, what, title in zip(axes, ("tip", "frequency"), ("deflection of the tip", "first frequency")):
        for area, colour in MODES.items():
            for clamp, line in zip(CLAMPS, ("o-", "s--")):
                values = [100 * abs(results[area, n][what, clamp]) for n in depths]
                axis.plot(depths, values, line, color=colour, mfc="white", ms=5,
                          label=f"{area}, clamp in the {'plane' if clamp == 'plane' else 'held layer'}: {judgement(depths, values)}")
        axis.plot(depths, 30 / np.array(depths), ":", color="#444444", lw=1, label="$1/n$")
        axis.axhspan(1e-4, FLOOR, color="#eeeeee", zorder=0)
        axis.text(depths[-1], 0.03, "beam theory is no reference", ha="right", fontsize=8, color="#666666")
        axis.set(xscale="log", yscale="log", xlabel="particles through the depth", title=title, ylim=(0.02, 100))
        axis.set_xticks(depths, [str(n) for n in depths], minor=False)
        axis.minorticks_off()
        axis.spines[["top", "right"]].set_visible(False)
        axis.legend(frameon=False, fontsize=8, loc="upper center", bbox_to_anchor=(0.5, -0.14))
    axes[0].set_ylabel("error against Timoshenko's beam  [%]")
    figure.savefig(path, dpi=110)


def table(depths, results):
    head = [f"{what}, {clamp}" for what in ("tip", "frequency") for clamp in CLAMPS]
    lines = ["| area | depth | " + " | ".join(head) + " |", "|" + "---|" * (2 + len(head))]
    keys = [(what, clamp) for what in ("tip", "frequency") for clamp in CLAMPS]
    for area in MODES:
        for n in depths:
            lines.append(f"| `{area}` | {n} | " + " | ".join(f"{100 * results[area, n][key]:+.2f}" for key in keys) + " |")
        orders = [order(depths, [results[area, n][key] for n in depths]) for key in keys]
        lines.append(f"| `{area}` | *order* | " + " | ".join(f"{a:.1f} ({b:.1f})" for a, b in orders) + " |")
    return "\n".join(lines)


def within(depths, results, area, clamp):
    return ", ".join(f"{100 * max(abs(results[area, n][what, clamp]) for what in ('tip', 'frequency')):.1f} % at {n}"
                     for n in depths)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--lmp", default=LMP, type=lambda name: Path(name).resolve())
    parser.add_argument("--depths", nargs="+", type=int, default=DEPTHS)
    arguments = parser.parse_args()
    results = {}
    for n in arguments.depths:
        for area in MODES:
            results[area, n] = errors(arguments.lmp, n, area)
            print(area, n, {" ".join(key): f"{100 * value:+.2f} %" for key, value in results[area, n].items()}, flush=True)
    draw(arguments.depths, results, DOCS / "convergence.png")
    (DOCS / "convergence.md").write_text(PAGE.format(
        slenderness=SLENDERNESS, floor=FLOOR, table=table(arguments.depths, results), best=within(arguments.depths, results, "body", "layer"),
        lattice=within(arguments.depths, results, "lattice", "plane")), encoding="utf-8")


if __name__ == "__main__":
    main()
