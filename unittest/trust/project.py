# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""What the parts have in common: a build in a folder of its own, and the Python tests with a build."""

import os
import re
import subprocess
import sys
from pathlib import Path

from potdem import running
from potdem.paths import ROOT


def build(folder, *settings, targets=()):
    """configured once, with these settings of CMake, and brought up to date; all targets, or these"""
    if not (folder / "build.ninja").exists():
        subprocess.run(["cmake", "--preset", "default", "-S", ROOT, "-B", folder, *settings], cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", folder, *(["--target", *targets] if targets else [])], check=True)


def lammps_source(folder):
    """of the LAMMPS that the build in a folder is for"""
    cache = (folder / "CMakeCache.txt").read_text(encoding="utf-8")
    return Path(re.search(r"^POTDEM_LAMMPS_DIR:\w+=(.*)$", cache, re.MULTILINE).group(1)) / "src"


def mpi(stage):
    """options of the compiler for MPI; stage: compile or link"""
    return subprocess.run(["mpicxx", f"--showme:{stage}"], capture_output=True, text=True, check=True).stdout.split()


def compile_against_lammps(source, program, build, folder, *options):
    """by Clang, with the liblammps without our styles of a build, for the plugin in a folder; options come before that library"""
    plain = build / "unittest" / "plain"
    subprocess.run(["clang++", "-std=c++17", *options, "-I", lammps_source(folder), "-DLAMMPS_LIB_MPI", *mpi("compile"), source, "-o", program,
                    "-L", plain, "-llammps", f"-Wl,-rpath,{plain}", *mpi("link")], check=True)


def environment(folder, **more):
    """of tests with the build in this folder"""
    return {**os.environ, "POTDEM_BUILD": str(folder), "PYTHONPATH": str(ROOT / "tools"), **more}


def run(script, folder, name, **settings):
    """a Run (potdem.running) that ended well"""
    done = running.run(script, {}, folder, name=name, **settings)
    if not done.ended_well:
        raise RuntimeError(f"{name}: {done.error or done.stdout[-500:]}")
    return done


def test_files(left_out):
    """of the Python tests, without some names"""
    return [path for path in sorted((ROOT / "unittest" / "python").glob("test_*.py")) if path.stem not in left_out]


def run_tests(files, folder, temporary, **more):
    """(passed, failed, output) of files of tests, on all cores, with the build in a folder; more: variables of the environment"""
    done = subprocess.run([sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "-n", "auto", "--dist", "loadfile",
                           f"--basetemp={temporary}", *map(str, files)], cwd=ROOT, env=environment(folder, **more), capture_output=True,
                          text=True, check=False)
    count = {word: int(number) for number, word in re.findall(r"(\d+) (passed|failed|error)", done.stdout.splitlines()[-1])}
    return count.get("passed", 0), count.get("failed", 0) + count.get("error", 0), done.stdout
