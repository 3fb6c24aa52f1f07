"""Reads LAMMPS's text dumps (dump custom): a list of frames, each a dict of column name -> NumPy array, with
the time step under 'timestep'. Atoms must be sorted by ID (dump_modify sort id)."""

from pathlib import Path

import numpy as np


def read(path):
    frames = []
    with Path(path).open(encoding="utf-8") as dump:
        while dump.readline():
            step = int(dump.readline())
            dump.readline()
            count = int(dump.readline())
            for _ in range(4):
                dump.readline()
            names = dump.readline().split()[2:]
            values = np.array([dump.readline().split() for _ in range(count)], dtype=float)
            frames.append({"timestep": step, **dict(zip(names, values.T))})
    return frames
