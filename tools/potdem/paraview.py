# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Writes the frames of a run for ParaView: a legacy VTK file each, and a .vtk.series that gives their times. Every column of
the dump becomes a value of the points; show them as point gaussians or spheres of size `radius`."""

import json

import numpy as np

PLACE = ("x", "y", "z")


def _text(frame):
    points = np.column_stack([frame["x"], frame["y"], frame["z"]])
    count = len(points)
    cells = np.column_stack([np.ones(count, dtype=int), np.arange(count)])
    # what the whole frame has, such as its time, is no value of a particle
    values = {name: column for name, column in frame.items() if name not in PLACE and np.ndim(column)}
    parts = ["# vtk DataFile Version 3.0", f"time {frame['time']:g}", "ASCII", "DATASET POLYDATA", f"POINTS {count} double",
             _rows(points), f"VERTICES {count} {2 * count}", _rows(cells), f"POINT_DATA {count}"]
    for name, column in values.items():
        parts += [f"SCALARS {name} double 1", "LOOKUP_TABLE default", _rows(column[:, None])]
    return "\n".join(parts) + "\n"


def _rows(array):
    return "\n".join(" ".join(f"{value:.9g}" for value in row) for row in array)


def write(frames, folder, name):
    """the path of the series"""
    folder.mkdir(exist_ok=True)
    files = []
    for number, frame in enumerate(frames):
        file = folder / f"{name}.{number:04d}.vtk"
        file.write_text(_text(frame), encoding="utf-8")
        files.append({"name": file.name, "time": frame["time"]})
    series = folder / f"{name}.vtk.series"
    series.write_text(json.dumps({"file-series-version": "1.0", "files": files}, indent=1), encoding="utf-8")
    return series
