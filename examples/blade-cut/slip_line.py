# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""The heap in front of the blade and the slip line below it, from the dump of a run.

The profile of the surface is the top of the highest grain in each column of 20 x 20 mm, averaged over the width. A grain
moves when it goes at least half the blade's way. The slip line, in each layer of 20 mm, is the place that best has moving grains
before it and resting grains beyond; it meets the surface where that holds for the highest grains of the columns.
"""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from potdem import dumps, logs

D, LENGTH, WIDTH, BED, TIP, BACK, THICK = 0.02, 0.58, 0.10, 0.16, 0.06, 0.06, 0.02    # m, as in in.blade-cut
WAYS = (0.1, 0.2)    # m, Fig. 6.23
STRETCH = 0.01       # m of the blade's way, over which grains move or rest
MOVING = 0.5         # of STRETCH
FORCE = 0.02         # m of the way, over which the force is averaged


@dataclass
class State:
    """the bed when the blade has gone `way`"""

    way: float
    heap: float           # m over the first surface
    meets: float          # m from the blade's front to the slip line on the surface
    angle: float          # degrees, tip to there
    line: np.ndarray      # (x, z) of the slip line, layer by layer from the tip, and on the surface
    over: float           # mean share of the blade's way: grains between the blade and the line
    beyond: float         # ... and beyond it
    force: float          # N, on the blade, mean over FORCE


def read(folder):
    """the frames of a run, each with the blade's way; the table of its log"""
    table = logs.read_thermo(next(Path(folder).glob("log.*")))
    frames = dumps.read(Path(folder) / "dump.blade-cut")
    for frame in frames:
        frame["way"] = float(np.interp(frame.step, table["Step"], table["v_shift"]))
        frame["time"] = float(np.interp(frame.step, table["Step"], table["Time"]))
    return frames, table


def at_way(frames, wanted):
    return min(frames, key=lambda frame: abs(frame["way"] - wanted))


def shares(frames, wanted):
    """(the frame, each grain's share of the blade's way over the last STRETCH)"""
    before, frame = at_way(frames, wanted - STRETCH), at_way(frames, wanted)
    gone = frame["c_moved[1]"] - before["c_moved[1]"]
    return frame, gone / (frame["way"] - before["way"])


def highest(frame):
    """indices of the highest grain of each column of D x D, by column of x then y; -1 where there is none"""
    nx, ny = round(LENGTH / D), round(WIDTH / D)
    column = np.clip((frame["x"] / D).astype(int), 0, nx - 1) * ny + np.clip((frame["y"] / D).astype(int), 0, ny - 1)
    order = np.argsort(frame["z"])
    found = np.full(nx * ny, -1)
    found[column[order]] = order    # the last one written is the highest
    return found.reshape(nx, ny)


def profile(frame):
    """height of the surface in each column of x"""
    found = highest(frame)
    tops = np.where(found < 0, np.nan, (frame["z"] + frame["radius"])[found])
    filled = np.any(found >= 0, axis=1)
    return np.array([np.nanmean(row) if some else 0.0 for row, some in zip(tops, filled)])


def border(x, moving):
    """the x with the fewest grains that rest before it or move beyond it"""
    order = np.argsort(x)
    x, moving = x[order], moving[order]
    resting_before = np.concatenate([[0], np.cumsum(~moving)])
    moving_beyond = np.concatenate([np.cumsum(moving[::-1])[::-1], [0]])
    place = np.argmin(resting_before + moving_beyond)
    return 0.5 * (x[max(place - 1, 0)] + x[min(place, x.size - 1)])


def slip_line(frame, moving):
    """(x, z) from the tip, layer by layer, to the surface"""
    front = BACK + THICK + frame["way"]
    x, z, ahead = frame["x"], frame["z"], frame["x"] > front - D / 2
    tops = highest(frame)
    tops = tops[tops >= 0]
    tops = tops[ahead[tops]]
    meets = border(x[tops], moving[tops])
    height = profile(frame)[int(meets / D)]
    line = [(front, TIP)]
    for low in np.arange(TIP, height - D, D):
        layer = ahead & (z >= low) & (z < low + D)
        line.append((border(x[layer], moving[layer]), low + D / 2))
    return np.array([*line, (meets, height)])


def state(frames, table, wanted):
    frame, share = shares(frames, wanted)
    line = slip_line(frame, share >= MOVING)
    (front, _), (meets, height) = line[0], line[-1]
    ahead = (frame["x"] > front - D / 2) & (frame["z"] > TIP)
    over = frame["x"] < np.interp(frame["z"], line[:, 1], line[:, 0])
    last = (table["v_shift"] > frame["way"] - FORCE) & (table["v_shift"] <= frame["way"] + 1e-9)
    return State(way=frame["way"], heap=profile(frame)[int(front / D) :].max() - BED, meets=meets - front,
                 angle=np.degrees(np.arctan2(height - TIP, meets - front)), line=line, over=share[ahead & over].mean(),
                 beyond=share[ahead & ~over].mean(), force=-table["v_blade"][last].mean())


def states(folder):
    frames, table = read(folder)
    return [state(frames, table, wanted) for wanted in WAYS]
