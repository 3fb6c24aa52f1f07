# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""What all benchmarks share: cases, how LAMMPS is run for them, and what is read from its output."""

import re
import statistics
import tempfile
from dataclasses import dataclass, field, replace
from pathlib import Path

from potdem import running

HERE = Path(__file__).resolve().parent
SHORTEST = 0.05    # s, of a loop of which LAMMPS can tell what share of a processor it had


@dataclass
class Case:
    """what is timed: the parts of LAMMPS's loop that count, per bond, contact or particle; less the cost of `base`"""

    name: str
    style: str
    per: str
    parts: tuple
    variables: dict = field(default_factory=dict)
    base: "Case | None" = None
    script: str = "in.cost"
    ranks: int = 1
    threads: int = 1


@dataclass
class Timed:
    """of a run: for each `run` of the script the seconds of the loop's parts; the number in the last column of the thermo output;
    processor seconds, and bytes at the peak, of the whole process; what it printed"""

    loops: list
    links: int
    cpu: float
    peak: int
    text: str

    @property
    def set_up(self):
        """processor seconds of all but the loops; of one rank"""
        return self.cpu - sum(loop["Loop"] for loop in self.loops)


class Bench:
    """runs each script once a round"""

    def __init__(self, size, steps, lmp=None):
        self.size, self.steps, self.lmp = size, steps, lmp
        self.known = {}

    def given(self, case):
        return {"n": self.size, "steps": self.steps, "style": case.style, **case.variables}

    def timed(self, case):
        key = str((case.script, case.style, case.variables, case.ranks, case.threads))
        if key not in self.known:
            self.known[key] = launch(case.script, self.given(case), self.lmp, case.ranks, case.threads)
        return self.known[key]

    def run(self, case):
        """seconds of the loop's parts that count for the case, and the number of bonds, contacts or particles"""
        timed = self.timed(case)
        return sum(timed.loops[0][part] for part in case.parts), self.given(case)["n"] ** 3 if case.per == "particle" else timed.links

    def cost(self, case):
        """ns each and step"""
        seconds, count = self.run(case)
        without = self.run(case.base)[0] if case.base else 0.0
        return 1e9 * (seconds - without) / count / self.given(case)["steps"]


def launch(script, variables, lmp=None, ranks=1, threads=1):
    """lmp: if not the build's"""
    given = {name: value for name, value in variables.items() if value != ""}
    with tempfile.TemporaryDirectory() as folder:
        done = running.must_run(HERE / script, given, folder, lmp=lmp, nprocs=ranks, threads=threads)
    return Timed(loops_of(done.stdout), last_number(done.stdout), done.cpu, done.peak, done.stdout)


def loops_of(text):
    """seconds of each part of the loop, of each run. Of a process alone, that of the processor: on a busy machine it does not have one all
    the time. Ranks and threads that wait for each other keep it busy, and are timed by the clock; `Clock`: the loop, in any case by it"""
    found = []
    for loop in text.split("Loop time of ")[1:]:
        seconds = float(loop.split()[0])
        alone = re.search(r"^(\S+)% CPU use with 1 MPI tasks x 1 ", loop, re.MULTILINE)
        share = min(1.0, float(alone.group(1)) / 100) if alone and seconds > SHORTEST else 1.0
        parts = {name: share * float(value) for name, value in re.findall(r"^(\w+) +\| +\S+ +\| (\S+)", loop, re.MULTILINE)}
        found.append({**parts, "Loop": share * seconds, "Clock": seconds})
    return found


def last_number(text):
    return int(text[: text.index("Loop time")].splitlines()[-1].split()[-1])


def spread(values, digits=1):
    return f"{statistics.median(values):.{digits}f} ({min(values):.{digits}f} to {max(values):.{digits}f})"


def grouped(number):
    """12 345"""
    return f"{number:,}".replace(",", " ")


def added(name, base, *more, parts=("Loop",), per=None):
    """what commands add to the case `base`"""
    base = replace(base, parts=parts)
    return replace(base, name=name, per=per or base.per, variables={**base.variables, **dict(zip(("more", "more2"), more))},
                   base=base)


def alone(case, **changes):
    """all of the case, nothing subtracted"""
    return replace(case, base=None, **changes)
