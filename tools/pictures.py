#!/usr/bin/env python3
# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Draws the pictures on the pages of the scenes, animations of seven of them, and the pictures of docs/see.md.

Usage: tools/python tools/pictures.py [SCENE ...] [animation] [see] [recipes]   examples/*/*.png, docs/*.gif, docs/see*.png, or some
from the runs in build/examples; makes the runs that are not there (all: half an hour on one core).
"""

import re
import shutil
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

from potdem import dumps, picture, plot, running, see
from potdem.paths import DOCS, EXAMPLES, with_package
from potdem.progress import Progress
from potdem.scenes import run_scene
from potdem.scenes.scene import OUTPUT, Scene

ANIMATION, SEE, RECIPES = "animation", "see", "recipes"
FRAMES, COLOURS = 64, 80
HEIGHT, DPI = 3.1, 84    # inches, and dots in each


def run_of(scene, name):
    """the folder of a run on one rank, which is made if it is not there"""
    variant = Scene(scene).variant(name)
    if not list(variant.output(1).glob("log.*.g++.1")):
        run_scene.simulate(variant, 1, Progress(variant.label))
    return variant.output(1)


@dataclass
class Drawn:
    """a picture on the page of a scene: the variants that it shows, and the program that draws it, from their folders or, if it is not
    plot.py, from the folder of all of them or as its option says"""

    scene: str
    name: str
    variants: tuple
    program: str = "plot.py"

    @property
    def path(self):
        return EXAMPLES / self.scene / f"{self.name}.png"

    def draw(self):
        folders = [run_of(self.scene, variant) for variant in self.variants]
        program, *option = self.program.split()
        sources = folders if program == "plot.py" else option or [OUTPUT / self.scene]
        subprocess.run([sys.executable, EXAMPLES / self.scene / program, *sources, self.path], env=with_package(), check=True)
        print(self.path)


SPEEDS = ("v2", "v4", "v6", "v8")
PICTURES = [
    Drawn("bar-strength", "bar-strength", (), "strengths.py --draw"),
    Drawn("beam-impact", "beam-impact", ("i-3", "i-5")),
    Drawn("beam-impact", "mid-span", ("ii-3", "ii-5")),
    Drawn("beam-impact", "unbroken", ("i-3-unbroken", "i-5-unbroken")),
    Drawn("beam-impact", "crack", ("i-5", "i-5-crack")),
    Drawn("beam-impact", "deflection", ("i-5", "ii-5", "iii-5", "i-5-unbroken", "ii-5-unbroken", "iii-5-unbroken"), "deflection.py"),
    Drawn("beam-impulse", "beam-impulse", tuple(Scene("beam-impulse").default_variants)),
    Drawn("blade-cut", "blade-cut", ("fast", "slow")),
    Drawn("column-drop", "column-drop", ("sd5-1", "var5-1")),
    Drawn("column-drop", "spring", ("spring",)),
    Drawn("concrete-beam", "concrete-beam", ("v2", "v4")),
    Drawn("concrete-beam", "reaction", (*SPEEDS, *(f"{speed}-unbroken" for speed in SPEEDS)), "reaction.py"),
    *(Drawn("contact-laws", law, (law,)) for law in Scene("contact-laws").all_variants),
    Drawn("cylinder-impact", "cylinder-impact", ("1e6", "nearest", "2e5")),
    Drawn("cylinder-impact", "elastic", ("2e8",)),
    Drawn("disc-bed", "disc-bed", ("disc",)),
    Drawn("disc-bed", "others", ("printed", "fine", "unbreakable")),
    Drawn("elastic-statics", "hole", ("hole",)),
    Drawn("hopper", "hopper", ("smooth", "rough-walls", "rough")),
    Drawn("uniform-tension", "uniform-tension", ("sc-bulk", "sc-5", "sc-10", "fcc-bulk", "fcc-5", "fcc-10")),
]


@dataclass
class Shown:
    """a run in the animation until a time (s)"""

    scene: str
    variant: str
    until: float
    title: str

    def __post_init__(self):
        self.film = run_scene.film_of(Scene(self.scene))
        self.frames = self.film.frames(run_of(self.scene, self.variant))

    @property
    def shape(self):
        left, right, low, high = self.film.window
        return (right - left) / (high - low)

    def show(self, axis, share):
        self.film.show(axis, dumps.at(self.frames, self.film.zero + share * self.until))
        picture.header(axis, self.title)


# scene, variant, until (s), title
ANIMATIONS = {
    "scenes.gif": [("beam-impact", "i-5", 0.16, "a falling block breaks a beam"),
                   ("disc-bed", "disc", 1.2, "a disc falls on gravel"), ("hopper", "rough", 1.2, "a hopper")],
    "breaking.gif": [("concrete-beam", "v2", 0.2, "a hammer breaks a concrete beam"),
                     ("cylinder-impact", "2e5", 0.25, "a weak cylinder falls")],
    "grains.gif": [("column-drop", "spring", 1.2, "a column of grains spreads"), ("blade-cut", "fast", 2.0, "a blade in a bed")],
}


def animate(path):
    every = [Shown(*one) for one in ANIMATIONS[path.name]]
    figure, axes = picture.plt.subplots(1, len(every), figsize=(picture.WIDTH, HEIGHT), dpi=DPI, layout="constrained",
                                        width_ratios=[shown.shape for shown in every])

    def show(i):
        for axis, shown in zip(axes, every):
            shown.show(axis, i / (FRAMES - 1))

    picture.gif(figure, show, FRAMES, path, COLOURS)
    print(path)


def script_of_see():
    """the script of docs/see.md"""
    return re.search(r"^```LAMMPS\n(.*?)^```$", (DOCS / "see.md").read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)[1]


def draw_see(instant="0.036"):
    with tempfile.TemporaryDirectory() as folder:
        running.must_run(script_of_see(), {}, folder, name="mine", log="log.lammps")
        run, log = Path(folder) / "run.dump", Path(folder) / "log.lammps"
        for name, lines in (("see.png", []), ("see-bonds.png", ["--bonds"])):
            see.main([str(run), "--at", instant, *lines, "--still", str(DOCS / name)])
            picture.shrink(DOCS / name, DOCS / name)
        plot.main([str(log), "--out", str(DOCS / "see-plot.png")])


RECIPES_SHOWN = {
    "packing": ("a random packing", []),
    "stone": ("a stone from a drawing breaks", ["--colour", "speed", "--at", "0.0012"]),
    "interface": ("two materials drawn apart", ["--at", "0.0005"]),
    "crack": ("a crack runs through a plate", ["--view", "0", "90", "--at", "0.0006"]),
    "press": ("pressed between platens", ["--at", "0.0032"]),
    "bend": ("bent at three points", ["--view", "15", "10", "--at", "0.0044"]),
}


def draw_recipes(path=EXAMPLES / "recipes" / "recipes.png"):
    figure, axes = picture.plt.subplots(2, 3, figsize=(picture.WIDTH, 0.75 * picture.WIDTH), dpi=150, layout="constrained")
    with tempfile.TemporaryDirectory() as folder:
        for file in [*path.parent.glob("*.lmp"), *path.parent.glob("*.stl")]:
            shutil.copy(file, folder)
        for axis, (name, (title, how)) in zip(axes.flat, RECIPES_SHOWN.items()):
            running.must_run((path.parent / f"in.{name}").read_text(encoding="utf-8"), {}, folder, name=name, log=f"log.{name}")
            still = Path(folder) / f"{name}.png"
            see.main([str(Path(folder) / f"{name}.dump"), "--log", str(Path(folder) / f"log.{name}"), *how, "--still", str(still)])
            axis.imshow(picture.plt.imread(still))
            axis.set_axis_off()
            axis.set_title(title, fontsize="medium")
    figure.savefig(path)
    picture.shrink(path, path)
    print(path)


def main(*chosen):
    scenes = {drawn.scene for drawn in PICTURES}
    unknown = set(chosen) - {*scenes, ANIMATION, SEE, RECIPES}
    if unknown:
        sys.exit(f"no pictures of {', '.join(sorted(unknown))}; there are: {', '.join(sorted(scenes))}, {ANIMATION}, {SEE}, {RECIPES}")
    for drawn in PICTURES:
        if not chosen or drawn.scene in chosen:
            drawn.draw()
    if not chosen or ANIMATION in chosen:
        for name in ANIMATIONS:
            animate(DOCS / name)
    if not chosen or SEE in chosen:
        draw_see()
    if not chosen or RECIPES in chosen:
        draw_recipes()


if __name__ == "__main__":
    main(*sys.argv[1:])
