# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Lines of src that the tests run, by gcov in a build of its own (without optimisation)."""

import json
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

# lines that no test can run, by file, with the reason
NOT_RUN = {
    "lammps/plugin.cpp": "messages to hosts that do not fit; run by the tests of the plugin, in a process that gcov does not see",
    "lammps/plugin_styles.cpp": "loaded as a plugin only",
}


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
            number = line["line_number"]
            found[path][number] = found[path].get(number, False) or line["count"] > 0
    return found


def measure(build, work):
    folder = work / "coverage"
    run_tests(folder, work, [path for path in sorted((ROOT / "unittest" / "python").glob("test_*.py")) if path.stem not in LEFT_OUT])
    found = lines(folder, work)
    counted = {path: of for path, of in found.items() if path not in NOT_RUN}
    total, run = sum(map(len, counted.values())), sum(sum(of.values()) for of in counted.values())
    share = 100.0 * run / total
    rows = []
    for path, of in sorted(found.items(), key=lambda item: sum(item[1].values()) / len(item[1])):
        missed = [number for number, seen in sorted(of.items()) if not seen]
        if missed:
            rows.append((path, f"{100.0 * (1.0 - len(missed) / len(of)):.1f} %", runs_of(missed), NOT_RUN.get(path, "")))
    text = f"The laws' tests and the Python tests run {run} of {total} lines of `src`, **{share:.1f} %** ({LEAST:.0f} % are asked).\n\n"
    return text + table(["file", "of its lines", "not run", ""], rows), int(share < LEAST)


def runs_of(numbers):
    """3, 5-7"""
    parts, begin = [], None
    for k, number in enumerate(numbers):
        begin = number if begin is None else begin
        if k + 1 == len(numbers) or numbers[k + 1] != number + 1:
            parts.append(str(begin) if begin == number else f"{begin}-{number}")
            begin = None
    return ", ".join(parts)
