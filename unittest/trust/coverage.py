# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Lines of src that the tests run, by gcov in a build of its own (without optimisation)."""

import json
import re
import subprocess
from collections import defaultdict

import project

from potdem.paths import ROOT
from potdem.reports.writing import table

TITLE = "Lines that tests run"
LEAST = 92.0    # %
# the code for wider registers is the same lines
FLAGS = "--coverage;-O1;-g;-fprofile-update=atomic;-DPOTDEM_PLAIN_CODE"
# builds and installs of their own, whose programs are not those that are counted
LEFT_OUT = ["test_walk_through", "test_build", "test_install"]

# files that are not counted, with the reason
NOT_COUNTED = {
    "lammps/plugin.cpp": "messages to hosts that do not fit: run by the tests of the plugin in builds of their own",
    "lammps/plugin_styles.cpp": "loaded as a plugin only",
}
# why lines are not run that are no errors, by file
REASONS = {
    "lammps/bond/potdem_bond_network.cpp": "the memory of bond laws, of which the package has none with a memory: the walk-through's build runs it",
    "lammps/bond/potdem_bonds.cpp": "what LAMMPS asks of a bond style that stands in for one while bonds are made",
    "lammps/glue/potdem_pair_lists.cpp": "`neigh_modify exclude molecule`",
    "lammps/pair/fix_potdem_contacts.cpp": "contacts between runs of pairs that do not touch any more",
}
INLINE = "constructors and functions that the compiler has put into their callers"
AN_ERROR = re.compile(r"error->(all|one)\(|throw |catch \(|refuse_|collapsed|passed\(")


def run_tests(folder, work, tests):
    project.build(folder, f"-DPOTDEM_EXTRA_OPTIONS={FLAGS}")
    subprocess.run([folder / "unittest" / "test_laws", "--gtest_brief=1"], check=True)
    project.run_tests(tests, folder, work / "coverage-tests")


def lines(folder, work):
    """file below src -> {line: run or not}"""
    report = work / "coverage.json"
    subprocess.run(["gcovr", "--root", ROOT, "--filter", str(ROOT / "src") + "/", "--gcov-ignore-parse-errors", "--json", report, folder],
                   check=True)
    found = defaultdict(dict)
    for one in json.loads(report.read_text(encoding="utf-8"))["files"]:
        path = one["file"].removeprefix("src/")
        for line in one["lines"]:
            if line.get("gcovr/noncode"):
                continue
            number = line["line_number"]
            found[path][number] = found[path].get(number, False) or line["count"] > 0
    return found


def measure(_, work):
    folder = work / "coverage"
    run_tests(folder, work, project.test_files(LEFT_OUT))
    return report(lines(folder, work))


def report(found):
    """(text of the page's block, 1 if too few lines are run)"""
    counted = {path: of for path, of in found.items() if path not in NOT_COUNTED}
    total, run = sum(map(len, counted.values())), sum(sum(of.values()) for of in counted.values())
    share = 100.0 * run / total
    rows = []
    for path, of in sorted(found.items(), key=lambda item: sum(item[1].values()) / max(1, len(item[1]))):
        missed = [number for number, seen in sorted(of.items()) if not seen]
        if missed:
            errors, others = told_apart(path, missed)
            why = NOT_COUNTED.get(path) or (REASONS.get(path, INLINE if path.endswith(".h") else "") if others else "")
            rows.append((path, f"{100.0 * (1.0 - len(missed) / len(of)):.1f} %", runs_of(errors), runs_of(others), why))
    text = f"The laws' tests and the Python tests run {run} of {total} lines of `src`, **{share:.1f} %** ({LEAST:.0f} % are asked). " \
        "An error on more than one rank ends LAMMPS before it could say which lines it has run, and an error of one rank always does: those that " \
        "belong to errors stand apart. `unittest/wrong-scripts.yaml` has most of them.\n\n"
    return text + table(["file", "of its lines", "errors", "others not run", ""], rows), int(share < LEAST)


def told_apart(path, missed):
    """(those that belong to an error, others)"""
    text = (ROOT / "src" / path).read_text(encoding="utf-8").split("\n")
    errors = [number for number in missed if AN_ERROR.search("\n".join(text[max(0, number - 6):number + 6]))]
    return errors, [number for number in missed if number not in errors]


def runs_of(numbers):
    """3, 5-7"""
    parts, begin = [], None
    for k, number in enumerate(numbers):
        begin = number if begin is None else begin
        if k + 1 == len(numbers) or numbers[k + 1] != number + 1:
            parts.append(str(begin) if begin == number else f"{begin}-{number}")
            begin = None
    return ", ".join(parts)
