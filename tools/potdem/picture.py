# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Draws particles as shaded spheres, seen along a slanted direction, coloured by a value of each; pictures and animations."""

from dataclasses import dataclass
from pathlib import Path
from typing import Callable

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from matplotlib.animation import FuncAnimation, PillowWriter  # noqa: E402
from matplotlib.collections import EllipseCollection  # noqa: E402
from matplotlib.colors import Colormap, Normalize  # noqa: E402

from potdem import dumps  # noqa: E402

# shells of one sphere, from its rim to its highlight: size, offset towards the light, share of white
SHELLS = [(1.00, 0.00, -0.35), (0.93, 0.03, -0.12), (0.80, 0.10, 0.0), (0.60, 0.19, 0.12), (0.38, 0.27, 0.26),
          (0.18, 0.34, 0.45)]
LIGHT = np.array([-0.5, 0.75])
FRAMES_PER_SECOND, ANIMATION_DPI = 20, 100


def view(points, turn, tilt):
    """(across, up, depth) of points seen from the front (-y), turned about z and tilted down, in degrees"""
    a, b = np.radians(turn), np.radians(tilt)
    x, y, z = points.T
    across, away = x * np.cos(a) - y * np.sin(a), x * np.sin(a) + y * np.cos(a)
    return np.column_stack([across, z * np.cos(b) + away * np.sin(b), away * np.cos(b) - z * np.sin(b)])


def _shade(colours, white):
    target = 1.0 if white > 0 else 0.0
    shaded = colours.copy()
    shaded[:, :3] += (target - colours[:, :3]) * abs(white)
    return shaded


def spheres(axes, points, radii, colours, turn=-24.0, tilt=16.0):
    """one collection for all: the shells of a sphere follow each other, the far spheres come first"""
    seen = view(points, turn, tilt)
    order = np.argsort(-seen[:, 2])
    seen, radii, colours = seen[order], radii[order], colours[order]
    sizes = np.stack([2.0 * radii * size for size, _, _ in SHELLS], axis=1).ravel()
    centres = np.stack([seen[:, :2] + radii[:, None] * shift * LIGHT for _, shift, _ in SHELLS], axis=1).reshape(-1, 2)
    faces = np.stack([_shade(colours, white) for _, _, white in SHELLS], axis=1).reshape(-1, 4)
    axes.add_collection(EllipseCollection(sizes, sizes, np.zeros(sizes.size), units="xy", offsets=centres,
                                          transOffset=axes.transData, facecolors=faces, edgecolors="none"))


def floor(axes, corners, turn=-24.0, tilt=16.0):
    seen = view(np.asarray(corners, dtype=float), turn, tilt)
    axes.fill(seen[:, 0], seen[:, 1], color="#e7e3dc", zorder=-2, linewidth=0)


def panels(rows, columns, width=7.0, height=3.2):
    """figure and its array of panels, without axes: lengths are to scale"""
    figure, axes = plt.subplots(rows, columns, figsize=(width * columns, height * rows + 0.9), squeeze=False,
                                constrained_layout=True)
    for panel in axes.ravel():
        panel.set_aspect("equal")
        panel.axis("off")
    return figure, axes


@dataclass
class Film:
    """how a scene shows a frame of its dump: draw(axis, frame) fills a panel of the given size in inches; its colours are
    those of `scale`d values called `label`"""

    dump: str
    draw: Callable
    scale: Normalize
    colours: Colormap
    label: str
    width: float = 7.0
    height: float = 3.2

    def frames(self, folder):
        return dumps.read_run(folder, self.dump)

    def panels(self, rows, columns):
        return panels(rows, columns, self.width, self.height)

    def colour_bar(self, figure, axes, **settings):
        bar = figure.colorbar(matplotlib.cm.ScalarMappable(self.scale, self.colours), ax=list(axes), orientation="horizontal",
                              **settings)
        bar.set_label(self.label)

    def at_instants(self, folders, instants, label, by_rows=False, **bar):
        """figure of some runs at some instants, a column (or row) for each run, with the bar of the colours; label(variant, instant):
        (x, y, text) in a panel"""
        figure, axes = self.panels(*((len(folders), len(instants)) if by_rows else (len(instants), len(folders))))
        for line, folder in zip(axes if by_rows else axes.T, folders):
            frames, variant = self.frames(folder), Path(folder).resolve().name.split(".")[0]
            for axis, instant in zip(line, instants):
                self.draw(axis, dumps.at(frames, instant))
                axis.text(*label(variant, instant), transform=axis.transAxes, fontsize=11, va="top")
        self.colour_bar(figure, axes.ravel(), **bar)
        return figure

    def animate(self, folder, path):
        """all frames of a run"""
        figure, axes = self.panels(1, 1)
        axis = axes[0, 0]
        self.colour_bar(figure, [axis], shrink=0.8, pad=0.02)

        def show(frame):
            axis.clear()
            axis.axis("off")
            axis.set_aspect("equal")
            self.draw(axis, frame)
            axis.set_title(f"t = {frame['time']:.3f} s", fontsize=11, loc="left")

        FuncAnimation(figure, show, self.frames(folder)).save(path, writer=PillowWriter(FRAMES_PER_SECOND), dpi=ANIMATION_DPI)
        plt.close(figure)
