# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Claim 8 of the thesis (6.6, Figs 6.19 to 6.21) from finished runs; examples/run all prints it."""

from potdem import logs
from potdem.scenes.claim import Claim
from potdem.scenes.scene import beside

scan = beside(__file__, "scan")


def table_of(folder):
    return logs.read_thermo(next(folder.glob("log.*")))


def share(row, *names):
    """per cent of the particles"""
    return 100 * sum(row[name] for name in names) / scan.PARTICLES


def clusters_late(table):
    """grains (at least 5 % of the particles) by 0.2 s; after that more particles come off in pieces of 10 and more"""
    early, end = scan.at(table, 0.2), scan.at(table, 0.8)
    blocks = share(end, "v_n10", "v_n100") - share(end, "v_largest")
    measured = (f"single particles: {share(early, 'v_n1'):.1f} % at 0.2 s, {share(end, 'v_n1'):.1f} % at 0.8 s; pieces of 10 "
                f"and more, without the largest: {blocks:.1f} %; largest {share(end, 'v_largest'):.1f} %")
    grains = share(early, "v_n1") >= 5.0
    more_blocks = blocks > share(end, "v_n1") - share(early, "v_n1")
    verdict = "yes" if grains and more_blocks else "partly" if grains or (more_blocks and blocks > 5.0) else "no"
    return Claim("8a", "cylinder-impact, 1 MPa: grain-like fragments early, large clusters later", "both", measured, verdict)


def grains(table):
    end = scan.at(table, 0.8)
    single, largest = share(end, "v_n1"), share(end, "v_largest")
    measured = f"at 0.8 s {end['v_pieces']:.0f} pieces: {single:.0f} % single particles, largest piece {largest:.0f} %"
    verdict = "no" if single < 25.0 else "yes" if largest < 10.0 else "partly: one large piece is left"
    return Claim("8b", "cylinder-impact, 0.2 MPa: like a granular material", "grains", measured, verdict)


def rebounds(table):
    leaves = scan.rebound(table)
    measured = f"{table['v_broken'][-1]:.0f} bonds broken; " + (
        "leaves the plane at %.2f s with %.1f m/s" % leaves if leaves else "does not leave the plane")
    return Claim("8c", "cylinder-impact, 200 MPa: stays whole and rebounds", "rebounds", measured,
                 "yes" if leaves and table["v_broken"][-1] == 0 else "no")


def claims(folder_of):
    return [clusters_late(table_of(folder_of("1e6"))), grains(table_of(folder_of("2e5"))),
            rebounds(table_of(folder_of("2e8")))]
