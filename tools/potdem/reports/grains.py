# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Heaps and discharge of grains, beside LAMMPS's pair_style granular with the same laws: the report of tools/report grains.

  tools/report grains [--short] [--keep FOLDER]

Heaps are left on a rough base with and without rolling resistance, five to ten draws of the grains; heaps of other grains, three draws
each; a bin empties through slots of three widths, three draws each. One process at a time. Writes grains.md, grains-heaps.png,
grains-slot.png and a CSV of each to docs/report/ (about 30 minutes), or with --short, with two draws and shorter runs, to build/report/."""

import argparse
import sys
import tempfile
import time
from pathlib import Path

from potdem.reports import grains_page, grains_runs, writing


def main(argv):
    parser = argparse.ArgumentParser(prog="tools/report grains", description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("--short", action="store_true", help="fewer draws, shorter runs; writes to build/report/")
    parser.add_argument("--keep", help="folder for the runs")
    arguments = parser.parse_args(argv)
    start, machine = time.monotonic(), writing.machine()
    with tempfile.TemporaryDirectory() as work:
        work = Path(arguments.keep or work)
        times = {"flow": 1.2, "rest": 0.2} if arguments.short else {"flow": grains_runs.FLOW, "rest": grains_runs.REST}
        seeds = (1, 2) if arguments.short else (1, 2, 3)
        found, contact = grains_runs.all_heaps(2 if arguments.short else 10, work, times)
        others = grains_runs.changed_heaps(seeds, work, times)
        slots = grains_runs.all_discharges(seeds, work)
        grains_page.write(writing.folder(arguments.short), grains_page.Found(found, contact, others, slots, times),
                          [*machine, ("this report took", f"{(time.monotonic() - start) / 60:.0f} minutes")])


if __name__ == "__main__":
    main(sys.argv[1:])
