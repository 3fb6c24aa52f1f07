# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""plot.py FOLDER [FOLDER ...] PICTURE.png: deflection of the loaded section against time for the runs in the folders
(build/examples/beam-impulse/<variant>.np<ranks>) and the references, a panel for each pulse."""

import sys
from pathlib import Path

import matplotlib
import numpy as np

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

from potdem import struck_beam  # noqa: E402

TITLES = {"f1": "$f_1$: rectangle, 1 ms", "f2": "$f_2$: triangle, 2 ms"}
RUNS = ("#d1495b", "#3b7dd8", "#2a9d5c", "#8d6cab", "#b5651d", "#4b4b4b", "#d08c2e", "#6fb1b5")


def show(axis, history, label, **style):
    axis.plot(1e3 * history.time, 1e3 * history.deflection, label=label, **style)


def references(axis, pulse):
    show(axis, struck_beam.calculix("2d", pulse), "CalculiX, plane stress", color="#b9c2c9", lw=6)
    show(axis, struck_beam.calculix("2d-layer", pulse), "… clamped in the layer", color="#efdcb8", lw=6, zorder=1)
    show(axis, struck_beam.calculix("3d", pulse), "CalculiX, 3D", color="black", lw=1.2, ls=(0, (5, 3)))
    show(axis, struck_beam.modal("half", pulse), "Timoshenko, modal sum", color="black", lw=1.2, ls=(0, (1, 2)))


def inset(axis, pulse):
    """the pulse itself"""
    small = axis.inset_axes((1.03, 0.82, 0.12, 0.16))
    time = np.linspace(-0.5e-3, 3e-3, 1401)
    value = sum(step * (time >= start) + slope * np.maximum(time - start, 0)
                for start, step, slope in struck_beam.PULSES[pulse])
    small.plot(1e3 * time, value, color="black", lw=1)
    small.set_xticks([0, 1, 2])
    small.set_yticks([0, 1])
    small.tick_params(labelsize=7)
    small.set_xlabel("ms", fontsize=7, labelpad=1)
    small.set_ylabel("$F/F_0$", fontsize=7, labelpad=1)


def main(*arguments):
    *folders, path = arguments
    runs = [struck_beam.lammps(next(Path(folder).glob("log*"))) for folder in folders]
    pulses = [pulse for pulse in struck_beam.PULSES if pulse in {run[0] for run in runs}]
    pyplot.rcParams.update({"font.size": 10})
    figure, axes = pyplot.subplots(len(pulses), 1, figsize=(12, 4 * len(pulses)), squeeze=False, layout="constrained")
    for axis, pulse in zip(axes.ravel(), pulses):
        references(axis, pulse)
        for colour, (_, history) in zip(RUNS, (run for run in runs if run[0] == pulse)):
            show(axis, history, history.label, color=colour, lw=1.5)
        inset(axis, pulse)
        axis.axhline(0, color="black", lw=0.6)
        axis.set_xlim(0, 1e3 * struck_beam.TIME)
        axis.set_ylabel("deflection at A [mm]")
        axis.set_title(TITLES[pulse], loc="left")
        axis.spines[["top", "right"]].set_visible(False)
        axis.legend(frameon=False, fontsize=9, loc="upper left", bbox_to_anchor=(1.0, 0.7))
    axes[-1, 0].set_xlabel("time [ms]")
    figure.savefig(path, dpi=100)


if __name__ == "__main__":
    main(*sys.argv[1:])
