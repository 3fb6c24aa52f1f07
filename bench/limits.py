# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""What stands behind the costs: operations and bytes of a bond and of a contact, counted by hand from the loops, instructions counted by
callgrind, and what one core of the machine could do at most (roof.cpp)."""

import math
import re
import shutil
import statistics
import subprocess
import sys
import tempfile
from dataclasses import dataclass, replace
from pathlib import Path

import cost
import matplotlib
import targets
from measure import HERE, Bench, Case, grouped, last_number

from potdem import running
from potdem.reports import writing

matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.ticker import FixedLocator, NullLocator  # noqa: E402

COLOURS = ("#20516e", "#3b7dd8", "#2a9d5c", "#8d6cab", "#d08c2e", "#d1495b")
ROOFS = "#555555"
COMPILE = ["g++", "-O3", "-march=native", "-fno-math-errno"]
CALLGRIND = ["valgrind", "--tool=callgrind", "--callgrind-out-file=counted"]
ROUNDS = 3
SIZES, SHORT = (40, 100), (6, 8)    # particles along an edge: bodies that the outer cache may hold, and that it cannot
COUNTED, MORE = 12, (10, 20)        # particles along an edge, and steps of two runs, whose difference is counted


@dataclass
class Work:
    """of one bond or contact: additions and multiplications; divisions and roots, half of each; bytes that are its own, and bytes of a
    particle, all of which come from memory once a step if the body is large and its order good. width: numbers in a register of the
    loop. Counted by hand; peers are not"""

    name: str
    case: Case
    added: int = 0
    divided: int = 0
    own: int = 0
    particle: int = 0
    width: int = 4

    @property
    def operations(self):
        return self.added + self.divided

    def data(self, each):
        """bytes; each: bonds or contacts of a particle"""
        return self.own + self.particle / each


# bond_potdem_loop.h. Difference of places 3, square of the distance 5, over that of the reference 1, load 1, pull 2, force 3, sums of both
# particles 6; a root and a division. Partner 4, type 2, length and stiffness 8 each; place 24, force read and written 48, first bond and
# first ghost 4 each. Damping: difference of velocities 3, times distance 5, dashpot 3, sum 1; dashpot 8, velocity 24. Penetration 6: nine
# and the product; a root and a division
BOND = dict(added=21, divided=2, own=22, particle=80)
DAMPED = dict(added=33, divided=2, own=30, particle=104)
PENETRATED = dict(added=31, divided=4, own=22, particle=80)
# pair_potdem_loop.h, contact.h, hertz.h: difference of places 3, square 5, reach 3, overlap and force 8, push 4, sums 6; roots of r2 and
# R w, divisions by r and ri + rj. Entry of the list 4; place, radius, type, force, list of the particle 24 + 8 + 4 + 48 + 12
HERTZ = dict(added=29, divided=4, own=4, particle=96)
# with memory and rotation: gathering 19, spins 20, sliding 35, old spring turned 43, new one and limit 26, Hertz, masses and weights 18,
# force and torque 19, sums 18; four divisions and four roots. List 4, flag 4, five numbers read and four written 72; place, velocities,
# radius, mass, type, force, torque, lists of the particle 24 + 48 + 8 + 8 + 4 + 96 + 28
REMEMBERING = dict(added=198, divided=8, own=80, particle=216, width=8)


def works():
    return [
        Work("bond", cost.bond(""), **BOND),
        Work("bond with failure", replace(targets.FAILING, parts=("Bond",)), **BOND),
        Work("bond with `damping`", cost.bond("", "damping 0.01"), **DAMPED),
        Work("bond with `penetration 6`", cost.bond("", "penetration 6"), **PENETRATED),
        Work("contact of `potdem/hertz`", cost.contact("", "potdem/hertz", "1.0 0.3"), **HERTZ),
        Work("contact with memory and rotation", targets.REMEMBERING, **REMEMBERING),
        Work("LAMMPS's `bpm/spring`", targets.SPRINGS),
        Work("LAMMPS's `gran/hertz/history`", targets.GRAN),
    ]


def roof(copies=1):
    """what the machine could do at most, by name: of one core, while as many do the same"""
    found = {}
    with tempfile.TemporaryDirectory() as folder:
        for flags in (["-ffp-contract=off"], ["-DFUSED", "-ffp-contract=fast"]):
            program = Path(folder) / "roof"
            subprocess.run([*COMPILE, *flags, HERE / "roof.cpp", "-o", program], check=True)
            running_copies = [subprocess.Popen([program], stdout=subprocess.PIPE, text=True) for _ in range(copies)]
            for line in running_copies[0].communicate()[0].splitlines():
                name, value = line.split()
                found.setdefault(name, float(value))
            for one in running_copies[1:]:
                one.communicate()
    return found


def instructions(case):
    """of a bond or contact, in the style's compute() and all that it calls"""
    if not shutil.which("valgrind"):
        return None
    counts = []
    for steps in MORE:
        given = {"n": COUNTED, "steps": steps, "style": case.style, **case.variables}
        with tempfile.TemporaryDirectory() as folder:
            arguments = running.command(HERE / case.script, {name: value for name, value in given.items() if value != ""})
            status, *_ = running.processor_seconds([*CALLGRIND, *arguments], folder, Path(folder) / "screen")
            if status:
                sys.exit(f"callgrind failed: {(Path(folder) / 'screen').read_text()[-2000:]}")
            counts.append(counted(folder, case.parts[0]))
            links = last_number((Path(folder) / "screen").read_text())
    return (counts[1] - counts[0]) / (MORE[1] - MORE[0]) / links


