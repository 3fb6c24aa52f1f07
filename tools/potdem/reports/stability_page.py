# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Writes the stability report: Markdown, CSV and the figure, all from what was measured."""

from collections import Counter

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.lines import Line2D  # noqa: E402

from potdem.reports import stability_cases, writing  # noqa: E402
from potdem.reports import stability_more as more  # noqa: E402

SILENT = "SILENT NONSENSE"
VERDICTS = {
    "right": "the ledger closes, all particles are where they can be, nothing is said",
    "right, warns": "the same, with a warning",
    "warns": "wrong, and the log says so with a warning of POTDEM",
    "stops": "ends with an error",
    SILENT: "wrong without a word",
}
LOOKS = {"right": ("#2a7f3f", "o"), "right, warns": ("#7fb24a", "s"), "warns": ("#e0902a", "^"), "stops": ("#b5332e", "X"),
         SILENT: ("#000000", "*")}
LEAST_ERROR, MOST_ERROR = 1e-7, 1e6    # of the figure
LAW_ENDS = [("granular", "granular linear"), ("lj", "lj linear")]
LATTICE_MARGIN, ROUNDING = 0.15, 1e-10
UNITS_BOUND = 1e-9
CALLS = {"critical": "is longer than the critical step", "contact too stiff": "The contact of", "bond too stiff": "The bond of",
         "crushed bond too stiff": "The crushed bond of", "too deep": "too deep", "bond crushed": "is crushed to",
         "too fast": "contacts may be missed"}


def title(outcome):
    return outcome.case.name.strip()


def by_case(outcomes):
    """case -> {label: outcome}, in order"""
    found = {}
    for outcome in outcomes:
        found.setdefault(id(outcome.case), {})[outcome.label] = outcome
    return list(found.values())


def percent(error):
    """of a ledger's error"""
    if error == float("inf"):
        return "–"
    value = 100 * error
    return f"{value:.2g} %" if value < 1000 else f"{value:.0e} %"


def cell(outcome):
    if outcome is None:
        return ""
    if outcome.verdict == "stops" and outcome.error in (0.0, float("inf")):
        return outcome.verdict
    word = f"**{outcome.verdict}**" if outcome.verdict == SILENT else outcome.verdict
    return f"{word} {percent(outcome.error)}"


def shorten(text, length=200):
    text = text.replace("|", "/")
    return text if len(text) <= length else text[: length - 1].rsplit(" ", 1)[0] + " …"


def sign_text(outcome):
    step, what = outcome.sign
    said = {"warning": outcome.warnings, "error": [outcome.message]}.get(what, [])
    return f"step {step}: {what}" + (f": *{shorten(said[0])}*" if said and said[0] else "")


# --- parts of the page ------------------------------------------------------------------------------------------------

def matrix(cases):
    labels = ["adaptive", "0.5", "0.9", "1.1", "2", "thesis"]
    header = ["case", "critical step", *(f"{label} Δt_c" if label[0].isdigit() else label for label in labels)]
    rows = [[title(runs["0.5"]), runs["0.5"].step / 0.5, *(cell(runs.get(label)) for label in labels)] for runs in cases]
    thesis = [f"{title(runs['thesis'])}: {runs['thesis'].step:g} s = {runs['thesis'].fraction:.3g} Δt_c" for runs in cases if "thesis" in runs]
    return writing.table(header, rows) + "\n\nThe thesis's own steps: " + "; ".join(thesis) + "."


def signs(cases):
    """the first fraction at which something is not right, and 2"""
    rows = []
    for runs in cases:
        troubled = [run for run in runs.values() if run.verdict != "right"]
        if troubled:
            first = min(troubled, key=lambda run: run.fraction)
            rows.append([title(first), first.label, sign_text(first)])
    return writing.table(["case", "first at", "first sign of trouble"], rows)


def calls(outcomes):
    """how often each warning came, and how often it was the first sign"""
    rows = []
    for name, words in CALLS.items():
        with_it = [o for o in outcomes if any(words in text for text in o.warnings)]
        wrong = [o for o in with_it if not o.verdict.startswith("right")]
        rows.append([name, f"*… {words} …*", len(with_it), len(wrong)])
    return writing.table(["warning", "words", "runs with it", "of them wrong or ended"], rows)


