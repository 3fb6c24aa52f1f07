# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""plot.py FOLDER [FOLDER ...] PICTURE.png: deflection of the loaded section against time for the runs in the folders
(build/examples/beam-impulse/<variant>.np<ranks>) and the references, a panel for each pulse."""

import sys
from pathlib import Path

import numpy as np

from potdem import picture, struck_beam

TITLES = {"f1": "rectangular pulse $f_1$ of 1 ms", "f2": "triangular pulse $f_2$ of 2 ms"}


def show(axis, history, label, **style):
    axis.plot(1e3 * history.time, 1e3 * history.deflection, label=label, **style)


def references(axis, pulse):
    show(axis, struck_beam.calculix("2d", pulse), "CalculiX, plane stress", color="#b9c2c9", lw=6)
    show(axis, struck_beam.calculix("2d-layer", pulse), "… clamped in the layer", color="#efdcb8", lw=6, zorder=1)
    show(axis, struck_beam.calculix("3d", pulse), "CalculiX, 3D", color="black", lw=1.2, ls=(0, (5, 3)))
    show(axis, struck_beam.modal("half", pulse), "Timoshenko, modal sum", color="black", lw=1.2, ls=(0, (1, 2)))


def inset(axis, pulse):
    """the pulse itself"""
    small = axis.inset_axes((1.12, 0.8, 0.17, 0.19))
    time = np.linspace(-0.5e-3, 3e-3, 1401)
    value = sum(step * (time >= start) + slope * np.maximum(time - start, 0)
                for start, step, slope in struck_beam.PULSES[pulse])
    small.plot(1e3 * time, value, color="black", lw=1)
    small.set_xticks([0, 1, 2])
    small.set_yticks([0, 1])
    small.tick_params(labelsize=picture.FONT - 3)
    small.set_xlabel("time, ms", fontsize=picture.FONT - 3, labelpad=1)
    small.set_ylabel("$F/F_0$", fontsize=picture.FONT - 3, labelpad=1)


def main(*arguments):
    *folders, path = arguments
    runs = [struck_beam.lammps(next(Path(folder).glob("log*"))) for folder in folders]
    pulses = [pulse for pulse in struck_beam.PULSES if pulse in {run[0] for run in runs}]
    figure, axes = picture.curves(len(pulses), 1, 3.6)
    for axis, pulse in zip(axes.ravel(), pulses):
        references(axis, pulse)
        for colour, (_, history) in zip(picture.CURVES, (run for run in runs if run[0] == pulse)):
            show(axis, history, history.label, color=colour)
        inset(axis, pulse)
        axis.axhline(0, color="black", lw=0.6)
        axis.set_xlim(0, 1e3 * struck_beam.TIME)
        axis.set_ylabel("deflection at A, mm")
        axis.set_title(TITLES[pulse], loc="left")
        axis.legend(loc="upper left", bbox_to_anchor=(1.0, 0.68))
    axes[-1, 0].set_xlabel("time, ms")
    picture.save(figure, path)


if __name__ == "__main__":
    main(*sys.argv[1:])
