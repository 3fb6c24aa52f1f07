"""Error against run time: the report of tools/report accuracy.

  tools/report accuracy [--short] [--case NAME ...] [--repeats N]

For each case the knobs of a user are swept, in turn and several times, one process at a time. Writes accuracy.md and, for
each case, accuracy-<case>.png and accuracy-<case>.csv to docs/report/ (about 20 minutes), or with --short, which sweeps
less, to build/report/ (under 5 minutes). With --case the page has these cases only and goes to build/report/ as well.
"""

import argparse
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import work_precision  # noqa: E402
import writing  # noqa: E402
from cases import CASES, Unavailable  # noqa: E402

INTRODUCTION = """# Error against run time

Made by `tools/report accuracy{options}`; nothing here is written by hand.

*Seconds*: processor time of one core. For solids it is that of the whole LAMMPS process, because `area body` spends some before the first
step; for grains that of LAMMPS's loop. Settings ran in turn, one process at a time, {repeats} times; bars reach from the
least to the most, points and tables are medians. *Error*: relative, against the reference that each case names. Grey: Pareto front, the
settings that none beats in both. Dashed lines with open symbols: other programs and styles. Where a case is chaotic, its quantities are
means over several draws: ± and bars are standard errors of the difference. An error smaller than its ± counts as that.

$\\Delta t_c$ is the critical step of [compute potdem/timestep](../compute_potdem_timestep.md) at the start.
"""


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
    text = case.text.replace("{reference}", f"{known[0].label}, {seconds_text(known[0])} s") if known else case.text
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
        return "\n".join(f"* {line}" for line in work_precision.recommendations(points))
    lines = []
    for series in dict.fromkeys(p.series for p in points):
        lines.append(f"* {series}")
        lines += [f"  * {line}" for line in work_precision.recommendations([p for p in points if p.series == series])]
    return "\n".join(lines)


def section(case, points, text, out):
    """writes the picture and the CSV, returns the Markdown"""
    files = f"accuracy-{case.name}"
    work_precision.picture(out / f"{files}.png", points, case.labels, case.floors)
    writing.write_csv(out / f"{files}.csv", ["series", "knob", "seconds", "least", "most"]
                      + [f"error of {label}" for label in case.labels.values()],
                      [[p.series, p.knob, p.median, min(p.seconds), max(p.seconds), *p.errors.values()] for p in points])
    best = work_precision.front(points, lambda p: p.worst)
    rows = [[("**" if p in best else "") + p.series + ("**" if p in best else ""), p.knob, seconds_text(p), *error_cells(p)]
            for p in points]
    lines = [f"## {case.title}", text, f"![error against seconds]({files}.png)", "**Recommended**, the cheapest setting of POTDEM with "
             "all errors below a limit:", recommended(case, [p for p in points if not p.peer])]
    remarks = work_precision.against_peers(points) + case.remarks(points)
    if remarks:
        lines.append("\n".join(f"* {line}" for line in remarks))
    lines.append(writing.table([case.series, case.knob, "seconds (least to most)", *(f"error of {x}, %" for x in case.labels.values())],
                               rows))
    lines.append(f"Bold: Pareto front of the largest error. Data: [{files}.csv]({files}.csv).")
    return "\n\n".join(lines) + "\n"


def main(argv):
    parser = argparse.ArgumentParser(prog="tools/report accuracy", description=__doc__.split("\n\n")[2])
    parser.add_argument("--short", action="store_true", help="sweep less; writes to build/report/")
    parser.add_argument("--case", action="append", choices=list(CASES), help="only this case; may be repeated; writes to build/report/")
    parser.add_argument("--repeats", type=int, default=3)
    arguments = parser.parse_args(argv)
    out = writing.folder(arguments.short or arguments.case is not None)
    start, sections, skipped = time.monotonic(), [], []
    machine = writing.machine()
    with tempfile.TemporaryDirectory() as work:
        for name in arguments.case or CASES:
            try:
                case = CASES[name](arguments.short, Path(work) / name)
            except Unavailable as reason:
                print(f"{name}: left out: {reason}", flush=True)
                skipped.append(f"* {name}: left out: {reason}")
                continue
            sections.append(section(case, *points_of(case, arguments.repeats, Path(work) / name), out))
    minutes = (time.monotonic() - start) / 60
    page = [INTRODUCTION.format(options=" --short" if arguments.short else "", repeats=arguments.repeats),
            writing.table(("machine", ""), [*machine, ("this report took", f"{minutes:.0f} minutes")]), *skipped, *sections]
    (out / "accuracy.md").write_text("\n\n".join(page), encoding="utf-8")
    print(f"written in {minutes:.1f} minutes: {(out / 'accuracy.md').relative_to(writing.ROOT)}")


if __name__ == "__main__":
    main(sys.argv[1:])
