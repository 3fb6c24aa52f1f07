# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""The runs of the report of grains: heaps and discharge, with POTDEM and with LAMMPS's pair_style granular with the same laws."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy.optimize import brentq

from potdem import dumps, formulas, heaps, logs, running
from potdem.reports.cases.case import HERE

STYLES = ("potdem", "granular")
ROLLING = {0.0: 10, 0.2: 5}    # coefficient: draws
# what else is changed in heaps of POTDEM without rolling resistance
CHANGED = {
    "$E$ = 0.5 MPa": {"E": 5e5, "dt": 1e-4},
    "$E$ = 50 MPa": {"E": 5e7, "dt": 2e-5},
    "friction 0.25": {"mu": 0.25},
    "friction 1": {"mu": 1.0},
    "restitution 0.2": {"e": 0.2},
    "restitution 0.8": {"e": 0.8},
}
WIDTHS = (5, 7, 9)
WIDTH_OF_BOTH = 7    # at which the slot is run with both styles

# as in.heap and in.slot have them
D, DENSITY, NU, RESTITUTION, XI, RATIO = 0.01, 2500.0, 0.3, 0.5, 0.3, 0.5
CELL = 1.1 * D    # each with a grain of the base
ACROSS, LONG = 6 * CELL, 18 * CELL
SLOT_DEEP = 6 * D
FLOW, REST = 3.4, 0.6    # s, before the first measurement and between the two
EMPTIES = (0.92, 0.5)    # shares in the bin between which the rate is measured


@dataclass
class Heap:
    """one run; changed: a name of CHANGED, or nothing; angles, degrees: of the surface after the flow and after the rest, by volume after
    the rest; grains: in the box, after the flow, after the rest; moved: the farthest that a grain went during the rest, m; cpu: s"""

    style: str
    rolling: float
    seed: int
    changed: str
    angle: float
    later: float
    by_volume: float
    start: int
    grains: int
    stay: int
    moved: float
    cpu: float
    folder: Path


@dataclass
class Discharge:
    """one run; width in grains; rate, kg/s; bends: largest deviation of the mass from a line over the mass; density, kg/m^3; time
    since the slot is open, s, and mass in the bin, kg"""

    style: str
    width: int
    seed: int
    rate: float
    bends: float
    density: float
    cpu: float
    time: np.ndarray
    mass: np.ndarray


# --- the same laws in LAMMPS's terms ----------------------------------------------------------------------------------

def damping_ratio(restitution):
    """fraction of critical damping of a dashpot that may not pull: ln e = -2 zeta acos(zeta)/sqrt(1 - zeta^2)"""
    return brentq(lambda zeta: 2 * zeta * np.arccos(zeta) / np.sqrt(1 - zeta**2) + np.log(restitution), 0.0, 1 - 1e-9)


def in_lammps_terms(stiffness):
    """variables of in.heap for LAMMPS's granular. stiffness: dF/dw for which its rolling spring, a constant, is that of POTDEM"""
    zeta = damping_ratio(RESTITUTION)
    mass = formulas.sphere_mass(D, DENSITY)
    spring = RATIO * stiffness
    tangential = 2 * (1 - NU) / (2 - NU)
    return {
        # LAMMPS takes ln e = -pi zeta/sqrt(1 - zeta^2), that of a dashpot that pulls as well
        "e_gran": np.exp(-np.pi * zeta / np.sqrt(1 - zeta**2)),
        # 2 xi sqrt(k_t 2/7 m) over sqrt(5) zeta sqrt(2/3 m dF/dw)
        "xt": 2 * XI * np.sqrt(tangential * 2 / 7) / (zeta * np.sqrt(10 / 3)),
        "k_roll": spring,
        # 2 xi sqrt(k m_r), 1/m_r = R^2 (1/I + 1/I), of two grains of the mean size
        "g_roll": 2 * XI * np.sqrt(spring * 0.8 * mass),
    }


