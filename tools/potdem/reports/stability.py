# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Where the method breaks, and whether it says so: extreme cases at fractions of their critical step.

Each case runs three times over: adaptively (fix potdem/timestep), which also tells the critical step and the energies; at
fractions of that step; at the thesis's own step where there is one. A row is sound if the ledger closes and no particle is where
it cannot get. If it is not, the run must have stopped with an error or warned."""

import argparse
import math
import re
import shutil
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from potdem import logs, running
from potdem.reports import stability_cases, stability_page, writing

TERMS = 10
LEDGER_BOUND = 0.1    # of the energy exchanged
ADAPTIVE = 0.1        # fraction of the critical step
MOST_ROWS = 1000
MOST_STEPS = 400000
MARK = "CASE BEGINS"
COLUMNS = "step time dt c_ledger c_ledger[*] v_stray"


@dataclass
class Outcome:
    """one run; label: fraction of the critical step, 'adaptive' or 'thesis'; critical: step; error: ledger's, over the energy
    exchanged; energies: that; sign: (step, what) of the first trouble"""

    case: object
    label: str
    fraction: float
    step: float
    error: float
    message: str
    warnings: list
    sign: tuple
    verdict: str


# --- scripts ----------------------------------------------------------------------------------------------------------

def _observed(case, every, columns=COLUMNS):
    return f"""
compute ledger all potdem/energy
variable stray equal {case.stray}
thermo_style custom {columns}
thermo_modify format float %.12g lost error
thermo {every}
print "{MARK}"
"""


def adaptive_script(case, part):
    most = MOST_STEPS if case.time else 2000
    return case.script + f"compute critical all potdem/timestep\nfix pace all potdem/timestep 1 {ADAPTIVE} max {case.longest}\n" + (
        _observed(case, 2, COLUMNS + " c_critical")
        + f"variable done equal time>={case.time * part or 1e300:.17g}\nfix end all halt 1 v_done != 0 error continue message no\nrun {most}\n")


def fixed_script(case, step, part):
    steps = case.steps * part if case.steps else case.time * part / step
    steps = max(10, min(MOST_STEPS if not case.steps else case.steps, math.ceil(steps)))
    return case.script + f"timestep {step:.17g}\n" + _observed(case, max(1, steps // MOST_ROWS)) + f"run {steps}\n"


# --- what a run shows -------------------------------------------------------------------------------------------------

def our_warnings(output):
    """those of this package, by the source file that LAMMPS names; rates of LAMMPS's own are another matter"""
    return re.findall(r"^WARNING: (.*?) \(\S*potdem\S*:\d+\)$", output, re.MULTILINE)


def table(output):
    """thermo output behind the mark; None where the run did not come that far"""
    try:
        return logs.thermo(output.split(MARK, 1)[1])
    except (IndexError, logs.LogError):
        return None


def exchanged(thermo, least=0.0):
    """the largest kinetic energy, or the largest amount of energy that changed its kind since the start"""
    terms = np.array([thermo[f"c_ledger[{k}]"] for k in range(1, TERMS + 1)])
    moved = 0.5 * np.abs(terms - terms[:, :1]).sum(axis=0)
    return max(float(np.nanmax(moved)), float(np.nanmax(terms[0])), least)


def ledger_error(thermo, scale):
    """of every row; infinite where it is no number"""
    total = thermo["c_ledger"]
    with np.errstate(over="ignore", invalid="ignore"):
        error = np.abs(total - total[0]) / scale
    return np.where(np.isfinite(error), error, np.inf)


def step_named(text, otherwise=0):
    match = re.search(r"(?:on|at) step (\d+)", text)
    return int(match.group(1)) if match else otherwise


