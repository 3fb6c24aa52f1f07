"""Reads LAMMPS's text dumps (dump custom): a list of frames, each a dict of column name -> NumPy array, with
the time step under 'timestep'. Atoms must be sorted by ID (dump_modify sort id)."""

from pathlib import Path

import numpy as np

import logfile


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


def read_run(folder, name):
    """frames of the dump of that name in a run's folder, with the 'time' of each by the run's log"""
    folder = Path(folder)
    table = logfile.read_thermo(next(folder.glob("log.*")))
    frames = read(folder / name)
    for frame in frames:
        frame["time"] = float(np.interp(frame["timestep"], table["Step"], table["Time"]))
    return frames


def at(frames, instant):
    """the frame nearest to an instant"""
    return min(frames, key=lambda frame: abs(frame["time"] - instant))
