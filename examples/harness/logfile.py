"""Reads LAMMPS log files: the thermo output of all runs joined to one table, and error messages."""

import re

import numpy as np


class LogError(Exception):
    """a log file that cannot be read"""


def _numbers(words):
    try:
        return [float(word) for word in words]
    except ValueError:
        return None


def _blocks(lines):
    """(columns, rows) of each run, from thermo_style custom (one) or thermo_modify line yaml"""
    columns = None
    for line in lines:
        words = line.split()
        if line.startswith("keywords: ["):
            columns = re.findall(r"'([^']*)'", line)
            yield columns, []
        elif words[:1] == ["Step"]:
            columns = words
            yield columns, []
        elif line.startswith(("Loop time of", "...")):
            columns = None
        elif columns:
            numbers = _numbers(line.replace("- [", " ").replace("]", " ").replace(",", " ").split())
            # warnings may stand between the rows
            if numbers and len(numbers) == len(columns):
                yield None, numbers


def thermo(text):
    """column -> array over all rows of all runs; the step two runs share is kept once"""
    columns, rows = None, []
    for header, row in _blocks(text.splitlines()):
        if header is None:
            if not rows or row[0] != rows[-1][0]:
                rows.append(row)
        elif columns is None:
            columns = header
        elif columns != header:
            raise LogError(f"the runs of one log differ in their columns: {columns} and {header}")
    if columns is None:
        raise LogError("no thermo output")
    table = np.array(rows).reshape(len(rows), len(columns))
    return {name: table[:, i] for i, name in enumerate(columns)}


def read_thermo(path):
    try:
        with open(path, encoding="utf-8", errors="replace") as file:
            return thermo(file.read())
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
