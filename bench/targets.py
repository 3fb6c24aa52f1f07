# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""What this package is to reach, beside LAMMPS's own styles or another limit, measured in turn in one run: docs/performance.md says what
each line means. Asserts nothing: times belong to the machine."""

import re
import statistics
import sys
from dataclasses import dataclass, replace
from typing import Callable

import cost
from measure import Bench, Case, added, alone, grouped, spread
from potdem.reports import writing


@dataclass(frozen=True)
class Sizes:
    """particles along an edge: of bodies whose parts are timed, of those on two ranks, of grains, of the large body, of those whose
    costs should be the same; the bar of `area body`; steps of the first two, of the grains, and of the large body"""

    small: int = 40
    body: int = 41
    grains: int = 29
    large: int = 100
    flat: tuple = (22, 40, 100)
    bar: tuple = (5, 5, 600)
    steps: int = 200
    grain_steps: int = 1000
    large_steps: int = 20


SHORT = Sizes(6, 6, 5, 8, (5, 8), (3, 3, 12), 100, 20, 10)
HUGE = 159    # 4 million particles


@dataclass
class Target:
    """ours and what is beside it, in that unit. ratio: of the two is judged, else ours alone; sign, limit: what it should be; without
    a sign, nothing is asked"""

    what: str
    unit: str
    ours: Callable
    beside: str = ""
    peer: "Callable | None" = None
    ratio: bool = True
    sign: str = ""
    limit: float = 0.0

    def judged(self, ours, peer):
        return ours / peer if self.ratio and self.peer else ours

    def reached(self, value):
        return value <= self.limit if self.sign == "≤" else value >= self.limit


def at(case, size, steps, **changes):
    """the same with so many particles along an edge and so many steps"""
    return replace(case, variables={**case.variables, "n": size, "steps": steps}, **changes)


def each(case):
    return lambda bench: bench.cost(case)


def loop(bench, case, number=0, part="Loop"):
    return bench.timed(case).loops[number][part]


def clock(bench, case):
    return loop(bench, case, part="Clock")


def over(first, second):
    """of two loops, by the clock"""
    return lambda bench: clock(bench, first) / clock(bench, second)


FAILURE = "fix fail all potdem/failure 1 tension 0.5"
FAILING = alone(added("", cost.SOLID, FAILURE))
SPARING = replace(FAILING, variables={**FAILING.variables, "newton": "off"})
SPRINGS = replace(cost.bond("", style="bpm"), variables={"newton": "off"})
REMEMBERING = cost.contact("", "potdem/hertz rotation yes", "1.0 0.3 friction 0.3 mindlin")
GRAN = Case("", "gran", "contact", ("Pair",))
OURS, HISTORY = cost.grains("", "potdem"), cost.grains("", "history")
LEDGER = added("", cost.SOLID, *cost.LEDGER)
STRAIN = added("", cost.SOLID, "compute strain all potdem/strain/atom", "fix each all ave/atom 100 1 100 c_strain[1]",
               parts=("Modify",))


def on_bonds(sizes):
    failing, solid, springs = (at(case, sizes.small, sizes.steps) for case in (FAILING, cost.SOLID, SPRINGS))
    bond, ledger = at(cost.bond(""), sizes.small, sizes.steps), at(LEDGER, sizes.small, sizes.steps, base=solid)
    strain = at(STRAIN, sizes.small, sizes.steps, base=replace(solid, parts=("Modify",)))
    steps = sizes.steps // 2
    breaking, unbroken = (Case("", "potdem", "bond", ("Loop",), {"n": sizes.small, "steps": steps, "share": share}, script="in.breaking")
                          for share in (1e-4 * steps, 1e-12))

    def broken_at_one_per_cent(bench):
        """the loop of the unbroken body and what 1 % in 100 steps would add, by what was added and the share that did fail"""
        failed = 1 - bench.timed(breaking).links / bench.timed(unbroken).links
        without = loop(bench, unbroken)
        return without + (loop(bench, breaking) - without) * 1e-4 * steps / failed

    return [
        Target("bond with failure", "ns", each(replace(failing, parts=("Bond",))), "`bpm/spring`", each(springs), True, "≤", 0.33),
        Target("step with failure, a bond", "ns", each(failing), "without", each(solid), True, "≤", 1.05),
        Target("loop while 1 % of the bonds fail in 100 steps", "s", broken_at_one_per_cent, "unbroken",
               lambda bench: loop(bench, unbroken), True, "≤", 1.3),
        Target("`compute potdem/energy` on each step, a bond", "ns", each(ledger), "the bond itself", each(bond), True, "≤", 1.8),
        Target("`compute potdem/strain/atom` on each 100th step, of the loop", "%",
               lambda bench: 100 * (bench.run(strain)[0] - bench.run(strain.base)[0]) / bench.run(solid)[0], "", None, False, "≤", 3.0),
    ]


def on_grains(sizes):
    ours, history = (at(replace(case, variables={**case.variables, "bare": "yes"}), sizes.grains, sizes.grain_steps)
                     for case in (OURS, HISTORY))

    def walls(case):
        """Modify less that of the same grains without walls"""
        return lambda bench: 100 * (loop(bench, case, 0, "Modify") - loop(bench, case, 1, "Modify")) / loop(bench, case)

    return [
        Target("contact with memory and rotation", "ns", each(at(REMEMBERING, sizes.small, sizes.steps)), "`gran/hertz/history`",
               each(at(GRAN, sizes.small, sizes.steps)), True, "≤", 0.7),
        Target("settling grains, a grain and step", "ns", each(ours), "`gran/hertz/history`", each(history), True, "≤", 0.6),
        Target("walls in the loop of these grains", "%", walls(ours), "`wall/gran`", walls(history), False, "≤", 10.0),
    ]


def on_two(sizes):
    """two ranks over one, and two threads over two ranks"""
    rows, threads = [], []
    for what, case, peer, style in (
            ("solid with failure", at(SPARING, sizes.body, sizes.steps), at(SPRINGS, sizes.body, sizes.steps), "`bpm/spring`"),
            ("settling grains", at(OURS, sizes.grains, sizes.grain_steps), at(HISTORY, sizes.grains, sizes.grain_steps),
             "`gran/hertz/history`")):
        two = replace(case, ranks=2)
        rows.append(Target(f"2 ranks over 1, {what}", "", over(case, two), f"{style}", over(peer, replace(peer, ranks=2)), False,
                           "≥", 1.85))
        threads.append(Target(f"2 threads over 2 ranks, {what}", "s", lambda bench, one=replace(case, threads=2): clock(bench, one),
                              "2 ranks", lambda bench, two=two: clock(bench, two), True, "≤", 1.1))
    return rows + threads


def own_memory(text):
    """MB, by LAMMPS's own count"""
    return float(re.search(r"^Per MPI rank memory allocation .* (\S+) Mbytes", text, re.MULTILINE).group(1))


