# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Claim 7 measured: how the right part falls, how many grains stay on the ledges, how fast the others leave.

  claims.py FOLDER ...                     of examples/run: build/examples/hopper/<variant>.np<ranks>
  claims.py NAME=VALUE[,VALUE ...] ...     new runs, e.g. claims.py mu_wall=0.3 mu_grain=0,0.3 seed=1,2,3

For each run: the right part's median downward velocity at 0.11 s over that of free fall, and the
share of its pairs of neighbours that are still neighbours; the grains on the upper and on the lower ledge at the end, all
and those slower than 0.02 m/s; the downward velocity in the exit at 5, 10, 15, 20 and 25 cm below the lower ledge; the median
acceleration of grains that touch nothing.
"""

import sys
from pathlib import Path

import numpy as np
from scipy.spatial import cKDTree

from potdem import dumps
from potdem.scenes import scanning
from potdem.scenes.claim import Claim

HERE = Path(__file__).resolve().parent

UPPER, LOWER, EDGE, EXIT = 0.32, 0.24, 0.03, 0.04    # m: z0, z1, x0, x1 of in.hopper
GRAVITY, INSTANT = 9.81, 0.11                        # m/s^2; s: in free fall 6 cm down
DEPTHS = np.array([0.05, 0.10, 0.15, 0.20, 0.25])    # m below the lower ledge
AT_REST = 0.02                                       # m/s
CLEAR = 0.0097                                       # m: larger than any diameter
NEIGHBOURS = (0.0095, 0.0105)                        # m: neighbours at the start (spacing 0.00925), and later


def places(frame, atoms):
    rows = np.searchsorted(frame["id"], atoms)
    return np.column_stack([frame["x"], frame["y"], frame["z"]])[rows], -frame["vz"][rows]


def block(frames):
    """(median velocity over free fall, share of pairs that are still neighbours) of the right part"""
    first, later = frames[0], dumps.at(frames, INSTANT)
    right = first["id"][first["x"] > EDGE]
    start, _ = places(first, right)
    points, down = places(later, right)
    i, j = cKDTree(start).query_pairs(NEIGHBOURS[0], output_type="ndarray").T
    together = np.linalg.norm(points[i] - points[j], axis=1) < NEIGHBOURS[1]
    return np.median(down) / (GRAVITY * later["time"]), together.mean()


def on_ledges(frame):
    """grains on the upper and on the lower ledge: all, at rest"""
    slow = frame["vx"] ** 2 + frame["vy"] ** 2 + frame["vz"] ** 2 < AT_REST**2
    upper = frame["z"] > UPPER
    lower = (frame["z"] > LOWER) & ~upper & (frame["x"] > EXIT)
    return [np.sum(chosen) for chosen in (upper, upper & slow, lower, lower & slow)]


def exit_velocities(frames):
    """mean downward velocity near each of DEPTHS, over all frames"""
    z = np.concatenate([frame["z"] for frame in frames])
    down = -np.concatenate([frame["vz"] for frame in frames])
    return [down[np.abs(LOWER - depth - z) < 0.01].mean() for depth in DEPTHS]


def alone(frame):
    """mask of the grains in the exit that touch neither another nor a wall"""
    points = np.column_stack([frame["x"], frame["y"], frame["z"]])
    gap = cKDTree(points).query(points, k=2)[0][:, 1]
    inside = (np.abs(frame["x"] - EXIT / 2) < EXIT / 2 - CLEAR) & (frame["y"] > CLEAR) & (frame["y"] < frame["y"].max() - CLEAR)
    return inside & (frame["z"] < LOWER - CLEAR) & (gap > CLEAR)


def falls(frames):
    """acceleration over g of grains that are alone in two frames in a row"""
    found = []
    for first, second in zip(frames, frames[1:]):
        _, rows, others = np.intersect1d(first["id"][alone(first)], second["id"][alone(second)], return_indices=True)
        before, after = first["vz"][alone(first)][rows], second["vz"][alone(second)][others]
        found.append((before - after) / (second["time"] - first["time"]) / GRAVITY)
    return np.concatenate(found)


def measure(folder):
    frames = dumps.read_run(folder, "dump.hopper")
    velocity, together = block(frames)
    counts = "upper %d (%d at rest), lower %d (%d)" % tuple(on_ledges(frames[-1]))
    leaving = " ".join(f"{value:.2f}" for value in exit_velocities(frames))
    free = falls(frames)
    return (f"block {velocity:.2f} of free fall, {100 * together:.0f} % together; {counts}; exit {leaving} m/s; "
            f"{len(free)} times alone, {np.median(free):.3f} g")


def claims(folder_of):
    """for the table of examples/run all"""
    runs = [dumps.read_run(folder_of(name), "dump.hopper") for name in ("smooth", "rough-walls", "rough")]
    together = [100 * block(frames)[1] for frames in runs]
    upper, _, lower, _ = np.array([on_ledges(frames[-1]) for frames in runs]).T
    leaving = [exit_velocities(frames) for frames in runs]
    falls = min(together) > 50
    grows = np.all(np.diff(upper) > 0) and np.all(np.diff(lower) > 0)
    faster = all(np.all(np.diff(speeds) > 0) for speeds in leaving)
    three = "{:.0f}, {:.0f}, {:.0f}".format
    measured = (f"no friction, rough walls, rough: {three(*together)} % of the block's neighbours still together at {INSTANT} s; "
                f"{three(*upper)} grains on the upper ledge, {three(*lower)} on the lower; exit "
                f"{leaving[2][0]:.2f} to {leaving[2][-1]:.2f} m/s over 20 cm")
    verdict = "yes" if falls and grows and faster else "partly" if grows or faster else "no"
    return [Claim("7", "hopper: the right part falls about as a block; grains stay on both ledges, more with friction; the exit "
                  "speed grows with height", "all", measured, verdict)]


if __name__ == "__main__":
    scanning.main(HERE, measure, sys.argv[1:])
