#!/usr/bin/python3
# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Runs LAMMPS's force-style harness on every YAML file of tests/ and writes the results as one JUnit XML file.

usage: run_harness.py FOLDER_OF_THE_PROGRAMS RESULTS.xml

The program for tests/KIND-STYLE.yaml is KIND. Where the harness skips a test, the YAML file must say why, in a
comment '# TEST: reason': a test that is skipped without one has failed.
"""

import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from pathlib import Path

YAML_FILES = sorted((Path(__file__).resolve().parent / "tests").glob("*.yaml"))
# LAMMPS's accelerator packages that POTDEM has no styles for
LEFT_OUT = "-*.kokkos*:*.gpu:*.intel:*.opt"


def stated_reasons(yaml_file):
    """test -> why the YAML file says that it is skipped"""
    return dict(re.findall(r"^# (\w+): (.+)$", yaml_file.read_text(), re.MULTILINE))


def add_failure(suite, name, message):
    """a failed test of that name"""
    case = ElementTree.SubElement(suite, "testcase", name=name)
    ElementTree.SubElement(case, "failure", message=message)


def explain_skip(suite, case, reasons):
    """gives a skipped test the reason in its YAML file, or puts a failed one in its place"""
    name = case.get("name")
    if name in reasons:
        case.find("skipped").set("message", reasons[name])
        return
    print(f"{suite.get('name')}: {name} was skipped, and the YAML file does not say why")
    suite.remove(case)
    add_failure(suite, name, "skipped without a reason in the YAML file")


def run(program, yaml_file, folder):
    """the results of one YAML file: a testsuite"""
    results = Path(folder) / "results.xml"
    process = subprocess.run(
        [program, yaml_file, "--gtest_brief=1", f"--gtest_filter={LEFT_OUT}", f"--gtest_output=xml:{results}"],
        cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
    suite = ElementTree.Element("testsuite", name=yaml_file.stem)
    if results.exists():
        suite.extend(ElementTree.parse(results).getroot().iter("testcase"))
    if process.returncode != 0 or len(suite) == 0:
        print(f"{yaml_file.stem}: exit status {process.returncode}\n{process.stdout}")
        if suite.find(".//failure") is None:
            add_failure(suite, "run", f"exit status {process.returncode}, {len(suite)} tests")
    reasons = stated_reasons(yaml_file)
    for case in suite.findall("testcase[skipped]"):
        explain_skip(suite, case, reasons)
    for case in suite:
        case.set("classname", yaml_file.stem)
    return suite


def main(programs, results):
    suites = ElementTree.Element("testsuites")
    for yaml_file in YAML_FILES:
        kind = yaml_file.stem.rsplit("-", 1)[0]
        with tempfile.TemporaryDirectory() as folder:
            suites.append(run(Path(programs).resolve() / kind, yaml_file, folder))
    ElementTree.ElementTree(suites).write(results)
    return 1 if suites.find(".//failure") is not None else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
