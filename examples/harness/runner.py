"""Runs LAMMPS on a scene's script and shows how it gets on."""

import os
import shutil
import subprocess
import sys
import time
from pathlib import Path

import logfile

LMP = Path(__file__).resolve().parent.parent.parent / "build" / "lmp"
TOTAL_STEPS = "POTDEM total steps "


class Progress:
    """a bar with per cent and time left, one line that is rewritten; on no terminal a line now and then"""

    def __init__(self, title):
        self.title, self.total, self.step = title, 0, 0
        self.start = self.shown = time.monotonic()
        self.in_thermo = False
        self.terminal = sys.stdout.isatty()

    def read(self, line):
        """takes one line of LAMMPS's screen output"""
        words = line.split()
        if line.startswith(TOTAL_STEPS):
            self.total = int(float(line[len(TOTAL_STEPS) :]))
        elif words[:1] == ["Step"]:
            self.in_thermo = True
        elif line.startswith("Loop time of"):
            self.in_thermo = False
        elif self.in_thermo and words and words[0].isdigit():
            self.step = int(words[0])
            self.show()

    def text(self):
        elapsed = time.monotonic() - self.start
        if not self.total:
            return f"{self.title}: step {self.step}, {clock(elapsed)}"
        fraction = min(1.0, self.step / self.total)
        left = clock(elapsed * (1.0 - fraction) / fraction) if fraction > 0 else "-:--"
        bar = ("#" * round(30 * fraction)).ljust(30, ".")
        return f"{self.title}: [{bar}] {100 * fraction:3.0f} %, {left} left"

    def show(self):
        now = time.monotonic()
        if now - self.shown < (0.2 if self.terminal else 20.0):
            return
        self.shown = now
        print(("\r\033[K" if self.terminal else "") + self.text(), end="" if self.terminal else "\n", flush=True)

    def end(self):
        if self.terminal:
            print("\r\033[K", end="", flush=True)
        print(f"{self.title}: {clock(time.monotonic() - self.start)}", flush=True)


def clock(seconds):
    return f"{int(seconds) // 60}:{int(seconds) % 60:02d}"


def environment():
    """what LAMMPS is run with, besides the user's own environment"""
    settings = {
        "OMP_NUM_THREADS": "1",
        # containers forbid the system call that Open MPI would copy between processes with
        "OMPI_MCA_btl_vader_single_copy_mechanism": "none",
    }
    if os.getuid() == 0:
        settings.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    return {**settings, **os.environ}


def command(lmp, script, variables, log, nprocs):
    """LAMMPS's command line; nothing is buffered so that progress is seen at once"""
    arguments = [str(lmp), "-in", str(script), "-log", str(log), "-nonbuf"]
    for name, value in variables.items():
        arguments += ["-var", name, *(str(v) for v in (value if isinstance(value, list) else [value]))]
    if nprocs > 1:
        arguments = [shutil.which("mpirun") or "mpirun", "--oversubscribe", "-np", str(nprocs), *arguments]
    return arguments


def run(arguments, folder, title):
    """None when LAMMPS ended well, else what it said"""
    progress = Progress(title)
    output = []
    with subprocess.Popen(arguments, cwd=folder, env=environment(), stdin=subprocess.DEVNULL, text=True,
                          errors="replace", stdout=subprocess.PIPE, stderr=subprocess.STDOUT) as process:
        for line in process.stdout:
            progress.read(line)
            output.append(line)
    progress.end()
    if process.returncode == 0:
        return None
    message = logfile.error_message("".join(output))
    return f"ERROR: {message}" if message else "".join(output[-10:]) + f"exit status {process.returncode}"
