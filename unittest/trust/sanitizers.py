# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""The tests in a LAMMPS that is compiled, all of it, with GCC's address and undefined-behaviour sanitizers, leaks included; a breaking body and a
heap on two ranks under valgrind; the styles /omp under the thread sanitizer; clang-tidy with the checks that stand here."""

import re
import shutil
import subprocess

import project
import threads

from potdem import running, same_answer
from potdem.paths import ROOT
from potdem.reports.writing import table

TITLE = "Memory and undefined behaviour"
FLAGS = "-O1 -g -DPOTDEM_PLAIN_CODE -fno-omit-frame-pointer -fsanitize=address,undefined -fno-sanitize=vptr -fno-sanitize-recover=undefined"
# Open MPI keeps some memory until the end; nothing of ours is on the list
LEAKS_OF_OTHERS = ["libopen-pal", "libopen-rte", "libmpi", "libpmix", "libhwloc", "libevent", "libudev", "mca_"]
# tests that load liblammps into Python, or build or install: not with the sanitizers' library in the way
LEFT_OUT = ["test_install", "test_simulation", "test_python_module", "test_build", "test_bench", "test_docs", "test_manual", "test_recipes",
            "test_walk_through", "test_howto_python", "test_architecture", "test_race", "test_report", "test_every_style"]
# bugprone: likely faults. Left out: what the style of LAMMPS asks for (narrowing of bigint, neighbouring parameters of one type, casts to
# bytes of restart files), and exceptions that LAMMPS's errors throw by design
CHECKS = ["bugprone-*", "-bugprone-easily-swappable-parameters", "-bugprone-narrowing-conversions", "-bugprone-exception-escape",
          "-bugprone-reserved-identifier", "-bugprone-macro-parentheses", "-bugprone-implicit-widening-of-multiplication-result",
          "clang-analyzer-*", "performance-*", "-performance-enum-size", "-performance-no-int-to-ptr", "misc-redundant-expression"]


def settings(work):
    """of the environment: a leak or an error ends a program badly, and with it its test"""
    list_of_leaks = work / "leaks-of-others"
    list_of_leaks.write_text("".join(f"leak:{name}\n" for name in LEAKS_OF_OTHERS), encoding="utf-8")
    return {"ASAN_OPTIONS": "detect_leaks=1", "LSAN_OPTIONS": f"suppressions={list_of_leaks}:print_suppressions=0",
            "UBSAN_OPTIONS": "print_stacktrace=1"}


def tests(folder, work):
    """(passed, failed, names of the failed)"""
    # lines are enough to find our own faults by: the compiler needs a quarter of the time without the variables
    project.build(folder, "-DCMAKE_BUILD_TYPE=None", f"-DCMAKE_CXX_FLAGS={FLAGS}", f"-DCMAKE_C_FLAGS={FLAGS}", "-DPOTDEM_EXTRA_OPTIONS=-g1",
                  targets=["lmp", "test_laws"])
    subprocess.run([folder / "unittest" / "test_laws", "--gtest_brief=1"], check=True, env=project.environment(folder, **settings(work)))
    passed, failed, said = project.run_tests(project.test_files(LEFT_OUT), folder, work / "sanitized-tests", **settings(work))
    (work / "sanitized.said").write_text(said, encoding="utf-8")
    return passed, failed, re.findall(r"^FAILED \S*?(test_\S+)", said, re.MULTILINE)


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
    """lines of clang-tidy on all sources of src"""
    listed = subprocess.run(["ninja", "-C", build, "-t", "compdb"], capture_output=True, text=True, check=True).stdout
    (build / "compile_commands.json").write_text(listed, encoding="utf-8")
    sources = sorted(str(path) for path in (ROOT / "src").rglob("*.cpp") if "plugin" not in path.name)
    lines = set()
    for source in sources:
        done = subprocess.run(["clang-tidy", "-p", build, f"--checks=-*,{','.join(CHECKS)}", "--quiet", f"--header-filter={ROOT}/src/.*", source],
                              capture_output=True, text=True, check=False)
        lines.update(line for line in done.stdout.splitlines() if re.match(rf"{ROOT}/src/\S+: (warning|error):", line))
    return sorted(line.removeprefix(f"{ROOT}/") for line in lines)


def measure(build, work):
    passed, failed, names = tests(work / "sanitized", work)
    valgrind = under_valgrind(build, work)
    races = threads.races(build, work)
    (work / "races.said").write_text("\n".join(races), encoding="utf-8")
    lines = tidy(build)
    rows = [("tests with the address and undefined-behaviour sanitizers, leaks included", f"{passed} passed", ", ".join(names) or "nothing"),
            ("valgrind, 2 ranks, a body that breaks", "memory read or written", f"{len(valgrind)} errors" if valgrind else "nothing"),
            ("thread sanitizer, 2 threads, a body that breaks and a heap", "data races", f"{len(races)} reports" if races else "nothing"),
            ("clang-tidy", f"`{', '.join(CHECKS)}`", f"{len(lines)} lines" if lines else "nothing")]
    return table(["what", "", "found"], rows), failed + len(valgrind) + len(races) + len(lines)
