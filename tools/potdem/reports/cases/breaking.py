# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Bodies that break, beside the same with a sixteenth of a step: trajectories until the first break, then bulk quantities over
several draws of the diameters."""

import numpy as np
from scipy.interpolate import CubicSpline

from potdem import logs
from potdem.paths import EXAMPLES
from potdem.reports.cases.bulk import against_reference, seeded
from potdem.reports.cases.case import Case, critical_step, ending, lammps
from potdem.text import replaced

# the scenes' own output costs more than their steps; pieces are counted at the end only
RUN = """thermo_style custom step time {columns} v_broken v_fracture
thermo_modify line one format float %.12g lost ignore lost/bond ignore
thermo {every}
{run}
thermo_style custom step v_pieces
thermo_modify lost ignore lost/bond ignore
run 0 post no"""
PACE = """fix pace all potdem/timestep 20 {fraction} max {longest}
variable late equal time
fix stop all halt 10 v_late > ${{time}} error continue message no
run 1000000000"""
BULK = ("broken", "fracture")
APART = 0.01    # of the range of a motion


def quantities_of(columns):
    """function of a run: the histories of some columns and what is left at the end"""
    def quantities(run):
        history, end = run.stdout.rsplit("v_pieces", 1)
        thermo = logs.thermo(history.rsplit("\n", 1)[0])
        return {"time": thermo["Time"], "broken so far": thermo["v_broken"], "paths": [thermo[column] for column in columns],
                "broken": thermo["v_broken"][-1], "fracture": thermo["v_fracture"][-1], "pieces": float(end.split()[1])}

    return quantities


def deviation(found, known):
    """time, and the largest deviation from the reference's motions there, over their range so far"""
    times = found["time"][found["time"] <= known["time"][-1]]
    worst = np.zeros_like(times)
    for path, wanted in zip(found["paths"], known["paths"]):
        exact = CubicSpline(known["time"], wanted)(times)
        size = np.maximum.accumulate(exact) - np.minimum.accumulate(exact)
        worst = np.maximum(worst, np.maximum.accumulate(np.abs(path[: times.size] - exact)) / np.maximum(size, 1e-3 * size[-1]))
    return times, worst


def path_error(found, known):
    """largest deviation until something breaks in either"""
    whole = min(run["time"][run["broken so far"] == 0][-1] for run in (found, known))
    times, worst = deviation(found, known)
    return float(worst[times <= whole][-1])


def partings(settings, quantities):
    """sentence: how long, in the mean, each setting stays near the reference"""
    parts = []
    for setting, runs in zip(settings[:-1], quantities):
        if all(runs):
            ends = [times[worst < APART][-1] for times, worst in (deviation(*pair) for pair in zip(runs, quantities[-1]))]
            parts.append(f"{setting.series}, {setting.knob}: {1e3 * np.mean(ends):.3g} ms")
    return f"The motion is within {100 * APART:g} % of the reference's until, in the mean, " + "; ".join(parts) + "."


def pieces(settings, quantities):
    """sentence: few, so that a relative error would say little"""
    counts = [", ".join(f"{run['pieces']:.0f}" for run in runs) if all(runs) else "failed" for runs in quantities]
    parts = [f"{setting.series}, {setting.knob}: {count}" for setting, count in zip(settings, counts)]
    return "Pieces at the end, draw by draw: " + "; ".join(parts) + "."


def breaking(name, title, text, scene, settings, columns, variables, every, folder):
    """settings: steps in s, the reference last, or words 'fraction longest' of fix potdem/timestep; every: s between outputs"""
    script = EXAMPLES / scene / f"in.{scene}"
    critical = critical_step(script, variables, folder / "critical")
    made, seen = [], []
    for setting in settings:
        if isinstance(setting, str):
            fraction, longest = setting.split()
            series, knob = "fix potdem/timestep", f"{fraction} of the critical step, at most {1e6 * float(longest):g} µs"
            step, run = float(longest), PACE.format(fraction=fraction, longest=longest)
        else:
            series, knob = "constant step", f"{1e6 * setting:g} µs = {setting / critical:.2g} Δt_c"
            step, run = setting, "run ${steps}"
        lines = RUN.format(columns=" ".join(columns), every=max(1, round(every / step)), run=run)
        made.append(lammps(series, knob, ending(script, lines), seeded({**variables, "dt": step}), quantities_of(columns)))
    made[-1].reference = True
    labels = {"path": "the motion before the first break", "broken": "the number of broken bonds", "fracture": "the fracture energy"}

    def errors(quantities):
        seen.extend([partings(made, quantities), pieces(made, quantities)])
        return against_reference(BULK, {"path": path_error})(quantities)

    reading = replaced(READING, "{motion}", ", ".join(column[2:] for column in columns))
    return Case(name, title, text + "\n\n" + reading, "step", "value", labels, made, errors, remarks=lambda points: seen)


READING = """Reference: {reference}. *Motion*: of {motion}; largest deviation, over its range, until something breaks in
either run. After that single paths are chaotic, and means over the draws of the diameters, one a round, are compared."""

BEAM_TEXT = """Scene [beam-impact](../../examples/beam-impact/README.md), position {position}, {time} s, with less output."""
CYLINDER_TEXT = """Scene [cylinder-impact](../../examples/cylinder-impact/README.md), strength 1 MPa, {time} s. Here the contact with the
rigid plane sets the step, and there is none at the start: $\\Delta t_c$ is that of the bonds."""


def beam_impact(speed):
    def make(short, folder):
        time = 0.15 if short else 0.3
        settings = [4e-5, 2e-5, "0.4 6e-5", 1e-5] if short else [6e-5, 4e-5, 2e-5, 1e-5, "0.8 6e-5", "0.4 6e-5", "0.2 6e-5", 2.5e-6]
        return breaking(f"beam-impact-{speed}", f"A block breaks a beam, {speed} m/s (beam-impact i-{speed})",
                        BEAM_TEXT.format(position=f"i, {speed} m/s", time=time), "beam-impact", settings, ("v_middle", "v_tip", "v_block"),
                        {"position": "i", "speed": speed, "time": time, "picture": "no"}, 1e-4, folder)

    return make


def cylinder_impact(short, folder):
    time = 0.3 if short else 0.5
    settings = [2e-4, 1e-4, "0.4 2e-3", 5e-5] if short else [4e-4, 2e-4, 1e-4, 5e-5, "0.8 2e-3", "0.4 2e-3", "0.2 2e-3", 1.25e-5]
    return breaking("cylinder-impact", "A cylinder breaks on a plane (cylinder-impact)", CYLINDER_TEXT.format(time=time),
                    "cylinder-impact", settings, ("v_height", "v_speed"), {"strength": 1e6, "time": time, "picture": "no"}, 5e-4, folder)
