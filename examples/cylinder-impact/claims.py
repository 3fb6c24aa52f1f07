# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Claim 8 of the thesis (6.6, Figs 6.19 to 6.21) from finished runs; examples/run all prints it."""

import math

from potdem import logs
from potdem.scenes.claim import Claim, of_draws
from potdem.scenes.scene import beside

scan = beside(__file__, "scan")

DRAWS = (1, 2, 3)
E, DENSITY, SPEED = 3e6, 2400.0, 10.0    # Pa, kg/m^3, m/s
FIRST, LATE, END = 0.2, 0.4, 0.8         # s, of Figs 6.19 to 6.21


def tables_of(folder_of, variant):
    """of each draw"""
    return [logs.read_thermo(next(folder_of(variant, draw=draw).glob("log.*"))) for draw in DRAWS]


def each(found, value, digits=0):
    """the draws' values of a quantity"""
    return ", ".join(f"{value(one):.{digits}f}" for one in found)


def single(table, instant=END):
    return scan.share(scan.at(table, instant), "v_n1")


def largest(table):
    return scan.share(scan.at(table, END), "v_largest")


def blocks(table, instant=END):
    """per cent of the particles in pieces of 10 and more, without the largest"""
    row = scan.at(table, instant)
    return scan.share(row, "v_n10", "v_n100") - scan.share(row, "v_largest")


def clusters_late(table):
    """grains (at least 5 % of the particles) by 0.2 s; after that more particles come off in pieces of 10 and more"""
    return single(table, FIRST) >= 5.0 and blocks(table) - blocks(table, FIRST) > single(table) - single(table, FIRST)


def first_claim(printed, nearest):
    def words(found):
        return (f"{each(found, lambda t: single(t, FIRST), 1)} % single particles at 0.2 s, {each(found, single, 1)} % at 0.8 s, "
                f"{each(found, blocks, 1)} % in pieces of 10 and more, {each(found, largest, 1)} % in the largest")

    verdict = of_draws(map(clusters_late, printed))
    if verdict == "no":
        verdict += (f": a bond fails at a strain of {1e6 / E:.2f}, and the impact strains the cylinder by "
                    f"v0/c = {SPEED / math.sqrt(E / DENSITY):.2f}")
    return Claim("8a", "cylinder-impact, 1 MPa: grain-like fragments early, large clusters later", "both",
                 f"three draws: {words(printed)}; with the non-penetration factor m = 1: {words(nearest)}", verdict)


def second_claim(tables):
    """grains: pieces of fewer than 10 particles; three quarters of the particles are in them"""
    fine = [scan.share(scan.at(table, END), "v_n1", "v_n2") for table in tables]
    measured = (f"at 0.8 s, three draws: {each(tables, single)} % single particles, {each(fine, float)} % in pieces of fewer than 10, "
                f"the largest piece {each(tables, largest)} %")
    return Claim("8b", "cylinder-impact, 0.2 MPa: like a granular material", "grains", measured, of_draws(share >= 75.0 for share in fine))


def is_off(table):
    """off the plane and rising at the thesis's last two instants"""
    rows = [scan.at(table, instant) for instant in (FIRST, LATE)]
    return all(row["v_force"] == 0 and row["v_speed"] > 0 for row in rows)


def third_claim(tables):
    off = [is_off(table) for table in tables]
    leaves = [scan.rebound(table) or (math.nan, math.nan) for table in tables]
    measured = (f"three draws: {each(tables, lambda table: table['v_broken'][-1])} bonds broken; leaves the plane at "
                f"{each(leaves, lambda one: one[0], 3)} s with {each(leaves, lambda one: one[1], 1)} m/s, off it at {FIRST} and {LATE} s "
                f"in {sum(off)} of {len(off)}")
    return Claim("8c", "cylinder-impact, 200 MPa: stays whole and rebounds", "rebounds", measured,
                 of_draws(table["v_broken"][-1] == 0 and rises for table, rises in zip(tables, off)))


def claims(folder_of):
    return [first_claim(tables_of(folder_of, "1e6"), tables_of(folder_of, "nearest")), second_claim(tables_of(folder_of, "2e5")),
            third_claim(tables_of(folder_of, "2e8"))]
