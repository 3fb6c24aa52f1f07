#!/usr/bin/env python3
# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Runs the scripts of docs/howto_grains.md as they stand there, and draws what they leave.

Usage: tools/python tools/howto_grains.py      writes docs/howto_grains.png
"""

import tempfile
from pathlib import Path

import numpy as np

from potdem import dumps, picture, running
from potdem.picture import plt
from potdem.paths import DOCS
from potdem.scripts import of_page
from potdem.text import replaced

PAGE = DOCS / "howto_grains.md"
SHOWN = {"pour.lmp": "poured", "heap.lmp": "the heap stands", "discharge.lmp": "0.15 s after the slot is opened"}
SHORTER = {"discharge.lmp": ("run             12000", "run             3000")}    # for the picture
SAND, FIXED = (0.85, 0.72, 0.48, 1.0), (0.45, 0.45, 0.45, 1.0)
LONG, TOP = 0.143, 0.15    # m, of the base and of the picture


def scripts():
    return of_page(PAGE)


def draw(axis, frame, text):
    order = np.argsort(-frame["y"])
    points = np.column_stack([frame["x"], frame["y"], frame["z"]])[order]
    colours = np.where((frame["type"] == 1)[order, None], SAND, FIXED)
    picture.spheres(axis, points, frame["radius"][order], colours, turn=0.0, tilt=0.0)
    for wall in (0.0, *([LONG] if "heap" not in text else [])):
        axis.plot([wall, wall], [-0.005, TOP], color="#888888", linewidth=2)
    axis.set_xlim(-0.01, LONG + 0.03)
    axis.set_ylim(-0.03, TOP)
    axis.set_title(text, fontsize=12)


def main():
    figure, axes = picture.panels(1, len(SHOWN), 4.0, 3.6)
    with tempfile.TemporaryDirectory() as folder:
        for axis, (name, text) in zip(axes[0], SHOWN.items()):
            script = scripts()[name]
            if name in SHORTER:
                script = replaced(script, *SHORTER[name])
            running.must_run(script + "write_dump all custom last.dump id type x y z radius\n", {}, folder, name=name)
            draw(axis, dumps.read(Path(folder) / "last.dump")[-1], text)
    figure.savefig(DOCS / "howto_grains.png", dpi=90)
    plt.close(figure)


if __name__ == "__main__":
    main()
