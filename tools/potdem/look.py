# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""How the particles of any dump are shown, with bonds or contacts as lines, and the walls that the log of the run tells of: what is
seen, from where, in which colours (see.py makes files of it)."""

from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from potdem import commands, dumps, picture, regions

SHARE = 0.02                # of values beyond the range of colours, and of particles outside the picture
KIND_COLOURS = np.array([picture.BODY, *map(picture.to_rgba, picture.CURVES)])    # of types 1, 2, ...
SMALL = {"bonds": 0.45, "contacts": 0.35}    # share of their radius with which particles are drawn among lines
DPI = 200


class SeeError(Exception):
    """what cannot be shown, and the remedy"""


# --- particles --------------------------------------------------------------------------------------------------------

def placed(frame, source, diameter):
    """the frame with x, y, z and radius, whatever columns stand for these"""
    if "x" not in frame:
        frame.update(zip("xyz", _positions(frame, source)))
    if diameter is not None:
        frame["radius"] = np.full(frame["x"].size, 0.5 * diameter)
    elif "diameter" in frame:
        frame["radius"] = 0.5 * frame["diameter"]
    elif "radius" not in frame:
        raise SeeError(f"{source} has no column radius. Let the script write it,\n{_advice(source)}\n"
                       "or give the diameter of all particles: --diameter 0.005")
    return frame


def _positions(frame, source):
    if "xu" in frame:
        return [frame["xu"], frame["yu"], frame["zu"]]
    if "xs" in frame or "xsu" in frame:
        shares = np.column_stack([frame[f"{k}s" if "xs" in frame else f"{k}su"] for k in "xyz"])
        return (frame.box.low + shares @ frame.box.edges).T
    raise SeeError(f"{source} has no positions, only {', '.join(frame)}. Let the script write them:\n{_advice(source)}")


def _advice(source):
    return f"  dump see all custom N {source.name} id type x y z radius"


def points(frame):
    return np.column_stack([frame[k] for k in "xyz"])


# --- bonds and contacts -----------------------------------------------------------------------------------------------

KINDS = {"bonds": ("batom1", "batom2"), "contacts": ("patom1", "patom2")}
ASKED = {"bonds": "bond/local b1 b2", "contacts": "pair/local force p1"}


class Links:
    """lines between particles, of a dump local: kind: bonds or contacts"""

    def __init__(self, kind, path, run):
        self.kind, self.run, self.dump = kind, run, dumps.Dump(path)
        self.path = Path(path)
        meaning = {column: run.meaning(column)[1] or column for column in self.dump.names}
        found = [next((column for column, what in meaning.items() if what == end), None) for end in KINDS[kind]]
        if None in found:
            # without a log: the first two columns after the index are taken for IDs
            if run.wrote(path) or len(self.dump.names) < 2 + ("index" in meaning):
                raise SeeError(f"{path} does not say which particles are joined. Let the script write it:\n"
                               f"{self.advice(kind, self.path.name)}")
            found = [column for column in self.dump.names if column != "index"][:2]
        self.ends = tuple(found)
        self.meaning = {column: what for column, what in meaning.items() if column not in found and column != "index"}
        self.number = {step: number for number, step in enumerate(self.dump.steps)}

    @staticmethod
    def advice(kind, file):
        one, two = KINDS[kind]
        values = ASKED[kind].split()
        columns = " ".join(f"c_state[{number}]" for number in range(1, len(values)))
        return (f"  compute ends all property/local {one} {two}\n  compute state all {ASKED[kind]}\n"
                f"  dump {kind} all local N {file} index c_ends[1] c_ends[2] {columns}")

    def default(self):
        """the column that gives the colour, or None"""
        for wanted in ("b1", "b2", "force", "p1"):
            for column, what in self.meaning.items():
                if what == wanted:
                    return column
        return next(iter(self.meaning), None)

    def at(self, frame):
        """(ends, columns) of those that are there at a frame's step: shape (n, 2, 3), and arrays with id1 and id2"""
        rows = self.dump[self.number[frame.step]]
        order = np.argsort(frame["id"])
        ids = frame["id"][order]
        places = np.stack([np.searchsorted(ids, rows[end]).clip(max=max(ids.size - 1, 0)) for end in self.ends])
        here = np.all(ids[places] == np.stack([rows[end] for end in self.ends]), axis=0) if ids.size else np.zeros(places.shape[1], bool)
        for column, what in self.meaning.items():
            if self.kind == "contacts" and (what == "p1" or what == "force"):    # of pairs that are near, those that touch
                here &= rows[column] != 0 if what == "force" else rows[column] > 0
        first, second = (points(frame)[order][place[here]] for place in places)
        way = second - first
        if frame.box is not None:
            way = frame.box.nearest(way)
        table = {"id1": rows[self.ends[0]][here], "id2": rows[self.ends[1]][here]}
        table.update((column, rows[column][here]) for column in self.meaning)
        return np.stack([first, first + way], axis=1), table


# --- what is drawn ----------------------------------------------------------------------------------------------------

