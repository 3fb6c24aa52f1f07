# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Reads LAMMPS's text dumps, of atoms (dump custom) and of other entries (dump local)."""

from pathlib import Path

import numpy as np

from potdem import logs


class Frame(dict):
    """one snapshot: column name -> array, one value for each row in the dump's own order; step: its time step"""

    def __init__(self, step, columns):
        super().__init__(columns)
        self.step = step


def read(path):
    """the frames of a dump"""
    frames = []
    with Path(path).open(encoding="utf-8") as dump:
        for line in dump:
            if line.startswith("ITEM: TIMESTEP"):
                step = int(next(dump))
            elif line.startswith("ITEM: NUMBER OF"):
                count = int(next(dump))
            elif line.startswith(("ITEM: ATOMS", "ITEM: ENTRIES")):
                names = line.split()[2:]
                values = np.array([next(dump).split() for _ in range(count)], dtype=float).reshape(count, len(names))
                frames.append(Frame(step, zip(names, values.T)))
    return frames


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
