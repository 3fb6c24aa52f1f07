# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Triangles and STL files: simple bodies for tests and recipes. Triangles are arrays of shape (n, 3, 3): triangle, corner, x y z; seen from
outside their corners go anticlockwise."""

from pathlib import Path

import numpy as np

RECORD = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("more", "<u2")])    # of a binary file


def rectangle(corner, a, b, cells=1):
    """spanned by a and b from a corner, in cells x cells squares of two triangles each; its normal points along a x b"""
    corner, a, b = (np.asarray(v, dtype=float) for v in (corner, a, b))
    s = np.linspace(0.0, 1.0, cells + 1)
    grid = corner + s[:, None, None] * a + s[None, :, None] * b
    p, q, r, t = grid[:-1, :-1], grid[1:, :-1], grid[1:, 1:], grid[:-1, 1:]
    return np.concatenate([np.stack([p, q, r], axis=2).reshape(-1, 3, 3), np.stack([p, r, t], axis=2).reshape(-1, 3, 3)])


def box(lo, hi, cells=1):
    """a closed block"""
    lo, hi = np.asarray(lo, dtype=float), np.asarray(hi, dtype=float)
    x, y, z = np.diag(hi - lo)
    return np.concatenate([
        rectangle(lo, y, x, cells), rectangle(lo + z, x, y, cells), rectangle(lo, z, y, cells),
        rectangle(lo + x, y, z, cells), rectangle(lo, x, z, cells), rectangle(lo + y, z, x, cells)])


def sphere(centre, radius, cells):
    """a closed sphere: a block's surface, its points moved out"""
    points = box([-1, -1, -1], [1, 1, 1], cells)
    points = np.tan(0.25 * np.pi * points)    # triangles of about the same size
    return np.asarray(centre) + radius * points / np.linalg.norm(points, axis=2, keepdims=True)


def is_closed(triangles):
    """does each edge join two triangles that run through it in opposite directions?"""
    points, numbers = np.unique(np.reshape(triangles, (-1, 3)), axis=0, return_inverse=True)
    of = np.reshape(numbers, (-1, 3)).astype(np.int64)
    forward = (of * len(points) + np.roll(of, -1, axis=1)).ravel()
    backward = (np.roll(of, -1, axis=1) * len(points) + of).ravel()
    return len(np.unique(forward)) == len(forward) and np.array_equal(np.sort(forward), np.sort(backward))


def read(path):
    """triangles of an STL file, as region potdem/mesh takes them; ValueError if it is none"""
    content = Path(path).read_bytes()
    count = int.from_bytes(content[80:84], "little")
    if len(content) >= 84 and len(content) == 84 + RECORD.itemsize * count:
        return np.frombuffer(content, RECORD, offset=84)["corners"].astype(float)
    numbers = [float(word) for line in content.decode("ascii", "replace").splitlines() if line.split()[:1] == ["vertex"]
               for word in line.split()[1:]]
    if not numbers or len(numbers) % 9:
        raise ValueError(f"{path} is no STL file")
    return np.reshape(numbers, (-1, 3, 3))


def write(path, triangles, binary=False):
    """an STL file; text keeps all digits, binary single precision"""
    triangles = np.asarray(triangles, dtype=float)
    if binary:
        records = np.zeros(len(triangles), dtype=RECORD)
        records["corners"] = triangles
        Path(path).write_bytes(b"POTDEM".ljust(80) + np.uint32(len(triangles)).tobytes() + records.tobytes())
        return
    lines = ["solid potdem"]
    for corners in triangles:
        lines += ["facet normal 0 0 0", "outer loop", *(f"vertex {x!r} {y!r} {z!r}" for x, y, z in corners.tolist()), "endloop",
                  "endfacet"]
    Path(path).write_text("\n".join([*lines, "endsolid potdem", ""]), encoding="utf-8")
