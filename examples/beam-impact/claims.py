# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Claims 2 to 5 of the thesis (6.3, Figs 6.3 to 6.11) from finished runs; examples/run all prints them."""

from potdem import dumps, logs
from potdem.scenes.claim import Claim
from potdem.scenes.scene import beside

scan = beside(__file__, "scan")

POSITIONS = ("i", "ii", "iii")


def outcome(folder):
    """(does the clamped section part, broken bonds near the block, pieces)"""
    frames = dumps.read(folder / "dump.beam-impact")
    block = frames[0]["x"][frames[0]["type"] == 2].mean()
    _, _, hit = scan.broken(folder, frames, block)
    found = scan.pieces(frames)
    return found[0][1] < scan.CLAMP_END, hit, found


def contrast(number, folder_of, position, text, thesis):
    clamp3, hit3, _ = outcome(folder_of(f"{position}-3"))
    clamp5, hit5, found = outcome(folder_of(f"{position}-5"))
    measured = (f"3 m/s: clamped section {'parts' if clamp3 else 'holds'}, {hit3} bonds broken near the block; "
                f"5 m/s: {'parts' if clamp5 else 'holds'}, {hit5}; pieces {len(found)}")
    if not (clamp3 and not clamp5 and hit5):
        verdict = "no"
    else:
        verdict = "yes" if hit3 else "partly: no local rupture at 3 m/s"
    return Claim(number, text, thesis, measured, verdict)


def deflection(folder, until=0.4):
    """largest downward deflection of the middle section in mm, until the shorter of the runs ends"""
    table = logs.read_thermo(next(folder.glob("log.*")))
    return -1e3 * table["v_middle"][table["Time"] <= until].min()


def unbroken(folder_of):
    rows, larger, differs = [], True, True
    for position in POSITIONS:
        whole = [deflection(folder_of(f"{position}-{speed}-unbroken")) for speed in (3, 5)]
        failing = [deflection(folder_of(f"{position}-{speed}")) for speed in (3, 5)]
        larger = larger and all(a > b for a, b in zip(whole, failing))
        differs = differs and abs(whole[0] - whole[1]) > 0.01 * max(whole)
        rows.append(f"{position}: {whole[0]:.1f} and {whole[1]:.1f}, with failure {failing[0]:.1f} and {failing[1]:.1f}")
    verdict = "yes" if larger and differs else "partly" if larger or differs else "no"
    return Claim("4", "beam-impact, unbroken: 3 and 5 m/s differ; mid-span deflects more unbroken than with failure", "both",
                 "largest deflection in mm at 3 and 5 m/s: " + "; ".join(rows), verdict)


def cracked(folder_of):
    with_crack, _, found = outcome(folder_of("i-5-crack"))
    without, _, _ = outcome(folder_of("i-5"))
    measured = f"cracked: {'parts' if with_crack else 'holds'} near the crack, {len(found)} pieces; uncracked: " + (
        "parts" if without else "holds")
    return Claim("5", "beam-impact, crack, 5 m/s: parts in two at the crack, unlike the uncracked beam", "parts", measured,
                 "yes" if with_crack and not without else "no")


def claims(folder_of):
    return [
        contrast("2", folder_of, "i", "beam-impact i: 3 m/s local rupture and failure at the clamp, 5 m/s local rupture only",
                 "contrast"),
        contrast("3", folder_of, "ii", "beam-impact ii: the same contrast, in mid-span", "contrast, two parts"),
        unbroken(folder_of),
        cracked(folder_of),
    ]
