# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""The two cases of the race in YADE, which runs this file:

  yade -n -x -j CORES yade_race.py CASE PACKING SOFTER DT TIME EVERY MODULUS DENSITY E MU E_STEEL OUT

CASE: silo or ball; PACKING: the data file that in.silo or in.ball wrote; SOFTER: what both moduli are divided by; TIME: s;
EVERY: s between two rows of OUT, a CSV file of the time and of the grains in the silo or the height of the ball; MODULUS to
E_STEEL: of the grains, in SI, with restitution and friction among them and restitution with steel. Prints what
the steps alone took, in seconds of the clock and of the processor."""

import sys
import time
from math import atan, cos, pi, sin

from yade import O, geom, utils
from yade.wrapper import (Bo1_Facet_Aabb, Bo1_Sphere_Aabb, ForceResetter, FrictMat, Ig2_Facet_Sphere_ScGeom, Ig2_Sphere_Sphere_ScGeom,
                          InsertionSortCollider, InteractionLoop, Ip2_FrictMat_FrictMat_MindlinPhys, Law2_ScGeom_MindlinPhys_Mindlin,
                          MatchMaker, NewtonIntegrator)

GRAINS, STEEL = 0, 1                                      # materials, types less 1
WIDE, OUTLET, DEEP, HIGH = 0.1, 0.03, 0.07, 0.15          # the silo, as in in.silo
HALF, TALL = 0.04, 0.2                                    # the box, as in in.ball
SIDES, RING = 72, 0.01                                    # facets: around a circle, height of a ring of them
SPEED = 5.0
VERLET = 0.1                                              # how far boxes reach beyond a grain, over its radius: as in YADE's own scripts


def materials(softer, grains):
    for modulus, density in (grains, (210e9, 7200)):
        O.materials.append(FrictMat(young=modulus / softer, poisson=0.2, density=density))


def engines(e, mu, e_steel):
    """friction and restitution of grains with grains, grains with steel, steel with steel"""
    pairs = ((GRAINS, GRAINS), (GRAINS, STEEL), (STEEL, STEEL))
    friction = MatchMaker(matches=[(*pair, atan(one)) for pair, one in zip(pairs, (mu, 0.2, 0.2))])
    restitution = MatchMaker(matches=[(*pair, one) for pair, one in zip(pairs, (e, e_steel, e_steel))])
    return [
        ForceResetter(),
        InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Facet_Aabb()], verletDist=-VERLET),
        InteractionLoop([Ig2_Sphere_Sphere_ScGeom(), Ig2_Facet_Sphere_ScGeom(hertzian=True)],
                        [Ip2_FrictMat_FrictMat_MindlinPhys(frictAngle=friction, en=restitution)],
                        [Law2_ScGeom_MindlinPhys_Mindlin()]),
        NewtonIntegrator(damping=0, gravity=(0, 0, -9.81)),
    ]


def spheres(path):
    """of the rows id type diameter density x y z of a data file, in the order of their ids"""
    with open(path, encoding="ascii") as file:
        lines = iter(file.read().split("\n"))
    next(line for line in lines if line.startswith("Atoms"))
    next(lines)
    rows = []
    for line in lines:
        if not line:
            break
        rows.append([float(word) for word in line.split()])
    return [utils.sphere(row[4:7], row[2] / 2, material=int(row[1]) - 1) for row in sorted(rows)]


def ring(low, low_radius, high, high_radius):
    """facets between two circles, outside of them, so that they press no grain that touches the circle"""
    def corner(k, z, radius):
        turn = 2 * pi * k / SIDES
        return (radius / cos(pi / SIDES) * cos(turn), radius / cos(pi / SIDES) * sin(turn), z)

    for k in range(SIDES):
        a, b = corner(k, low, low_radius), corner(k + 1, low, low_radius)
        c, d = corner(k, high, high_radius), corner(k + 1, high, high_radius)
        yield utils.facet((a, b, c), material=STEEL)
        yield utils.facet((b, d, c), material=STEEL)


def silo():
    """facets of funnel and cylinder"""
    levels = [-DEEP + k * RING for k in range(round((DEEP + HIGH) / RING) + 1)]
    radii = [min(WIDE, OUTLET + (WIDE - OUTLET) * (z + DEEP) / DEEP) for z in levels]
    return [facet for k in range(len(levels) - 1) for facet in ring(levels[k], radii[k], levels[k + 1], radii[k + 1])]


def box():
    """facets of a box without a lid"""
    return geom.facetBox((0, 0, TALL / 2), (HALF, HALF, TALL / 2), wallMask=31, material=STEEL)


def grains_inside(grains):
    """their number; those well below the outlet are taken away"""
    for body in [body for body in grains if body.state.pos[2] < -DEEP - 0.02]:
        O.bodies.erase(body.id)
        grains.remove(body)
    return sum(body.state.pos[2] > -DEEP for body in grains)


def main(case, packing, softer, dt, duration, every, *grains, out):
    modulus, density, *contact = map(float, grains)
    materials(float(softer), (modulus, density))
    O.bodies.append(silo() if case == "silo" else box())
    bodies = [O.bodies[number] for number in O.bodies.append(spheres(packing))]
    ball = next((body for body in bodies if body.mat.id == STEEL), None)
    if case == "ball":
        ball.state.vel = (0, 0, -SPEED)
    O.engines, O.dt = engines(*contact), float(dt)
    chunk, wall, cpu = round(float(every) / O.dt), 0.0, 0.0
    with open(out, "w", encoding="ascii") as file:
        for k in range(round(float(duration) / O.dt / chunk) + 1):
            if k:
                start = time.perf_counter(), time.process_time()
                O.run(chunk, True)
                wall, cpu = wall + time.perf_counter() - start[0], cpu + time.process_time() - start[1]
            value = grains_inside(bodies) if case == "silo" else ball.state.pos[2]
            file.write(f"{O.time:.9g},{value:.9g}\n")
    print(f"SECONDS {wall:.6g} {cpu:.6g} STEPS {O.iter} CONTACTS {O.interactions.countReal()}")


main(*sys.argv[1:-1], out=sys.argv[-1])
