# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""The pictures of all scenes in one style: particles as shaded spheres, seen along a slanted direction, coloured by a value of each;
curves; animations. Pictures have one width and one size of letters, so that they look alike side by side on a page."""

import io
import re
from dataclasses import dataclass
from pathlib import Path
from typing import Callable

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from matplotlib.collections import EllipseCollection, LineCollection, PolyCollection  # noqa: E402
from matplotlib.colors import LinearSegmentedColormap, Normalize, to_rgba  # noqa: E402
from matplotlib.patheffects import withStroke  # noqa: E402
from matplotlib.ticker import MaxNLocator  # noqa: E402
from PIL import Image, features  # noqa: E402

from potdem import dumps  # noqa: E402
from potdem.scenes import scene as scenes  # noqa: E402

WIDTH, DPI = 9.5, 100          # inches, of a picture
PANEL = (5.0, 4.5)             # width and height, inches, that a panel has at most
FONT = 11                      # points
FRAMES_PER_SECOND = 20
plt.rcParams.update({"font.size": FONT, "axes.titlesize": FONT, "axes.labelsize": FONT, "legend.fontsize": FONT - 2,
                     "xtick.labelsize": FONT - 1, "ytick.labelsize": FONT - 1, "figure.titlesize": FONT + 2, "legend.frameon": False,
                     "figure.constrained_layout.h_pad": 0.06, "figure.constrained_layout.w_pad": 0.06, "lines.linewidth": 1.5,
                     "axes.spines.top": False, "axes.spines.right": False, "savefig.dpi": DPI, "figure.dpi": DPI})


def _between(*colours):
    return LinearSegmentedColormap.from_list("", colours)


def _part(name, low, high):
    """a colour map without its ends, where the shades of a sphere are lost"""
    return LinearSegmentedColormap.from_list(name, matplotlib.colormaps[name](np.linspace(low, high, 256)))


# what a colour stands for, in every scene
MAPS = {"strain": matplotlib.colormaps["coolwarm"], "stress": matplotlib.colormaps["coolwarm"],
        "velocity": _between("#41237a", "#a394cf", "#dedbd5", "#e9ac5e", "#95500e"),
        "speed": _part("YlGnBu", 0.12, 0.95), "way": _part("RdPu", 0.1, 0.95), "damage": _part("YlOrRd", 0.08, 0.95)}
BODY, GRAINS, LOOSE = to_rgba("#8a8f98"), to_rgba("#b9b4aa"), to_rgba("#c9b458")    # a body that only hits, a bed, debris
WALL, FLOOR, STEEL = "#b9c2c9", "#e7e3dc", "#555555"
INK, POINT, GUIDE = "#20516e", "#d1495b", "#9aa5ad"    # formula, LAMMPS, what helps the eye
CURVES = ("#d1495b", "#3b7dd8", "#2a9d5c", "#8d6cab", "#b5651d", "#4b4b4b", "#d08c2e", "#6fb1b5")
# particles in pieces of that many
PIECES = {"100 and more": "#4a5568", "10 to 99": "#8aa0bd", "2 to 9": "#e6b566", "single": "#c4553b"}

# shells of one sphere, from its rim to its highlight: size, offset towards the light, share of white
SHELLS = [(1.00, 0.00, -0.35), (0.93, 0.03, -0.12), (0.80, 0.10, 0.0), (0.60, 0.19, 0.12), (0.38, 0.27, 0.26),
          (0.18, 0.34, 0.45)]
LIGHT = np.array([-0.5, 0.75])
PALETTE = Image.Quantize.LIBIMAGEQUANT if features.check("libimagequant") else Image.Quantize.MEDIANCUT
SLANTED, FRONT, TOP = (-24.0, 16.0), (0.0, 0.0), (0.0, 90.0)    # degrees: turn about z, tilt
SLABS = 32    # in depth, of what is painted from far to near


# --- words ------------------------------------------------------------------------------------------------------------

def time_words(seconds):
    return f"{1e3 * seconds:.3g} ms" if 0 < seconds < 0.01 else f"{seconds:.3g} s"


def length_words(metres):
    factor, unit = (1.0, "m") if metres >= 1 else (1e2, "cm") if metres >= 0.01 else (1e3, "mm")
    return f"{factor * metres:.3g} {unit}"


def settings(folder):
    """the values (text) that the variables of the script had in the run in build/examples/<scene>/<variant>.np<ranks>: those of the
    variant and, of the others, what the script itself sets; none of another folder"""
    folder = Path(folder).resolve()
    try:
        variant = scenes.Scene(folder.parent.name).variant(folder.name.rsplit(".np", 1)[0])
    except scenes.SceneError:
        return {}
    script = (variant.scene.folder / variant.scene.script).read_text(encoding="utf-8")
    own = dict(re.findall(r"^variable +(\w+) +index +(\S+)", script, re.MULTILINE))
    return {**own, **{name: str(value) for name, value in variant.variables.items()}}


# --- bodies -----------------------------------------------------------------------------------------------------------

@dataclass
class Scale:
    """values of a kind (see MAPS) between low and high, as colours; extend: the ends whose colours stand for all beyond, as of a
    colour bar"""

    kind: str
    low: float
    high: float
    label: str
    extend: str = "neither"

    @property
    def limits(self):
        return Normalize(self.low, self.high)

    def __call__(self, values):
        return MAPS[self.kind](self.limits(values))

    def bar(self, figure, axes):
        """the colours with their values, below the axes"""
        shown = matplotlib.cm.ScalarMappable(self.limits, MAPS[self.kind])
        figure.colorbar(shown, ax=list(np.ravel(axes)), label=self.label, extend=self.extend,
                        orientation="horizontal", shrink=0.5 if figure.get_figwidth() > PANEL[0] else 0.9, aspect=40, pad=0.03,
                        ticks=MaxNLocator(5, steps=[1, 2, 2.5, 5, 10]))


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


def spheres(axes, points, radii, colours, turn=SLANTED[0], tilt=SLANTED[1], zorder=1.0):
    """one collection for all: the shells of a sphere follow each other, the far spheres come first"""
    seen = view(points, turn, tilt)
    order = np.argsort(-seen[:, 2])
    seen, radii, colours = seen[order], radii[order], colours[order]
    sizes = np.stack([2.0 * radii * size for size, _, _ in SHELLS], axis=1).ravel()
    centres = np.stack([seen[:, :2] + radii[:, None] * shift * LIGHT for _, shift, _ in SHELLS], axis=1).reshape(-1, 2)
    faces = np.stack([_shade(colours, white) for _, _, white in SHELLS], axis=1).reshape(-1, 4)
    axes.add_collection(EllipseCollection(sizes, sizes, np.zeros(sizes.size), units="xy", offsets=centres,
                                          transOffset=axes.transData, facecolors=faces, edgecolors="none", zorder=zorder))


def particles(axes, frame, colours, direction=SLANTED):
    """the particles of a frame of a dump"""
    spheres(axes, np.column_stack([frame["x"], frame["y"], frame["z"]]), frame["radius"], colours, *direction)


@dataclass
class Lines:
    """between points, shape (n, 2, 3); their colours and widths in points"""

    ends: np.ndarray
    colours: np.ndarray
    widths: np.ndarray


@dataclass
class Tiles:
    """of walls: corners, shape (n, 4, 3), and normals to the side of the particles. Those that would hide the particles are not drawn"""

    corners: np.ndarray
    normals: np.ndarray


def painted(axes, direction, balls, lines=None, tiles=None):
    """spheres (points, radii, colours), lines and tiles in slabs from far to near, each in front of the one before"""
    depth = {"balls": view(balls[0], *direction)[:, 2]}
    if lines is not None:
        depth["lines"] = view(lines.ends.mean(axis=1), *direction)[:, 2]
    if tiles is not None:
        shown = tiles.normals @ view(np.eye(3), *direction)[:, 2] < 1e-6    # on edge they are lines
        tiles = Tiles(tiles.corners[shown], tiles.normals[shown])
        depth["tiles"] = view(tiles.corners.reshape(-1, 3), *direction)[:, 2].reshape(-1, 4).max(axis=1)
    every = np.concatenate(list(depth.values()))
    if not every.size:
        return
    edges = np.linspace(every.max(), every.min(), SLABS + 1)[1:-1]
    slab = {kind: np.searchsorted(-edges, -values) for kind, values in depth.items()}
    for number in range(SLABS):
        level = 1.0 + number / SLABS
        if tiles is not None:
            _tiles(axes, tiles, slab["tiles"] == number, direction, level)
        if lines is not None:
            _lines(axes, lines, slab["lines"] == number, direction, level + 0.3 / SLABS)
        chosen = slab["balls"] == number
        if chosen.any():
            spheres(axes, *(values[chosen] for values in balls), *direction, zorder=level + 0.6 / SLABS)


def _tiles(axes, tiles, chosen, direction, zorder):
    if not chosen.any():
        return
    corners = view(tiles.corners[chosen].reshape(-1, 3), *direction)[:, :2].reshape(-1, 4, 2)
    light = np.abs(view(tiles.normals[chosen], *direction) @ np.array([-0.3, 0.8, -0.5]))
    faces = np.column_stack([np.array(to_rgba(FLOOR))[:3] * (0.78 + 0.24 * light[:, None]), np.ones(light.size)]).clip(0, 1)
    on_edge = np.abs(tiles.normals[chosen] @ view(np.eye(3), *direction)[:, 2]) <= 1e-6
    edges = np.where(on_edge[:, None], to_rgba(WALL), faces)
    axes.add_collection(PolyCollection(corners, facecolors=faces, edgecolors=edges, linewidths=np.where(on_edge, 2.0, 0.4), zorder=zorder))


def _lines(axes, lines, chosen, direction, zorder):
    if chosen.any():
        ends = view(lines.ends[chosen].reshape(-1, 3), *direction)[:, :2].reshape(-1, 2, 2)
        axes.add_collection(LineCollection(ends, colors=lines.colours[chosen], linewidths=lines.widths[chosen], zorder=zorder))


def floor(axes, corners, turn=SLANTED[0], tilt=SLANTED[1]):
    seen = view(np.asarray(corners, dtype=float), turn, tilt)
    axes.fill(seen[:, 0], seen[:, 1], color=FLOOR, zorder=-2, linewidth=0)


def block(axes, left, right, low, high, colour=WALL, layer=-2):
    """a wall seen from the front"""
    axes.fill([left, right, right, left], [low, low, high, high], color=colour, linewidth=0, zorder=layer)


def length_bar(axes, start, length, direction=FRONT, text=None):
    """a bar of that length (m) along x from the place `start`, with its length in words, or another text"""
    ends = view(np.array([start, np.add(start, (length, 0, 0))], dtype=float), *direction)[:, :2]
    halo = [withStroke(linewidth=2.5, foreground="white")]    # particles may fly past
    axes.plot(*ends.T, color="black", linewidth=2.5, solid_capstyle="butt", zorder=6)
    axes.annotate(text or length_words(length), ends.mean(axis=0), xytext=(0, -3), textcoords="offset points", ha="center", va="top",
                  fontsize=FONT - 1, path_effects=halo, zorder=6)


def panels(rows, columns, width=7.0, height=3.2):
    """figure and its array of panels of that size in inches, without axes: lengths are to scale"""
    figure, axes = plt.subplots(rows, columns, figsize=(width * columns, height * rows + 0.9), squeeze=False,
                                constrained_layout=True)
    for panel in axes.ravel():
        panel.set_aspect("equal")
        panel.axis("off")
    return figure, axes


@dataclass
class Film:
    """how a scene shows a frame of its dump: draw(axis, frame) fills a panel, its colours are those of `scale`"""

    dump: str
    draw: Callable
    scale: Scale
    window: tuple               # left, right, low, high: what is seen, m
    bar: tuple                  # the length that is shown, m, and the place (x, y, z) where it starts
    direction: tuple = FRONT
    words: "Callable | None" = None    # words(variables of a run, see settings): what it is
    zero: float = 0.0           # s, when the scene's time starts
    by: str = "time"            # what the instants are values of
    bar_words: "str | None" = None    # the length in other words than metres

    def frames(self, folder):
        return dumps.read_run(folder, self.dump)

    def name(self, folder):
        """what the run in a folder is, in words"""
        variables = settings(folder)
        return self.words(variables) if self.words and variables else Path(folder).resolve().name

    def title(self, frame):
        return time_words(frame["time"] - self.zero)

    def panels(self, rows, columns, below=(), one_run=False):
        """figure, its panels, and for each height (inches) in `below` a row of axes for curves: one under each column, or, of one run,
        one for all columns"""
        left, right, low, high = self.window
        width = min(WIDTH, columns * min(PANEL[0], PANEL[1] * (right - left) / (high - low)))
        height = (width - (0.7 if below else 0.0)) / columns * (high - low) / (right - left) + 0.25    # curves have labels
        figure = plt.figure(figsize=(width, rows * height + sum(below) + 1.0), layout="constrained")
        grid = figure.add_gridspec(rows + len(below), columns, height_ratios=[*[height] * rows, *below])
        axes = np.array([[figure.add_subplot(grid[row, column]) for column in range(columns)] for row in range(rows)])
        for panel in axes.ravel():
            panel.axis("off")
        places = [slice(None)] if one_run else range(columns)
        return figure, axes, [[figure.add_subplot(grid[rows + row, place]) for place in places] for row in range(len(below))]

    def show(self, axis, frame):
        """a frame in a panel, instead of what was there, with its time and a length"""
        axis.clear()
        axis.axis("off")
        axis.set(xlim=self.window[:2], ylim=self.window[2:], aspect="equal")
        self.draw(axis, frame)
        length_bar(axis, self.bar[1], self.bar[0], self.direction, self.bar_words)
        axis.set_title(self.title(frame), loc="left", pad=2)

    def _reaches(self, frames, instant):
        """to half the distance of frames"""
        return instant + self.zero <= 1.5 * frames[-1][self.by] - 0.5 * frames[-2][self.by]

    def reached(self, runs, instants):
        """those of the instants that one of the runs (lists of frames) reaches"""
        return [instant for instant in instants if any(self._reaches(frames, instant) for frames in runs)]

    def column(self, column, frames, instants):
        """frames at instants, one below the other; a run may end before the last of them"""
        for axis, instant in zip(column, instants):
            if self._reaches(frames, instant):
                self.show(axis, dumps.at(frames, instant + self.zero, self.by))
            else:
                axis.text(0.5, 0.5, f"the run ends at {self.title(frames[-1])}", transform=axis.transAxes, ha="center", color=GUIDE)

    def at_instants(self, folders, instants, below=()):
        """figure of some runs at some instants, and axes for curves (see panels): a column for each run, a row for each instant that
        one of them reaches. The instants of a single run come side by side."""
        runs = [self.frames(folder) for folder in folders]
        instants = self.reached(runs, instants)
        if len(folders) == 1:
            return self._one_run(folders[0], runs[0], instants, below)
        figure, axes, curves_below = self.panels(len(instants), len(folders), below)
        for column, folder, frames in zip(axes.T, folders, runs):
            self.column(column, frames, instants)
            header(column[0], self.name(folder))
        self.scale.bar(figure, axes)
        return figure, curves_below

    def _one_run(self, folder, frames, instants, below):
        left, right, low, high = self.window
        columns = 2 if right - left > high - low and len(instants) != 3 else len(instants)
        figure, axes, curves_below = self.panels(-(-len(instants) // columns), columns, below, one_run=True)
        self.column(axes.ravel(), frames, instants)
        figure.suptitle(self.name(folder))
        self.scale.bar(figure, axes)
        return figure, curves_below

    def animate(self, folder, path):
        """all frames of a run"""
        figure, ((axis,),), _ = self.panels(1, 1)
        self.scale.bar(figure, axis)
        figure.suptitle(self.name(folder))
        frames = self.frames(folder)

        gif(figure, lambda i: self.show(axis, frames[i]), len(frames), path)


def header(axis, text):
    """over a panel and its title"""
    axis.set_title(f"{text}\n", loc="center", fontsize=FONT + 1)


# --- curves -----------------------------------------------------------------------------------------------------------

def curves(rows, columns, height, **more):
    """figure and its array of axes, of that height in inches"""
    return plt.subplots(rows, columns, figsize=(WIDTH, rows * height), squeeze=False, layout="constrained", **more)


def ordered(count):
    """colours of curves that follow each other, such as of growing speeds"""
    return matplotlib.colormaps["viridis"](np.linspace(0.0, 0.85, count))


# --- files ------------------------------------------------------------------------------------------------------------

def _with_palette(images, sample, colours):
    """images with one palette, made for a sample of them"""
    palette = sample.quantize(colours, PALETTE)
    entries = np.array(palette.getpalette())
    palette.putpalette(np.where(entries > 248, 255, entries).tolist())    # white stays white
    return [image.quantize(palette=palette, dither=Image.Dither.NONE) for image in images]


def save(figure, path):
    """as PNG with a palette, which takes a third of the space"""
    whole = io.BytesIO()
    figure.savefig(whole, format="png", facecolor="white")
    plt.close(figure)
    shrink(whole, path)


def shrink(source, path):
    """a PNG as one with a palette"""
    image = Image.open(source).convert("RGB")
    _with_palette([image], image, 256)[0].save(path, format="png", optimize=True)


def gif(figure, show, count, path, colours=128):
    """show(0), ... show(count - 1) fill the figure, each for a frame; the last stands for a second. The palette is that of every
    fourth"""
    images = []
    show(0)
    figure.canvas.draw()
    figure.set_layout_engine("none")    # panels stay where they are
    for i in range(count):
        show(i)
        figure.canvas.draw()
        images.append(Image.fromarray(np.asarray(figure.canvas.buffer_rgba())[..., :3]))
    plt.close(figure)
    sample = Image.fromarray(np.concatenate([np.asarray(image) for image in images[::4]]))
    images = _with_palette(images, sample, colours)
    images[0].save(path, save_all=True, append_images=images[1:], loop=0, optimize=True,
                   duration=[1000 // FRAMES_PER_SECOND] * (count - 1) + [1000])