def stiffness_of(folder):
    """(mean dF/dw, mean overlap) of the contacts of a heap"""
    contacts = dumps.read(folder / "contacts.dump")[-1]
    touches = contacts["c_contacts[1]"] > 0
    return float(contacts["c_contacts[2]"][touches].mean()), float(contacts["c_contacts[1]"][touches].mean())


# --- runs -------------------------------------------------------------------------------------------------------------

def grains_of(frame):
    """without the fixed ones"""
    chosen = frame["type"] == 1
    return dumps.Frame(frame.step, {name: values[chosen] for name, values in frame.items()})


def slope(frame):
    """(angle, height at x = 0, slope) of the surface, the base included"""
    return heaps.slope(*heaps.surface(frame, ACROSS, CELL, LONG), D)


def farthest(before, after):
    """the longest way of a grain that is in both frames"""
    _, first, second = np.intersect1d(before["id"], after["id"], return_indices=True)
    ways = np.array([after[axis][second] - before[axis][first] for axis in "xyz"])
    ways[1] -= ACROSS * np.round(ways[1] / ACROSS)
    return float(np.linalg.norm(ways, axis=0).max())


def heap(style, rolling, seed, folder, times, changed="", **more):
    given = {"style": style, "rolling": rolling, "seed": seed, **times, **CHANGED.get(changed, {}), **more}
    done = running.must_run(HERE / "in.heap", given, folder)
    frames = [dumps.read(folder / f"{name}.dump")[-1] for name in ("box", "heap", "later")]
    angles = [slope(frame)[0] for frame in frames[1:]]
    box, before, after = (grains_of(frame) for frame in frames)
    solid = heaps.solid_fraction(box, ACROSS, LONG, 3 * D, 12 * D)
    by_volume = heaps.slope(*heaps.filled(after, ACROSS, CELL, LONG, solid), D)[0]
    print(f"heap: {style}, rolling {rolling:g}, seed {seed} {changed}: {angles[1]:.1f} degrees, {done.cpu:.0f} s", flush=True)
    counts = [len(frame["x"]) for frame in (box, before, after)]
    return Heap(style, rolling, seed, changed, *angles, by_volume, *counts, farthest(before, after), done.cpu, folder)


def all_heaps(most, work, times):
    """(heaps, (stiffness, overlap) of the contacts of the first of them). most: draws"""
    first = heap("potdem", 0.0, 1, work / "first", times)
    contact = stiffness_of(first.folder)
    terms = in_lammps_terms(contact[0])
    chosen = [(style, rolling, seed) for rolling, draws in ROLLING.items() for seed in range(1, min(draws, most) + 1)
              for style in STYLES]
    return [first] + [heap(*what, work / "-".join(map(str, what)), times, **terms) for what in chosen[1:]], contact


def changed_heaps(seeds, work, times):
    return [heap("potdem", 0.0, seed, work / f"changed-{number}-{seed}", times, what)
            for number, what in enumerate(CHANGED) for seed in seeds]


def discharge(style, width, seed, folder, more):
    done = running.must_run(HERE / "in.slot", {"style": style, "wide": width, "seed": seed, **more}, folder, log="log.slot")
    given = {name: float(value) for name, value in logs.parameters(done.log).items()}
    open_ = done.thermo["Time"] >= given["opened"]
    time, mass = done.thermo["Time"][open_] - given["opened"], done.thermo["c_inside"][open_]
    rate, bends = heaps.rate(time, mass, *EMPTIES)
    print(f"slot: {style}, {width} grains, seed {seed}: {rate:.3f} kg/s, {done.cpu:.0f} s", flush=True)
    return Discharge(style, width, seed, rate, bends, given["density"], done.cpu, time, mass)


def all_discharges(seeds, work):
    terms = {name: value for name, value in in_lammps_terms(1.0).items() if name in ("e_gran", "xt")}
    chosen = [("potdem", width) for width in WIDTHS] + [("granular", WIDTH_OF_BOTH)]
    return [discharge(style, width, seed, work / f"slot-{style}-{width}-{seed}", terms)
            for seed in seeds for style, width in chosen]