def counted(folder, part):
    """instructions of compute() of the pair or bond style in a file of callgrind"""
    listed = subprocess.run(["callgrind_annotate", "--inclusive=yes", "--threshold=100", "counted"], cwd=folder, check=True,
                            capture_output=True, text=True).stdout
    found = re.findall(rf"^\s*([\d,]+) .*LAMMPS_NS::{part}\S*(?:<.*>)?::compute\(int, int\)", listed, re.MULTILINE)
    return max(int(number.replace(",", "")) for number in found)


def nanoseconds(listed, sizes):
    """of each case in turn, for each size: medians"""
    found = {}
    for number in range(ROUNDS):
        for size in sizes:
            bench = Bench(size, max(10, round(100 * (sizes[0] / size) ** 3)))
            for work in listed:
                found.setdefault((work.name, size), []).append((bench.cost(work.case), bench.run(work.case)[1] / size**3))
        print(f"times: round {number + 1} of {ROUNDS} done", file=sys.stderr, flush=True)
    return {key: (statistics.median(value[0] for value in values), values[0][1]) for key, values in found.items()}


def needs(work, each, machine):
    """ns: arithmetic, memory"""
    return (work.added / machine[f"plain-{work.width}"] + 0.5 * work.divided * machine[f"root-{work.width}"],
            work.data(each) / machine["read-memory"])


def table_of(listed, times, counts, machine, sizes):
    rows = []
    for work in listed:
        (small, _), (large, each) = (times[work.name, size] for size in sizes)
        counted_by_hand = ("", "", "", "", "")
        if work.operations:
            arithmetic, memory = needs(work, each, machine)
            counted_by_hand = (work.added, work.divided, f"{work.data(each):.0f}", f"{arithmetic:.1f}", f"{memory:.1f}")
        instructions_each = counts[work.name]
        rows.append((work.name, *counted_by_hand[:3], "" if instructions_each is None else f"{instructions_each:.0f}",
                     *counted_by_hand[3:], f"{small:.1f}", f"{large:.1f}"))
    particles = [grouped(size**3) for size in sizes]
    return writing.table(("", "additions, multiplications", "divisions, roots", "bytes", "instructions", "arithmetic needs, ns",
                          "memory needs, ns", *(f"takes, ns, {number} particles" for number in particles)), rows)


def table_of_roof(one, both):
    names = {"read-L1": "reading from the first cache, GB/s", "read-L2": "from the second", "read-L3": "from the third",
             "read-memory": "from memory", "triad-memory": "memory, two numbers read and one written, GB/s",
             "plain-4": "multiplications and additions, four at once, Gflop/s", "plain-8": "eight at once",
             "fused-4": "fused, four at once", "fused-8": "fused, eight at once",
             "root-4": "a division and a root, four at once, ns each", "root-8": "eight at once, ns each"}
    return writing.table(("what", "one core", "the same while two cores do it"),
                         [(text, f"{one[name]:.3g}", f"{both[name]:.3g}") for name, text in names.items()])


