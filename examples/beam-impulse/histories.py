"""Deflection of the loaded section against time: references and runs of LAMMPS."""

from dataclasses import dataclass
from pathlib import Path

import case
import logfile
import numpy as np
import timoshenko
from scipy.optimize import minimize

HERE = Path(__file__).resolve().parent
FIRST_SWING = 0.007    # s, well after the first maximum, well before the beam swings back
PULSE_OVER = 0.002     # s


@dataclass
class History:
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


def calculix(model, pulse):
    table = np.loadtxt(HERE / "calculix" / f"{model}-{pulse}.csv", delimiter=",", skiprows=1)
    return History(f"CalculiX {model}", *table.T)


def modal(clamp, pulse):
    beam = timoshenko.Beam(case.CLAMPS[clamp][0], case.WIDTH, case.DEPTH, case.MODULUS, case.POISSON, case.DENSITY)
    time = np.linspace(0, case.TIME, 1501)
    return History(f"Timoshenko {clamp}", time,
                   timoshenko.deflection(beam, case.CLAMPS[clamp][1], case.FORCE, case.PULSES[pulse], time))


def lammps(log):
    """the pulse and the history of a run, which is named <pulse>-<area mode>-<r_infl over d>"""
    pulse, area, reach = log.name.split(".beam-impulse.")[1].split(".g++")[0].split("-")
    table = logfile.read_thermo(log)
    return pulse, History(f"LAMMPS, {area}, {float(reach):g} d", table["Time"], table["v_deflection"])
