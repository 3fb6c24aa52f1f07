#!/usr/bin/env python3
# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Shows three scenes side by side: a bonded solid that breaks, one that falls on grains, and grains.

Usage: tools/python tools/animation.py      writes docs/scenes.gif, from the runs in build/examples; runs what has not been run
"""

from dataclasses import dataclass

from potdem import dumps, picture
from potdem.paths import DOCS
from potdem.progress import Progress
from potdem.scenes import run_scene
from potdem.scenes.scene import Scene

PATH = DOCS / "scenes.gif"
FRAMES, COLOURS = 64, 80
HEIGHT, DPI = 3.1, 84    # inches, and dots in each


@dataclass
class Shown:
    scene: str
    variant: str
    until: float    # s
    title: str

    def __post_init__(self):
        variant = Scene(self.scene).variant(self.variant)
        if not list(variant.output(1).glob("log.*.g++.1")):
            run_scene.simulate(variant, 1, Progress(variant.label))
        self.film = run_scene.film_of(variant.scene)
        self.frames = self.film.frames(variant.output(1))

    @property
    def shape(self):
        left, right, low, high = self.film.window
        return (right - left) / (high - low)

    def show(self, axis, share):
        self.film.show(axis, dumps.at(self.frames, self.film.zero + share * self.until))
        picture.header(axis, self.title)


def main():
    every = [Shown("beam-impact", "i-5", 0.4, "a falling block breaks a beam"), Shown("disc-bed", "disc", 1.2, "a disc falls on gravel"),
             Shown("hopper", "rough", 1.2, "a hopper")]
    figure, axes = picture.plt.subplots(1, len(every), figsize=(picture.WIDTH, HEIGHT), layout="constrained",
                                        dpi=DPI,
                                        width_ratios=[shown.shape for shown in every])

    def show(i):
        for axis, shown in zip(axes, every):
            shown.show(axis, i / (FRAMES - 1))

    picture.gif(figure, show, FRAMES, PATH, COLOURS)


if __name__ == "__main__":
    main()
