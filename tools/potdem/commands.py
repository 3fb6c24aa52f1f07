# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""The script of a run as its log has it: LAMMPS repeats every command there, with the values of its variables. Units, step, computes,
dumps, regions and the fixes that are walls on them."""

import math
import re
import shlex
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from potdem import logs

# of LAMMPS's unit systems, as words behind a number
UNITS = {
    "si": {"length": "m", "time": "s", "velocity": "m/s", "force": "N", "energy": "J", "stress": "Pa", "mass": "kg"},
    "cgs": {"length": "cm", "time": "s", "velocity": "cm/s", "force": "dyne", "energy": "erg", "stress": "barye", "mass": "g"},
    "micro": {"length": "µm", "time": "µs", "velocity": "µm/µs", "force": "pg µm/µs²", "energy": "pg µm²/µs²",
              "stress": "pg/(µm µs²)", "mass": "pg"},
    "nano": {"length": "nm", "time": "ns", "velocity": "nm/ns", "force": "ag nm/ns²", "energy": "ag nm²/ns²", "stress": "ag/(nm ns²)",
             "mass": "ag"},
    "metal": {"length": "Å", "time": "ps", "velocity": "Å/ps", "force": "eV/Å", "energy": "eV", "stress": "bar", "mass": "g/mol"},
    "real": {"length": "Å", "time": "fs", "velocity": "Å/fs", "force": "kcal/(mol Å)", "energy": "kcal/mol", "stress": "atm",
             "mass": "g/mol"},
    "electron": {"length": "Bohr", "time": "fs", "velocity": "Bohr/atu", "force": "Hartree/Bohr", "energy": "Hartree", "stress": "Pa",
                 "mass": "u"},
    "lj": {},
}
# terms of compute potdem/energy, in the order of its vector
LEDGER = ("kinetic", "gravity", "bonds", "contacts", "walls", "fracture", "friction", "viscous", "damping", "work of walls", "springs")
# what the outputs of the package's styles are, by their number (0: what stands without one): in words, and a key of UNITS
BONDS = "bonds of the particle"
OUTPUTS = {
    "potdem/strain/atom": {**{number: (f"strain {name}", "") for number, name in enumerate(("xx", "yy", "zz", "xy", "xz", "yz"), start=1)},
                           7: (BONDS, "")},
    "potdem/piece/atom": {0: ("piece", "")},
    "potdem/timestep": {0: ("critical step", "time")},
    "potdem/energy": {number: (name, "energy") for number, name in enumerate((
        "sum of all energies", *LEDGER[:-1], "springs of friction"))},
    "potdem/failure": {0: ("failed bonds", ""), 1: ("fracture energy", "energy"), 2: ("failed in tension", ""),
                       3: ("failed in compression", "")},
    "potdem/wall/region": {0: ("energy of the wall", "energy"),
                           **{number: (f"force on the wall, {k}", "force") for number, k in enumerate("xyz", start=1)}},
}
# of compute bond/local and pair/local
LOCAL = {"b1": ("strain of the bond", ""), "b2": ("axial stress", "stress"), "p1": ("overlap", "length"), "force": ("force", "force"),
         "dist": ("distance", "length"), "engpot": ("energy", "energy"), "eng": ("energy", "energy")}


@dataclass
class Wall:
    """a fix on a region, from a step to another"""

    region: str
    start: int
    end: float = math.inf


@dataclass
class Region:
    """words: its style and what follows; scale: length of a lattice spacing along x, y, z, if it counts in these; folder: of the log"""

    words: list
    scale: np.ndarray
    folder: Path = Path()


@dataclass
class Commands:
    """what a log says; without one, nothing. path: of the log; dt: time step"""

    path: "Path | None" = None
    units: str = "lj"
    dt: "float | None" = None
    computes: dict = field(default_factory=dict)    # ID -> words from the style on
    fixes: dict = field(default_factory=dict)
    dumps: list = field(default_factory=list)       # words of each dump and write_dump
    regions: dict = field(default_factory=dict)     # ID -> Region
    walls: dict = field(default_factory=dict)       # ID of the fix -> Wall
    old_walls: list = field(default_factory=list)   # those of fixes that were ended

    def unit(self, quantity):
        return UNITS.get(self.units, {}).get(quantity, "")

    def wrote(self, file):
        """whether the run has a dump of that name; a * or % stands for anything"""
        return self.dump_of(file) is not None

    def dump_of(self, file):
        """the words of the dump that wrote it, or None"""
        for words in self.dumps:
            written = Path(words[5] if words[0] == "dump" else words[3]).name
            pattern = re.sub(r"\\[*%]", ".*", re.escape(written))
            if re.fullmatch(pattern, Path(file).name):
                return words
        return None

    def meaning(self, column):
        """(style, what it is there) of a column c_ID, c_ID[N], f_ID or f_ID[N] of a dump or of thermo output: a keyword of the package's
        tables, or what the compute was asked for; ("", "") if that is not known"""
        match = re.fullmatch(r"([cf])_(\w+)(?:\[(\d+)\])?", column)
        every = self.computes if match and match[1] == "c" else self.fixes
        if not match or match[2] not in every:
            return "", ""
        style, *values = every[match[2]]
        number = int(match[3] or 0)
        if style in OUTPUTS:
            return style, OUTPUTS[style].get(number, ("", ""))[0]
        number = max(number - 1, 0)
        return style, values[number] if number < len(values) else ""

    def quantity(self, column):
        """a key of UNITS, or '' """
        style, meaning = self.meaning(column)
        if style in OUTPUTS:
            return dict(OUTPUTS[style].values()).get(meaning, "")
        return LOCAL.get(meaning, ("", ""))[1] if style.endswith("/local") else _quantity(column)

    def words(self, column):
        """a column as the label of a scale or an axis, without its unit"""
        style, meaning = self.meaning(column)
        if style.endswith("/local"):
            return LOCAL.get(meaning, (meaning, ""))[0]
        return meaning if style in OUTPUTS and meaning else column

    def label(self, column):
        """with its unit"""
        unit = self.unit(self.quantity(column))
        return f"{self.words(column)}, {unit}" if unit else self.words(column)

    def walls_at(self, step):
        """IDs of the regions that are walls at a step"""
        every = [*self.old_walls, *self.walls.values()]
        return sorted({wall.region for wall in every if wall.start <= step <= wall.end})


def _quantity(column):
    """of an attribute of dump custom or a keyword of thermo_style, or ''"""
    kinds = {"length": r"[xyz]u?|radius|diameter|[xyz](lo|hi)|[Ll][xyz]", "velocity": r"v[xyz]|speed", "force": r"f[xyz]",
             "time": r"Time|Dt", "energy": r"PotEng|KinEng|TotEng|E_\w+|Econserve|ecouple", "stress": r"Press|P[xyz]{2}",
             "mass": r"mass"}
    return next((kind for kind, pattern in kinds.items() if re.fullmatch(pattern, column)), "")


def of_log(path):
    """the Commands of a log file"""
    text = logs.read(path)
    found, spacing, step = Commands(Path(path)), np.ones(3), 0
    for line in text.replace("&\n", " ").splitlines():
        if match := re.match(r"Lattice spacing in x,y,z = (\S+) (\S+) (\S+)", line):
            spacing = np.array(match.groups(), dtype=float)
        elif match := re.match(r"Loop time of \S+ on \d+ procs for (\d+) steps", line):
            step += int(match[1])
        elif "$" not in line:
            _take(found, _split(line), spacing, step)
    return found


def _split(line):
    try:
        return shlex.split(line, comments=True)
    except ValueError:    # a quote in what is no command
        return []


def _take(found, words, spacing, step):
    """one command"""
    if len(words) > 1 and words[0] == "units":
        found.units = words[1]
    elif len(words) > 1 and words[0] == "timestep":
        found.dt = float(words[1])
    elif len(words) > 1 and words[0] == "unfix":
        _end_wall(found, words[1], step)
    elif len(words) > 3 and words[0] == "compute":
        found.computes[words[1]] = words[3:]
    elif len(words) > 5 and words[0] == "dump" or len(words) > 3 and words[0] == "write_dump":
        found.dumps.append(words)
    elif len(words) > 2 and words[0] == "region":
        box = words[words.index("units") + 1] == "box" if "units" in words[:-1] else False
        found.regions[words[1]] = Region(words[2:], np.ones(3) if box else spacing, found.path.parent if found.path else Path())
    elif len(words) > 3 and words[0] == "fix":
        found.fixes[words[1]] = words[3:]
        _end_wall(found, words[1], step)
        if "wall" in words[3]:
            _take_flat_walls(found, words)
            for word in words[4:]:
                if word in found.regions:
                    found.walls[words[1]] = Wall(word, step)


def _take_flat_walls(found, words):
    """walls that fix wall/gran has without a region, as a region with the ID of the fix: xplane lo hi, ..., zcylinder radius"""
    for axis, word in enumerate(("xplane", "yplane", "zplane")):
        if word in words[:-2]:
            place = words.index(word) + 1
            bounds = ["INF"] * 6
            bounds[2 * axis: 2 * axis + 2] = ["INF" if end == "NULL" else end for end in words[place:place + 2]]
            found.regions[words[1]] = Region(["block", *bounds], np.ones(3))
            words.append(words[1])
    if "zcylinder" in words[:-1]:
        radius = words[words.index("zcylinder") + 1]
        found.regions[words[1]] = Region(["cylinder", "z", "0", "0", radius, "INF", "INF"], np.ones(3))
        words.append(words[1])


def _end_wall(found, name, step):
    if name in found.walls:
        wall = found.walls.pop(name)
        wall.end = step
        found.old_walls.append(wall)


def beside(dumps):
    """the Commands of the newest log in the folder of a dump, or in the present one, whose run wrote the dump; None if there is none"""
    folders = dict.fromkeys((Path(dumps[0]).resolve().parent, Path.cwd()))
    candidates = {path for folder in folders for pattern in ("log.*", "*.log") for path in folder.glob(pattern) if path.is_file()}
    for path in sorted(candidates, key=lambda path: path.stat().st_mtime, reverse=True):
        found = of_log(path)
        if found.wrote(dumps[0]):
            return found
    return None
