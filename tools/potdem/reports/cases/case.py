# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""What a case of the report consists of."""

import re
import sys
from dataclasses import dataclass, field
from pathlib import Path
from typing import Callable

import numpy as np

from potdem import running

HERE = Path(__file__).resolve().parent
FAILED = None


@dataclass
class Setting:
    """one choice of all knobs. measure(folder, round) -> (seconds, dict of quantities or FAILED)"""

    series: str
    knob: str
    measure: Callable
    peer: bool = False
    reference: bool = False


@dataclass
class Case:
    """errors: quantities of all settings, one per round -> (errors, bars) of each setting; labels: name of an error -> what it is
    of; floors: name -> uncertainty of the reference; remarks: points -> sentences; bundled: points that were not measured now; apart: each
    series gets its own recommendation"""

    name: str
    title: str
    text: str
    series: str
    knob: str
    labels: dict
    settings: list
    errors: Callable
    floors: dict = field(default_factory=dict)
    remarks: Callable = lambda points: []
    bundled: Callable = lambda: []
    apart: bool = False


def lammps(series, knob, script, variables, quantities, loop=False, peer=False):
    """a setting that is a run of LAMMPS. quantities: function of the Run; variables may be a function of the round"""
    def measure(folder, repeat):
        chosen = variables(repeat) if callable(variables) else variables
        done = running.run(script, chosen, folder)
        if not done.ended_well:
            print(f"{series}, {knob}: {done.error or done.stdout[-500:]}", file=sys.stderr, flush=True)
        seconds = done.loop_cpu if loop else done.cpu
        return seconds, quantities(done) if done.ended_well else FAILED

    return Setting(series, knob, measure, peer)


def ending(script, lines):
    """text of a scene's script with other lines in place of its run"""
    text, count = re.subn(r"^run +\$\{steps\} upto$", lines, Path(script).read_text(encoding="utf-8"), flags=re.MULTILINE)
    if count != 1:
        raise ValueError(f"{script} has no line 'run ${{steps}} upto'")
    return text


def critical_step(script, variables, folder):
    """of a scene at its start"""
    text = ending(script, "compute critical all potdem/timestep\nthermo_style custom step c_critical\nrun 0")
    return float(running.must_run(text, variables, folder).thermo["c_critical"][0])


def relative(found, reference):
    return abs(found / reference - 1)


def exact_errors(names, of_one, floors=None):
    """errors of settings that give the same in every round; of_one: quantities -> errors by name; floors: as in Case"""
    def errors(quantities):
        return [(dict.fromkeys(names, np.inf) if runs[0] is FAILED else of_one(runs[0]), floors or {}) for runs in quantities]

    return errors


def integration_and_model(points, names):
    """sentences: which part of the error the step has, where it was swept"""
    lines = []
    for series in dict.fromkeys(p.series for p in points if not p.peer):
        swept = [p for p in points if p.series == series and np.isfinite(p.worst)]
        if len(swept) < 3:
            continue
        finest = swept[-1]
        parts = [f"{100 * max(relative(p.values[name], finest.values[name]) for name in names):.2g} % at {p.knob}" for p in swept[:-1]]
        lines.append(f"{series}: the model's error, at the finest step, is {100 * finest.worst:.2g} %; the step's own, against the finest, "
                     + ", ".join(parts) + ".")
    return lines
