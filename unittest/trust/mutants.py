# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Faults put into the laws, the contact and the loops over pairs and bonds: does a test notice each?

Clang's parser (python3-clang) finds places in the bodies of functions; at each drawn place the expression e becomes

    (POTDEM_MUTANT(n) ? fault : e)

so that one build has all faults, and the environment variable POTDEM_MUTANT switches one on. Nothing of this is in the sources of the
package: they are copied to the build folder first."""

import concurrent.futures
import json
import os
import random
import re
import shlex
import shutil
import subprocess
import sys
import time
from dataclasses import dataclass

import project

from potdem.paths import ROOT
from potdem.reports.writing import table

TITLE = "Faults that tests notice"
COUNT, SEED = 200, 11
TARGETS = ["core/laws/*.h", "core/contact/*.h", "lammps/pair/pair_potdem_loop.h", "lammps/bond/bond_potdem_loop.h"]
# what includes all of them
UNITS = ["lammps/pair/pair_potdem_laws.cpp", "lammps/bond/bond_potdem_laws.cpp", "lammps/wall/fix_potdem_wall_region.cpp"]
# beside the laws' own tests, the ones that find most first
TESTS = ["pair_laws", "two_particles", "width", "conservation", "damping", "restitution", "failure", "dead_bonds", "stress", "timestep", "monitor",
         "energy_ledger", "dmt", "two_dimensions", "hybrid", "wall_laws", "friction_springs", "wall_friction", "wall_springs", "rolling",
         "chung_ooi", "bodies", "strain", "invariances", "parallel", "restart", "resume"]
LIMIT = 900    # s, for all tests of one fault: a run that hangs is noticed, too
HEADER = """#pragma once
#include <cstdlib>
inline const int potdem_mutant = std::getenv("POTDEM_MUTANT") ? std::atoi(std::getenv("POTDEM_MUTANT")) : 0;
#define POTDEM_MUTANT(n) (potdem_mutant == (n))
"""
OTHER = {"+": "-", "-": "+", "*": "/", "/": "*", "<": ">=", ">": "<=", "<=": ">", ">=": "<", "==": "!=", "!=": "==", "&&": "||", "||": "&&",
         "+=": "-=", "-=": "+=", "*=": "/=", "/=": "*="}

# faults that change nothing, with the reason; by file and text, because numbers change with the sources
EQUIVALENT = {}


@dataclass
class Fault:
    file: str      # below src
    first: int     # bytes
    last: int
    line: int
    old: str
    new: str

    @property
    def name(self):
        return f"{self.file}: {shortened(self.old)} → {shortened(self.new)}"


def shortened(text):
    return re.sub(r"\s+", " ", text)


# --- the places ----------------------------------------------------------------------------------------------------------------


def arguments_of(build, unit):
    """how the build compiles it"""
    listed = subprocess.run(["ninja", "-C", build, "-t", "compdb"], capture_output=True, text=True, check=True).stdout
    command = next(shlex.split(one["command"]) for one in json.loads(listed) if one["file"].endswith(f"/src/{unit}"))
    kept = [word for word in command if re.match(r"-(I|D|std)", word)]
    for flag, folder in zip(command, command[1:]):
        if flag == "-isystem":
            kept += [flag, folder]
    return kept


def faults_in(unit, arguments, targets):
    """of all places in the bodies of functions of the files"""
    import clang.cindex as clang    # here, because only this needs it

    tree = clang.Index.create().parse(str(ROOT / "src" / unit), [*arguments, "-Wno-everything"])
    problems = [one.spelling for one in tree.diagnostics if one.severity >= clang.Diagnostic.Error]
    if problems:
        raise RuntimeError(f"{unit}: {problems[0]}")
    texts, found = {}, {}
    kinds = clang.CursorKind

    def text_of(path):
        return texts.setdefault(path, (ROOT / "src" / path).read_bytes())

    def span(cursor):
        return cursor.extent.start.offset, cursor.extent.end.offset

    def look(cursor, path, inside):
        file = cursor.location.file
        if cursor.kind != kinds.TRANSLATION_UNIT and cursor.kind.is_declaration() and file:
            path = relative(file.name)
            if path not in targets and not cursor.kind == kinds.NAMESPACE:
                return
        first, last = span(cursor)
        words = text_of(path)[first:last].decode() if path in targets else ""
        if words and (cursor.kind.is_declaration() or cursor.kind == kinds.FUNCTION_TEMPLATE) and re.match(r"[^{;=]*\bconstexpr\b", words):
            return
        if cursor.kind == kinds.COMPOUND_STMT:
            inside = True
        children = list(cursor.get_children())
        if cursor.kind == kinds.IF_STMT and words.startswith("if constexpr"):
            children = children[1:]
        if inside and words:
            for new in changes(cursor, words, [span(child) for child in children], text_of(path), kinds):
                found[path, first, last, new] = Fault(path, first, last, cursor.extent.start.line, words, new)
        for child in children:
            look(child, path, inside)

    look(tree.cursor, None, False)
    return found


def changes(cursor, words, spans, text, kinds):
    """what an expression is replaced with"""
    piece = lambda k: text[spans[k][0]:spans[k][1]].decode()
    if cursor.kind in (kinds.BINARY_OPERATOR, kinds.COMPOUND_ASSIGNMENT_OPERATOR) and len(spans) == 2:
        operator = text[spans[0][1]:spans[1][0]].decode().strip()
        if operator in OTHER:
            yield f"({piece(0)}) {OTHER[operator]} ({piece(1)})"
    elif cursor.kind == kinds.UNARY_OPERATOR and len(spans) == 1 and words[0] in "-!":
        yield piece(0)
    elif cursor.kind == kinds.CONDITIONAL_OPERATOR and len(spans) == 3:
        yield piece(2)
    elif cursor.kind == kinds.FLOATING_LITERAL and re.fullmatch(r"[\d.e+-]+", words):
        yield "1.0" if float(words) == 0.0 else f"2.0 * {words}"


def relative(name):
    path = os.path.realpath(name)
    source = str(ROOT / "src") + "/"
    return path[len(source):] if path.startswith(source) else name


def drawn(build):
    """faults that do not lie in each other, the same as long as the sources are"""
    targets = {str(path.relative_to(ROOT / "src")) for pattern in TARGETS for path in (ROOT / "src").glob(pattern)}
    found = {}
    for unit in UNITS:
        found.update(faults_in(unit, arguments_of(build, unit), targets))
    places = sorted(found.values(), key=lambda fault: (fault.file, fault.first, fault.last, fault.new))
    random.Random(SEED).shuffle(places)
    chosen = []
    for fault in places:
        if len(chosen) == COUNT:
            break
        if not any(one.file == fault.file and one.first < fault.last and fault.first < one.last for one in chosen):
            chosen.append(fault)
    return sorted(chosen, key=lambda fault: (fault.file, fault.first)), len(places)


# --- the build that has them -----------------------------------------------------------------------------------------------------


def write_sources(folder, faults):
    """a copy of the project with all faults, each behind its number"""
    shutil.rmtree(folder, ignore_errors=True)
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], cwd=ROOT, capture_output=True, text=True, check=True).stdout
    for name in filter(None, listed.split("\n")):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, folder / name)
    (folder / "src" / "mutant.h").write_text(HEADER, encoding="utf-8")
    for path in {fault.file for fault in faults}:
        text = (folder / "src" / path).read_bytes()
        for number, fault in reversed(list(enumerate(faults, start=1))):
            if fault.file == path:
                both = f"(POTDEM_MUTANT({number}) ? ({fault.new}) : ({fault.old}))"
                text = text[:fault.first] + both.encode() + text[fault.last:]
        (folder / "src" / path).write_bytes(b'#include "mutant.h"\n' + text)


def build_them(source, build):
    subprocess.run(["cmake", "--preset", "default", "-S", source, "-B", build], cwd=source, check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", build, "--target", "lmp", "test_laws"], check=True)


# --- the tests -----------------------------------------------------------------------------------------------------------------


def noticed(number, source, build, tests, folder):
    """the program that fails, or None; and seconds"""
    environment = project.environment(build, POTDEM_MUTANT=str(number), PYTHONPATH=str(source / "tools"))
    begun = time.monotonic()
    pytest = [sys.executable, "-m", "pytest", "-q", "-x", "-p", "no:cacheprovider", "-p", "no:xdist", f"--basetemp={folder}",
              "-o", "console_output_style=classic"]
    pytest += [str(source / "unittest" / "python" / f"test_{name}.py") for name in tests]
    for command in ([str(build / "unittest" / "test_laws"), "--gtest_brief=1", "--gtest_fail_fast"], pytest):
        try:
            done = subprocess.run(command, capture_output=True, text=True, env=environment, cwd=source, timeout=LIMIT, check=False)
        except subprocess.TimeoutExpired:
            return "a test that takes too long", time.monotonic() - begun
        if done.returncode != 0:
            return first_failure(done.stdout + done.stderr), time.monotonic() - begun
    return None, time.monotonic() - begun


def first_failure(text):
    match = re.search(r"^FAILED \S*?(test_\w+)\.py|^ERROR \S*?(test_\w+)\.py|^\[  FAILED  \] (\w+)", text, re.MULTILINE)
    return next(filter(None, match.groups())) if match else "a program that ends badly"


def measure(build, work, count=None):
    """(text of the page's block, number of faults that should have been noticed and were not)"""
    faults, places = drawn(build)
    source, mutated = work / "mutants-source", work / "mutants"
    write_sources(source, faults)
    build_them(source, mutated)
    found, seconds = noticed(0, source, mutated, TESTS, work / "mutants-tests")
    if found:
        raise RuntimeError(f"without any fault {found} fails")
    print(f"all tests without a fault: {seconds:.0f} s", flush=True)
    faults = faults[:count]
    outcomes = {}
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        waiting = {pool.submit(noticed, n, source, mutated, TESTS, work / f"mutants-tests-{n}"): (n, fault)
                   for n, fault in enumerate(faults, start=1)}
        for done in concurrent.futures.as_completed(waiting):
            n, fault = waiting[done]
            outcomes[n], took = done.result()
            how = outcomes[n] or "NOT NOTICED"
            print(f"{len(outcomes)}/{len(faults)} {how} ({took:.0f} s): {n} line {fault.line} {fault.name}", flush=True)
            shutil.rmtree(work / f"mutants-tests-{n}", ignore_errors=True)
    return report(faults, outcomes, places)


def report(faults, outcomes, places):
    numbered = dict(enumerate(faults, start=1))
    alive = [numbered[n] for n in sorted(outcomes) if not outcomes[n]]
    harmless = [fault for fault in alive if fault.name in EQUIVALENT]
    missed = [fault for fault in alive if fault.name not in EQUIVALENT]
    by_laws = sum(1 for one in outcomes.values() if one and not one.startswith("test_"))
    real = len(faults) - len(harmless)
    text = f"{len(faults)} of {places} places were drawn. Tests notice {real - len(missed)} of the {real} faults that change something" \
        f" ({100 * (real - len(missed)) / real:.1f} %), {by_laws} of them those of the laws alone.\n\n"
    rows = [(fault.file, fault.line, f"`{shortened(fault.old)}`".replace("|", "\\|"), f"`{shortened(fault.new)}`".replace("|", "\\|"),
             EQUIVALENT.get(fault.name, "**not noticed**")) for fault in [*missed, *harmless]]
    if rows:
        text += table(["file", "line", "is", "became", ""], rows)
    return text, len(missed)
