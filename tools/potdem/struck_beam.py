# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""The struck cantilever of the scene beam-impulse: its data, and the deflection of the loaded section against time by finite
elements, as a sum over modes and in runs of LAMMPS."""

from dataclasses import dataclass

import numpy as np
from scipy.optimize import minimize

from potdem import beams, logs
from potdem.paths import EXAMPLES

WIDTH = DEPTH = 0.025    # m
MODULUS, POISSON, DENSITY = 5e9, 0.1, 2400.0
FORCE = 1000.0           # N
TIME = 0.03              # s, three periods

# (length, place of the load) from the clamp. half: the clamp acts midway between the last clamped and the first free
# layer of particles; layer: in the last clamped layer. The load acts on the last layer, half a spacing before the end.
CLAMPS = {"half": (0.24, 0.2375), "layer": (0.2425, 0.24)}

# steps and changes of slope: (time, step, change of slope) over the force
PULSES = {"f1": [(0.0, 1.0, 0.0), (1e-3, -1.0, 0.0)],
          "f2": [(0.0, 0.0, 1e3), (1e-3, 0.0, -2e3), (2e-3, 0.0, 1e3)]}

CALCULIX = EXAMPLES / "beam-impulse" / "calculix"    # results of finite elements
FIRST_SWING = 0.007    # s, well after the first maximum, well before the beam swings back
PULSE_OVER = 0.002     # s


@dataclass
class History:
    """time (s) and deflection (m): arrays of the same length"""

    label: str
    time: np.ndarray
    deflection: np.ndarray

    @property
    def peak(self):
        """largest deflection of the first swing, m"""
        return float(np.max(self.deflection[self.time < FIRST_SWING]))

    @property
    def period(self):
        """of the fundamental, s: least squares over the free vibration, together with the second mode"""
        free = self.time >= PULSE_OVER
        time, deflection = self.time[free], self.deflection[free] / self.peak

        def misfit(frequencies):
            waves = np.column_stack([wave(2 * np.pi * f * time) for f in frequencies for wave in (np.cos, np.sin)])
            return np.sum((deflection - waves @ np.linalg.lstsq(waves, deflection, rcond=None)[0]) ** 2)

        guesses = [(f, 6 * f) for f in np.geomspace(60, 220, 40)]
        start = min(guesses, key=misfit)
        return 1 / minimize(misfit, start, method="Nelder-Mead", options={"xatol": 1e-4, "fatol": 1e-12}).x[0]


def beam(length, depth=DEPTH):
    """Timoshenko's, from the clamp to its end; square if it has another depth"""
    return beams.Beam(length, depth, depth, MODULUS, POISSON, DENSITY)


def calculix(model, pulse):
    table = np.loadtxt(CALCULIX / f"{model}-{pulse}.csv", delimiter=",", skiprows=1)
    return History(f"CalculiX {model}", *table.T)


def modal(clamp, pulse):
    length, loaded = CLAMPS[clamp]
    time = np.linspace(0, TIME, 1501)
    return History(f"Timoshenko {clamp}", time, beams.deflection(beam(length), loaded, FORCE, PULSES[pulse], time))


def lammps(log):
    """the pulse and the history of a run, which is named <pulse>-<area mode, or nu>-<r_infl over d>"""
    pulse, area, reach = log.name.split(".beam-impulse.")[1].split(".g++")[0].split("-")
    table = logs.read_thermo(log)
    mode = "area body, ν 0.1" if area == "nu" else f"area {area}"
    return pulse, History(f"LAMMPS, {mode}, {float(reach):g} d", table["Time"], table["v_deflection"])