def on_large(sizes):
    body, springs = (at(case, sizes.large, sizes.large_steps) for case in (cost.SOLID, SPRINGS))
    plain = replace(body, variables={**body.variables, "area": "factor 0.28"})
    flat = [at(cost.SOLID, n, max(10, round(sizes.large_steps * (sizes.flat[-1] / n) ** 3))) for n in sizes.flat]

    def largest_over_least(per):
        def measure(bench):
            costs = [bench.cost(replace(case, per=per)) for case in flat]
            return max(costs) / min(costs)
        return measure

    particles = ", ".join(grouped(n**3) for n in sizes.flat)
    million = grouped(sizes.large**3)
    return [
        Target(f"peak memory, {million} particles", "GB", lambda bench: 1e-9 * bench.timed(body).peak, "`bpm/spring`",
               lambda bench: 1e-9 * bench.timed(springs).peak, True, "≤", 1.0),
        Target("the same by LAMMPS's own count", "GB", lambda bench: 1e-3 * own_memory(bench.timed(body).text), "`bpm/spring`",
               lambda bench: 1e-3 * own_memory(bench.timed(springs).text), True, "≤", 1.0),
        Target("peak memory with `area factor`, one stiffness for all as the peer has it", "GB",
               lambda bench: 1e-9 * bench.timed(plain).peak, "`bpm/spring`", lambda bench: 1e-9 * bench.timed(springs).peak, True,
               "≤", 1.0),
        Target("their set-up", "s", lambda bench: bench.timed(body).set_up, "`bpm/spring`", lambda bench: bench.timed(springs).set_up,
               False, "≤", 5.0),
        Target(f"cost of a particle, {particles}: largest over least", "", largest_over_least("particle"), "", None, False, "≤", 1.15),
        Target("cost of a bond in these: largest over least", "", largest_over_least("bond")),
    ]


