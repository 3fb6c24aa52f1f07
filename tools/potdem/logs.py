# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""LAMMPS's log files: the thermo output of all runs joined to one table, warnings, error messages, what a script printed.

Thermo output is read by LAMMPS's own lammps.formats.LogFile. It leaves out rows with nan or inf and a run that was not
ended; both are put into a form that it takes."""

import functools
import importlib.util
import re
import tempfile
from pathlib import Path

import numpy as np

from potdem.paths import BUILD, SOURCES, TOOLS

NAN, INFINITE = "-9.87654321e-300", "1e999"    # stand for what LogFile takes for text


class LogError(Exception):
    """a log file that cannot be read"""


@functools.cache
def lammps_tree():
    """folder of the LAMMPS that the build was made from"""
    cache = BUILD / "CMakeCache.txt"
    if not cache.exists():
        raise LogError(f"logs are read by LAMMPS's own reader, and {cache}, which says where LAMMPS is, has not been made yet (examples/run makes it)")
    return Path(re.search(r"^POTDEM_LAMMPS_DIR:\w+=(.+)$", cache.read_text(encoding="utf-8"), re.MULTILINE).group(1))


@functools.cache
def _formats():
    """LAMMPS's module lammps.formats alone: the whole package would want the rest of LAMMPS's Python in the path"""
    folder = lammps_tree() / "python" if SOURCES else TOOLS
    path = folder / "lammps" / "formats.py"
    spec = importlib.util.spec_from_file_location("lammps_formats", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def _prepared(text):
    """the text as LogFile can read it: no row with words that are numbers, and every run ended"""
    text = re.sub(r"(?<=\s)[+-]?nan(?=\s)", NAN, text)
    text = re.sub(r"(?<=\s)(-?)inf(?=\s)", rf"\g<1>{INFINITE}", text)
    starts = [match.start() for match in re.finditer(r"^ *Step ", text, re.MULTILINE)]
    if starts and "\nLoop time of" not in text[starts[-1]:]:
        # what a killed run wrote of its last line is no row, nor what MPI says after an error
        text = re.split(r"^ERROR", text, maxsplit=1, flags=re.MULTILINE)[0]
        text = text[: text.rfind("\n") + 1] + "Loop time of a run that was not ended\n"
    return text


def _runs(text):
    """a dict of column -> list of values for each run"""
    if not re.search(r"^ *Step |^keywords:", text, re.MULTILINE):
        return []
    with tempfile.NamedTemporaryFile("w", encoding="ascii", errors="replace", suffix=".log") as file:
        file.write(_prepared(text))
        file.flush()
        return _formats().LogFile(file.name).runs


def thermo(text, last=False):
    """column -> array over all rows of all runs; the step two runs share is kept once. last: of those runs that have the columns of the
    last, where they differ"""
    columns, tables = None, []
    runs = _runs(text)
    for run in runs:
        if last and list(run) != list(runs[-1]):
            continue
        if columns is None:
            columns = list(run)
        elif columns != list(run):
            raise LogError(f"the runs of one log differ in their columns: {columns} and {list(run)}")
        if len({len(values) for values in run.values()}) != 1:
            raise LogError(f"rows of thermo output that are shorter than its header: {columns}")
        tables.append(np.array(list(run.values()), dtype=float))
    if columns is None:
        raise LogError("no thermo output")
    table = np.concatenate(tables, axis=1)
    table[table == float(NAN)] = np.nan
    step = table[0]
    table = table[:, np.append(True, step[1:] != step[:-1])[: step.size]]
    return dict(zip(columns, table))


def read(path):
    """text of a log; bytes that are no UTF-8 are replaced"""
    return Path(path).read_text(encoding="utf-8", errors="replace")


def read_thermo(path, last=False):
    """as thermo(), of a file"""
    try:
        return thermo(read(path), last)
    except LogError as problem:
        raise LogError(f"{path}: {problem}") from None


def version(text):
    """'4Feb2025' from 'LAMMPS (4 Feb 2025 - Update 1)'"""
    match = re.search(r"^LAMMPS \((\d+ \w+ \d+)", text, re.MULTILINE)
    if not match:
        raise LogError("no LAMMPS version")
    return match.group(1).replace(" ", "")


def wall_seconds(text):
    """the run time that the log's last line gives, or None"""
    match = re.search(r"^Total wall time: (\d+):(\d+):(\d+)", text, re.MULTILINE)
    return sum(int(part) * unit for part, unit in zip(match.groups(), (3600, 60, 1))) if match else None


def parameters(text):
    """name -> text, of the line "PARAMETERS name=value ..." that a script prints"""
    match = re.search(r"^PARAMETERS (.*)$", text, re.MULTILINE)
    if not match:
        raise LogError("no line PARAMETERS")
    return dict(word.split("=") for word in match.group(1).split())


def error_message(text):
    """the text of the first ERROR, its lines joined, without the place in LAMMPS's source; or None"""
    match = re.search(r"^ERROR[^:\n]*: (.*?)(?:\s\(\S*:\d+\)|\nLast (?:input|command)|\Z)", text,
                      re.MULTILINE | re.DOTALL)
    return " ".join(match.group(1).split()) if match else None
