# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Runs LAMMPS: its command line and environment, and what a run leaves behind."""

import os
import re
import shutil
import subprocess
import sys
import threading
from dataclasses import dataclass
from pathlib import Path

from potdem import logs
from potdem.paths import LMP, ROOT

MATERIALS = ROOT / "potentials"
# Open MPI's start of a single rank without helpers, 0.05 instead of 0.4 s. Such ranks would share one folder of temporary files,
# which each removes at its end, so they go without: else some fail to start where several are run at a time
ALONE = {"OMPI_MCA_ess_singleton_isolated": "1", "OMPI_MCA_orte_create_session_dirs": "0"}


@dataclass
class Run:
    """folder: where LAMMPS ran; status: exit status, negative if killed; stdout: what it wrote to the screen; log: text of its
    log file, if it wrote one; cpu: user and system time of the process, s; peak: its largest memory, bytes"""

    folder: Path
    status: int
    stdout: str
    log: str = ""
    cpu: float = 0.0
    peak: int = 0

    @property
    def ended_well(self):
        return self.status == 0

    @property
    def error(self):
        """the text of the ERROR message on one line, or None"""
        return logs.error_message(self.stdout)

    @property
    def thermo(self):
        """column -> array, of all runs in the script"""
        return logs.thermo(self.log or self.stdout)

    @property
    def loop_cpu(self):
        """processor seconds of LAMMPS's own loops: it says which share of the time it had a core, of short loops it cannot tell"""
        loops = re.findall(r"^Loop time of (\S+).*?^(\S+)% CPU use", self.stdout, re.MULTILINE | re.DOTALL)
        return sum(float(seconds) * (min(1.0, float(share) / 100) if float(seconds) > 0.05 else 1.0) for seconds, share in loops)


def environment(**more):
    """what LAMMPS is run with, besides the user's own environment"""
    settings = {
        "OMP_NUM_THREADS": "1",
        # containers forbid the system call that Open MPI would copy between processes with
        "OMPI_MCA_btl_vader_single_copy_mechanism": "none",
    }
    if os.getuid() == 0:
        settings.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    folders = [str(MATERIALS), *filter(None, [os.environ.get("LAMMPS_POTENTIALS")])]
    # key by key: pytest changes one of its own while other threads start LAMMPS
    here = {name: value for name in list(os.environ) if (value := os.environ.get(name)) is not None}
    return {**settings, **here, "LAMMPS_POTENTIALS": os.pathsep.join(folders), **more}


def command(script, variables, log="none", nprocs=1, lmp=None, threads=1):
    """LAMMPS's command line, of the build's LAMMPS if no other is given; a variable may be a list of words; nothing is buffered,
    so that progress is seen at once; threads: of each rank, by the styles for OpenMP where there are several"""
    arguments = [str(lmp or LMP), "-in", str(script), "-log", str(log), "-nonbuf"]
    if threads > 1:
        arguments += ["-sf", "omp", "-pk", "omp", str(threads)]
    for name, value in variables.items():
        arguments += ["-var", name, *(str(v) for v in (value if isinstance(value, list) else [value]))]
    return on_ranks(nprocs, arguments) if nprocs > 1 else arguments


def on_ranks(nprocs, arguments):
    """the command line of an MPI program"""
    return [shutil.which("mpirun") or "mpirun", "--oversubscribe", "-np", str(nprocs), *map(str, arguments)]


def processor_seconds(arguments, folder, output, limit=None, more=None):
    """(exit status, processor seconds, peak memory in bytes) of a program whose output goes to a file; killed after `limit`
    seconds; more: variables of its environment"""
    with open(output, "w", encoding="utf-8") as file:
        process = subprocess.Popen(arguments, cwd=folder, env=environment(**(more or {})), stdin=subprocess.DEVNULL, stdout=file,
                                   stderr=subprocess.STDOUT)
        timer = threading.Timer(limit or 1e6, process.kill)
        timer.daemon = True
        timer.start()
        _, status, usage = os.wait4(process.pid, 0)
        timer.cancel()
    process.returncode = os.waitstatus_to_exitcode(status)
    return process.returncode, usage.ru_utime + usage.ru_stime, 1024 * usage.ru_maxrss


def run(script, variables, folder, nprocs=1, name="run", log="none", screen="screen", limit=None, lmp=None,
        threads=1, more=None):
    """a Run. script: path of an input script, or its text, which goes to in.<name>; LAMMPS runs in the folder, to which the paths
    of its log and of the file with its screen output are relative; limit: s; lmp: if not the build's; more: variables of its
    environment"""
    folder = Path(folder).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    if isinstance(script, str):
        (folder / f"in.{name}").write_text(script, encoding="utf-8")
        script = f"in.{name}"
    else:
        script = Path(script).resolve()
    settings = {**(ALONE if nprocs == 1 else {}), **(more or {})}
    status, cpu, peak = processor_seconds(command(script, variables, log, nprocs, lmp, threads), folder, folder / screen, limit, settings)
    return Run(folder, status, logs.read(folder / screen), logs.read(folder / log) if (folder / log).exists() else "", cpu, peak)


def must_run(script, variables, folder, **settings):
    """the same; ends the program where LAMMPS does not end well"""
    done = run(script, variables, folder, **settings)
    if not done.ended_well:
        sys.exit(f"LAMMPS failed (exit status {done.status}) in {done.folder}:\n{done.error or done.stdout[-2000:]}")
    return done


def watched(arguments, folder, progress):
    """runs a command line of LAMMPS, with its progress shown; None when LAMMPS ended well, else what it said"""
    output = []
    line_by_line = ["stdbuf", "-oL", *arguments]    # LAMMPS's own -nonbuf is not heeded for what goes to a pipe
    with subprocess.Popen(line_by_line, cwd=folder, env=environment(), stdin=subprocess.DEVNULL, text=True,
                          errors="replace", stdout=subprocess.PIPE, stderr=subprocess.STDOUT) as process:
        for line in process.stdout:
            progress.read(line)
            output.append(line)
    progress.end()
    if process.returncode == 0:
        return None
    message = logs.error_message("".join(output))
    return f"ERROR: {message}" if message else "".join(output[-10:]) + f"exit status {process.returncode}"
