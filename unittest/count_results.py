# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Adds up the results of the test programs (JUnit XML) and ends with one line for all of them.

usage: count_results.py EXIT_STATUS:FILE.xml ...
"""

import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path


def count(path):
    """passed, failed and skipped tests of one file; the skipped ones are printed with their reasons"""
    failed = total = 0
    skipped = {}
    for case in ElementTree.parse(path).getroot().iter("testcase"):
        total += 1
        if case.find("failure") is not None or case.find("error") is not None:
            failed += 1
        elif case.find("skipped") is not None:
            reason = case.find("skipped").get("message") or "no reason given"
            skipped.setdefault(reason, []).append(f"{case.get('classname')}.{case.get('name')}")
    for reason, names in skipped.items():
        print(f"skipped, {reason}: {', '.join(names)}")
    number = sum(map(len, skipped.values()))
    return total - failed - number, failed, number


def count_program(status, path):
    """as count(); a program that ended badly without naming a failed test is one failure"""
    try:
        passed, failed, skipped = count(path)
    except (OSError, ElementTree.ParseError) as problem:
        print(f"no results of {path.stem}: {problem}")
        return 0, 1, 0
    if failed == 0 and (status != 0 or passed + skipped == 0):
        print(f"{path.stem}: exit status {status}, {passed + skipped} tests")
        failed = 1
    return passed, failed, skipped


def main(arguments):
    totals = [0, 0, 0]
    for argument in arguments:
        status, path = argument.split(":", 1)
        totals = [a + b for a, b in zip(totals, count_program(int(status), Path(path)))]
    passed, failed, skipped = totals
    print(f"{passed} passed, {failed} failed" + (f", {skipped} skipped" if skipped else ""))
    return 0 if failed == 0 and passed > 0 else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