def cures(cases):
    """laws with and without their straight end; walls with and without layer; adaptive step"""
    named = {title(runs["0.5"]): runs for runs in cases}
    pairs = [(f"{law}, {scene}", f"{cure}, {scene}") for law, cure in LAW_ENDS for scene in ("collision", "violent collision", "packing overlaps by 30 %")]
    pairs += [(wall, f"{wall}, soft layer") for wall in ("soft grain, wall 10^6 times as stiff", "hard grain, hard wall")]
    pairs += [("bond compressed to 10 % of its length", "bond compressed to 10 %, penetration 6"),
              *((f"cube hits a wall at {v} times its wave speed", f"cube at {v} times, penetration 6, granular law of the wall") for v in (1, 3))]
    rows = []
    for plain, cured in pairs:
        for name in (plain, cured):
            runs = named[name]
            rows.append([name if name == plain else f"→ {name}", runs["0.5"].step / 0.5,
                         *(cell(runs[label]) for label in ("adaptive", "0.5", "0.9", "1.1", "2"))])
    return writing.table(["case, → with the cure", "critical step", "adaptive", "0.5 Δt_c", "0.9", "1.1", "2"], rows)


def counts(outcomes):
    number = Counter(outcome.verdict for outcome in outcomes)
    return writing.table(["verdict", "means", "runs"], [[name, text, number[name]] for name, text in VERDICTS.items()])


def lattices(rows):
    good = all((1 - LATTICE_MARGIN) * exact < bound < exact * (1 + ROUNDING) for _, _, exact, bound, _, _ in rows)
    text = writing.table(["lattice", "r_infl/d", "exact step, c/d", "bound, c/d", "bound / exact", "√(m/K) / exact"], rows)
    return text + f"\n\nWithin {100 * LATTICE_MARGIN:g} % below the exact step and never above: **{'yes' if good else 'no'}**."


# --- figure -----------------------------------------------------------------------------------------------------------

def height(run):
    """in the figure; a run that ended at once has no ledger to speak of"""
    if run.verdict == "stops" and run.error < LEAST_ERROR:
        return MOST_ERROR
    return min(max(run.error, LEAST_ERROR), MOST_ERROR)


def draw(path, outcomes):
    figure, panel = plt.subplots(figsize=(10, 6), constrained_layout=True)
    for case in by_case(outcomes):
        runs = sorted((run for run in case.values()), key=lambda run: run.fraction)
        heights = [height(run) for run in runs]
        panel.plot([run.fraction for run in runs], heights, color="#d5d5d5", linewidth=0.6, zorder=1)
        for run, error in zip(runs, heights):
            colour, marker = LOOKS[run.verdict]
            panel.plot(run.fraction, error, marker, color=colour, markersize=6, zorder=2, alpha=0.85)
    panel.axhline(0.1, color="#333333", linewidth=1, linestyle="--")
    panel.text(3.4, 0.115, "bound 10 %", ha="right", va="bottom", fontsize=9)
    panel.text(0.105, 1.5 * MOST_ERROR, "on this line: ended at once, or not finite", fontsize=9, va="bottom")
    panel.axvline(1.0, color="#333333", linewidth=1, linestyle=":")
    panel.text(0.985, 3e4, "critical step", rotation=90, ha="right", va="top", fontsize=9)
    panel.set(xscale="log", yscale="log", xlim=(0.085, 3.6), ylim=(0.5 * LEAST_ERROR, 10 * MOST_ERROR),
              xlabel="time step over the critical step   (0.1: adaptive)",
              ylabel="largest error of the energy ledger over the energy exchanged")
    panel.set_xticks([0.1, 0.5, 0.9, 1.1, 2.0], ["0.1\nadaptive", "0.5", "0.9", "1.1", "2"])
    panel.minorticks_off()
    panel.set_title("Every run of the matrix: how wrong it is, and what the code says")
    panel.legend(handles=[Line2D([], [], color=colour, marker=marker, linestyle="", label=name) for name, (colour, marker) in LOOKS.items()],
                 loc="lower right", title="grey lines join the runs of one case", fontsize=9, title_fontsize=9)
    figure.savefig(path, dpi=110)
    plt.close(figure)


# --- the page ---------------------------------------------------------------------------------------------------------

def more_rows(folder, short):
    return {"lattices": more.lattice_steps(folder), "order": more.adaptive_order(folder), "drift": more.drifts(folder, short),
            "far": more.far_away(folder), "units": more.in_units(folder)}