@dataclass
class Colouring:
    """values of a frame as colours: of a scale, or one for each whole number; kinds: these numbers; loose: column that is 0 of particles
    without bonds"""

    column: "str | None" = None
    scale: "picture.Scale | None" = None
    kinds: tuple = ()
    loose: "str | None" = None

    def values(self, table):
        if self.column == "speed":
            return np.sqrt(sum(table[f"v{k}"] ** 2 for k in "xyz"))
        return table[self.column]

    def __call__(self, table, count):
        if self.column is None:
            return np.tile(picture.BODY, (count, 1))
        values = self.values(table)
        if self.scale is None:
            return KIND_COLOURS[(values.astype(int) - 1) % len(KIND_COLOURS)]
        colours = self.scale(values)
        if self.loose:
            colours[table[self.loose] == 0] = picture.LOOSE
        return colours


@dataclass
class View(picture.Film):
    """a run as it is shown"""

    run: commands.Commands = field(default_factory=commands.Commands)
    colouring: Colouring = field(default_factory=Colouring)
    links: "Links | None" = None
    room: "regions.Room | None" = None
    thermo: "dict | None" = None
    not_drawn: set = field(default_factory=set)

    def time(self, frame):
        """of a frame, in the units of the script, or None"""
        if "time" in frame:
            return frame["time"]
        if self.thermo and "Time" in self.thermo:
            return float(np.interp(frame.step, self.thermo["Step"], self.thermo["Time"]))
        return None if self.run.dt is None else frame.step * self.run.dt

    def title(self, frame):
        time = self.time(frame)
        if time is None:
            return f"step {frame.step}"
        return picture.time_words(time) if self.run.units == "si" else f"time {time:.4g} {self.run.unit('time')}".strip()

    def tiles(self, step):
        """of the walls at a step"""
        parts = [part for name in self.run.walls_at(step) if (part := self._tiles_of(name, step)) is not None]
        if not parts:
            return None
        return picture.Tiles(*(np.concatenate(arrays) for arrays in zip(*parts)))

    def _tiles_of(self, name, step):
        try:
            return regions.surface(name, self.run.regions, self.room, self._shift(name, step))
        except regions.NotDrawn as problem:
            self.not_drawn.add(f"{problem}, is a wall that is not drawn")
            return None

    def _shift(self, name, step):
        """how far a region has moved: by its variables, if they are columns of the thermo output"""
        words = self.run.regions[name].words
        if "rotate" in words:
            self.not_drawn.add(f"region {name} turns, and is drawn where it starts")
        if "move" not in words:
            return np.zeros(3)
        columns = words[words.index("move") + 1:][:3]
        missing = [column for column in columns if column != "NULL" and column not in (self.thermo or {})]
        if missing:
            self.not_drawn.add(f"region {name} moves, and is drawn where it starts: put {' '.join(missing)} into thermo_style custom")
            return np.zeros(3)
        way = [0.0 if column == "NULL" else np.interp(step, self.thermo["Step"], self.thermo[column]) for column in columns]
        return np.array(way) * self.run.regions[name].scale

    def paint(self, axis, frame):
        balls, lines = self.parts(axis, frame)
        picture.painted(axis, self.direction, balls, lines, self.tiles(frame.step))

    def parts(self, axis, frame):
        """(points, radii, colours) of the particles, and picture.Lines or None"""
        radii = frame["radius"]
        if self.links is None:
            return (points(frame), radii, self.colouring(frame, radii.size)), None
        ends, table = self.links.at(frame)
        colour = picture.GRAINS if self.links.kind == "contacts" else picture.BODY
        balls = points(frame), SMALL[self.links.kind] * radii, np.tile(colour, (radii.size, 1))
        per_length = axis.get_window_extent().width / np.ptp(axis.get_xlim()) * 72 / axis.figure.dpi
        widths = np.full(len(ends), 0.3 * np.median(radii) * per_length)
        if self.links.kind == "contacts" and self.colouring.scale:    # the larger the force, the wider
            widths *= 0.3 + 2.0 * self.colouring.scale.limits(np.abs(self.colouring.values(table))).clip(0, 1)
        return balls, picture.Lines(ends, self.colouring(table, len(ends)), widths)

    def figure(self):
        """figure and its panel, laid out with the first frame that it is to show"""
        figure, ((axis,),), _ = self.panels(1, 1)
        figure.set_dpi(DPI)
        wide, high = figure.get_size_inches()
        figure.set_size_inches(wide, high - (0.4 if self.colouring.scale else 0.7))    # no title of the whole, perhaps no colour bar
        if self.colouring.scale:
            self.colouring.scale.bar(figure, axis)
        elif 1 < len(self.colouring.kinds) < len(KIND_COLOURS):
            handles = [picture.plt.Line2D([], [], marker="o", linestyle="", color=KIND_COLOURS[kind - 1], label=str(kind))
                       for kind in self.colouring.kinds if 0 < kind <= len(KIND_COLOURS)]
            figure.legend(handles=handles, loc="lower center", ncols=len(handles), title=self.run.words(self.colouring.column))
            figure.get_layout_engine().set(rect=(0.0, 0.1, 1.0, 0.9))
        axis.set(xlim=self.window[:2], ylim=self.window[2:], aspect="equal")
        axis.set_title(" ", loc="left", pad=2)
        figure.canvas.draw()
        figure.set_layout_engine("none")    # panels stay where they are
        return figure, axis


