# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Goes on with a run of LAMMPS that was stopped: finds its newest complete restart file, and brings the log, the dumps and the files of
fix ave/time that it left to the step of that file, so that the rest can be written behind them."""

import os
import re
import struct
from pathlib import Path

from potdem import commands, dumps, logs

MAGIC = b"LammpS RestartT\0"    # the first and the last bytes of a restart file
# marks of its header: version and units; the step; where the first mark is, and by where the step has come
STRINGS, STEP, FIRST, HEADER = (0, 4), 5, 24, 1024
ENDED = "Loop time of 0 on 1 procs for {} steps: stopped here, goes on below\n"


class Failure(Exception):
    """what ends the command"""


# --- restart files ---------------------------------------------------------------------------------------------------------------

def step_of(path):
    """of a restart file; None if it is none, or not written to its end"""
    with Path(path).open("rb") as file:
        data = file.read(HEADER)
        file.seek(-min(len(data), len(MAGIC)), os.SEEK_END)
        whole = data.startswith(MAGIC) and len(data) > FIRST and file.read() == MAGIC
    if not whole:
        return None
    place = FIRST
    while True:
        mark, value = struct.unpack_from("2i", data, place)
        if mark == STEP:
            return struct.unpack_from("q", data, place + 4)[0]
        place += 8 + (value if mark in STRINGS else 0)


def newest(paths):
    """(path, step) of the complete file with the latest step, or None"""
    found = [(step, path) for path in paths if path.is_file() and (step := step_of(path)) is not None]
    return max(found)[::-1] if found else None


def files_of_log(log):
    """what the last command `restart` of a log may have written, in the log's folder"""
    found = re.findall(r"^ *restart +(?!0\b)[^$\s]+ +([^$\n]+)$", logs.read(log), re.MULTILINE)
    names = found[-1].split("#")[0].split() if found else []
    if len(names) == 1:
        names = [names[0] if "*" in names[0] else f"{names[0]}.*"]
    return [path for name in names for path in sorted(Path(log).parent.glob(name) if not name.startswith("/") else
                                                      Path(name).parent.glob(Path(name).name))]


# --- what the run left -----------------------------------------------------------------------------------------------------------

def rows(lines):
    """(number of the line, step) of each row of thermo output"""
    inside = False
    for number, line in enumerate(lines):
        words = line.split()
        if words[:1] == ["Step"]:
            inside = True
        elif line.startswith("Loop time of"):
            inside = False
        elif inside and words and words[0].isdigit() and line.endswith("\n"):
            yield number, int(words[0])


def cut_log(text, step):
    """the log without what came after a step, its last run ended there"""
    lines = text.splitlines(keepends=True)
    later = [number for number, of_row in rows(lines) if of_row > step]
    lines = lines[:later[0]] if later else [line for line in lines if line.endswith("\n")]
    headers = [number for number, line in enumerate(lines) if line.split()[:1] == ["Step"]]
    if headers and not any(line.startswith("Loop time of") for line in lines[headers[-1]:]):
        first = [of_row for number, of_row in rows(lines) if number > headers[-1]]
        lines.append(ENDED.format(step - first[0] if first else 0))
    return "".join(lines)


def joined(before, after):
    """the log of a run that went on. The rest begins with a row of the step of the restart file, which a run that was not stopped has on
    steps of `thermo` only"""
    lines = after.splitlines(keepends=True)
    first = next(rows(lines), None)
    if first:
        number, step = first
        every = re.findall(r"^ *thermo +(\d+)\s*$", before, re.MULTILINE)
        seen = step in (of_row for _, of_row in rows(before.splitlines(keepends=True)))
        if seen or not every or step % int(every[-1]):
            del lines[number]
    return before + "".join(lines)


def cut_dump(path, step):
    """leaves the frames up to a step"""
    try:
        ends = [place.end for place in dumps.Dump(path).places if place.step <= step]
    except dumps.DumpError:    # of another form, or without a complete frame
        return
    with path.open("r+b") as file:
        file.truncate(max(ends, default=0))


def cut_table(path, step):
    """leaves the lines of fix ave/time up to a step"""
    lines = [line for line in logs.read(path).splitlines(keepends=True) if line.endswith("\n")]
    path.write_text("".join(line for line in lines if line.startswith("#") or int(line.split()[0]) <= step), encoding="utf-8")


def cut_files(log, folder, step):
    """the text files that the commands of a log name, in the folder in which LAMMPS ran"""
    script = commands.of_log(log)
    for words in script.dumps:
        if words[0] == "dump" and words[3] in ("custom", "atom", "local") and not re.search(r"[*%]|\.(bin|gz|zst)$", words[5]):
            if (folder / words[5]).is_file():
                cut_dump(folder / words[5], step)
    for style, *words in script.fixes.values():
        names = [name for word, name in zip(words, words[1:]) if word in ("file", "append")]
        if style == "ave/time" and "vector" not in words and names and (folder / names[0]).is_file():
            cut_table(folder / names[0], step)


class Stopped:
    """what a run that was stopped left: log, in the folder in which LAMMPS ran if no other is given"""

    def __init__(self, log, folder=None):
        self.log, self.folder = Path(log), Path(folder or Path(log).parent)
        # of several stops: the log up to the last restart file that was gone on from. Not named as the logs are that others look for
        self.before = self.log.with_name(f"before.{self.log.name.removeprefix('log.')}")

    def forget(self):
        self.before.unlink(missing_ok=True)

    def cut(self, step):
        """before LAMMPS goes on from there"""
        if not self.log.exists():
            return
        cut_files(self.log, self.folder, step)
        earlier, text = self.read(), logs.read(self.log)
        if earlier and not any(rows(text.splitlines(keepends=True))):
            return    # it did not get as far as its first step
        # where it went on from the same file again, nothing was added
        self.before.write_text(cut_log(joined(earlier, text) if earlier else text, step), encoding="utf-8")

    def read(self):
        return logs.read(self.before) if self.before.exists() else ""

    def join(self):
        """when LAMMPS has ended"""
        if self.before.exists():
            self.log.write_text(joined(self.read(), logs.read(self.log)), encoding="utf-8")
            self.forget()
