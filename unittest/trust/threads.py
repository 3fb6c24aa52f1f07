# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""The styles /omp under Clang's thread sanitizer: the package as a plugin, in a LAMMPS whose main program and OpenMP are Clang's, because the
sanitizer understands only that one (by libarcher)."""

import re
import subprocess

import project

from potdem import same_answer

SANITIZED = ["-O1", "-g", "-DPOTDEM_PLAIN_CODE", "-fsanitize=thread"]
# grains that fall on a floor and on each other, with all that the styles for threads can do
HEAP = """units si
atom_style sphere
boundary f f f
region box block -6 6 -6 6 0 20 units box
create_box 2 box
neighbor 0.3 bin
lattice sc 1.1
region grains block -4 4 -4 4 0.6 9 units box
create_atoms 1 region grains
set group all type/fraction 2 0.5 4711
set group all diameter 1.0
set group all density 1.0
pair_style potdem/hertz rotation yes
pair_coeff 1 1 2000 0.3 restitution 0.5 friction 0.4 mindlin rolling 0.1 0.5 0.1
pair_coeff 2 2 3000 0.2 restitution 0.6 friction 0.3 mindlin rolling 0.1 0.5 0.1
velocity all create 2.0 4711 loop geom
fix walls all potdem/wall/region box law hertz 2000 0.3 restitution 0.5 friction 0.4 mindlin rotation yes
fix falls all gravity 9.81 vector 0 0 -1
fix slower all potdem/damping 0.1
fix moves all nve/sphere
timestep 1e-3
thermo 50
thermo_style custom step pe ke press
run 300
"""


def program(build, folder):
    """LAMMPS, with the plugin in its folder"""
    project.build(folder, "-DCMAKE_CXX_COMPILER=clang++", f"-DPOTDEM_EXTRA_OPTIONS={';'.join(SANITIZED)}", targets=["potdemplugin"])
    lmp = folder / "lmp_threads"
    # its libomp comes before the libgomp of liblammps, and serves both
    project.compile_against_lammps(project.lammps_source(folder) / "main.cpp", lmp, build, folder, *SANITIZED, "-fopenmp",
                                   "-Wl,--no-as-needed", "-lomp")
    return lmp


def reports_of(script, name, lmp, work, settings):
    done = project.run(script, work / f"threads-{name}", name, lmp=lmp, threads=2, more=settings)
    return re.findall(r"^WARNING: ThreadSanitizer: .*?^=+$", done.stdout, re.MULTILINE | re.DOTALL)


def races(build, work):
    """reports of the sanitizer that name a source of ours"""
    folder = work / "threads"
    lmp = program(build, folder)
    archer = subprocess.run(["clang++", "-print-file-name=libarcher.so"], capture_output=True, text=True, check=True).stdout.strip()
    settings = {"LAMMPS_PLUGIN_PATH": str(folder), "OMP_TOOL_LIBRARIES": archer, "TSAN_OPTIONS": "ignore_noninstrumented_modules=1 exitcode=0"}
    # without libarcher the sanitizer knows no barrier, and all that threads share must look like a race to it
    if not reports_of(same_answer.script(), "control", lmp, work, {**settings, "OMP_TOOL": "disabled"}):
        raise RuntimeError("the thread sanitizer sees nothing of the threads: is the plugin compiled with it?")
    found = []
    for name, script in (("breaking", same_answer.script()), ("heap", HEAP)):
        found += reports_of(script, name, lmp, work, settings)
    return [report for report in found if "/src/lammps/" in report or "/src/core/" in report]
