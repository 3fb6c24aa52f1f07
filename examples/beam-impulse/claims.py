# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Claim 1 measured: deflection and period against finite elements.

  claims.py [LOG ...]      default: the reference logs in this folder

For each pulse: first peak and period of the references and of the runs, and their deviations, in per cent, from
CalculiX's plane stress with the clamp midway between the last clamped and the first free layer of particles, and with the
clamp in the last clamped layer.
"""

import sys
from pathlib import Path

from potdem import struck_beam
from potdem.scenes.claim import Claim

HERE = Path(__file__).resolve().parent

MODELS = ("2d", "3d", "2d-linear", "2d-layer")
AREAS = {"body": "area body", "lattice": "lattice", "factor": "factor 0.4 (the thesis)"}


def numbers(history):
    return history.peak, history.period


def deviations(found, reference):
    """of peak and period, in per cent"""
    return [100 * (value / expected - 1) for value, expected in zip(found, reference)]


def report(runs):
    """a table for each pulse"""
    for pulse in struck_beam.PULSES:
        known = [struck_beam.calculix(model, pulse) for model in MODELS]
        known += [struck_beam.modal(clamp, pulse) for clamp in struck_beam.CLAMPS]
        found = {history.label: numbers(history) for history in known + [h for which, h in runs if which == pulse]}
        half, layer = found["CalculiX 2d"], found["CalculiX 2d-layer"]
        print(f"\n{pulse:32} peak [mm]  period [ms]   from 2d: peak  period   from 2d-layer: peak  period")
        for label, values in found.items():
            print(f"{label:32} {1e3 * values[0]:9.3f} {1e3 * values[1]:12.4f} %15.2f %7.2f %20.2f %7.2f"
                  % (*deviations(values, half), *deviations(values, layer)))


def claims(folder_of):
    """for the table of examples/run all"""
    worst, texts = {}, []
    for area, name in AREAS.items():
        pairs = []
        for pulse in struck_beam.PULSES:
            _, history = struck_beam.lammps(next(folder_of(f"{pulse}-{area}-2.00").glob("log*")))
            pairs.append(deviations(numbers(history), numbers(struck_beam.calculix("2d", pulse))))
        worst[area] = max(abs(value) for pair in pairs for value in pair)
        texts.append(f"{name} {pairs[0][0]:+.1f}, {pairs[1][0]:+.1f} % and {pairs[0][1]:+.1f}, {pairs[1][1]:+.1f} %")
    measured = "peak (two pulses) and period off by: " + "; ".join(texts)
    verdict = "yes" if worst["body"] < 5 else "no"
    return [Claim("1", "beam-impulse: deflection and period agree with finite elements", "satisfactory", measured, verdict)]


if __name__ == "__main__":
    logs = [Path(name) for name in sys.argv[1:]] or sorted(HERE.glob("log.*.g++.1"))
    report([struck_beam.lammps(log) for log in logs])
