# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""The field's own race: the report of tools/report race.

  tools/report race [--short] [--case NAME] [--keep FOLDER]

Two cases of M. Dosta and others, Computer Physics Communications 296, 2024, 109066, at a size for one core: a silo that discharges, with
two materials, and a ball that strikes a bed. POTDEM, LAMMPS's pair_style granular and YADE, if it is installed, run each from the same
packing with the same laws, on one core and on two. Writes race.md and race.csv and, for each case, race-<case>.png and race-<case>.csv to
docs/report/, or with --short, few steps, and --case, one of them, to build/report/. --keep: where packings, logs and outcomes stay; what is
there already is not run again."""

import argparse
import dataclasses
import os
import sys
import tempfile
from dataclasses import dataclass, field
from pathlib import Path
from typing import Callable

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

from potdem.paths import ROOT  # noqa: E402
from potdem.reports import writing  # noqa: E402
from potdem.reports.race_programs import MATERIALS, PROGRAMS, Material, Outcome, missing_yade, settle  # noqa: E402

WHOLE, OTHER_LISTS, ON_TWO = "one core", "other lists", "two cores"    # runs of a program
PART = 0.1                                                           # of the time, on two cores
COLOURS = {"POTDEM": "#c23b22", "LAMMPS granular": "#1f6fb4", "YADE": "#3a8f3a"}


@dataclass
class Case:
    """bulk: silo or ball; material: of the grains; variables: of the script, for every run; settling: those of the runs that make the
    packing, one after the other; column: of the thermo output; every: s between two rows; curve: values -> what is drawn, called
    quantity and measured in unit; grains: their number at the start; skin: of the scripts' neighbour lists, m"""

    name: str
    title: str
    text: str
    bulk: str
    material: Material
    column: str
    every: float
    variables: dict
    settling: list
    curve: Callable
    quantity: str
    unit: str
    grains: int
    skin: float
    found: dict = field(default_factory=dict)    # (program, run) -> Outcome

    @property
    def script(self):
        return f"in.{self.bulk}"


SILO_TEXT = """{grains} grains ({material}) of radius 2 mm in a silo of radius 100 mm, with a funnel that is 70 mm high and ends in an outlet
of radius 30 mm; the lid on the outlet is gone at the start, and {time} s follow. The moduli of grains and steel are divided by {softer},
and the step is {dt} s in place of 1.5·10⁻⁶ s: with the moduli as they are, the same time would take {times} times as many steps.
*Curve*: grains above the outlet."""

BALL_TEXT = """A ball of steel, radius 10 mm, meets the top of a bed of {grains} grains (M1) of radius 2 mm with 5 m/s; box of 80 × 80 mm,
moduli as they are, step {dt} s, the first {time} s. *Curve*: how far the ball has come since it was at the highest grain's level."""


def silo(short, name="silo", material="M1"):
    variables = {"softer": 100, "dt": 2.5e-5, "time": 0.1, "most": 20000}
    settling = [{"stage": "settle", "time": 0.35}]
    if short:
        variables, settling = {**variables, "time": 0.02, "most": 2000}, [{"stage": "settle", "time": 0.1}]
    text = SILO_TEXT.format(**variables, grains=variables["most"], times=round(variables["dt"] / 1.5e-6), material=material)
    return Case(name, f"A silo discharges {material}", text, "silo", MATERIALS[material], "c_inside", 0.005, variables, settling,
                lambda values: values, "in the silo", "grains", variables["most"], 1e-3)


def ball(short):
    variables = {"softer": 1, "dt": 5e-7, "time": 0.006, "most": 8000}
    settling = [{"stage": "settle", "softer": 100, "dt": 1.5e-5, "time": 0.25}, {"stage": "calm", "softer": 10, "dt": 5e-6, "time": 0.03},
                {"stage": "calm", "softer": 1, "dt": 1.5e-6, "time": 0.03, "put": "yes"}]
    if short:
        variables = {**variables, "time": 0.002, "most": 1000}
        settling[1:] = [{**stage, "time": 0.003} for stage in settling[1:]]
    text = BALL_TEXT.format(**variables, grains=variables["most"])
    return Case("ball", "A ball strikes a bed of M1", text, "ball", MATERIALS["M1"], "v_z", 0.0002, variables, settling,
                lambda z: 1e3 * (z[0] - z), "depth", "mm", variables["most"], 5e-4)


def silo_of_m2(short):
    return silo(short, "silo-m2", "M2")


CASES = {"silo": silo, "silo-m2": silo_of_m2, "ball": ball}