def write(folder, outcomes, extra, short, bound):
    """report of that folder: stability.md, .csv, .png"""
    cases = by_case(outcomes)
    draw(folder / "stability.png", outcomes)
    writing.write_csv(folder / "stability.csv",
                      ["group", "case", "label", "fraction", "step", "ledger error", "verdict", "first sign step", "first sign", "error",
                       "warnings"],
                      [[o.case.group, title(o), o.label, float(o.fraction), o.step or "", o.error, o.verdict,
                        *(o.sign or ("", "")), o.message or "", " / ".join(o.warnings)] for o in outcomes])
    silent = sum(outcome.verdict == SILENT for outcome in outcomes)
    moved = [row[1] for row in extra["units"]]
    apart = max(row[2] for row in extra["units"])
    command = "tools/report stability" + (" --short" if short else "")
    text = f"""# Stability: where the method breaks, and whether it says so

Made by `{command}`; nothing here is written by hand but the words. Rows with **{SILENT}: {silent}** of {len(outcomes)} runs.

{writing.table(["", ""], writing.machine())}

Each case runs adaptively (`fix potdem/timestep` with every = 1 and fraction = 0.1), which also gives its critical step $\\Delta t_c$, the
smallest during that run by [compute potdem/timestep](../compute_potdem_timestep.md), and the energy that is exchanged; then with fixed steps of
0.5, 0.9, 1.1 and 2 times that; then with the thesis's own step where there is one. So $\\Delta t_c$ belongs to the stiffest moment, which for a collision
is where the particles turn back. The number in each cell is the largest error of the [energy ledger](../compute_potdem_energy.md), over the energy
exchanged. A run is **right** if that is below {100 * bound:g} %, all numbers are finite, and no particle is behind a wall or beyond the particle
that it hit. Otherwise it must end with an error or carry [a warning of POTDEM](../warnings.md). LAMMPS's own warnings do not count.

{counts(outcomes)}

![Error of the ledger over the step, one point for each run](stability.png)

## The matrix

{matrix(cases)}

(*stops* without a number: the run ended before there was a ledger to judge. –: not finite.) All rows, with every message: [stability.csv](stability.csv).

## The first sign of trouble

At the smallest step at which a case is not simply right:

{signs(cases)}

## What is said

{calls(outcomes)}

A warning in a run that is right is a warning in time: most are of the critical step's bound, or of a contact that half a period is too few steps for.

## Cures

`linear` continues a law straight below a distance (here {stability_cases.STRAIGHT:g} of that at rest or at first contact), so that its stiffness is
bounded: compare the critical steps. The soft layer of a wall makes the contact begin gently; `penetration` keeps the ends of a bond apart; the law
*granular* of a wall has no end that a fast particle could pass. The adaptive step keeps the error small where no step is known beforehand. Steps are
fractions of each row's own critical step.

{cures(cases)}

## The critical step

Perfect lattices with bonds at rest, the bound of `compute potdem/timestep` beside the exact critical step (the largest frequency of all plane
waves), and the thesis's rule:

{lattices(extra["lattices"])}

Adaptive stepping keeps second order; a Hertz collision, halving *fraction* and *max*:

{writing.table(["fraction", "error of the ledger", "times smaller than before"], extra["order"])}

(`unittest/python/test_timestep.py` has the bound for lattices, bodies, heaps and walls, and the step at which they blow up;
`test_adaptive_step.py` second order in a collision and in a breaking beam, and that grains at rest leave the step alone: no chatter.)

## Long runs

At a tenth of the critical step; fluctuation and drift of the ledger, over the mean kinetic energy. Drift: mean of the last tenth of the run less
that of the first tenth.

{writing.table(["case", "steps", "fluctuation", "drift"], extra["drift"])}

## Far from the origin

The same collision at the origin and at $10^6$ diameters from it on each axis, where a coordinate has ten digits left of its diameter:

{writing.table(["law", "difference of the rebound speed, over the speed", "difference of the distance, d"], extra["far"])}

## Units

One scene (a bonded cube with dashpots and a grain fall on a plane with friction) in four systems, coordinates in diameters after 400 steps:

{writing.table(["units", "extent in z, d", "largest difference from si, d"], extra["units"])}

They agree within {UNITS_BOUND:g} d: **{'yes' if apart < UNITS_BOUND and min(moved) > 0 else 'no'}**.
"""
    (folder / "stability.md").write_text(text, encoding="utf-8")
