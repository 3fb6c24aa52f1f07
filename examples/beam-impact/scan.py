# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Where does the beam part, as a function of what the thesis does not state?

  scan.py NAME=VALUE[,VALUE ...] ...      e.g. scan.py position=i speed=3,5 damping=0.01,0.015,0.02 seed=1,2,3

Runs in.beam-impact for every combination (two at a time) and prints, for each, the number of broken bonds
(all, within L/10 of the clamp, within a of the place that is hit), whether the clamped section has parted, and
the pieces of at least 20 particles with the stretch of the undeformed beam that they came from (in beam lengths
from the clamp).
"""

import sys
from pathlib import Path

import numpy as np

from potdem import dumps
from potdem.scenes import scanning

HERE = Path(__file__).resolve().parent

LENGTH, WIDTH, SPACING = 0.24, 0.025, 0.005
PIECE = 20         # particles: less is debris
CLAMP_END = 0.1    # beam lengths: a cut this near to the clamp is a failure of the clamped section
CRACK = 0.1        # beam lengths from the clamp
NEAR = WIDTH / LENGTH    # a cut this near to the middle of the block is where it hits


def pieces(frames):
    """(start, end, particles) of each piece, in beam lengths of the undeformed beam"""
    first, last = frames[0], frames[-1]
    started = dict(zip(first["id"], first["x"]))
    beam = last["type"] == 1    # debris may have left the box
    found = []
    for piece in np.unique(last["c_piece"][beam]):
        x = np.array([started[atom] for atom in last["id"][beam & (last["c_piece"] == piece)]])
        if x.size >= PIECE:
            found.append(((x.min() - SPACING / 2) / LENGTH, (x.max() + SPACING / 2) / LENGTH, x.size))
    return sorted(found)


def broken(folder, frames, hit):
    """numbers of broken bonds: all, near the clamp, near the middle of the block"""
    # a run that went on lists what broke since then
    lists = [frame for path in [folder / "dump.failed", *folder.glob("dump.earlier.*")] for frame in dumps.read(path)]
    pairs = {pair for rows in lists for pair in zip(rows["f_fail[3]"], rows["f_fail[4]"])}
    started = dict(zip(frames[0]["id"], frames[0]["x"]))
    middles = np.array([(started[i] + started[j]) / 2 for i, j in pairs])
    return middles.size, np.sum(middles < CLAMP_END * LENGTH), np.sum(np.abs(middles - hit) < WIDTH)


class Outcome:
    """of a finished run in which bonds can break: broken bonds; the pieces; stump: where the one on the clamp ends, beam lengths"""

    def __init__(self, folder):
        frames = dumps.read(folder / "dump.beam-impact")
        self.block = frames[0]["x"][frames[0]["type"] == 2].mean()
        self.broken, self.near_clamp, self.hit = broken(folder, frames, self.block)
        self.pieces = pieces(frames)
        self.stump = self.pieces[0][1]

    @property
    def clamp_parts(self):
        return self.stump < CLAMP_END

    @property
    def two_at_block(self):
        """is the beam cut in two where the block hits?"""
        return abs(self.stump - self.block / LENGTH) < NEAR and len(self.pieces) > 1

    @property
    def parts_at_crack(self):
        """between the layers on both sides of it"""
        return abs(self.stump - CRACK) < SPACING / LENGTH


def measure(folder):
    run = Outcome(folder)
    ranges = "  ".join(f"{start:.2f}-{end:.2f} ({count})" for start, end, count in run.pieces)
    return (f"broken {run.broken:4d}, clamp {run.near_clamp:3d}, hit {run.hit:4d}; clamp {'parts' if run.clamp_parts else 'holds'}; "
            f"{ranges}")


if __name__ == "__main__":
    scanning.main(HERE, measure, sys.argv[1:])
