# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Claim 11 of the thesis (6.9, Fig. 6.27) from finished runs; examples/run all prints it."""

from potdem import logs
from potdem.scenes.claim import Claim, of_draws
from potdem.scenes.scene import beside

scan = beside(__file__, "scan")

DRAWS = (1, 2, 3)
LEAST_RISE = (scan.SPEED / 10) ** 2 / (2 * 9.81)    # m: a tenth of the velocity of the impact is left
LEAST_PIECES = 10
LEAST_SHARE = 10.0                                  # % of the grains


def outcomes(folder_of, variant):
    """of each draw"""
    return [scan.outcome(logs.read_thermo(next(folder_of(variant, draw=draw).glob("log.*")))) for draw in DRAWS]


def each(found, value, digits=0):
    """the draws' values of a quantity"""
    return ", ".join(f"{value(one):.{digits}f}" for one in found)


def moved(one):
    return 100 * one["far"] / scan.GRAINS


def rebounds(disc, printed, unbreakable):
    measured = (f"E = 3 GPa, three draws: the centre of mass of the disc rises by {each(disc, lambda one: one['rise'], 3)} m after "
                f"the impact, of a disc that cannot break by {unbreakable['rise']:.3f} m; with the printed E of 30 GPa and a step for it "
                f"by {each(printed, lambda one: one['rise'], 3)} m")
    return Claim("11a", "disc-bed: the disc rebounds", "rebound", measured, of_draws(one["rise"] > LEAST_RISE for one in disc))


def breaks(disc, printed):
    def words(found):
        return (f"{each(found, lambda one: 100 * one['broken'] / scan.BONDS, 1)} % of {scan.BONDS} bonds break, "
                f"{each(found, lambda one: one['pieces'])} pieces, the largest "
                f"{each(found, lambda one: 100 * one['largest'] / scan.PARTICLES)} % of the disc")

    return Claim("11b", "disc-bed: the disc breaks", "fracture", f"{words(disc)}; with the printed E {words(printed)}",
                 of_draws(one["pieces"] > LEAST_PIECES for one in disc))


def displaces(disc, printed):
    measured = (f"{each(disc, moved)} % of the grains move by more than a diameter, up to a height of "
                f"{each(disc, lambda one: one['high'], 1)} m (bed: 0.3 m); with the printed E {each(printed, moved)} %")
    return Claim("11c", "disc-bed: great displacements of the grains", "great", measured,
                 of_draws(moved(one) > LEAST_SHARE for one in disc))


def claims(folder_of):
    disc, printed = outcomes(folder_of, "disc"), outcomes(folder_of, "printed")
    unbreakable = scan.outcome(logs.read_thermo(next(folder_of("unbreakable").glob("log.*"))))
    return [rebounds(disc, printed, unbreakable), breaks(disc, printed), displaces(disc, printed)]
