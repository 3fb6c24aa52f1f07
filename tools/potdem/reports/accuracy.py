# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Error against run time: the report of tools/report accuracy.

  tools/report accuracy [--short] [--case NAME ...] [--repeats N] [--calculix]

For each case the knobs of a user are swept, in turn and several times, one process at a time. Writes accuracy.md and, for
each case, accuracy-<case>.png and accuracy-<case>.csv to docs/report/ (about 20 minutes), or with --short, which sweeps
less, to build/report/ (under 5 minutes). With --case the page has these cases only and goes to build/report/ as well.
"""

import argparse
import re
import sys
import tempfile
import time
from pathlib import Path

from potdem import logs
from potdem.reports import work_precision, writing
from potdem.reports.cases import CASES, keep_calculix
from potdem.text import replaced

INTRODUCTION = """# Error against run time

Made by `tools/report accuracy{options}`; nothing here is written by hand. The whole report takes about 20 minutes on two quiet cores;
`tools/report accuracy --short` sweeps less, in under 5 minutes, and writes to build/report/. `--case NAME` makes one case.

*Seconds*: processor time of one core. For solids it is that of the whole LAMMPS process, because `area body` spends some before the first
step; for grains that of LAMMPS's loop. Settings ran in turn, one process at a time, {repeats} times; bars reach from the
least to the most, points and tables are medians. *Error*: relative, against the reference that each case names. Grey: Pareto front, the
settings that none beats in both. Dashed lines with open symbols: other programs and styles. Where a case is chaotic, its quantities are
means over several draws: ± and bars are standard errors of the difference, from the scatter of all settings together. An error smaller
than its ± counts as that, so more draws (`--repeats`) would tell more.

$\\Delta t_c$ is the critical step of [compute potdem/timestep](../../docs/compute_potdem_timestep.md) at the start."""


def measure(case, repeats, work):
    """seconds and quantities of each setting, one of each per round"""
    found = [[] for _ in case.settings]
    for repeat in range(repeats):
        for number, setting in enumerate(case.settings):
            found[number].append(setting.measure(work / str(number), repeat))
        print(f"{case.name}: round {repeat + 1} of {repeats} done", file=sys.stderr, flush=True)
    return found


def points_of(case, repeats, work):
    """of all settings but the reference, and what is bundled; the case's text learns what the reference is"""
    found = measure(case, repeats, work)
    errors = case.errors([[values for _, values in runs] for runs in found])
    points = [work_precision.Point(setting.series, setting.knob, [seconds for seconds, _ in runs], of_names, setting.peer, bars, runs[0][1])
              for setting, runs, (of_names, bars) in zip(case.settings, found, errors)]
    known = [point for point, setting in zip(points, case.settings) if setting.reference]
    text = replaced(case.text, "{reference}", f"{known[0].label}, {seconds_text(known[0])} s") if known else case.text
    return [point for point in points if point not in known] + case.bundled(), text


def seconds_text(point):
    return f"{point.median:.3g} ({min(point.seconds):.3g} to {max(point.seconds):.3g})"


def error_cells(point):
    cells = []
    for name, value in point.errors.items():
        bar = point.bars.get(name)
        cells.append("failed" if value == float("inf") else f"{100 * value:.3g}" + (f" ± {100 * bar:.2g}" if bar else ""))
    return cells


def recommended(case, points):
    """Markdown list; for each series where they are no substitutes for each other"""
    if not case.apart:
        return "\n".join(f"* {line}" for line in work_precision.recommendations(points) + work_precision.indistinct(points))
    lines = []
    for series in dict.fromkeys(p.series for p in points):
        lines.append(f"* {series}")
        lines += [f"  * {line}" for line in work_precision.recommendations([p for p in points if p.series == series])]
    return "\n".join(lines)


def files_of(case):
    return f"accuracy-{case.name}"


def write_data(case, points, out):
    work_precision.picture(out / f"{files_of(case)}.png", points, case.labels, case.floors, not case.apart)
    header = ["series", "knob", "POTDEM", "seconds", "least", "most"]
    header += [f"{what} of {label}" for label in case.labels.values() for what in ("error", "uncertainty")]
    writing.write_csv(out / f"{files_of(case)}.csv", header, [
        [p.series, p.knob, "no" if p.peer else "yes", p.median, min(p.seconds), max(p.seconds)]
        + [value for name in case.labels for value in (p.errors[name], p.bars.get(name, 0.0))] for p in points])


