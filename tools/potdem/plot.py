# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Draws columns of the thermo output of a run, over time or over each other, with units (docs/see.md)."""

import argparse
import sys
from pathlib import Path

import numpy as np

from potdem import commands, logs, picture

TALL = 2.6    # inches, of a panel
MOST = 12     # panels that are drawn when no column is named


class PlotError(Exception):
    """what cannot be drawn, and the remedy"""


def named(text):
    """(column, label or None) of COLUMN or COLUMN=LABEL"""
    column, _, label = text.partition("=")
    return column, label or None


def label_of(run, column, label):
    return label if label is not None else run.label(column)


def groups(run, columns):
    """lists of columns for each panel: those of one compute or fix, and LAMMPS's own keywords, share it if their unit is the same"""
    found = {}
    for column, label in columns:
        quantity = run.quantity(column)
        found.setdefault((column.split("[")[0] if "_" in column else "", quantity) if quantity and label is None else column,
                         []).append((column, label))
    return list(found.values())


def check(table, columns, path):
    missing = [column for column, _ in columns if column not in table]
    if missing:
        raise PlotError(f"{path} has no column {', '.join(missing)}; it has: {', '.join(table)}. Others: thermo_style custom")


def draw(table, run, x, panels):
    """the figure"""
    columns = 1 if len(panels) == 1 else 2
    figure, axes = picture.curves(-(-len(panels) // columns), columns, TALL if columns > 1 else 4.5)
    for axis in axes.ravel()[len(panels):]:
        axis.axis("off")
    for axis, panel in zip(axes.ravel(), panels):
        for number, (column, label) in enumerate(panel):
            axis.plot(table[x[0]], table[column], color=picture.CURVES[number % len(picture.CURVES)],
                      linestyle="--" if number >= len(picture.CURVES) else "-",
                      label=label or run.words(column), marker="." if table[column].size < 3 else None)
        axis.set_xlabel(label_of(run, *x))
        unit = run.unit(run.quantity(panel[0][0]))
        axis.set_ylabel(label_of(run, *panel[0]) if len(panel) == 1 else f"{run.quantity(panel[0][0])}, {unit}".rstrip(", "))
        axis.ticklabel_format(axis="y", style="sci", scilimits=(-3, 4), useMathText=True)
        if len(panel) > 1:
            axis.legend(loc="center left", bbox_to_anchor=(1.0, 0.5))
    return figure


def parse(argv):
    parser = argparse.ArgumentParser(prog="tools/plot", description="Curves of the thermo output in a log of LAMMPS, as a PNG.")
    parser.add_argument("log")
    parser.add_argument("x", nargs="?", help="column on the horizontal axis, or COLUMN=LABEL (default: Time, or Step)")
    parser.add_argument("y", nargs="*", help="columns, or COLUMN=LABEL (default: all); those with one unit share a panel")
    parser.add_argument("--out", metavar="FILE.png", help="default: beside the log")
    return parser.parse_args(argv)


def main(argv):
    arguments = parse(argv)
    path = Path(arguments.log)
    if not path.is_file():
        raise PlotError(f"no log {path}")
    run, table = commands.of_log(path), logs.read_thermo(path, last=True)
    x = named(arguments.x or ("Time" if "Time" in table else "Step"))
    ys = [named(text) for text in arguments.y] or [(column, None) for column in table if column not in (x[0], "Step", "Time", "CPU")]
    check(table, [x, *ys], path)
    zero = [column for column, _ in ys if not np.any(table[column])]
    if zero and not arguments.y:
        print(f"zero, and not drawn: {', '.join(zero)}")
        ys = [(column, label) for column, label in ys if column not in zero]
    panels = groups(run, ys)
    if not arguments.y and len(panels) > MOST:
        print(f"{len(panels)} panels, of which the first {MOST} are drawn: name the columns that you want")
        panels = panels[:MOST]
    if not panels:
        raise PlotError(f"{path} has no other column than {', '.join(table)}: thermo_style custom adds some")
    out = Path(arguments.out or path.with_name(f"{path.name}.png"))
    picture.save(draw(table, run, x, panels), out)
    print(f"picture: {out}")
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except (PlotError, logs.LogError) as problem:
        sys.exit(f"tools/plot: {problem}")