def allowed(work, machine):
    """Gflop/s, if nothing had to be read or written"""
    return work.operations / (work.added / machine[f"plain-{work.width}"] + 0.5 * work.divided * machine[f"root-{work.width}"])


def draw_roofs(axes, machine, left, right):
    """axes: laid out already, so that words can go along lines"""
    top = machine["fused-8"]
    for name, text, style in (("memory", "memory", "-"), ("L3", "third cache", "--"), ("L2", "second cache", ":")):
        slope = machine[f"read-{name}"]
        ends = [[left, slope * left], [min(right, top / slope), min(slope * right, top)]]
        axes.plot(*zip(*ends), style, color=ROOFS, lw=1.4)
        (x, y), (further, higher) = axes.transData.transform(ends)
        axes.annotate(f"{text}, {slope:.0f} GB/s", ends[0], xytext=(8, 10), textcoords="offset points", fontsize=9, color=ROOFS,
                      rotation=math.degrees(math.atan2(higher - y, further - x)), rotation_mode="anchor")
    for name, text, at in (("fused-8", "eight at once, fused", right), ("plain-8", "eight at once", right),
                           ("plain-4", "four at once", 0.6 * right)):
        axes.axhline(machine[name], color="#9aa5ad", lw=1.0)
        axes.annotate(f"{text}, {machine[name]:.0f} Gflop/s", (at, machine[name]), xytext=(-4, 3), textcoords="offset points", ha="right",
                      fontsize=9, color=ROOFS)


def draw(path, listed, times, machine, sizes):
    figure, axes = plt.subplots(figsize=(9.0, 6.0), constrained_layout=True)
    drawn = [work for work in listed if work.operations]
    reached = {key: work.operations / times[key][0] for work in drawn for key in ((work.name, size) for size in sizes)}
    left, right = 0.4, 4.0
    axes.set(xscale="log", yscale="log", xlim=(left, right), ylim=(0.6 * min(reached.values()), 1.3 * machine["fused-8"]),
             xlabel="operations over bytes of memory", ylabel="Gflop/s of one core")
    for work, colour in zip(drawn, COLOURS):
        for size, face in zip(sizes, ("white", colour)):
            axes.plot(work.operations / work.data(times[work.name, size][1]), reached[work.name, size], "o", ms=9, color=colour, mfc=face,
                      mew=1.8, label=work.name.replace("`", "") if face == colour else None)
        axes.plot(work.operations / work.data(times[work.name, sizes[1]][1]), allowed(work, machine), "_", ms=22, mew=2.2, color=colour)
    axes.plot([], [], "_", ms=16, mew=2.2, color=ROOFS, label="what divisions and roots allow")
    for axis, ticks in ((axes.xaxis, (0.5, 1, 2, 4)), (axes.yaxis, (2, 5, 10, 20, 50, 100, 200))):
        axis.set_major_locator(FixedLocator(ticks))
        axis.set_major_formatter("{x:g}")
        axis.set_minor_locator(NullLocator())
    axes.legend(loc="lower right", fontsize=9, frameon=False, title_fontsize=9,
                title=f"open: {grouped(sizes[0] ** 3)} particles, filled: {grouped(sizes[1] ** 3)}")
    figure.draw_without_rendering()
    draw_roofs(axes, machine, left, right)
    figure.savefig(path, dpi=110)
    plt.close(figure)


def blocks(short, picture):
    """name -> text for docs/performance.md; draws the picture"""
    sizes, listed = SHORT if short else SIZES, works()
    one, both = roof(), roof(2)
    times = nanoseconds(listed, sizes)
    counts = {}
    for work in listed:
        counts[work.name] = instructions(work.case)
        print(f"instructions: {work.name} done", file=sys.stderr, flush=True)
    if picture:
        draw(picture, listed, times, one, sizes)
    return {"roof": table_of_roof(one, both), "counted": table_of(listed, times, counts, one, sizes)}