def data_table(case, points):
    best = [] if case.apart else work_precision.front(points, lambda p: p.worst)
    rows = [[f"**{p.series}**" if p in best else p.series, p.knob, seconds_text(p), *error_cells(p)] for p in points]
    return writing.table([case.series, case.knob, "seconds (least to most)", *(f"error of {x}, %" for x in case.labels.values())], rows)


def section(case, points, text):
    """Markdown"""
    remarks = work_precision.against_peers(points) + case.remarks(points)
    parts = [f"## {case.title}", text, f"![error against seconds]({files_of(case)}.png)",
             "**Recommended**, the cheapest setting of POTDEM with all errors below a limit:", recommended(case, [p for p in points if not p.peer]),
             "\n".join(f"* {line}" for line in remarks), data_table(case, points),
             ("" if case.apart else "Bold: Pareto front of the largest error. ") + f"Data: [{files_of(case)}.csv]({files_of(case)}.csv)."]
    return "\n\n".join(part for part in parts if part)


def summary(cases):
    """Markdown: for each case, and each series where they are no substitutes, the cheapest below limits and the best that was found"""
    rows = []
    for case, points in cases:
        ours = [p for p in points if not p.peer]
        for series in dict.fromkeys(p.series for p in ours) if case.apart else (None,):
            chosen = [p for p in ours if series in (None, p.series)]
            best = [*(work_precision.cheapest(chosen, limit) for limit in (0.1, 0.01)), min(chosen, key=lambda p: p.worst)]
            texts = [f"{p.knob if series else p.label}: {work_precision.percent(p.worst)} in {p.median:.2g} s" if p else "–" for p in best]
            rows.append([f"[{case.title}](#{anchor(case.title)})" + (f": {series}" if series else ""), *texts])
    return writing.table(["case", "cheapest below 10 %", "cheapest below 1 %", "most accurate"], rows)


def anchor(title):
    """as GitHub makes it from a heading"""
    return re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")


def page(arguments, cases, skipped, machine, minutes):
    introduction = INTRODUCTION.format(options=" --short" if arguments.short else "", repeats=arguments.repeats)
    parts = [introduction, writing.table(("machine", ""), [*machine, ("this report took", f"{minutes:.0f} minutes")]),
             "\n".join(skipped), "## In short", summary([(case, points) for case, points, _ in cases])]
    parts += [section(case, points, text) for case, points, text in cases]
    return "\n\n".join(part for part in parts if part) + "\n"


def main(argv):
    parser = argparse.ArgumentParser(prog="tools/report accuracy")
    parser.add_argument("--short", action="store_true", help="sweep less; writes to build/report/")
    parser.add_argument("--case", action="append", choices=list(CASES), help="only this case; may be repeated; writes to build/report/")
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--calculix", action="store_true", help="measures CalculiX's run times anew, for machines without it (3 minutes)")
    arguments = parser.parse_args(argv)
    start, cases, skipped = time.monotonic(), [], []
    out, machine = writing.folder(arguments.short or arguments.case is not None), writing.machine()
    with tempfile.TemporaryDirectory() as work:
        work = Path(work)
        if arguments.calculix:
            keep_calculix(work)
            return
        for name in arguments.case or CASES:
            try:
                case = CASES[name](arguments.short, work / name)
                made = (case, *points_of(case, arguments.repeats, work / name))
            except (LookupError, ValueError, logs.LogError) as reason:
                # a scene that has changed must not cost the other cases
                skipped.append(f"* {name} is left out: {type(reason).__name__}: {reason}.")
                print(skipped[-1], file=sys.stderr, flush=True)
                continue
            cases.append(made)
            write_data(*made[:2], out)
    minutes = (time.monotonic() - start) / 60
    (out / "accuracy.md").write_text(page(arguments, cases, skipped, machine, minutes), encoding="utf-8")
    print(f"written in {minutes:.1f} minutes: {out / 'accuracy.md'}")


if __name__ == "__main__":
    main(sys.argv[1:])
