# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""For users of clusters: what ranks send each other, counted here; from that weak scaling on paper; balance where grains are not
everywhere; threads and ranks. Ranks may be more than cores where they are only counted."""

import math
import re
import statistics
import subprocess
import sys
import tempfile
from dataclasses import dataclass, replace
from pathlib import Path

import cost
import targets
from measure import HERE, Bench, Case, loops_of

from potdem import running
from potdem.paths import EXAMPLES
from potdem.reports import writing

RANKS = (2, 4, 8)
MORE = (10, 40)                             # steps of two runs, whose difference is counted; too few to rebuild lists
LATENCY, BANDWIDTH = 2e-6, 10e9             # assumed of a network: s for a message, bytes/s of a rank
PAPER = ((1_000_000, 8), (1_000_000, 64), (1_000_000, 1000), (100_000, 10_000), (10_000, 100_000))    # particles of a rank, ranks


@dataclass
class Sent:
    """of one rank and step, mean over the ranks; ghosts of a rank, mean and most; bytes is of the rank that sends most"""

    messages: float
    bytes: float
    collective: float
    ghosts: float
    most_ghosts: float


def sent(case, size, ranks, counter):
    given = {"style": case.style, **case.variables, "n": size}
    counts = []
    for steps in MORE:
        given["steps"] = steps
        with tempfile.TemporaryDirectory() as folder:
            lammps = running.command(HERE / case.script, {name: value for name, value in given.items() if value != ""})
            screen = Path(folder) / "screen"
            status, *_ = running.processor_seconds(running.on_ranks(ranks, ["env", f"LD_PRELOAD={counter}", *lammps]), folder, screen)
            text = screen.read_text(encoding="utf-8")
        if status:
            sys.exit(f"LAMMPS failed on {ranks} ranks:\n{text[-2000:]}")
        counts.append(sorted(tuple(map(int, line.split()[1:])) for line in text.splitlines() if line.startswith("MESSAGES ")))
    each = [[(later - sooner) / (MORE[1] - MORE[0]) for sooner, later in zip(*both)] for both in zip(*counts)]
    messages, volume, collective = zip(*each)
    ghosts, most = re.search(r"^Nghost: +(\S+) ave +(\S+) max", text, re.MULTILINE).groups()
    return Sent(statistics.mean(messages), max(volume), statistics.mean(collective), float(ghosts), float(most))


def halos(bodies, ranks):
    """name -> {ranks: Sent}"""
    found = {}
    with tempfile.TemporaryDirectory() as folder:
        counter = Path(folder) / "messages.so"
        subprocess.run(["mpicc", "-shared", "-fPIC", "-O2", HERE / "messages.c", "-o", counter], check=True)
        for name, (case, size) in bodies.items():
            found[name] = {number: sent(case, size, number, counter) for number in ranks}
            print(f"messages: {name} done", file=sys.stderr, flush=True)
    return found


def table_of_halos(found, bodies):
    rows = [(name, number, f"{bodies[name][1] ** 3 / number:.0f}", f"{one.ghosts:.0f}", f"{one.most_ghosts:.0f}", f"{one.messages:.3g}",
             f"{one.bytes / 1024:.0f}", f"{one.collective:.2g}") for name, of_ranks in found.items() for number, one in of_ranks.items()]
    return writing.table(("", "ranks", "particles of a rank", "ghosts, mean", "ghosts, most", "messages of a rank and step",
                          "KiB of a rank and step, most", "reductions over all ranks, a step"), rows)


def layers(of_ranks, size):
    """of ghosts beside a face: two ranks share one face"""
    return of_ranks[2].ghosts / size**2


def on_paper(particles, ranks, of_ranks, size, nanoseconds):
    """seconds of a step of a rank inside a cubic grid of ranks: computing, messages, bytes, reductions; its ghosts"""
    edge, reach, eighth = particles ** (1 / 3), layers(of_ranks, size), of_ranks[8]
    ghosts = (edge + 2 * reach) ** 3 - edge**3
    each = eighth.bytes / eighth.most_ghosts
    # on eight ranks each has a neighbour on one side of each direction, inside it has one on both
    return (1e-9 * nanoseconds * particles, 2 * eighth.messages * LATENCY, each * ghosts / BANDWIDTH,
            eighth.collective * math.ceil(math.log2(ranks)) * LATENCY, ghosts)


def table_of_paper(found, bodies, costs):
    rows = []
    for name, of_ranks in found.items():
        for particles, ranks in PAPER:
            computing, messages, volume, reductions, ghosts = on_paper(particles, ranks, of_ranks, bodies[name][1], costs[name])
            step = computing + messages + volume + reductions
            rows.append((name, f"{particles * ranks:.1e}".replace("e+0", "e"), ranks, f"{ghosts / particles:.2f}", *(
                f"{1e3 * seconds:.3g}" for seconds in (computing, messages, volume, reductions)), f"{computing / step:.2f}"))
    return writing.table(("", "particles", "ranks", "ghosts over particles", "computing, ms", "messages, ms", "bytes, ms", "reductions, ms",
                          "efficiency"), rows)


# --- balance ----------------------------------------------------------------------------------------------------------

WAYS = {"`comm_style brick`, as it is": "fix even all balance 100 1e9 shift x 1 1.0",
        "`brick`, `fix balance 100 1.05 shift xyz 10 1.05`": "fix even all balance 100 1.05 shift xyz 10 1.05",
        "`comm_style tiled`, `fix balance 100 1.05 rcb`": "comm_style tiled\nfix even all balance 100 1.05 rcb"}
# what is run of them, and what of them if it is to be short
SCENES = {"hopper": ({"time": 0.5}, {"time": 0.01}),
          "column-drop": ({"settling": 0.4, "spreading": 0.6}, {"settling": 0.005, "spreading": 0.005})}
MEAN = """
variable load equal f_even[1]*{ranks}/atoms
fix load all ave/time 100 1 100 v_load ave running
"""


def balanced(scene, way, variables, ranks):
    """(largest number of particles on a rank over the mean, averaged over the run; seconds of the loops)"""
    text = (EXAMPLES / scene / f"in.{scene}").read_text(encoding="utf-8")
    begin = re.search(r"^timestep ", text, re.MULTILINE).start()
    script = text[:begin] + way + MEAN.format(ranks=ranks) + text[begin:] + '\nprint "LOAD $(f_load)"\n'
    with tempfile.TemporaryDirectory() as folder:
        done = running.must_run(script, {**variables, "picture": "no"}, folder, nprocs=ranks)
    return (float(re.search(r"^LOAD (\S+)", done.stdout, re.MULTILINE).group(1)), sum(loop["Clock"] for loop in loops_of(done.stdout)))


def table_of_balance(short):
    rows = []
    for scene, settings in SCENES.items():
        for name, way in WAYS.items():
            load, seconds = balanced(scene, way, settings[short], 2)
            rows.append((scene, name, f"{load:.2f}", f"{seconds:.2f}", f"{balanced(scene, way, settings[short], 4)[0]:.2f}"))
            print(f"balance: {scene}, {name} done", file=sys.stderr, flush=True)
    return writing.table(("scene", "how", "most particles of a rank over the mean, 2 ranks", "loop on 2 ranks, s",
                          "over the mean, 4 ranks"), rows)


# --- threads and ranks ------------------------------------------------------------------------------------------------

def table_of_threads(short):
    rows = []
    for name, case, sizes in (("solid with failure", targets.SPARING, (12, 22, 41)), ("settling grains", targets.OURS, (12, 29))):
        for size in sizes[:1] if short else sizes:
            steps = 10 if short else max(100, round(100 * (41 / size) ** 3))
            one = replace(targets.at(case, size, steps), per="particle", parts=("Clock",))
            cases = [one, replace(one, ranks=2), replace(one, threads=2)]
            seconds = [statistics.median(Bench(size, steps).cost(each) for _ in range(1 if short else 3)) for each in cases]
            rows.append((name, size**3, *(f"{value:.1f}" for value in seconds), f"{seconds[2] / seconds[1]:.2f}"))
            print(f"threads: {name} {size}^3 done", file=sys.stderr, flush=True)
    return writing.table(("", "particles", "one core, ns a particle and step", "2 ranks", "2 threads", "threads over ranks"), rows)


def bodies_of(short):
    """name -> case, particles along an edge"""
    sizes = targets.SHORT if short else targets.Sizes()
    return {"solid with failure": (targets.FAILING, sizes.body), "the same, `newton off`": (targets.SPARING, sizes.body),
            "settling grains": (targets.OURS, sizes.grains)}


def cost_of(case: Case, size, short):
    """ns a particle and step of the loop on one core"""
    return Bench(size, 100).cost(replace(targets.at(case, size, 10 if short else 200), per="particle", parts=("Loop",)))


def blocks(short):
    """name -> text for docs/performance.md"""
    bodies = bodies_of(short)
    costs = {name: cost_of(case, size, short) for name, (case, size) in bodies.items()}
    found = halos(bodies, RANKS)
    return {"halo": table_of_halos(found, bodies), "paper": table_of_paper(found, bodies, costs), "balance": table_of_balance(short),
            "threads": table_of_threads(short)}