def on_areas(sizes):
    bar = Case("", "", "bond", ("Loop",), dict(zip(("nx", "ny", "nz"), sizes.bar)), script="in.area-body")
    lattice = replace(bar, variables={**bar.variables, "area": "lattice"})
    one_of_two = replace(bar, ranks=2)
    bond = at(cost.bond(""), sizes.small, sizes.steps)

    def seconds(bench):
        """of the processor, less those of a run that finds its sections by area lattice, in no time"""
        return bench.timed(bar).cpu - bench.timed(lattice).cpu

    def each_bond(bench):
        return 1e9 * seconds(bench) / bench.timed(bar).links

    def said(bench, case, what):
        """iterations, or seconds, in the log"""
        return float(re.search(rf"(\S+) {what}", re.search(r"misfit.*", bench.timed(case).text).group()).group(1))

    return [
        Target(f"`area body`, bar of {' × '.join(map(str, sizes.bar))} particles", "s", seconds),
        Target("the same in steps of its bonds", "", lambda bench: each_bond(bench) / bench.cost(bond), "", None, False, "≤",
               AREA_STEPS / 5),
        Target("the same, a bond and iteration", "ns", lambda bench: each_bond(bench) / said(bench, bar, "iterations")),
        Target("the same, 2 ranks over 1", "", lambda bench: said(bench, bar, "s$") / max(said(bench, one_of_two, "s$"), 0.01), "", None,
               False, "≥", 1.85),
    ]


AREA_STEPS = 2800    # what `area body` cost before it was made faster


def targets(sizes):
    return on_bonds(sizes) + on_grains(sizes) + on_two(sizes) + on_large(sizes) + on_areas(sizes)


def rounds(listed, repeats, sizes):
    """(ours, beside) of each target, of each round"""
    found = [[] for _ in listed]
    for number in range(repeats):
        bench = Bench(sizes.small, sizes.steps)
        for target, values in zip(listed, found):
            values.append((target.ours(bench), target.peer(bench) if target.peer else None))
            print(f"round {number + 1} of {repeats}: {target.what}", file=sys.stderr, flush=True)
    return found


def digits(values):
    """behind the point, so that the median has three"""
    value = abs(statistics.median(values))
    return 0 if value >= 100 else 1 if value >= 10 else 2


def number(values, unit):
    return f"{statistics.median(values):.{digits(values)}f} {unit}".rstrip()


def row(target, values):
    ours, peers = ([value[k] for value in values] for k in (0, 1))
    judged = [target.judged(*value) for value in values]
    ratios = [mine / theirs for mine, theirs in values] if target.peer else None
    reached = [target.reached(value) for value in judged]
    verdict = "" if not target.sign else "yes" if all(reached) else "no" if not any(reached) else (
        f"{'yes' if target.reached(statistics.median(judged)) else 'no'}; in {sum(reached)} of {len(reached)} rounds")
    goal = f"{'ratio ' if target.ratio and target.peer else ''}{target.sign} {target.limit:g} {'' if target.ratio else target.unit}"
    beside = f"{target.beside}: {number(peers, target.unit)}" if target.peer else ""
    here = number(ours, target.unit) if target.peer else f"{spread(ours, digits(ours))} {target.unit}".rstrip()
    return target.what, here, beside, spread(ratios, 2) if ratios else "", goal.strip() if target.sign else "", verdict


def report(listed, found):
    return writing.table(("target", "here", "beside it", "ratio", "asked", "reached"),
                         [row(target, values) for target, values in zip(listed, found)])


PAGE = """# What was to be reached

Made by `bench/run --targets --page`, in {repeats} rounds in which all runs were made in turn. Medians, and where there are three
numbers the median and the least to the most of the rounds. A *ratio* is that of the two numbers before it, of each round. Solids have
bonds up to two diameters, about 16 to a particle. [Performance](../performance.md) says what stands behind each line and why some are
missed.

{machine}

{table}
"""