def first_sign(thermo, errors, warnings, message):
    """(step, what) of the first trouble, or None"""
    signs, last = [(step_named(text), "warning") for text in warnings], 0
    if thermo is not None:
        last = int(thermo["Step"][-1])
        steps = thermo["Step"].astype(int)
        signs += [(steps[k], "energy ledger") for k in np.flatnonzero(errors > LEDGER_BOUND)[:1]]
        signs += [(steps[k], "particle astray") for k in np.flatnonzero(thermo["v_stray"] != 0)[:1]]
    if message:
        signs.append((step_named(message, last), "error"))
    order = {"warning": 0, "error": 1}
    return min(signs, key=lambda sign: (sign[0], order.get(sign[1], 2))) if signs else None


def verdict(is_sound, warnings, message):
    """of a run: stops, right, right with a warning, warns, or silent nonsense"""
    if message:
        return "stops"
    if is_sound:
        return "right, warns" if warnings else "right"
    return "warns" if warnings else "SILENT NONSENSE"


def judge(case, label, fraction, step, done, scale):
    thermo = table(done.stdout)
    message = None if done.ended_well else (done.error or f"exit status {done.status}")
    warnings = our_warnings(done.stdout)
    errors = np.array([np.inf]) if thermo is None else ledger_error(thermo, scale)
    is_sound = thermo is not None and errors.max() <= LEDGER_BOUND and not np.any(thermo["v_stray"] != 0)
    return Outcome(case, label, fraction, step, float(errors.max()), message, warnings,
                   first_sign(thermo, errors, warnings, message), verdict(is_sound, warnings, message))


# --- runs -------------------------------------------------------------------------------------------------------------

def run_case(case, folder, short):
    """outcomes: adaptive, fractions, thesis"""
    part = case.short if short else 1.0
    done = running.run(adaptive_script(case, part), {}, folder / "adaptive", limit=300)
    thermo = table(done.stdout)
    scale, critical = case.scale, case.critical
    if thermo is not None:
        scale = exchanged(thermo, case.scale)
        critical = critical or float(thermo["c_critical"].min())
    outcomes = [judge(case, "adaptive", ADAPTIVE, None, done, scale or 1.0)]
    if critical is None:
        sys.exit(f"{case.name}: no critical step, see {folder}")
    steps = [(f"{f:g}", f, f * critical) for f in case.fractions]
    if case.thesis:
        steps.append(("thesis", case.thesis / critical, case.thesis))
    for label, fraction, step in steps:
        done = running.run(fixed_script(case, step, part), {}, folder / label, limit=300)
        mine = table(done.stdout)
        outcomes.append(judge(case, label, fraction, step, done, scale or (exchanged(mine) if mine else 1.0)))
    return outcomes


def run_all(cases, folder, short):
    def one(numbered):
        number, case = numbered
        outcomes = run_case(case, folder / f"{number:02d}", short)
        print(f"{case.group}: {case.name}: " + ", ".join(f"{o.label} {o.verdict} {o.error:.2g}" for o in outcomes), flush=True)
        return outcomes

    with ThreadPoolExecutor(2) as pool:
        return [outcome for outcomes in pool.map(one, enumerate(cases)) for outcome in outcomes]


def main():
    parser = argparse.ArgumentParser(prog="tools/report stability", description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("--short", action="store_true", help="a few minutes, to build/report/")
    parser.add_argument("--only", default="", help="cases whose name has this text, no report is written")
    parser.add_argument("--keep", help="folder for the runs")
    choice = parser.parse_args()
    folder = Path(choice.keep or tempfile.mkdtemp())
    cases = [case for case in stability_cases.cases() if choice.only in f"{case.group}: {case.name}"]
    outcomes = run_all(cases, folder, choice.short)
    if not choice.only:
        stability_page.write(writing.folder(choice.short), outcomes, stability_page.more_rows(folder, choice.short), choice.short,
                             LEDGER_BOUND)
    if not choice.keep:
        shutil.rmtree(folder)
    return sum(outcome.verdict == "SILENT NONSENSE" for outcome in outcomes) > 0


if __name__ == "__main__":
    sys.exit(main())
