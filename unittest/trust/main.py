# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""What `unittest/run --full` does beyond the tests: docs/trust.md, part by part.

usage: python unittest/trust/main.py [--page] [--junit FILE] [PART ...]

Parts: answers, restart, wrong, invariances, fuzz, sanitizers, coverage, mutants, load (default: all). --page writes what was found into
docs/trust.md; a part that is not run keeps what the page has of its last run. Ends badly if anything was found."""

import argparse
import datetime
import importlib
import subprocess
import sys
import time
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import project

from potdem.paths import BUILD, DOCS, ROOT
from potdem.reports.writing import with_blocks

PARTS = ["answers", "restart", "wrong", "invariances", "fuzz", "sanitizers", "coverage", "mutants", "load"]
PAGE = DOCS / "trust.md"
# parts that are tests of the suite: title, file, and what the page says of them
TESTS = {
    "restart": ("Restart", "test_resume", "runs that are continued from a file written within a run, in which every bit of positions, velocities, forces "
                "and thermo output is compared, and files in which a bit is flipped"),
    "wrong": ("Wrong scripts", "test_wrong_scripts", "runs of scripts with one mistake, on one rank and on two: each ends by itself in one error that names "
              "the mistake"),
    "invariances": ("Axes, numbering, units", "test_invariances", "random heaps seen from elsewhere, turned, in a mirror, numbered otherwise and in other "
                    "units: forces, torques and motion transform exactly"),
}


def tests(part, build, work):
    """(text, failed) of one file of tests"""
    _, name, what = TESTS[part]
    passed, failed, said = project.run_tests([ROOT / "unittest" / "python" / f"{name}.py"], build, work / part)
    print(said if failed else f"  {passed} passed", flush=True)
    return f"{passed} of {passed + failed} tests pass: {what} (`unittest/python/{name}.py`).", failed


def measure(part, build, work):
    return tests(part, build, work) if part in TESTS else importlib.import_module(part).measure(build, work)


def commit():
    return subprocess.run(["git", "rev-parse", "--short", "HEAD"], cwd=ROOT, capture_output=True, text=True, check=False).stdout.strip() or "?"


def write_junit(path, wrong):
    """a test for each part, for unittest/count_results.py"""
    suite = ElementTree.Element("testsuite", name="trust")
    for part, number in wrong.items():
        case = ElementTree.SubElement(suite, "testcase", classname="trust", name=part)
        if number:
            ElementTree.SubElement(case, "failure", message=f"{number} found; docs/trust.md")
    ElementTree.ElementTree(suite).write(path, encoding="unicode")


def main(argv):
    parser = argparse.ArgumentParser(prog="unittest/trust/main.py", usage=__doc__)
    parser.add_argument("--page", action="store_true")
    parser.add_argument("--junit", type=Path)
    parser.add_argument("parts", nargs="*")
    arguments = parser.parse_args(argv)
    unknown = set(arguments.parts) - set(PARTS)
    if unknown:
        parser.error(f"no such part: {', '.join(sorted(unknown))}; there are {', '.join(PARTS)}")
    work = BUILD / "trust"
    work.mkdir(parents=True, exist_ok=True)
    wrong = {}
    for part in arguments.parts or PARTS:
        print(f"{part}:", flush=True)
        begun = time.monotonic()
        try:
            text, wrong[part] = measure(part, BUILD, work)
        except (OSError, RuntimeError, subprocess.CalledProcessError) as problem:
            text, wrong[part] = f"**It could not be run:** {str(problem)[:300]}", 1
        minutes = (time.monotonic() - begun) / 60
        today = datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%d")
        text = f"Commit {commit()}, {today}, {minutes:.0f} min.\n\n{text}"
        (work / f"{part}.md").write_text(text, encoding="utf-8")
        if arguments.page:
            PAGE.write_text(with_blocks(PAGE.read_text(encoding="utf-8"), {part: text}), encoding="utf-8")
    if arguments.junit:
        write_junit(arguments.junit, wrong)
    bad = {part: number for part, number in wrong.items() if number}
    print("\n" + (f"found: {bad}" if bad else "nothing was found"))
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
