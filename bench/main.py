# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""bench/run: the tables of costs and of targets; what stands behind them; what clusters need. All in Markdown."""

import argparse
import sys
from dataclasses import replace
from pathlib import Path

import cluster
import cost
import limits
import targets
from potdem.paths import DOCS
from potdem.reports import writing


def costs(arguments, machine):
    tables = cost.report(*cost.rounds(arguments))
    print(tables)
    write(arguments, "report/cost.md", cost.PAGE.format(size=arguments.size**3, steps=arguments.steps, repeats=arguments.repeats,
                                                        machine=machine, tables=tables))


def aims(arguments, machine):
    sizes = targets.SHORT if arguments.short else targets.Sizes()
    if arguments.large:
        sizes = replace(sizes, flat=(*sizes.flat, targets.HUGE))
    listed = targets.targets(sizes)
    table = targets.report(listed, targets.rounds(listed, arguments.repeats, sizes))
    print(table)
    write(arguments, "report/targets.md", targets.PAGE.format(repeats=arguments.repeats, machine=machine, table=table))


def behind(arguments, machine):
    blocks(arguments, {"machine": machine, **limits.blocks(arguments.short, DOCS / "performance.png" if arguments.page else None)})


def many_ranks(arguments, _):
    blocks(arguments, cluster.blocks(arguments.short))


def write(arguments, page, text):
    if arguments.page:
        (DOCS / page).write_text(text, encoding="utf-8")


def blocks(arguments, found):
    """prints them, or puts each in its place in docs/performance.md"""
    for name, text in found.items():
        print(f"\n{name}\n\n{text}")
    if arguments.page:
        path = DOCS / "performance.md"
        path.write_text(writing.with_blocks(path.read_text(encoding="utf-8"), found), encoding="utf-8")


def main(argv):
    parser = argparse.ArgumentParser(prog="bench/run", description="without one of the next four: the first two")
    chosen = parser.add_mutually_exclusive_group()
    chosen.add_argument("--costs", action="store_true", help="what each feature costs")
    chosen.add_argument("--targets", action="store_true", help="what was to be reached, beside LAMMPS's own styles and other limits")
    chosen.add_argument("--limits", action="store_true", help="bytes, operations, instructions, and what the machine could do at most")
    chosen.add_argument("--cluster", action="store_true", help="messages, weak scaling on paper, balance, threads and ranks")
    chosen.add_argument("--against", type=Path, metavar="BUILD", help="costs compared with the LAMMPS of another build folder")
    parser.add_argument("--size", type=int, default=40, help="of costs: particles along an edge (default 40: 64 000)")
    parser.add_argument("--steps", type=int, default=100, help="of costs (default 100)")
    parser.add_argument("--repeats", type=int, default=5, help="rounds (default 5)")
    parser.add_argument("--large", action="store_true", help="of targets: a body of 4 million particles, too; it needs 16 GB")
    parser.add_argument("--short", action="store_true", help="of all but costs: small bodies, to see that it works")
    parser.add_argument("--page", action="store_true", help="for maintainers: write docs/report and docs/performance.md as well")
    arguments = parser.parse_args(argv)
    if arguments.short and arguments.page:
        parser.error("--short is not for the pages")
    if arguments.against:
        print(cost.against(arguments))
        return
    machine = writing.table(("machine", ""), writing.machine())
    parts = {"costs": costs, "targets": aims, "limits": behind, "cluster": many_ranks}
    for part in [name for name in parts if getattr(arguments, name)] or ["costs", "targets"]:
        parts[part](arguments, machine)


if __name__ == "__main__":
    main(sys.argv[1:])
