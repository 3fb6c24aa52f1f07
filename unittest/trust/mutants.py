# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Faults put into the laws, the contact and the loops over pairs and bonds: does a test notice each?

Clang's parser (python3-clang) finds places in the bodies of functions; at each drawn place the expression e becomes

    (POTDEM_MUTANT(n) ? fault : e)

so that one build has all faults, and the environment variable POTDEM_MUTANT switches one on. Nothing of this is in the sources of the
package: they are copied to the build folder first. The tests are run once without a fault, to learn which faults each of them comes to;
then, for each fault, those that come to it, the quickest first, until one fails."""

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
from dataclasses import dataclass, field
from pathlib import Path

import project

from potdem.paths import ROOT
from potdem.reports.writing import table

TITLE = "Faults that tests notice"
COUNT, SEED = 200, 11
LEAST = 95.0    # %, of the faults that change something
# the choice of a width is not among them: the build with faults has one only
TARGETS = ["core/laws/[!w]*.h", "core/contact/*.h", "lammps/pair/pair_potdem_loop.h", "lammps/bond/bond_potdem_loop.h"]
# what includes all of them
UNITS = ["pair_potdem_hertz.cpp", "bond_potdem_laws.cpp", "fix_potdem_wall_region.cpp"]
# beside the laws' own tests
TESTS = ["pair_laws", "two_particles", "conservation", "damping", "restitution", "failure", "dead_bonds", "stress", "timestep", "monitor",
         "energy_ledger", "dmt", "two_dimensions", "hybrid", "wall_laws", "friction_springs", "wall_friction", "wall_springs", "rolling",
         "chung_ooi", "bodies", "strain", "invariances", "parallel", "restart", "resume", "adapt", "collisions", "waves", "left_out"]
PLENTY = 150.0    # s of tests for one fault: what these do not notice counts as not noticed
HEADER = """#pragma once
#include <cstdio>
#include <cstdlib>
// the faults that this program comes to; at its end their numbers are appended to the file POTDEM_REACHED
struct PotdemMutants {
  int on = std::getenv("POTDEM_MUTANT") ? std::atoi(std::getenv("POTDEM_MUTANT")) : 0;
  bool reached[COUNT + 1] = {};
  bool is(int n)
  {
    reached[n] = true;
    return on == n;
  }
  ~PotdemMutants()
  {
    const char *const name = std::getenv("POTDEM_REACHED");
    std::FILE *const file = name ? std::fopen(name, "a") : nullptr;
    if (!file) return;
    for (int n = 1; n <= COUNT; n++)
      if (reached[n]) std::fprintf(file, "%d ", n);
    std::fclose(file);
  }
};
inline PotdemMutants potdem_mutants;
#define POTDEM_MUTANT(n) potdem_mutants.is(n)
"""
OTHER = {"+": "-", "-": "+", "*": "/", "/": "*", "<": ">=", ">": "<=", "<=": ">", ">=": "<", "==": "!=", "!=": "==", "&&": "||", "||": "&&",
         "+=": "-=", "-=": "+=", "*=": "/=", "/=": "*="}

# faults that change nothing, with the reason; by file and text, because numbers change with the sources
EQUIVALENT = {
    "core/contact/contact.h: 0.0 → 1.0 in: {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}};": "the torque of rolling is read only where a law of rolling sets it",
    "core/contact/contact.h: 0.0 → 1.0 in: shear_ratio_of(kernel, 0), 0.0, false},": "the radius is for forces that depend on the speed, not for springs",
    "core/laws/restitution.h: 1.0 → 2.0 * 1.0 in: double low = 0.0, high = 1.0 + 1.0 / std::sqrt(e);": "where the halving begins",
    "core/laws/tangential_spring.h: 0.0 → 1.0 in: const double scale = below > 0.0 ? std::sqrt(above / below) : 0.0;":
        "what is scaled there is zero",
    "core/laws/viscous.h: 1.0 → 2.0 * 1.0 in: return {0.5 * (a.H + b.H), a.attract != 0.0 || b.attract != 0.0 ? 1.0 : 0.0};":
        "any number but 0 says yes",
    "lammps/bond/bond_potdem_loop.h: 2.0 * half_modulus → (2.0) / (half_modulus) in: return kernel.evaluate(r, re, 2.0 * half_modulus, state).energy;":
        "laws that take one bond at a time, of which the package has none; the walk-through's law is one, and its tests notice",
    "core/laws/strength_scatter.h: 1.0 + parameter * z → (1.0) - (parameter * z) in: return 1.0 + parameter * z;": "z is as often negative as positive",
}

# those that no test notices, with the reason
MISSED = {
    "lammps/bond/bond_potdem_loop.h: q > CRUSHED → (q) <= (CRUSHED) in: auto doubtful = !(q > CRUSHED);":
        "each of four bonds is looked at as soon as one of them is not crushed",
}


@dataclass
class Fault:
    file: str      # below src
    first: int     # bytes
    last: int
    line: int
    old: str
    new: str
    code: str      # the line in which it begins

    @property
    def name(self):
        return f"{self.file}: {shortened(self.old)} → {shortened(self.new)} in: {self.code}"


def line_at(text, place):
    return text[text.rfind(b"\n", 0, place) + 1:].split(b"\n", 1)[0].decode().strip()


def shortened(text):
    return re.sub(r"\s+", " ", text)


# --- the places ----------------------------------------------------------------------------------------------------------------


def compilation(build, unit):
    """(path of the source, how the build compiles it)"""
    listed = subprocess.run(["ninja", "-C", build, "-t", "compdb"], capture_output=True, text=True, check=True).stdout
    file, command = next((one["file"], shlex.split(one["command"])) for one in json.loads(listed) if one["file"].endswith(f"/{unit}"))
    kept = [word for word in command if re.match(r"-(I|D|std)", word)]
    for flag, folder in zip(command, command[1:]):
        if flag == "-isystem":
            kept += [flag, folder]
    return str(build / file), kept


def faults_in(source, arguments, targets):
    """of all places in the bodies of functions of the files"""
    import clang.cindex as clang    # here, because only this needs it

    tree = clang.Index.create().parse(source, [*arguments, "-Wno-everything"])
    problems = [one.spelling for one in tree.diagnostics if one.severity >= clang.Diagnostic.Error]
    if problems:
        raise RuntimeError(f"{source}: {problems[0]}")
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
                found[path, first, last, new] = Fault(path, first, last, cursor.extent.start.line, words, new,
                                                      line_at(text_of(path), first))
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
        found.update(faults_in(*compilation(build, unit), targets))
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
    (folder / "src" / "mutant.h").write_text(HEADER.replace("COUNT", str(len(faults))), encoding="utf-8")
    for path in {fault.file for fault in faults}:
        text = (folder / "src" / path).read_bytes()
        for number, fault in reversed(list(enumerate(faults, start=1))):
            if fault.file == path:
                both = f"(POTDEM_MUTANT({number}) ? ({fault.new}) : ({fault.old}))"
                text = text[:fault.first] + both.encode() + text[fault.last:]
        (folder / "src" / path).write_bytes(b'#include "mutant.h"\n' + text)


def build_them(source, build):
    """not for the wider registers: that takes many times as long, and the faults are the same"""
    subprocess.run(["cmake", "--preset", "default", "-S", source, "-B", build, "-DPOTDEM_EXTRA_OPTIONS=-DPOTDEM_PLAIN_CODE"], cwd=source,
                   check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", build, "--target", "lmp", "test_laws"], check=True)


# --- the tests -----------------------------------------------------------------------------------------------------------------


@dataclass
class Mutated:
    """the sources and the build with all faults, and what is learnt without any: {test: (seconds, faults that it comes to)}"""
    source: Path
    build: Path
    work: Path
    tests: dict = field(default_factory=dict)

    def settings(self, **more):
        """arguments for subprocess.run; more: variables of the environment"""
        environment = project.environment(self.build, PYTHONPATH=f"{self.source / 'tools'}{os.pathsep}{Path(__file__).parent}", **more)
        return {"env": environment, "cwd": self.source, "capture_output": True, "text": True, "check": False}

    def pytest(self, name, *options):
        """its command line; name: of the folder for what the tests write"""
        return [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", f"--basetemp={self.work / name}",
                "-o", "console_output_style=classic", *options]

    def learn(self):
        """runs all tests without a fault"""
        folder = self.work / "mutants-reached"
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        files = [f"unittest/python/test_{name}.py" for name in TESTS]
        done = subprocess.run(self.pytest("mutants-tests", "-p", "reaching", "-n", "auto", "--dist", "loadfile", *files),
                              **self.settings(POTDEM_REACHING=str(folder)))
        if done.returncode != 0:
            raise RuntimeError(f"without any fault {first_failure(done.stdout + done.stderr)} fails")
        for part in folder.glob("tests.*"):
            for line in map(json.loads, part.read_text(encoding="utf-8").splitlines()):
                self.tests[line["test"]] = line["seconds"], set(line["reached"])
        self.share_runs()

    def share_runs(self):
        """a test that looks at what a fixture has run once for all of its file comes to what the file comes to"""
        of_file = {}
        for name, (_, reached) in self.tests.items():
            of_file.setdefault(name.split("::")[0], set()).update(reached)
        self.tests = {name: (seconds, reached or of_file[name.split("::")[0]]) for name, (seconds, reached) in self.tests.items()}

    def quickest(self, number):
        """the tests that come to a fault, as many as are plenty"""
        chosen, total = [], 0.0
        for name, (seconds, reached) in sorted(self.tests.items(), key=lambda item: item[1][0]):
            if number in reached and total + seconds < PLENTY:
                chosen.append(name)
                total += seconds
        return chosen

    def notices(self, number):
        """(what fails with this fault, or None; seconds)"""
        begun = time.monotonic()
        settings = self.settings(POTDEM_MUTANT=str(number))
        tests, folder = self.quickest(number), f"mutants-tests-{number}"
        try:
            done = subprocess.run([self.build / "unittest" / "test_laws", "--gtest_brief=1", "--gtest_fail_fast"], **settings, timeout=PLENTY)
            if done.returncode == 0 and tests:
                done = subprocess.run(self.pytest(folder, "-x", "-p", "no:xdist", *tests), **settings, timeout=3.0 * PLENTY)
            found = None if done.returncode == 0 else first_failure(done.stdout + done.stderr)
        except subprocess.TimeoutExpired:
            found = "a test that takes too long"
        shutil.rmtree(self.work / folder, ignore_errors=True)
        return found, time.monotonic() - begun


def first_failure(text):
    match = re.search(r"^FAILED \S*?(test_\w+)\.py|^ERROR \S*?(test_\w+)\.py|^\[  FAILED  \] (\w+)", text, re.MULTILINE)
    return next(filter(None, match.groups())) if match else "a program that ends badly"


def measure(build, work, count=None):
    """(text of the page's block, number of faults that should have been noticed and were not)"""
    faults, places = drawn(build)
    mutated = Mutated(work / "mutants-source", work / "mutants", work)
    write_sources(mutated.source, faults)
    build_them(mutated.source, mutated.build)
    mutated.learn()
    print(f"{len(mutated.tests)} tests without a fault: {sum(seconds for seconds, _ in mutated.tests.values()):.0f} s", flush=True)
    faults = faults[:count]
    outcomes = {}
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        waiting = {pool.submit(mutated.notices, n): (n, fault) for n, fault in enumerate(faults, start=1)}
        for done in concurrent.futures.as_completed(waiting):
            n, fault = waiting[done]
            outcomes[n], took = done.result()
            how = outcomes[n] or "NOT NOTICED"
            print(f"{len(outcomes)}/{len(faults)} {how} ({took:.0f} s): {n} line {fault.line} {fault.name}", flush=True)
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
             EQUIVALENT.get(fault.name) or f"**not noticed** {MISSED.get(fault.name, '')}") for fault in [*missed, *harmless]]
    if rows:
        text += table(["file", "line", "is", "became", ""], rows)
    enough = 100.0 * (real - len(missed)) / real >= LEAST
    return text, sum(fault.name not in MISSED for fault in missed) if enough else len(missed)
