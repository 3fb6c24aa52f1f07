# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""How far runs of LAMMPS have come: one line that is rewritten on a terminal, a line now and then elsewhere."""

import re
import sys
import threading
import time

TOTAL_STEPS = "POTDEM total steps "


class Progress:
    """a bar with per cent and time left, one line that is rewritten; on no terminal a line now and then"""

    def __init__(self, title):
        self.title, self.total, self.step = title, 0, 0
        self.begun = None    # first step, not 0 where a run goes on
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
            self.begun = self.step if self.begun is None else self.begun
            self.show()

    @property
    def fraction(self):
        return min(1.0, self.step / self.total) if self.total else 0.0

    def text(self):
        elapsed = time.monotonic() - self.start
        if not self.total:
            return f"{self.title}: step {self.step}, {clock(elapsed)}"
        return f"{self.title}: {bar(self.fraction, elapsed, (self.begun or 0) / self.total)}"

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


class OfScript(Progress):
    """of a script as LAMMPS repeats it (-echo both): plan: the steps of its runs, None where these are not known before. While the
    steps of a later run are not known the bar is that of the present one"""

    def __init__(self, title, plan):
        super().__init__(title)
        self.plan, self.count, self.before, self.first, self.last = plan, 0, 0, 0, 0
        self.wanted = None

    def read(self, line):
        if match := re.match(r"\s*run\s+(\d+)(.*)", line):
            self.before += self.last - self.first
            self.count, self.wanted = self.count + 1, (int(match[1]), "upto" in match[2])
            self.first = self.last = self.step
        elif self.wanted and (match := re.match(r"\s*Current step +: (\d+)", line)):
            self.first = self.step = int(match[1])
            steps, upto = self.wanted
            self.last = steps if upto else self.first + steps
            self.wanted = None
        super().read(line)

    @property
    def later(self):
        """steps of the runs that follow, or None"""
        later = self.plan[self.count:] if self.plan is not None and self.count <= len(self.plan) else [None]
        return None if None in later else sum(later)

    @property
    def fraction(self):
        if self.total:    # the script said it
            return super().fraction
        done, every = self.step - self.first, self.last - self.first
        if self.later is not None:
            done, every = done + self.before, every + self.before + self.later
        return min(1.0, done / every) if every > 0 else 0.0

    def text(self):
        which = "" if self.total or self.later is not None else f", run {self.count}"
        return f"{self.title}{which}: {bar(self.fraction, time.monotonic() - self.start)}"


class Part(Progress):
    """the progress of one of several runs at once, shown by the Together it belongs to"""

    def __init__(self, title, together):
        super().__init__(title)
        self.together = together

    def show(self):
        self.together.show()

    def end(self):
        self.together.end(self)


class Together:
    """one bar for several runs, each of which has a weight (about its seconds)"""

    def __init__(self, weights):
        self.weights, self.done, self.running = weights, 0.0, []
        self.total = sum(weights.values())
        self.start = self.shown = time.monotonic()
        self.terminal = sys.stdout.isatty()
        self.lock = threading.Lock()

    def part(self, title):
        part = Part(title, self)
        with self.lock:
            self.running.append(part)
        return part

    def show(self):
        with self.lock:
            now = time.monotonic()
            if now - self.shown < (0.2 if self.terminal else 30.0):
                return
            self.shown = now
            done = self.done + sum(self.weights[part.title] * part.fraction for part in self.running)
            names = ", ".join(part.title for part in self.running)
            print(("\r\033[K" if self.terminal else "") + f"{bar(done / self.total, now - self.start)}: {names}",
                  end="" if self.terminal else "\n", flush=True)

    def end(self, part):
        with self.lock:
            self.running.remove(part)
            self.done += self.weights[part.title]

    def say(self, text):
        with self.lock:
            print(("\r\033[K" if self.terminal else "") + text, flush=True)


def bar(fraction, elapsed, begun=0.0):
    left = clock(elapsed * (1.0 - fraction) / (fraction - begun)) if fraction > begun else "-:--"
    return f"[{('#' * round(30 * fraction)).ljust(30, '.')}] {100 * fraction:3.0f} %, {left} left"


def clock(seconds):
    return f"{int(seconds) // 60}:{int(seconds) % 60:02d}"
