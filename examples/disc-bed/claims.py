# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Claim 11 of the thesis (6.9, Fig. 6.27) from finished runs; examples/run all prints it."""

from potdem import logs
from potdem.scenes.claim import Claim
from potdem.scenes.scene import beside

scan = beside(__file__, "scan")

LEAST_RISE = (scan.SPEED / 10) ** 2 / (2 * 9.81)    # m: a tenth of the velocity of the impact is left


def rebounds(disc, unbreakable):
    measured = (f"the centre of mass of the disc rises by {disc['rise']:.3f} m after the impact; that of a disc that cannot break "
                f"by {unbreakable['rise']:.3f} m")
    verdict = "yes" if disc["rise"] > LEAST_RISE else "no: only if it does not break" if unbreakable["rise"] > LEAST_RISE else "no"
    return Claim("11a", "disc-bed: the disc rebounds", "rebound", measured, verdict)


def breaks(disc):
    measured = (f"{100 * disc['broken'] / scan.BONDS:.0f} % of {scan.BONDS} bonds break; {disc['pieces']:.0f} pieces, the largest "
                f"{100 * disc['largest'] / scan.PARTICLES:.0f} % of the disc, {disc['single']:.0f} single particles")
    return Claim("11b", "disc-bed: the disc breaks", "fracture", measured, "yes" if disc["pieces"] > 10 else "no")


def displaces(disc):
    share = 100 * disc["far"] / scan.GRAINS
    measured = (f"{share:.0f} % of the grains move by more than a diameter, up to a height of {disc['high']:.2f} m (bed: 0.30 m); "
                f"the disc sinks {disc['depth']:.2f} m into the bed")
    return Claim("11c", "disc-bed: great displacements of the grains", "great", measured,
                 "yes" if share > 10 else "partly" if share > 1 else "no")


def claims(folder_of):
    disc, unbreakable = (scan.outcome(logs.read_thermo(next(folder_of(variant).glob("log.*"))))
                         for variant in ("disc", "unbreakable"))
    return [rebounds(disc, unbreakable), breaks(disc), displaces(disc)]
