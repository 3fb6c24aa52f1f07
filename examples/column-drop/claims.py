# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Claim 10 measured: the final shape of the heap, for several readings of its height and width.

  claims.py FOLDER ...                     of examples/run: build/examples/column-drop/<variant>.np<ranks>
  claims.py NAME=VALUE[,VALUE ...] ...     new runs, e.g. claims.py mu_grain=0,0.3,0.5 seed=1,2,3

For each run: h0/r0 of the settled column; h_f; r_f, from the right wall to the foremost grain of the heap; h_f/r_f; the
same with the foremost of all grains, with the width within which 99 % and 95 % of the mass lie, and with that of a triangle of
the heap's height and side area; by how much the heap has sunk and its grains have moved in the last 0.5 s. The
heap is the largest set of grains that touch one another; h_f is its highest point within two mean diameters of the right wall.
"""

import sys
from pathlib import Path

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree
from scipy.stats import t

from potdem import dumps, logs
from potdem.scenes import scanning
from potdem.scenes.claim import Claim

HERE = Path(__file__).resolve().parent

D = 0.018              # m, mean diameter
LATE = 0.5             # s, at the end: does the heap stand still?
TOUCH = 0.02 * D       # m: gap that counts as a contact
THESIS, REFERENCE = 0.2230, 0.2185    # h_f/r_f; the verdict is on the first, a single run
READINGS = {"standard deviation 5 mm": "sd5", "variance 5 mm²": "var5"}
SEEDS = (1, 2, 3, 4, 5)
WIDTHS = {"foremost": "the foremost grain of the heap", "any": "the foremost of all grains", "99 %": "99 % of the heap's mass"}


def heap(frame):
    """mask of the largest set of grains that touch one another"""
    points = np.column_stack([frame["x"], frame["y"], frame["z"]])
    radius = frame["radius"]
    i, j = cKDTree(points).query_pairs(2 * radius.max() + TOUCH, output_type="ndarray").T
    touch = np.linalg.norm(points[i] - points[j], axis=1) < radius[i] + radius[j] + TOUCH
    graph = coo_matrix((np.ones(touch.sum()), (i[touch], j[touch])), shape=(len(points), len(points)))
    _, label = connected_components(graph, directed=False)
    return label == np.bincount(label).argmax()


def mass_centre(frame):
    return np.average(frame["z"], weights=frame["radius"] ** 3)


def parameters(folder):
    given = logs.parameters(next(Path(folder).glob("log.*")).read_text(encoding="utf-8"))
    return float(given["r0"]), float(given["released"])


def top(frame, inside, r0):
    """height of the heap at the right wall"""
    return (frame["z"] + frame["radius"])[inside & (frame["x"] > r0 - 2 * D)].max()


def creep(folder):
    """m: by how much the heap's height falls, and the median way of its grains, in the last LATE seconds"""
    frames, (r0, _) = dumps.read_run(folder, "dump.column-drop"), parameters(folder)
    last = frames[-1]
    before = dumps.at(frames, last["time"] - LATE)
    rows = np.searchsorted(before["id"], last["id"])
    inside = heap(last)
    way = np.sqrt(sum((last[name] - before[name][rows]) ** 2 for name in "xyz"))
    return top(before, heap(before), r0) - top(last, inside, r0), np.median(way[inside])


def shape(folder):
    """(h0/r0, h_f, {reading of r_f: r_f}, share of the grains in the heap)"""
    frames = dumps.read_run(folder, "dump.column-drop")
    r0, released = parameters(folder)
    slender = 2 * mass_centre(dumps.at(frames, released)) / r0    # the column is a block
    last = frames[-1]
    inside = heap(last)
    x, radius = last["x"][inside], last["radius"][inside]
    height = top(last, inside, r0)
    front = np.sort(r0 - x + radius)
    order = np.argsort(r0 - x)
    mass = np.cumsum(radius[order] ** 3)
    within = {share: (r0 - x)[order][np.searchsorted(mass, share * mass[-1])] for share in (0.99, 0.95)}
    area = r0 * r0 * slender * mass[-1] / np.sum(last["radius"] ** 3)    # of the heap's side, as dense as the column
    widths = {"foremost": front[-1], "any": (r0 - last["x"] + last["radius"]).max(), "99 %": within[0.99], "95 %": within[0.95],
              "triangle": 2 * area / height}
    return slender, height, widths, inside.mean()


def measure(folder):
    slender, height, widths, inside = shape(folder)
    sunk, way = creep(folder)
    ratios = ", ".join(f"{name} {height / width:.3f}" for name, width in widths.items())
    return (f"h0/r0 {slender:.3f}; h_f {height:.3f} m, r_f {widths['foremost']:.3f} m; h_f/r_f {ratios}; "
            f"{100 * inside:.1f} % in the heap; {1e3 * sunk:.2f} mm sunk, grains moved {1e3 * way:.2f} mm in the last {LATE} s")


def reach(ratios):
    """half of the interval about the mean of some draws in which one more lies with 95 %, if they scatter normally"""
    return t.ppf(0.975, len(ratios) - 1) * ratios.std(ddof=1) * np.sqrt(1 + 1 / len(ratios))


def claims(folder_of):
    """for the table of examples/run all"""
    found = []
    for letter, (reading, name) in zip("ab", READINGS.items()):
        shapes = [shape(folder_of(f"{name}-{seed}")) for seed in SEEDS]
        ratios = {which: np.array([height / widths[which] for _, height, widths, _ in shapes]) for which in WIDTHS}
        measured = f"{len(SEEDS)} draws: " + ", ".join(
            f"{values.mean():.3f} ± {values.std(ddof=1):.3f} with {WIDTHS[which]}" for which, values in ratios.items())
        main = ratios["foremost"]
        measured += f"; one more draw: {main.mean() - reach(main):.3f} to {main.mean() + reach(main):.3f}"
        verdict = "yes" if abs(THESIS - main.mean()) < reach(main) else "no"
        found.append(Claim(f"10{letter}", f"column-drop, {reading}: h_f/r_f", f"{THESIS:.4f} (its reference: {REFERENCE:.4f})",
                           measured, verdict))
    return found


if __name__ == "__main__":
    scanning.main(HERE, measure, sys.argv[1:])