def _kind(values):
    return "strain" if values.size and values.min() < 0 < values.max() else "speed"


def _range(values, symmetric):
    low, high = np.quantile(values, [SHARE, 1 - SHARE]) if values.size else (0.0, 1.0)
    if symmetric:
        high = max(abs(low), abs(high))
        low = -high
    if high > low:
        return low, high
    return (low - 0.5 * abs(low), low + 0.5 * abs(low)) if low else (0.0, 1.0)


def colouring(frames, run, links, wanted, limits):
    """what gives the colours: the wanted column, or what there is"""
    tables = [links.at(frame)[1] for frame in frames] if links else frames
    if links:
        column = wanted or links.default()
    else:
        column = wanted or _default_column(frames[0], run)
    if column is None:
        return Colouring()
    if column not in tables[0] and not (column == "speed" and "vx" in tables[0]):
        source = links.path.name if links else "the dump"
        raise SeeError(f"{source} has no column {column}; it has: {', '.join(name for name in tables[0] if name not in ('id1', 'id2'))}")
    found = Colouring(column)
    values = np.concatenate([found.values(table) for table in tables])
    if column in ("type", "mol", "proc") or run.meaning(column)[1] == "piece":
        found.kinds = tuple(np.unique(values).astype(int))
        return found
    if values.dtype.kind != "f":
        raise SeeError(f"column {column} has words, not numbers; choose another with --colour")
    values = values[np.isfinite(values)]
    kind = _kind(values)
    if run.meaning(column)[1].startswith("strain"):
        kind = "strain"
        found.loose = next((name for name in frames[0] if run.meaning(name)[1] == commands.BONDS), None) if not links else None
    low, high = limits or _range(values, kind == "strain")
    label = f"speed, {run.unit('velocity')}".rstrip(", ") if column == "speed" else run.label(column)
    found.scale = picture.Scale(kind, low, high, label, "both")
    return found


def _default_column(frame, run):
    for name in frame:
        if run.meaning(name)[1].startswith("strain"):
            return name
    if all(f"v{k}" in frame for k in "xyz"):
        return "speed"
    return "type" if "type" in frame and np.ptp(frame["type"]) > 0 else None


def direction_of(frames):
    """from above what lies in a plane; along y what is longer that way"""
    spread = np.max([np.ptp(points(frame), axis=0) for frame in frames if frame["x"].size], axis=0)
    if spread[2] == 0 and np.any(spread > 0):
        return picture.TOP
    turn, tilt = picture.SLANTED
    return (turn + 90.0, tilt) if spread[1] > 1.5 * spread[0] else picture.SLANTED


def _extent(frames, share, direction=None):
    """(low, high) corners of the particles of frames, but for a share of them at each end; seen along a direction: (across, up)"""
    low, high = [], []
    for frame in frames:
        if frame["x"].size:
            seen = points(frame) if direction is None else picture.view(points(frame), *direction)[:, :2]
            radii = frame["radius"][:, None]
            low.append(np.quantile(seen - radii, share, axis=0))
            high.append(np.quantile(seen + radii, 1 - share, axis=0))
    return np.min(low, axis=0), np.max(high, axis=0)


def room_of(frames):
    """in which walls are drawn: that of the particles, and a little more"""
    low, high = _extent(frames, 0.5 * SHARE)
    whole = _extent(frames[:1], 0.0)
    low, high = np.minimum(low, whole[0]), np.maximum(high, whole[1])
    margin = 0.06 * np.max(high - low)
    return regions.Room(low - margin, high + margin)


def window_of(frames, direction, tiles):
    """(left, right, low, high) of the picture: all particles of the first frame, nearly all of the others, the walls; and below
    them the place (x, y, z) and length of the bar"""
    low, high = _extent(frames, 0.5 * SHARE, direction)
    whole = _extent(frames[:1], 0.0, direction)
    low, high = np.minimum(low, whole[0]), np.maximum(high, whole[1])
    if tiles is not None and len(tiles.corners):
        seen = picture.view(tiles.corners.reshape(-1, 3), *direction)[:, :2]
        low, high = np.minimum(low, seen.min(axis=0)), np.maximum(high, seen.max(axis=0))
    size = np.max(high - low)
    margin = 0.03 * size
    raw = 0.2 * size
    power = 10.0 ** np.floor(np.log10(raw))
    length = max(factor * power for factor in (1, 2, 5) if factor * power <= 1.0001 * raw)
    place = np.array([low[0], low[1] - 0.04 * size, 0.0])
    axes = picture.view(np.eye(3), *direction)    # rows: what x, y, z become
    return (low[0] - margin, high[0] + margin, low[1] - 0.13 * size, high[1] + margin), (length, tuple(axes @ place))