INTRODUCTION = """# The field's own race

Made by `tools/report race{options}`; nothing here is written by hand. Two of the cases of M. Dosta and others, *Comparing
open-source DEM frameworks for simulations of common bulk processes*, Computer Physics Communications 296, 2024, 109066, at a size
that one core runs in minutes.

Materials are the paper's: grains M1 1 GPa, 0.2, 2500 kg/m³, restitution 0.5, friction 0.3; grains M2 0.5 GPa, 0.2, 2000 kg/m³,
restitution 0.4, friction 0.4; steel 210 GPa, 0.2, 7200 kg/m³; of grains and steel restitution 0.4, friction 0.2. All programs have
Hertz's and Mindlin's contact, the dashpots $2\\beta\\sqrt{{m^*K}}$ and $2\\beta\\sqrt{{m^*k_t}}$ of that restitution, no
attraction as grains part, and Coulomb's limit. They read one packing, which POTDEM has let settle; contacts begin without friction.
The meshes and packings of the paper were not at hand: outlet, box, ball and numbers of grains are ours.

*One core*: processor seconds of the steps alone, without reading and set-up; *ns*: over steps and grains that are still there.
*Two cores*: of the clock, over the first tenth of the time, two MPI ranks of LAMMPS, two threads of YADE. *Off the others*: root
mean square, over time, of the difference between a program's curve and the mean of the other programs'. POTDEM ran once more with
lists that reach 0.7 times as far and are made at other times, to see what rounding alone does.
"""

DIFFERENCES = """## What is not the same

* Walls: POTDEM and LAMMPS have the surfaces of regions, cylinder, cone and block; YADE has facets, 72 around the silo, just
  outside of the circles.
* Springs of friction: as a contact unloads, POTDEM's and LAMMPS's (`mindlin_rescale/force`) fall with the stiffness (Thornton);
  YADE's do not. Where a contact slips, POTDEM limits the spring and then spring and dashpot, LAMMPS both together, and YADE the
  spring, without the dashpot.
* LAMMPS's `coeff_restitution` makes its dashpot of the restitution with attraction; it is given the one that belongs to the same
  dashpot.
* YADE's boxes reach 0.1 radii beyond a grain, as in its own scripts of these cases; POTDEM's and LAMMPS's lists {skins}."""


# --- measuring ------------------------------------------------------------------------------------------------

def run_all(case, programs, folder):
    """fills case.found; what the folder holds of an earlier start is not run again"""
    packing = folder / f"{case.name}.data"
    if not packing.exists():
        settle(case, packing)
    short = dataclasses.replace(case, variables={**case.variables, "time": PART * case.variables["time"]})
    other_lists = dataclasses.replace(case, variables={**case.variables, "skin": 0.7 * case.skin})
    runs = {(name, WHOLE): (case, name, 1) for name in programs}
    runs["POTDEM", OTHER_LISTS] = (other_lists, "POTDEM", 1)
    runs.update({(name, ON_TWO): (short, name, 2) for name in programs})
    for key, (what, name, cores) in runs.items():
        inside = folder / "-".join(key).replace(" ", "-")
        known = inside / "outcome.json"
        if not known.exists():
            known.write_text(PROGRAMS[name](what, packing, cores, inside).as_json(), encoding="utf-8")
        case.found[key] = found = Outcome.from_json(known.read_text(encoding="utf-8"))
        print(f"{case.name}: {', '.join(key)}: {found.clock:.1f} s of the clock, {found.processor:.1f} s of a processor", flush=True)


def names(case):
    """of the programs that ran"""
    return [name for name, run in case.found if run == WHOLE]


def times(case):
    return np.arange(0, case.variables["time"] * (1 + 1e-9), case.every)


def curve(case, name, run=WHOLE):
    found = case.found[name, run]
    return np.interp(times(case), found.time, case.curve(found.values))


def rms(values):
    return float(np.sqrt(np.mean(values**2)))


def off_the_others(case, name):
    """None where there are no others"""
    others = [curve(case, other) for other in names(case) if other != name]
    return rms(curve(case, name) - np.mean(others, axis=0)) if others else None


def nanoseconds(case, name, run):
    """for a grain and a step: of a processor, on two cores of the clock"""
    found = case.found[name, run]
    steps = found.time[-1] / case.variables["dt"]
    there = np.mean(found.values) if case.bulk == "silo" else case.grains
    return 1e9 * (found.clock if run == ON_TWO else found.processor) / steps / there


# --- writing --------------------------------------------------------------------------------------------------

def row(case, name):
    """of the table; without numbers where the program did not run"""
    if name not in names(case):
        return [case.title, name, *[None] * 5]
    return [case.title, name, case.found[name, WHOLE].processor, round(nanoseconds(case, name, WHOLE)),
            round(nanoseconds(case, name, ON_TWO)),
            f"{curve(case, name)[-1]:.5g} {case.unit}", off_the_others(case, name)]


HEADER = ["case", "program", "one core, s", "one core, ns", "two cores, ns", "curve at the end", "off the others"]


