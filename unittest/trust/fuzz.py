# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""libFuzzer (fuzz.cpp) on material files, arguments of commands, and sequences of commands; the package compiled by Clang with the address
and undefined-behaviour sanitizers, LAMMPS as it is in the build."""

import os
import re
import shutil
import subprocess

import project

from potdem.paths import ROOT
from potdem.reports.writing import table

TITLE = "Whatever is fed to it"
KINDS = {"material": "material files", "arguments": "arguments of commands", "sequence": "sequences of commands"}
CORPUS = ROOT / "unittest" / "trust" / "corpus"
SANITIZED = ["-O1", "-g", "-DPOTDEM_PLAIN_CODE", "-fno-omit-frame-pointer", "-fsanitize=address,undefined", "-fno-sanitize=vptr",
             "-fno-sanitize-recover=undefined"]
MINUTES = 10.0    # of processor time, all kinds together


def built(build, folder):
    """(program, plugin)"""
    project.build(folder, "-DCMAKE_CXX_COMPILER=clang++", f"-DPOTDEM_EXTRA_OPTIONS={';'.join([*SANITIZED, '-fsanitize=fuzzer-no-link'])}",
                  targets=["potdemplugin"])
    program = folder / "fuzz"
    project.compile_against_lammps(ROOT / "unittest" / "trust" / "fuzz.cpp", program, build, folder, *SANITIZED, "-fsanitize=fuzzer", "-rdynamic")
    return program, folder / "potdemplugin.so"


def fuzz(program, plugin, kind, seconds, folder, corpus=None):
    """(inputs that were run, text of what was found or None); new inputs that reach new code stay in `folder`"""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    environment = {**os.environ, "POTDEM_FUZZ": kind, "POTDEM_FUZZ_PLUGIN": str(plugin), "OMP_NUM_THREADS": "1",
                   "ASAN_OPTIONS": "detect_leaks=0", "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
    (folder / "new").mkdir()
    command = [program, f"-max_total_time={seconds:.0f}", "-max_len=4000" if kind == "material" else "-max_len=40", "-timeout=60",
               "-rss_limit_mb=4000", "-print_final_stats=1", "-close_fd_mask=1", "-seed=1", "new"]
    command += [corpus] if corpus and corpus.exists() else []
    done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, errors="replace", check=False)
    runs = re.search(r"stat::number_of_executed_units: (\d+)", done.stderr)
    found = re.search(r"^(==\d+==ERROR.*|.*runtime error:.*|.*libFuzzer: (?:timeout|out-of-memory).*)", done.stderr, re.MULTILINE)
    (folder / "said").write_text(done.stderr, encoding="utf-8")
    problem = None if done.returncode == 0 else (found.group(1) if found else f"exit status {done.returncode}")
    return int(runs.group(1)) if runs else 0, problem


def measure(build, work, minutes=MINUTES):
    program, plugin = built(build, work / "fuzz-build")
    rows, wrong = [], 0
    for kind, name in KINDS.items():
        runs, problem = fuzz(program, plugin, kind, 60 * minutes / len(KINDS), work / f"fuzz-{kind}", CORPUS / kind)
        print(f"  {name}: {runs} inputs, {problem or 'nothing found'}", flush=True)
        wrong += problem is not None
        rows.append((name, runs, problem or "nothing"))
    text = f"""{minutes:.0f} minutes of libFuzzer with the address and undefined-behaviour sanitizers, beginning with the kept inputs in
[unittest/trust/corpus](../unittest/trust/corpus). After each error LAMMPS goes on, as it does for those who drive it from Python.

""" + table(["fed with", "inputs", "found"], rows)
    return text, wrong
