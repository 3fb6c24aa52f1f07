# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Claims 2 to 5 of the thesis (6.3, Figs 6.3 to 6.10) from finished runs; examples/run all prints them."""

import numpy as np

from potdem import logs
from potdem.scenes.claim import Claim, of_draws
from potdem.scenes.scene import beside

scan = beside(__file__, "scan")

POSITIONS = ("i", "ii", "iii")
DRAWS = (1, 2, 3)
SHORTER = 0.4      # s
DIFFERENT = 0.1    # two histories of the deflection are different, root mean square of the difference over that of one


def outcomes(folder_of, variant):
    """of each draw"""
    return [scan.Outcome(folder_of(variant, draw=draw)) for draw in DRAWS]


def between(values, form="{}"):
    """'3' or '3 to 5'"""
    ends = [form.format(value) for value in (min(values), max(values))]
    return ends[0] if ends[0] == ends[1] else " to ".join(ends)


def clamp(runs):
    """'parts', 'holds', or in how many of the draws it parts"""
    count = sum(run.clamp_parts for run in runs)
    if count in (0, len(runs)):
        return "parts" if count else "holds"
    return f"parts in {count} of {len(runs)} draws"


def contrast(number, folder_of, position, text, thesis, also):
    """also: what else must be true of a run at 5 m/s"""
    slow, fast = (outcomes(folder_of, f"{position}-{speed}") for speed in (3, 5))
    measured = (f"3 m/s: clamped section {clamp(slow)}, {between([run.hit for run in slow])} bonds broken near the block; "
                f"5 m/s: {clamp(fast)}, {between([run.hit for run in fast])}, "
                f"what is on the wall ends at {between([run.stump for run in fast], '{:.2f}')} L")
    verdicts = [a.clamp_parts and a.hit and not b.clamp_parts and b.hit and also(b) for a, b in zip(slow, fast)]
    return Claim(number, text, thesis, measured, of_draws(map(bool, verdicts)))


def deflection(folder):
    """of the middle section in mm, downwards, until the runs with failure end"""
    table = logs.read_thermo(next(folder.glob("log.*")))
    return -1e3 * table["v_middle"][table["Time"] <= SHORTER]


def unbroken(folder_of):
    """at 3 and 5 m/s without failure (Figs 6.7 and 6.8: position i); at 5 m/s without and with failure (Fig. 6.81)"""
    slow, fast = (deflection(folder_of(f"i-{speed}-unbroken")) for speed in (3, 5))
    difference = np.sqrt(np.mean((slow - fast) ** 2) / np.mean(fast**2))
    rows, smaller = [], []
    for position in POSITIONS:
        whole = deflection(folder_of(f"{position}-5-unbroken")).max()
        failing = [deflection(folder_of(f"{position}-5", draw=draw)).max() for draw in DRAWS]
        rows.append(f"{position}: {whole:.0f} and {between(failing, '{:.0f}')} mm")
        if max(failing) >= whole:
            smaller.append(position)
    if difference < DIFFERENT or len(smaller) == len(POSITIONS):
        verdict = "no"
    else:
        verdict = f"partly: not at {' and '.join(smaller)}" if smaller else "yes"
    return Claim("4", "beam-impact: unbroken, 3 and 5 m/s differ; at 5 m/s the middle section goes down more unbroken than with failure",
                 "both", f"position i, unbroken: deflections at 3 and 5 m/s differ by {100 * difference:.0f} % (root mean square); "
                 f"largest at 5 m/s, unbroken and with failure: {'; '.join(rows)}", verdict)


def cracked(folder_of):
    crack, whole = (outcomes(folder_of, variant) for variant in ("i-5-crack", "i-5"))
    measured = (f"cracked: what is on the wall ends at {between([run.stump for run in crack], '{:.2f}')} L (crack: 0.10 L); "
                f"uncracked: at {between([run.stump for run in whole], '{:.2f}')} L")
    return Claim("5", "beam-impact, crack, 5 m/s: parts in two at the crack, unlike the uncracked beam", "parts", measured,
                 of_draws(a.parts_at_crack and not b.clamp_parts for a, b in zip(crack, whole)))


def claims(folder_of):
    return [
        contrast("2", folder_of, "i", "beam-impact i: 3 m/s local rupture and failure at the clamp, 5 m/s local rupture only",
                 "contrast", lambda run: True),
        contrast("3", folder_of, "ii", "beam-impact ii: the same contrast, in mid-span", "contrast, two parts",
                 lambda run: run.two_at_block),
        unbroken(folder_of),
        cracked(folder_of),
    ]
