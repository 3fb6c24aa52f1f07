# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Input for CalculiX: the struck cantilever of beam-impulse in quadratic elements, and the deflection that it prints."""

import itertools
import re

import numpy as np

from potdem import struck_beam

SQUARE = [(0, 0), (2, 0), (2, 2), (0, 2)]
SIDES = [(1, 0), (2, 1), (1, 2), (0, 1)]
# offsets of an element's nodes in half elements, in the order of CPS8 and C3D20R
NODES = {2: SQUARE + SIDES,
         3: [(*corner, z) for z in (0, 2) for corner in SQUARE] + [(*side, z) for z in (0, 2) for side in SIDES]
         + [(*corner, 1) for corner in SQUARE]}
# consistent shares of a uniform traction on the end face of an element: corners, middles of the edges
SHARES = {2: (1 / 6, 2 / 3), 3: (-1 / 12, 1 / 3)}


def halves(points):
    """the points and those midway between them"""
    points = np.asarray(points)
    return np.sort(np.append(points, (points[1:] + points[:-1]) / 2))


class Mesh:
    """a bar of elements along x, deep along y and (3D) wide along z; the last column of elements is the half layer
    behind the load"""

    def __init__(self, length, loaded, cells):
        self.cells = cells
        sizes = (struck_beam.DEPTH, struck_beam.WIDTH)
        grid = [halves(np.append(np.linspace(0, loaded, cells[0]), length))]
        grid += [halves(np.linspace(0, size, count + 1)) for size, count in zip(sizes, cells[1:])]
        # a quadratic element has nodes at its corners and in the middle of its edges
        places = [place for place in itertools.product(*(range(len(axis)) for axis in grid))
                  if sum(k % 2 for k in place) <= 1]
        self.numbers = {place: number for number, place in enumerate(places, start=1)}
        self.points = [[axis[k] for axis, k in zip(grid, place)] for place in places]

    @property
    def dimension(self):
        return len(self.cells)

    def elements(self):
        for cell in itertools.product(*(range(count) for count in self.cells)):
            yield [self.numbers[tuple(2 * c + k for c, k in zip(cell, offset))] for offset in NODES[self.dimension]]

    def clamp(self):
        return [number for place, number in self.numbers.items() if place[0] == 0]

    def shares(self):
        """node -> its share of the load"""
        plane, faces = 2 * (self.cells[0] - 1), np.prod(self.cells[1:])
        shares = dict.fromkeys((number for place, number in self.numbers.items() if place[0] == plane), 0.0)
        for cell in itertools.product(*(range(count) for count in self.cells[1:])):
            for offset in itertools.product(range(3), repeat=self.dimension - 1):
                number = self.numbers.get((plane, *(2 * c + k for c, k in zip(cell, offset))))
                if number:
                    shares[number] += SHARES[self.dimension][sum(k % 2 for k in offset)] / faces
        return shares

    def text(self):
        kind = {2: "CPS8", 3: "C3D20R"}[self.dimension]
        lines = ["*NODE"]
        lines += [", ".join([str(n), *(f"{x:.9g}" for x in point)]) for n, point in enumerate(self.points, start=1)]
        lines.append(f"*ELEMENT, TYPE={kind}, ELSET=BEAM")
        for n, nodes in enumerate(self.elements(), start=1):
            words = [str(word) for word in (n, *nodes)]
            lines += [", ".join(words[:11]) + ("," if len(words) > 11 else ""), ", ".join(words[11:])]
        lines += ["*NSET, NSET=CLAMP", *(f"{n}," for n in self.clamp())]
        lines += ["*NSET, NSET=LOADED", *(f"{n}," for n in self.shares())]
        return "\n".join(line for line in lines if line) + "\n"


def amplitude(pulse, increment):
    """corners of the pulse; a jump is spread over one time step, so that the impulse is exact"""
    corners, value, slope, last = {}, 0.0, 0.0, 0.0
    for time, step, change in struck_beam.PULSES[pulse]:
        value += slope * (time - last)
        spread = increment / 2 if step and time > 0 else 0.0
        corners[time - spread] = value
        value, slope, last = value + step, slope + change, time
        corners[time + spread] = value
    return ", ".join(f"{number:.9g}" for corner in corners.items() for number in corner)


def deck(mesh, mesh_file, pulse, finite, increment, time=struck_beam.TIME, every=2):
    """input of a run. increment, time: s; every: increments between two outputs"""
    section = f"\n{struck_beam.WIDTH:g}" if mesh.dimension == 2 else ""
    load = "\n".join(f"{n}, 2, {struck_beam.FORCE * share:.12g}" for n, share in mesh.shares().items())
    return f"""*INCLUDE, INPUT={mesh_file}
*MATERIAL, NAME=SOLID
*ELASTIC
{struck_beam.MODULUS:g}, {struck_beam.POISSON:g}
*DENSITY
{struck_beam.DENSITY:g}
*SOLID SECTION, ELSET=BEAM, MATERIAL=SOLID{section}
*BOUNDARY
CLAMP, 1, 3
*AMPLITUDE, NAME=PULSE
{amplitude(pulse, increment)}
*STEP, INC=100000{", NLGEOM" if finite else ""}
*DYNAMIC, DIRECT, ALPHA=0
{increment:g}, {time:g}
*CLOAD, AMPLITUDE=PULSE
{load}
*NODE PRINT, NSET=LOADED, FREQUENCY={every}
U
*END STEP
"""


def history(text, shares):
    """rows of time and mean deflection, each node weighted with its share of the load"""
    rows = [[0.0, 0.0]]
    for line in text.splitlines():
        start = re.search(r"^ displacements .* time +(\S+)", line)
        if start:
            rows.append([float(start.group(1)), 0.0])
        elif line.split():
            number, _, deflection, _ = line.split()
            rows[-1][1] += shares[int(number)] * float(deflection)
    return np.array(rows)
