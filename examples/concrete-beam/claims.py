# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Claim 6 measured: when the wave reaches the supports, how large the reaction gets, which part of the beam is broken.

  claims.py FOLDER ...                     of examples/run: build/examples/concrete-beam/<variant>.np<ranks>
  claims.py NAME=VALUE[,VALUE ...] ...     new runs, e.g. claims.py speed=2,4 damping=0,0.02,0.05 time=0.1

For each run: when the wave arrives at the left and at the right support, and the height of its pulse; when the reaction of both
supports passes the beam's weight, 5 and 10 kN; the largest, as the mean over 1 ms, and when; the width of the broken zone from the
top layer of particles to the bottom layer at 0.05 s; at 0.1 s the share of broken bonds in the parts over the supports; the pieces
of 20 particles and more; the median acceleration of the hammer where nothing touches it.
"""

import sys
from pathlib import Path

import numpy as np
from scipy.spatial import cKDTree

from potdem import dumps
from potdem.scenes import scanning
from potdem.scenes.claim import Claim, of_draws

HERE = Path(__file__).resolve().parent

SPACING, ACROSS, SUPPORT = 0.035, 8, 17 * 0.035    # m, particles, m: d, n, X of in.concrete-beam
HAMMER = np.array([-3.5, 4.5]) * SPACING           # m, its faces
WAVE = np.sqrt(3e10 / 2300)                        # m/s, along a bar
DISTANCES = np.array([HAMMER[0] + SUPPORT, SUPPORT - HAMMER[1]])
PULSE_ENDS = 3e-4    # s: after the first pulse the ends of the beam lift off
OVER = ACROSS / 2 * SPACING    # m: so near to a support is over it
PIECE = 20           # particles: less is debris
SPEEDS = (2, 4, 6, 8)          # m/s
DRAWS = (1, 2, 3)              # of the places
WEIGHT, RISING, RISEN = 2.17e3, 5e3, 1e4    # N; the first is that of the beam
QUIET, QUICK = (0.02, 0.045), 1e-3          # s: about 30 ms; a quick rise from RISING to RISEN
WEDGE = 1.1                    # lower half of the zone over its upper half
MARGINAL, CONTRAST = 10.0, 3.0    # per cent of the bonds; 4 m/s over 2 m/s
GRAVITY, CLEAR = 9.81, 1.01    # m/s^2; spacings: what is farther away does not touch


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
        """the first time that both together are above a force, or infinity"""
        above = self.force.sum(axis=1) > limit
        return self.time[np.argmax(above)] if above.any() else np.inf


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


def falls(frames):
    """acceleration of the hammer over g from frame to frame where no particle of the beam touches it in either"""
    last, found = None, []
    for frame in frames:
        hammer = frame["type"] == 2
        if not hammer.any():
            break
        points = np.column_stack([frame[name] for name in "xyz"])
        gap = cKDTree(points[~hammer]).query(points[hammer])[0].min() / SPACING
        now = frame["time"], frame["vz"][hammer].mean(), gap
        if last and min(last[2], gap) > CLEAR:
            found.append((last[1] - now[1]) / (now[0] - last[0]) / GRAVITY)
        last = now
    return np.array(found)


def measure(folder):
    frames, reaction = dumps.read_run(folder, "dump.concrete-beam"), Reaction(folder)
    when, pulse = reaction.arrival()
    peak, at_peak = reaction.peak()
    zone = " ".join(f"{100 * width:.0f}" for width in widths(frames))
    free = falls(frames)
    return (f"arrives {1e3 * when[0]:.3f} {1e3 * when[1]:.3f} ms, {pulse[0]:.0f} {pulse[1]:.0f} N; {WEIGHT / 1e3:.1f}, {RISING / 1e3:.0f}, "
            f"{RISEN / 1e3:.0f} kN at {listed([1e3 * reaction.above(force) for force in (WEIGHT, RISING, RISEN)], '.1f')} ms; peak "
            f"{peak / 1e3:.1f} kN at {1e3 * at_peak:.1f} ms; zone {zone} cm; over supports {100 * over_supports(frames):.1f} %; pieces "
            f"{pieces(frames)}; hammer in the air " +
            (f"{np.median(free):.3f} g, {np.sum(np.abs(free - 1) < 0.01)} of {len(free)} within 1 %"
             if len(free) else "never"))


def listed(values, form=".0f"):
    return ", ".join(f"{value:{form}}" for value in values)


def ranged(draws, form=".0f"):
    """'lowest to highest' of what the draws give, or one number if they look the same"""
    ends = [f"{value:{form}}" if np.isfinite(value) else "never" for value in (min(draws), max(draws))]
    return " to ".join(ends) if ends[0] != ends[1] else ends[0]


def each(runs, what, form=".0f"):
    """for each speed, the range over its draws"""
    return ", ".join(ranged([what(reaction) for reaction in draws], form) for draws in runs)


def quiet(reaction):
    """nothing but the first pulse for about 30 ms, then a quick rise"""
    return QUIET[0] < reaction.above(WEIGHT) < QUIET[1] and reaction.above(RISEN) < reaction.above(RISING) + QUICK


def waves(whole, broken):
    arrivals = np.array([reaction.arrival()[0] for draws in broken for reaction in draws])
    late = [np.all([quiet(reaction) for reaction in draws]) for draws in broken]
    early = " and ".join(f"{speed}" for speed, holds in zip(SPEEDS, late) if not holds)
    pulses = [reaction.arrival()[1].sum() / 1e3 for draws in broken for reaction in draws]
    measured = (f"at {listed(SPEEDS)} m/s: wave at {ranged(1e3 * arrivals[:, 0], '.3f')} and {ranged(1e3 * arrivals[:, 1], '.3f')} ms "
                f"(distance/speed {listed(1e3 * DISTANCES / WAVE, '.3f')} ms) with {ranged(pulses, '.1f')} kN; the weight of the beam is "
                f"reached at {each(broken, lambda r: 1e3 * r.above(WEIGHT), '.1f')} ms, 10 kN at "
                f"{each(broken, lambda r: 1e3 * r.above(RISEN), '.1f')} ms; unbroken: 10 kN at "
                f"{each(whole, lambda r: 1e3 * r.above(RISEN), '.2f')} ms")
    arrives = np.all(np.abs(arrivals - DISTANCES / WAVE) < 5e-5)
    return Claim("6a", "concrete-beam: practically no reaction for about 30 ms, then it rises very quickly", "30 ms", measured,
                 "no" if not arrives or not any(late) else "yes" if all(late) else
                 f"partly: at {early} m/s the beam bursts, and its pieces press on the supports sooner")


def order(whole, broken):
    measured = (f"at {listed(SPEEDS)} m/s: first pulse {each(broken, lambda r: r.arrival()[1].sum())} N; unbroken, largest mean over 1 ms "
                f"{each(whole, lambda r: r.peak()[0] / 1e3)} kN. Later, apart from the claim: "
                f"{each(broken, lambda r: r.peak()[0] / 1e3)} kN")
    draws = [[draws[k].arrival()[1].sum() for draws in broken] for k in range(len(broken[0]))] + [[runs[0].peak()[0] for runs in whole]]
    return Claim("6b", "concrete-beam: higher speed, higher reaction, at the beginning", "yes", measured,
                 of_draws(np.all(np.diff(values) > 0) for values in draws))


def wedge(draws):
    zones = [100 * widths(frames) for frames in draws]
    half = ACROSS // 2
    layers = ", ".join(ranged(layer) for layer in zip(*zones))
    return Claim("6c", "concrete-beam, 2 m/s: the failure is a wedge, wide below", "wedge",
                 f"broken zone from the top layer down {layers} cm wide",
                 of_draws(zone[:half].mean() > 0 and zone[half:].mean() > WEDGE * zone[:half].mean() for zone in zones))


def spared(slow, fast):
    shares = [[100 * over_supports(frames) for frames in draws] for draws in (slow, fast)]
    return Claim("6d", "concrete-beam: 2 m/s hardly touches the parts over the supports, 4 m/s does", "contrast",
                 f"bonds broken there {ranged(shares[0], '.1f')} %, {ranged(shares[1], '.1f')} %",
                 of_draws(one < MARGINAL and other > CONTRAST * one for one, other in zip(*shares)))


def claims(folder_of):
    """for the table of examples/run all"""
    broken = [[Reaction(folder_of(f"v{speed}", draw)) for draw in DRAWS] for speed in SPEEDS]
    whole = [[Reaction(folder_of(f"v{speed}-unbroken"))] for speed in SPEEDS]
    slow, fast = ([dumps.read_run(folder_of(name, draw), "dump.concrete-beam") for draw in DRAWS] for name in ("v2", "v4"))
    return [waves(whole, broken), order(whole, broken), wedge(slow), spared(slow, fast)]


if __name__ == "__main__":
    scanning.main(HERE, measure, sys.argv[1:])
