# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Reads LAMMPS's text dumps, of atoms (dump custom) and of other entries (dump local)."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from potdem import logs


class DumpError(Exception):
    """a file that is no text dump, or has no complete frame"""


class Frame(dict):
    """one snapshot: column name -> array, one value for each row in the dump's own order; step: its time step; box: a Box"""

    def __init__(self, step, columns, box=None):
        super().__init__(columns)
        self.step, self.box = step, box


@dataclass
class Box:
    """low: its corner; edges: its vectors, one a row; periodic: x, y, z"""

    low: np.ndarray
    edges: np.ndarray
    periodic: np.ndarray

    def nearest(self, ways):
        """ways between points, across the periodic faces where that is nearer"""
        share = ways @ np.linalg.inv(self.edges)
        return ways - (np.round(share) * self.periodic) @ self.edges

    @staticmethod
    def read(kinds, rows):
        """from the words after ITEM: BOX BOUNDS and the three rows below: of a tilted box the bounds are those of all its corners"""
        rows = np.array([row.split() for row in rows], dtype=float)
        low, high = rows[:, 0], rows[:, 1]
        tilt = rows[:, 2] if rows.shape[1] > 2 else np.zeros(3)    # xy, xz, yz
        corners = [min(0.0, tilt[0], tilt[1], tilt[0] + tilt[1]), min(0.0, tilt[2]), 0.0]
        beyond = [max(0.0, tilt[0], tilt[1], tilt[0] + tilt[1]), max(0.0, tilt[2]), 0.0]
        sides = (high - beyond) - (low - corners)
        edges = np.array([[sides[0], 0, 0], [tilt[0], sides[1], 0], [tilt[1], tilt[2], sides[2]]])
        return Box(low - corners, edges, np.array([word == "pp" for word in kinds[-3:]]))


@dataclass
class _Place:
    """where a frame is: its file, the first byte of its rows and the byte after them"""

    path: Path
    start: int
    end: int
    step: int
    count: int
    names: list
    box: "Box | None"
    time: "float | None"


class Dump:
    """the frames of a dump, each read when it is asked for; of several files too (a name with * in the script). A frame that is not
    written to its end is left out, and `cut` names its file. Of frames of the same step in a file, as of a run that went on, the last"""

    def __init__(self, *paths):
        self.paths, self.cut, self.units = [Path(path) for path in paths], None, None
        found = (place for path in self.paths for place in {place.step: place for place in self._index(path)}.values())
        self.places = sorted(found, key=lambda place: place.step)
        if not self.places:
            what = "its only frame is not complete" if self.cut else "it has no frame"
            raise DumpError(f"{self.paths[0]}: {what}. tools/see reads the text files of dump custom and dump local")

    def _index(self, path):
        try:
            with path.open("rb") as file:
                yield from self._places(path, file)
        except EOFError:
            self.cut = path
        except OSError as problem:
            raise DumpError(f"{path}: {problem.strerror}") from None
        except (ValueError, IndexError):
            raise DumpError(f"{path}: not a text file of dump custom or dump local (of another style, binary or compressed?)") from None

    def _places(self, path, file):
        step = count = box = time = None
        while line := file.readline():
            words = _whole(line).split()
            if words[:1] != ["ITEM:"]:
                raise ValueError
            if words[1:] == ["TIMESTEP"]:
                step, time = int(_whole(file.readline())), None
            elif words[1:] == ["UNITS"]:
                self.units = _whole(file.readline()).strip()
            elif words[1:] == ["TIME"]:
                time = float(_whole(file.readline()))
            elif words[1:3] == ["NUMBER", "OF"]:
                count = int(_whole(file.readline()))
            elif words[1:3] == ["BOX", "BOUNDS"]:
                box = Box.read(words[3:], [_whole(file.readline()) for _ in range(3)])
            else:
                start = file.tell()
                for _ in range(count):
                    _whole(file.readline())
                yield _Place(path, start, file.tell(), step, count, words[2:], box, time)

    def __len__(self):
        return len(self.places)

    def __getitem__(self, number):
        place = self.places[number]
        with place.path.open("rb") as file:
            file.seek(place.start)
            values = np.array(file.read(place.end - place.start).split())
        if values.size != place.count * len(place.names):
            raise DumpError(f"{place.path}: rows of step {place.step} have not the {len(place.names)} columns of their header")
        frame = Frame(place.step, zip(place.names, _numbers(values.reshape(place.count, len(place.names)))), place.box)
        if place.time is not None:
            frame["time"] = place.time
        return frame

    @property
    def steps(self):
        return [place.step for place in self.places]

    @property
    def names(self):
        return self.places[0].names


def _whole(line):
    """the text of a line that was written to its end"""
    if not line.endswith(b"\n"):
        raise EOFError
    return line.decode("ascii")


def _numbers(table):
    """columns as numbers; of words (element) as they are"""
    try:
        return table.astype(float).T
    except ValueError:
        return [_column(values) for values in table.T]


def _column(values):
    try:
        return values.astype(float)
    except ValueError:
        return values.astype(str)


def read(path):
    """the frames of a dump"""
    dump = Dump(path)
    return [dump[number] for number in range(len(dump))]


def read_run(folder, name):
    """frames of the dump of that name in a run's folder, with the 'time' of each by the run's log"""
    folder = Path(folder)
    thermo = logs.read_thermo(next(folder.glob("log.*")))
    frames = read(folder / name)
    for frame in frames:
        frame["time"] = float(np.interp(frame.step, thermo["Step"], thermo["Time"]))
    return frames


def at(frames, instant, by="time"):
    """the frame nearest to an instant, or to another value that each frame has"""
    return min(frames, key=lambda frame: abs(frame[by] - instant))
