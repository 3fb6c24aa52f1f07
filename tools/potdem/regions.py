# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""LAMMPS's regions as surfaces to draw: small four-sided tiles, each with the normal to the side on which the particles are. A tile of an
intersection or union is left out where another member hides it."""

from dataclasses import dataclass

import numpy as np

from potdem import stl

TILES, ROUND = 24, 96    # of a flat face along its longer side, of a circle
AXES = {"x": 0, "y": 1, "z": 2}


class NotDrawn(Exception):
    """a region that this cannot draw"""


@dataclass
class Room:
    """what is seen of regions without end: two corners"""

    low: np.ndarray
    high: np.ndarray

    @property
    def tile(self):
        return np.max(self.high - self.low) / TILES

    def holds(self, points):
        margin = 1e-9 * np.max(self.high - self.low)
        return np.all((points >= self.low - margin) & (points <= self.high + margin), axis=1)


def surface(name, regions, room, shift=(0.0, 0.0, 0.0)):
    """(tiles, normals), shapes (n, 4, 3) and (n, 3), of the region of that ID; shift: how far it has moved"""
    if regions[name].words[0] == "potdem/mesh":
        return _of_mesh(regions[name], np.asarray(shift))
    tiles = np.concatenate([np.zeros((0, 4, 3)), *_tiles(name, regions, room, np.asarray(shift))])
    tiles = tiles[room.holds(tiles.mean(axis=1))]
    normals = np.cross(tiles[:, 2] - tiles[:, 0], tiles[:, 3] - tiles[:, 1])
    normals /= np.maximum(np.linalg.norm(normals, axis=1), 1e-300)[:, None]
    step = 0.1 * room.tile    # more than the sag of a round tile
    ahead, behind = (_inside(name, regions, tiles.mean(axis=1) + sign * step * normals - shift) for sign in (1, -1))
    normals[behind & ~ahead] *= -1
    keep = ahead != behind
    return tiles[keep], normals[keep]


def _parts(name, regions):
    """style, numbers (INF and EDGE: infinite), members and whether the particles are outside"""
    region = regions[name]
    style, *words = region.words
    outside = "side" in words[:-1] and words[words.index("side") + 1] == "out"
    if style in ("union", "intersect"):
        return style, None, words[1:1 + int(words[0])], outside
    counts = {"block": 6, "plane": 6, "sphere": 4, "cylinder": 6, "cone": 7}
    if style not in counts:
        raise NotDrawn(f"region {name}, of style {style}")
    words = words[:counts[style]]
    try:
        numbers = [_length(word, position) for position, word in enumerate(words) if word not in AXES]
    except ValueError:
        raise NotDrawn(f"region {name}, whose size is a variable") from None
    return style, _scaled(style, words, np.array(numbers), region.scale), [], outside


def _length(word, position):
    if word in ("INF", "EDGE"):
        return np.inf if position % 2 else -np.inf
    return float(word)


def _scaled(style, words, numbers, scale):
    """lengths in the units of the script; of a cylinder or cone its axis comes first"""
    if style == "block":
        return numbers * np.repeat(scale, 2)
    if style == "plane":
        return numbers * np.append(scale, np.ones(3))
    if style == "sphere":
        return numbers * np.append(scale, scale[0])
    axis = AXES[words[0]]
    across = [k for k in range(3) if k != axis]
    radii = np.full(numbers.size - 4, scale[across[0]])
    low, high = numbers[-2:] * scale[axis]
    # the position of INF among the words differs from that in a block
    return np.array([axis, *numbers[:2] * scale[across], *numbers[2:-2] * radii, -abs(low) if np.isinf(low) else low,
                     abs(high) if np.isinf(high) else high])


def _inside(name, regions, points):
    """where particles may be"""
    style, numbers, members, outside = _parts(name, regions)
    if members:
        each = [_inside(member, regions, points) for member in members]
        found = np.all(each, axis=0) if style == "intersect" else np.any(each, axis=0)
    elif style == "block":
        found = np.all((points >= numbers[::2]) & (points <= numbers[1::2]), axis=1)
    elif style == "plane":
        found = (points - numbers[:3]) @ numbers[3:] >= 0
    elif style == "sphere":
        found = np.linalg.norm(points - numbers[:3], axis=1) <= numbers[3]
    else:
        axis, across, radius = _round(numbers)
        along = points[:, axis]
        found = np.linalg.norm(points[:, across] - numbers[1:3], axis=1) <= radius(along)
        found &= (along >= numbers[-2]) & (along <= numbers[-1])
    return found != outside


def _round(numbers):
    """axis, the two others, and the radius along it of a cylinder or cone"""
    axis = int(numbers[0])
    across = [k for k in range(3) if k != axis]
    first, last, low, high = numbers[3], numbers[-3], *numbers[-2:]
    if first == last:
        return axis, across, lambda along: np.full_like(along, first)
    return axis, across, lambda along: first + (last - first) * (np.clip(along, low, high) - low) / (high - low)


def _tiles(name, regions, room, shift):
    """arrays of tiles of its faces"""
    style, numbers, members, _ = _parts(name, regions)
    if members:
        for member in members:
            yield from _tiles(member, regions, room, shift)
    elif style == "block":
        yield from _of_block(numbers, room, shift)
    elif style == "plane":
        yield _of_plane(numbers[:3] + shift, numbers[3:], room)
    elif style == "sphere":
        polar, turn = np.linspace(0, np.pi, ROUND // 2 + 1), np.linspace(0, 2 * np.pi, ROUND + 1)
        direction = np.stack([np.outer(np.sin(polar), np.cos(turn)), np.outer(np.sin(polar), np.sin(turn)),
                              np.outer(np.cos(polar), np.ones_like(turn))], axis=-1)
        yield _between(numbers[:3] + shift + numbers[3] * direction)
    else:
        yield from _of_cylinder(numbers, room, shift)


def _of_mesh(region, shift):
    """all its triangles, as tiles whose last corner is double; a sheet, which has no inside, from both sides"""
    file, *words = region.words[1:]
    try:
        corners = stl.read(region.folder / file)
    except (OSError, ValueError) as problem:
        raise NotDrawn(f"region of triangles from {file} ({problem})") from None
    scale = float(words[words.index("scale") + 1]) if words[:1] == ["scale"] else 1.0
    corners = scale * region.scale * corners + shift
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    volume = np.einsum("ij,ij->", corners[:, 0] - corners[0, 0], normals) / 6
    size = np.linalg.norm(normals, axis=1)
    corners, normals = corners[size > 0], normals[size > 0] / size[size > 0, None]
    tiles = corners[:, [0, 1, 2, 2]]
    if not stl.is_closed(corners):
        return np.concatenate([tiles, tiles]), np.concatenate([normals, -normals])
    outside = "side" in words[:-1] and words[words.index("side") + 1] == "out"
    return tiles, normals if outside == (volume > 0) else -normals


def _between(grid):
    """tiles between the points of a grid, shape (n, m, 3)"""
    return np.stack([grid[:-1, :-1], grid[1:, :-1], grid[1:, 1:], grid[:-1, 1:]], axis=2).reshape(-1, 4, 3)


def _steps(low, high, tile):
    return np.linspace(low, high, max(2, int(np.ceil((high - low) / tile)) + 1))


def _face(axis, place, low, high, tile):
    """of a face across an axis; low and high: its corners"""
    one, two = (k for k in range(3) if k != axis)
    if high[one] <= low[one] or high[two] <= low[two]:
        return np.zeros((0, 4, 3))
    grid = np.empty((*(_steps(low[k], high[k], tile).size for k in (one, two)), 3))
    grid[..., axis] = place
    grid[..., one], grid[..., two] = np.meshgrid(_steps(low[one], high[one], tile), _steps(low[two], high[two], tile), indexing="ij")
    return _between(grid)


def _of_block(numbers, room, shift):
    low, high = numbers[::2] + shift, numbers[1::2] + shift
    seen = np.maximum(low, room.low), np.minimum(high, room.high)
    for axis in range(3):
        for place in (low[axis], high[axis]):
            if np.isfinite(place):
                yield _face(axis, place, *seen, room.tile)


def _of_plane(point, normal, room):
    if np.count_nonzero(normal) == 1:
        axis = int(np.flatnonzero(normal)[0])
        return _face(axis, point[axis], room.low, room.high, room.tile)
    normal = normal / np.linalg.norm(normal)
    centre = 0.5 * (room.low + room.high)
    centre = centre - np.dot(centre - point, normal) * normal
    one = np.cross(normal, np.eye(3)[np.argmin(abs(normal))])
    one /= np.linalg.norm(one)
    reach = 0.5 * np.linalg.norm(room.high - room.low)
    steps = np.linspace(-reach, reach, 4 * TILES + 1)
    across, along = np.meshgrid(steps, steps, indexing="ij")
    return _between(centre + across[..., None] * one + along[..., None] * np.cross(normal, one))


def _of_cylinder(numbers, room, shift):
    """and of a cone: around, and the ends that are there"""
    axis, across, radius = _round(numbers)
    low, high = numbers[-2:]
    along = _steps(max(low, room.low[axis] - shift[axis]), min(high, room.high[axis] - shift[axis]), room.tile)
    turn = np.linspace(0, 2 * np.pi, ROUND + 1)
    parts = [(along, radius(along))]
    for end in (low, high):
        if np.isfinite(end):
            parts.append((np.full(9, end), np.linspace(0, 1, 9) * radius(np.array([end]))))
    for places, radii in parts:
        grid = np.empty((places.size, turn.size, 3))
        grid[..., axis] = places[:, None]
        grid[..., across[0]] = numbers[1] + np.outer(radii, np.cos(turn))
        grid[..., across[1]] = numbers[2] + np.outer(radii, np.sin(turn))
        yield _between(grid + shift)
