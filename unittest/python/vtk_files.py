# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Reads VTK's XML files by their specification, without VTK: what tests of tools/potdem/paraview.py compare with."""

import base64
import struct
import xml.etree.ElementTree as xml
from pathlib import Path

import numpy as np


def _values(array):
    data = base64.b64decode(array.text)
    (size,) = struct.unpack("<Q", data[:8])
    assert len(data) == 8 + size and array.get("format") == "binary"
    values = np.frombuffer(data[8:], {"Float64": "<f8", "Int64": "<i8"}[array.get("type")])
    return values.reshape(-1, int(array.get("NumberOfComponents", 1))) if array.get("NumberOfComponents") else values


class PolyData:
    """points; cells: list of lists of points; data: name -> array, of points or cells"""

    def __init__(self, path):
        root = xml.parse(path).getroot()
        assert root.attrib == {"type": "PolyData", "version": "1.0", "byte_order": "LittleEndian", "header_type": "UInt64"}
        (self.piece,) = root.iter("Piece")
        self.points = _values(self.piece.find("Points/DataArray"))
        assert len(self.points) == int(self.piece.get("NumberOfPoints"))
        self.data = {array.get("Name"): _values(array) for kind in ("PointData", "CellData")
                     for array in (self.piece.find(kind) if self.piece.find(kind) is not None else [])}

    def cells(self, kind):
        """Verts, Lines or Polys"""
        part = self.piece.find(kind)
        if part is None:
            return []
        found = {array.get("Name"): _values(array) for array in part}
        starts = [0, *found["offsets"][:-1]]
        cells = [found["connectivity"][start:end].tolist() for start, end in zip(starts, found["offsets"])]
        assert len(cells) == int(self.piece.get(f"NumberOf{kind}"))
        return cells


def series(path):
    """[(time, {block: PolyData})] of a .pvd"""
    path = Path(path)
    frames = []
    for step in xml.parse(path).getroot().iter("DataSet"):
        blocks = xml.parse(path.parent / step.get("file")).getroot().iter("DataSet")
        frames.append((float(step.get("timestep")), {block.get("name"): PolyData(path.parent / block.get("file")) for block in blocks}))
    return frames