def in_short(case):
    """sentences: seconds and curve beside the others"""
    others = [name for name in names(case) if name != "POTDEM"]
    lines = []
    for name in others:
        one = case.found["POTDEM", WHOLE].processor / case.found[name, WHOLE].processor
        two = case.found["POTDEM", ON_TWO].clock / case.found[name, ON_TWO].clock
        lines.append(f"* {case.title}: POTDEM takes {one:.2f} of the seconds of {name} on one core, {two:.2f} on two.")
    chance = rms(curve(case, "POTDEM") - curve(case, "POTDEM", OTHER_LISTS))
    off = off_the_others(case, "POTDEM")
    text = f"POTDEM's curve is {off:.2g} {case.unit} off the others' mean, {chance:.2g} off its own with other lists"
    if len(others) > 1:
        text += f"; the two others are {rms(np.subtract(*(curve(case, name) for name in others))):.2g} {case.unit} apart"
    return [*lines, f"* {case.title}: {text}."]


def picture(case, path):
    """curves above, below what they differ from the mean of all programs"""
    figure, (above, below) = plt.subplots(2, 1, figsize=(7, 6.4), sharex=True, height_ratios=(2, 1), constrained_layout=True)
    mean = np.mean([curve(case, name) for name in names(case)], axis=0)
    drawn = [(name, WHOLE, COLOURS[name], name) for name in names(case)]
    for name, run, colour, label in [*drawn, ("POTDEM", OTHER_LISTS, "#e8a090", "POTDEM, other lists")]:
        style = {"color": colour, "linestyle": "-" if run == WHOLE else "--", "label": label}
        above.plot(1e3 * times(case), curve(case, name, run), **style)
        below.plot(1e3 * times(case), curve(case, name, run) - mean, **style)
    above.set_ylabel(f"{case.quantity}, {case.unit}")
    below.set_ylabel(f"off the mean of all, {case.unit}")
    below.set_xlabel("time, ms")
    above.legend()
    for axis in (above, below):
        axis.grid(alpha=0.3)
    figure.savefig(path, dpi=150)
    plt.close(figure)


def write_data(case, out):
    picture(case, out / f"race-{case.name}.png")
    drawn = [key for key in case.found if key[1] != ON_TWO]
    header = ["time, s", *(f"{case.quantity}, {case.unit}: {', '.join(key)}" for key in drawn)]
    writing.write_csv(out / f"race-{case.name}.csv", header, np.column_stack([times(case), *(curve(case, *key) for key in drawn)]).tolist())


def section(case):
    return "\n\n".join([f"## {case.title}", case.text, f"![{case.quantity} over time](race-{case.name}.png)",
                        f"Data: [race-{case.name}.csv](race-{case.name}.csv)."])


def page(options, cases, rows, machine):
    loads = [found.load for case in cases for found in case.found.values()]
    shared = " (the machine was shared: seconds of the clock say little)" if max(loads) > os.cpu_count() + 1 else ""
    load = f"{min(loads):.1f} to {max(loads):.1f} processes{shared}"
    clock = sum(found.clock for case in cases for found in case.found.values()) / 60
    about = [*machine, ("load over the runs", load), ("all steps took", f"{clock:.0f} minutes of the clock")]
    skins = " and ".join(f"{1e3 * skin:g} mm ({bulk})" for bulk, skin in {case.bulk: case.skin for case in cases}.items())
    parts = [INTRODUCTION.format(options=options), writing.table(("machine", ""), about), missing_yade(), "## In short",
             "\n".join(line for case in cases for line in in_short(case)), writing.table(HEADER, rows), "Data: [race.csv](race.csv).",
             *(section(case) for case in cases), DIFFERENCES.format(skins=skins)]
    return "\n\n".join(part.strip() for part in parts if part) + "\n"


def main(argv):
    parser = argparse.ArgumentParser(prog="tools/report race")
    parser.add_argument("--short", action="store_true", help="few grains and steps; writes to build/report/")
    parser.add_argument("--case", action="append", choices=list(CASES), help="only this case; may be repeated; writes to build/report/")
    parser.add_argument("--keep", type=Path, help="folder in which packings, logs and outcomes stay; what is there is not run again")
    arguments = parser.parse_args(argv)
    out, machine = writing.folder(arguments.short or arguments.case is not None), writing.machine()
    programs = [name for name in PROGRAMS if name != "YADE" or not missing_yade()]
    print(missing_yade(), end="\n" if missing_yade() else "", flush=True)
    cases = [CASES[name](arguments.short) for name in arguments.case or CASES]
    with tempfile.TemporaryDirectory() as work:
        for case in cases:
            run_all(case, programs, (arguments.keep or Path(work)).resolve() / case.name)
    rows = [row(case, name) for case in cases for name in PROGRAMS]
    for case in cases:
        write_data(case, out)
    writing.write_csv(out / "race.csv", HEADER, [["" if cell is None else cell for cell in cells] for cells in rows])
    (out / "race.md").write_text(page(" --short" if arguments.short else "", cases, rows, machine), encoding="utf-8")
    print(f"written: {(out / 'race.md').relative_to(ROOT)}")


if __name__ == "__main__":
    main(sys.argv[1:])
