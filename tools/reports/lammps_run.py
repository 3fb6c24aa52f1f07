"""Runs LAMMPS for the reports: what a run left behind and the processor seconds that it took."""

import os
import re
import subprocess
import sys
import threading
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "examples" / "harness"))
import logfile  # noqa: E402
import runner  # noqa: E402


@dataclass
class Run:
    """folder: where LAMMPS ran; cpu: user and system time of the process, s; status: exit status, negative if killed"""

    folder: Path
    status: int
    cpu: float
    output: str

    @property
    def error(self):
        """the text of the ERROR message, or None"""
        return logfile.error_message(self.output)

    @property
    def warnings(self):
        return re.findall(r"^WARNING: (.*?)(?: \(\S+:\d+\))?$", self.output, re.MULTILINE)

    @property
    def thermo(self):
        """column -> array, of all runs in the script"""
        return logfile.thermo(self.output)

    @property
    def loop(self):
        """LAMMPS's own loop times, s, added up"""
        return sum(float(seconds) for seconds in re.findall(r"^Loop time of (\S+)", self.output, re.MULTILINE))

    @property
    def loop_cpu(self):
        """processor seconds of the same loops: LAMMPS says which share of the time it had a core, of short loops it cannot tell"""
        loops = re.findall(r"^Loop time of (\S+).*?^(\S+)% CPU use", self.output, re.MULTILINE | re.DOTALL)
        return sum(float(seconds) * (min(1.0, float(share) / 100) if float(seconds) > 0.05 else 1.0) for seconds, share in loops)

    @property
    def ended_well(self):
        return self.status == 0


def processor_seconds(arguments, folder, output, limit=None):
    """(exit status, processor seconds) of a program whose output goes to a file; killed after `limit` seconds"""
    with open(output, "w", encoding="utf-8") as file:
        process = subprocess.Popen(arguments, cwd=folder, env=runner.environment(), stdin=subprocess.DEVNULL, stdout=file,
                                   stderr=subprocess.STDOUT)
        timer = threading.Timer(limit or 1e6, process.kill)
        timer.daemon = True
        timer.start()
        _, status, usage = os.wait4(process.pid, 0)
        timer.cancel()
    process.returncode = os.waitstatus_to_exitcode(status)
    return process.returncode, usage.ru_utime + usage.ru_stime


def run(script, variables, folder, nprocs=1, limit=None):
    """script: path of an input script, or its text; what LAMMPS writes goes to the folder"""
    folder = Path(folder).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    if isinstance(script, str):
        (folder / "in.report").write_text(script, encoding="utf-8")
        script = folder / "in.report"
    arguments = runner.command(runner.LMP, Path(script).resolve(), variables, "none", nprocs)
    status, cpu = processor_seconds(arguments, folder, folder / "screen", limit)
    return Run(folder, status, cpu, (folder / "screen").read_text(encoding="utf-8", errors="replace"))


def must_run(script, variables, folder, **settings):
    """the same; ends the report where LAMMPS does not end well"""
    done = run(script, variables, folder, **settings)
    if not done.ended_well:
        sys.exit(f"LAMMPS failed (exit status {done.status}), see {done.folder / 'screen'}:\n{done.error or done.output[-2000:]}")
    return done
