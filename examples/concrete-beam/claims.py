# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Claim 6 measured: when the wave reaches the supports, how large the reaction gets, which part of the beam is broken.

  claims.py FOLDER ...                     of examples/run: build/examples/concrete-beam/<variant>.np<ranks>
  claims.py NAME=VALUE[,VALUE ...] ...     new runs, e.g. claims.py speed=2,4 damping=0,0.02,0.05 time=0.1

For each run: when the wave arrives at the left and at the right support, and the height of its pulse; the largest reaction of
both supports, as the mean over 1 ms, and when; the width of the broken zone from the top layer of
particles to the bottom layer at 0.05 s; at 0.1 s the share of broken bonds in the parts over the supports; the pieces of 20 particles and more.
"""

import sys
from pathlib import Path

import numpy as np

from potdem import dumps
from potdem.scenes import scanning
from potdem.scenes.claim import Claim

HERE = Path(__file__).resolve().parent

SPACING, ACROSS, SUPPORT = 0.035, 8, 17 * 0.035    # m, particles, m: d, n, X of in.concrete-beam
HAMMER = np.array([-3.5, 4.5]) * SPACING           # m, its faces
WAVE = np.sqrt(3e10 / 2300)                        # m/s, along a bar
DISTANCES = np.array([HAMMER[0] + SUPPORT, SUPPORT - HAMMER[1]])
PULSE_ENDS = 3e-4    # s: after the first pulse the ends of the beam lift off
OVER = ACROSS / 2 * SPACING    # m: so near to a support is over it
PIECE = 20           # particles: less is debris
SPEEDS = (2, 4, 6, 8)          # m/s
RISEN, WEIGHT = 1e4, 2.17e3    # N; the second is that of the beam


class Reaction:
    """of both supports against time; columns left and right"""

    def __init__(self, folder):
        table = np.loadtxt(folder / "reaction.txt")
        self.time, self.force = table[:, 1], table[:, 2:]

    def arrival(self):
        """times at which half of the first pulse is reached, and its height, both sides"""
        early = self.force[self.time < PULSE_ENDS]
        first = np.argmax(early >= early.max(axis=0) / 2, axis=0)
        return self.time[first], early.max(axis=0)

    def smooth(self, width=1e-3):
        """sum of both, mean over `width` seconds"""
        count = round(width / (self.time[1] - self.time[0]))
        return np.convolve(self.force.sum(axis=1), np.ones(count) / count, "same")

    def peak(self):
        force = self.smooth()
        return force.max(), self.time[force.argmax()]

    def above(self, limit):
        """the first time that both together are above a force"""
        return self.time[np.argmax(self.force.sum(axis=1) > limit)]


def beam(frames, instant):
    """of the beam's particles in the box at that instant: where they were at the start, and the frame's columns"""
    first, now = frames[0], dumps.at(frames, instant)
    rows = np.searchsorted(first["id"], now["id"])
    chosen = now["type"] == 1
    start = {name: first[name][rows][chosen] for name in ("x", "z", "c_bonds")}
    return start, {name: now[name][chosen] for name in ("v_broken_bonds", "c_piece")}


def widths(frames, instant=0.05):
    """m, of the broken zone in each layer, top first: particles that have lost half of their bonds and more"""
    start, now = beam(frames, instant)
    layer = np.round(start["z"] / SPACING - 0.5).astype(int)
    broken = now["v_broken_bonds"] >= start["c_bonds"] / 2
    return np.bincount(layer[broken], minlength=ACROSS)[::-1] / ACROSS * SPACING


def over_supports(frames, instant=0.1):
    """share of the bonds lost near the supports"""
    start, now = beam(frames, instant)
    near = np.abs(start["x"]) > SUPPORT - OVER - SPACING / 4
    return now["v_broken_bonds"][near].sum() / start["c_bonds"][near].sum()


def pieces(frames, instant=0.1):
    _, now = beam(frames, instant)
    _, sizes = np.unique(now["c_piece"], return_counts=True)
    return sorted(sizes[sizes >= PIECE], reverse=True)


def measure(folder):
    frames, reaction = dumps.read_run(folder, "dump.concrete-beam"), Reaction(folder)
    when, pulse = reaction.arrival()
    peak, at_peak = reaction.peak()
    zone = " ".join(f"{100 * width:.0f}" for width in widths(frames))
    return (f"arrives {1e3 * when[0]:.3f} {1e3 * when[1]:.3f} ms, {pulse[0]:.0f} {pulse[1]:.0f} N; peak {peak / 1e3:.1f} kN at "
            f"{1e3 * at_peak:.1f} ms; zone {zone} cm; over supports {100 * over_supports(frames):.1f} %; pieces {pieces(frames)}")


def listed(values, form=".0f"):
    return ", ".join(f"{value:{form}}" for value in values)


def waves(whole, broken):
    """the wave arrives when distance over speed says so; then the reaction rises fast"""
    when, _ = broken[0].arrival()
    rise = [reaction.above(RISEN) for reaction in whole]
    late = [reaction.above(WEIGHT) for reaction in broken]
    measured = (f"wave at {listed(1e3 * when, '.3f')} ms, distance/speed {listed(1e3 * DISTANCES / WAVE, '.3f')} ms; unbroken: 10 kN at "
                f"{listed(1e3 * np.array(rise), '.2f')} ms; with failure: the beam's weight first borne at "
                f"{listed(1e3 * np.array(late), '.1f')} ms")
    arrives = np.all(np.abs(when - DISTANCES / WAVE) < 5e-5)
    return Claim("6a", "concrete-beam: no reaction until the wave arrives, then it rises fast", "30 ms", measured,
                 "no" if not arrives else "yes" if max(late) < 1e-3 else "partly: fast only where nothing breaks")


def order(whole, broken):
    pulses = [reaction.arrival()[1].sum() for reaction in broken]
    peaks, unbroken = ([reaction.peak()[0] / 1e3 for reaction in runs] for runs in (broken, whole))
    measured = (f"at {listed(SPEEDS)} m/s: first pulse {listed(pulses)} N, largest mean over 1 ms {listed(peaks, '.1f')} kN; unbroken "
                f"{listed(unbroken)} kN")
    grow = [np.all(np.diff(values) > 0) for values in (pulses, unbroken, peaks)]
    return Claim("6b", "concrete-beam: higher speed, higher reaction", "yes", measured,
                 "yes" if all(grow) else "partly: not in the beam that breaks" if any(grow) else "no")


def wedge(frames):
    zone = 100 * widths(frames)
    half = ACROSS // 2
    return Claim("6c", "concrete-beam, 2 m/s: the failure is a wedge, wide below", "wedge",
                 f"broken zone from the top layer down {listed(zone)} cm wide",
                 "yes" if zone[:half].mean() > 0 and zone[half:].mean() > 1.1 * zone[:half].mean() else "no")


def spared(slow, fast):
    shares = [100 * over_supports(frames) for frames in (slow, fast)]
    return Claim("6d", "concrete-beam: 2 m/s hardly touches the parts over the supports, 4 m/s does", "contrast",
                 f"bonds broken there {listed(shares, '.1f')} %", "yes" if shares[0] < 2.5 and shares[1] > 3 * shares[0] else "no")


def claims(folder_of):
    broken = [Reaction(folder_of(f"v{speed}")) for speed in SPEEDS]
    whole = [Reaction(folder_of(f"v{speed}-unbroken")) for speed in SPEEDS]
    slow, fast = (dumps.read_run(folder_of(name), "dump.concrete-beam") for name in ("v2", "v4"))
    return [waves(whole, broken), order(whole, broken), wedge(slow), spared(slow, fast)]


if __name__ == "__main__":
    scanning.main(HERE, measure, sys.argv[1:])
