# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""The tests in a LAMMPS that is compiled, all of it, with GCC's address and undefined-behaviour sanitizers, leaks included; a breaking body and a
heap on two ranks under valgrind; the styles /omp under the thread sanitizer; clang-tidy with the checks that stand here."""

import json
import os
import re
import shutil
import subprocess
from concurrent.futures import ThreadPoolExecutor

import project
import threads

from potdem import running, same_answer
from potdem.paths import ROOT
from potdem.reports.writing import table

TITLE = "Memory and undefined behaviour"
FLAGS = "-O1 -g -DPOTDEM_PLAIN_CODE -fno-omit-frame-pointer -fsanitize=address,undefined -fno-sanitize=vptr -fno-sanitize-recover=undefined"
# tests that load liblammps into Python, or build or install: not with the sanitizers' library in the way
LEFT_OUT = ["test_install", "test_simulation", "test_python_module", "test_build", "test_bench", "test_docs", "test_manual", "test_recipes",
            "test_walk_through", "test_howto_python", "test_architecture", "test_race", "test_report", "test_every_style", "test_fuzz",
            "test_versions"]
# bugprone: likely faults. Left out: what the style of LAMMPS asks for (narrowing of bigint, neighbouring parameters of one type, casts to
# bytes of restart files), exceptions that LAMMPS's errors throw by design, members that a function fills later, and the price of
# copies and growth where nothing is computed
CHECKS = ["bugprone-*", "-bugprone-easily-swappable-parameters", "-bugprone-narrowing-conversions", "-bugprone-exception-escape",
          "-bugprone-reserved-identifier", "-bugprone-macro-parentheses", "-bugprone-implicit-widening-of-multiplication-result",
          "clang-analyzer-*", "-clang-analyzer-optin.cplusplus.UninitializedObject", "performance-*", "-performance-enum-size",
          "-performance-no-int-to-ptr", "-performance-no-automatic-move", "-performance-inefficient-vector-operation",
          "misc-redundant-expression"]


# who asked for the memory of a leak, of those whose source is known: one of ours, or LAMMPS. What is only reached from it follows from it.
# Open MPI unloads its modules at the end, what they leak has no names any more
ASKED = re.compile(r"^ *#\d+ .* (?!\S*libsanitizer)(?!/usr/)(\S+/src/\S+)$", re.MULTILINE)
OURS = r"/src/(core|lammps)/"


def settings(reports):
    """of the environment: what is found goes into files, and programs end as they would without a sanitizer. Some tests start programs by
    stdbuf, whose library comes first"""
    where = f"log_path={reports}/report"
    return {"ASAN_OPTIONS": f"detect_leaks=1:exitcode=0:verify_asan_link_order=0:{where}", "UBSAN_OPTIONS": f"print_stacktrace=1:{where}"}


def found_in(reports):
    """the errors, and the leaks of ours"""
    found = []
    for path in sorted(reports.glob("report.*")):
        text = path.read_text(encoding="utf-8", errors="replace")
        found += re.findall(r"^.*(?:ERROR: AddressSanitizer|runtime error): .*$", text, re.MULTILINE)
        leaks = [block for block in re.split(r"\n\s*\n", text) if re.search(r"^Direct leak of", block, re.MULTILINE)]
        found += [block for block in leaks if (asked := ASKED.search(block)) and re.search(OURS, asked.group(1))]
    return found


def tests(folder, work):
    """(passed, names of the failed, what the sanitizers found)"""
    # lines are enough to find our own faults by: the compiler needs a quarter of the time without the variables
    project.build(folder, "-DCMAKE_BUILD_TYPE=None", f"-DCMAKE_CXX_FLAGS={FLAGS}", f"-DCMAKE_C_FLAGS={FLAGS}", "-DPOTDEM_EXTRA_OPTIONS=-g1",
                  targets=["lmp", "test_laws"])
    reports = work / "reports"
    shutil.rmtree(reports, ignore_errors=True)
    reports.mkdir(parents=True)
    subprocess.run([folder / "unittest" / "test_laws", "--gtest_brief=1"], check=True, env=project.environment(folder, **settings(reports)))
    passed, _, said = project.run_tests(project.test_files(LEFT_OUT), folder, work / "sanitized-tests", **settings(reports))
    (work / "sanitized.said").write_text(said, encoding="utf-8")
    return passed, re.findall(r"^(?:FAILED|ERROR) \S*?(test_\S+)", said, re.MULTILINE), found_in(reports)


def under_valgrind(build, work):
    """errors that valgrind finds on two ranks, in a scene in which bonds break and friction has a memory"""
    folder = work / "valgrind"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    script = same_answer.script().replace(f"run {same_answer.BROKEN - same_answer.WHOLE}", "run 200")
    (folder / "in.same").write_text(script, encoding="utf-8")
    command = ["valgrind", "--log-file=valgrind.%p", "--suppressions=/usr/share/openmpi/openmpi-valgrind.supp",
               str(build / "lmp"), "-in", "in.same", "-log", "none"]
    # valgrind does not know AVX-512
    subprocess.run(running.on_ranks(2, command), cwd=folder, env=running.environment(POTDEM_WIDTH="plain"), stdout=subprocess.DEVNULL, check=True)
    # those of Open MPI's start are in its own libraries
    text = "".join(path.read_text(encoding="utf-8") for path in folder.glob("valgrind.*"))
    blocks = re.split(r"==\d+== \n", text)
    return [block for block in blocks if re.search(r"Invalid|uninitialised", block) and re.search(r"LAMMPS_NS|POTDEM", block)]


def tidy(build):
    """lines of clang-tidy on all sources of the package, those that CMake makes of the list of laws too"""
    listed = subprocess.run(["ninja", "-C", build, "-t", "compdb"], capture_output=True, text=True, check=True).stdout
    (build / "compile_commands.json").write_text(listed, encoding="utf-8")
    sources = sorted({str(build / one["file"]) for one in json.loads(listed) if "/potdem.dir/" in one["output"]})

    def look(source):
        return subprocess.run(["clang-tidy", "-p", build, f"--checks=-*,{','.join(CHECKS)}", "--quiet", f"--header-filter={ROOT}/src/.*", source],
                              capture_output=True, text=True, check=False).stdout.splitlines()

    with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        lines = {line for said in pool.map(look, sources) for line in said}
    return sorted(line.removeprefix(f"{ROOT}/") for line in lines if re.match(rf"{ROOT}/src/\S+: (warning|error):", line))


def measure(build, work):
    passed, failed, reports = tests(work / "sanitized", work)
    valgrind = under_valgrind(build, work)
    races = threads.races(build, work)
    lines = tidy(build)
    for name, said in (("reports", reports), ("valgrind", valgrind), ("races", races), ("tidy", lines)):
        (work / f"{name}.said").write_text("\n".join(said), encoding="utf-8")
    wrong = [f"{len(reports)} reports"] * bool(reports) + failed
    rows = [("tests with the address and undefined-behaviour sanitizers, leaks included", f"{passed} passed", ", ".join(wrong) or "nothing"),
            ("valgrind, 2 ranks, a body that breaks", "memory read or written", f"{len(valgrind)} errors" if valgrind else "nothing"),
            ("thread sanitizer, 2 threads, a body that breaks and a heap", "data races", f"{len(races)} reports" if races else "nothing"),
            ("clang-tidy", f"`{', '.join(CHECKS)}`", f"{len(lines)} lines" if lines else "nothing")]
    return table(["what", "", "found"], rows), len(failed) + len(reports) + len(valgrind) + len(races) + len(lines)
