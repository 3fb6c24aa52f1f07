# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Writes the frames of a run as VTK's XML files, for ParaView and OVITO: particles, bonds and contacts (lines) and walls (polygons) of a
frame are blocks of one .vtm, and a .pvd gives the times of all. Every column of the dump becomes an array: of the points, or, of bonds
and contacts, of the lines. OVITO wants no appended or compressed arrays, `id` and `radius` of particles, lines that share no points,
`id1` and `id2` of lines."""

import base64
from pathlib import Path
from xml.sax.saxutils import quoteattr

import numpy as np

PLACE = ("x", "y", "z")
VECTORS = ("v", "f", "omega", "tq", "angmom")
WHOLE = ("id", "type", "mol", "proc", "id1", "id2")
KINDS = {"f": "Float64", "i": "Int64"}
HEAD = '<?xml version="1.0"?>\n<VTKFile type="{}" version="1.0" byte_order="LittleEndian" header_type="UInt64">\n'


def _array(name, values):
    values = np.ascontiguousarray(values)
    values = values.astype("<i8" if values.dtype.kind in "iu" else "<f8")
    components = f' NumberOfComponents="{values.shape[1]}"' if values.ndim > 1 else ""
    data = base64.b64encode(np.uint64(values.nbytes).tobytes() + values.tobytes()).decode("ascii")
    return f'<DataArray type="{KINDS[values.dtype.kind]}" Name={quoteattr(name)}{components} format="binary">{data}</DataArray>\n'


def _cells(kind, count, corners):
    """each with points of its own, in order"""
    return (f"<{kind}>\n" + _array("connectivity", np.arange(count * corners)) +
            _array("offsets", np.arange(corners, (count + 1) * corners, corners)[:count]) + f"</{kind}>\n")


def _data(kind, columns):
    return f"<{kind}>\n" + "".join(_array(name, values) for name, values in columns.items()) + f"</{kind}>\n"


def _poly_data(points, cells, corners, columns, of="CellData"):
    """cells: Verts, Lines or Polys"""
    count = len(points) // corners
    counts = " ".join(f'NumberOf{kind}="{count if kind == cells else 0}"' for kind in ("Verts", "Lines", "Strips", "Polys"))
    return (HEAD.format("PolyData") + f'<PolyData>\n<Piece NumberOfPoints="{len(points)}" {counts}>\n' + _data(of, columns) +
            "<Points>\n" + _array("points", points) + "</Points>\n" + _cells(cells, count, corners) +
            "</Piece>\n</PolyData>\n</VTKFile>\n")


def _columns(table):
    """arrays of a table of columns: x y z of a vector together; words and what the whole frame has, such as its time, are left out"""
    left = {name: np.asarray(column) for name, column in table.items()
            if name not in PLACE and np.ndim(column) and np.asarray(column).dtype.kind in "fi"}
    for name in VECTORS:
        parts = [f"{name}{k}" for k in PLACE]
        if all(part in left for part in parts):
            left[name] = np.column_stack([left.pop(part) for part in parts])
    return {name: column.astype(int) if name in WHOLE else column for name, column in left.items()}


def particles(frame):
    """the text of a file with the particles of a frame"""
    return _poly_data(np.column_stack([frame[k] for k in PLACE]), "Verts", 1, _columns(frame), "PointData")


def lines(ends, table):
    """of a file with lines between points, shape (n, 2, 3), and columns that have a value for each"""
    return _poly_data(ends.reshape(-1, 3), "Lines", 2, _columns(table))


def walls(corners):
    """of a file with four-sided polygons, shape (n, 4, 3)"""
    return _poly_data(corners.reshape(-1, 3), "Polys", 4, {})


class Series:
    """the files of all frames in a folder; its path is that of the .pvd"""

    def __init__(self, folder, name):
        self.folder, self.name, self.files = Path(folder), name, []
        self.folder.mkdir(parents=True, exist_ok=True)
        self.path = self.folder / f"{name}.pvd"

    def add(self, time, blocks):
        """{name of a block: the text of its file} of the next frame"""
        number = f"{self.name}.{len(self.files):04d}"
        rows = []
        for index, (block, text) in enumerate(blocks.items()):
            file = self.folder / f"{number}.{block}.vtp"
            file.write_text(text, encoding="ascii")
            rows.append(f'<DataSet index="{index}" name="{block}" file="{file.name}"/>\n')
        file = self.folder / f"{number}.vtm"
        file.write_text(HEAD.format("vtkMultiBlockDataSet") + "<vtkMultiBlockDataSet>\n" + "".join(rows) +
                        "</vtkMultiBlockDataSet>\n</VTKFile>\n", encoding="ascii")
        self.files.append(f'<DataSet timestep="{time:.9g}" file="{file.name}"/>\n')

    def end(self):
        self.path.write_text(HEAD.format("Collection") + "<Collection>\n" + "".join(self.files) + "</Collection>\n</VTKFile>\n",
                             encoding="ascii")
        return self.path


def write(frames, folder, name):
    """the particles of frames that have a time; the path of the series"""
    series = Series(folder, name)
    for frame in frames:
        series.add(frame["time"], {"particles": particles(frame)})
    return series.end()
