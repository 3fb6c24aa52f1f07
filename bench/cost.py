# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""What each feature costs in nanoseconds a step, beside LAMMPS's own styles on the same network and the same contacts; all
run in turn on one core, several times. Markdown. Asserts nothing: times belong to the machine."""

import sys
from dataclasses import replace

from measure import Bench, Case, added, spread
from potdem.reports import writing

LEDGER = ("compute ledger all potdem/energy", "fix mean all ave/time 1 1 1 c_ledger")
PACE = "fix pace all potdem/timestep 1 0.1 max 0.02"


def bond(name, coeff="", style="potdem"):
    return Case(name, style, "bond", ("Bond",), {"coeff": coeff})


def contact(name, style, coeff):
    return Case(name, "contact", "contact", ("Pair",), {"pair": style, "coeff": coeff})


def grains(name, style):
    return Case(name, style, "particle", ("Loop",), {"n": 29, "steps": 1000}, script="in.grains")


SOLID = Case("", "potdem", "bond", ("Loop",))
LAYER = Case("", "floor", "particle", ("Modify",))
HERTZ = Case("", "contact", "contact", ("Loop",), {"pair": "potdem/hertz", "coeff": "1.0 0.3"})
SLIDING = replace(HERTZ, variables={"pair": "potdem/hertz", "coeff": "1.0 0.3 friction 0.3 auto"})


def wall(name, options="", region="floor"):
    return added(name, LAYER, f"fix wall all potdem/wall/region {region} 1.0 0.3 particle 1.0 0.3 {options}", parts=("Modify",))


TABLES = {
    "Bonds": [
        bond("bond, `bond_style potdem/truss`"),
        bond("LAMMPS's `bond_style bpm/spring`", style="bpm"),
        bond("with `penetration 6`", "penetration 6"),
        bond("with `damping`", "damping 0.01"),
        Case("with `nu 0.3 area body`", "potdem", "bond", ("Bond",), {"nu": "nu 0.3", "area": "body"}),
        added("added by `fix potdem/failure`", SOLID, "fix fail all potdem/failure 1 tension 0.5"),
        added("added by `compute potdem/energy`", SOLID, *LEDGER),
    ],
    "Contacts": [
        contact("`pair_style potdem/truss`", "potdem/truss", "1.0 0.4"),
        contact("with `penetration 6`", "potdem/truss", "1.0 0.4 penetration 6"),
        contact("with `friction`", "potdem/truss", "1.0 0.4 friction 0.3 auto"),
        contact("`pair_style potdem/hertz`", "potdem/hertz", "1.0 0.3"),
        contact("with `viscous`", "potdem/hertz", "1.0 0.3 viscous 0.01"),
        contact("with `friction`", "potdem/hertz", "1.0 0.3 friction 0.3 auto"),
        contact("with `friction` and `rotation yes`", "potdem/hertz rotation yes", "1.0 0.3 friction 0.3 auto"),
        Case("LAMMPS's `gran/hertz/history`, which turns", "gran", "contact", ("Pair",)),
        contact("`pair_style potdem/granular`, n = 4", "potdem/granular", "1.0 4 0.2 cut 1.2"),
        contact("`pair_style potdem/lj`, n = 3", "potdem/lj", "1.0 0.2 3 0.2"),
        contact("with `friction mu mindlin` and `rotation yes`", "potdem/hertz rotation yes", "1.0 0.3 friction 0.3 mindlin"),
        added("added by `compute potdem/energy`, no friction", HERTZ, *LEDGER),
        added("added by `compute potdem/energy`, with friction", SLIDING, *LEDGER),
    ],
    "Walls and fixes": [
        wall("`fix potdem/wall/region`, each particle touches"),
        wall("with `layer none`", "layer none"),
        wall("with `friction`", "friction 0.3 auto"),
        wall("with `friction` and `rotation yes`", "friction 0.3 auto rotation yes"),
        wall("no particle touches", region="far"),
        added("`fix potdem/damping`", LAYER, "fix damp all potdem/damping 0.1", parts=("Modify",)),
    ],
    "24 389 grains that settle, the whole loop": [
        grains("`potdem/hertz`, walls of `fix potdem/wall/region`", "potdem"),
        grains("LAMMPS's `gran/hertz/history`, `fix wall/gran`", "history"),
        grains("LAMMPS's `granular`, `fix wall/gran/region`", "granular"),
    ],
    "When evaluated": [
        added("`compute potdem/strain/atom`", SOLID, "compute strain all potdem/strain/atom",
              "fix each all ave/atom 1 1 1 c_strain[1]", parts=("Modify",), per="particle"),
        added("`compute potdem/timestep`, bonds", SOLID, PACE, parts=("Modify",)),
        added("`compute potdem/timestep`, Hertz contacts", HERTZ, PACE, parts=("Modify",)),
    ],
}
COMPARED = [
    ("Bonds", 0, 1, "a bond over one of bpm/spring"),
    ("Bonds", 4, 0, "a bond of another Poisson's ratio over one of bonds alone"),
    ("Contacts", 6, 7, "a contact with friction and rotation over one of gran/hertz/history"),
    ("Contacts", 10, 7, "one that remembers its friction, mindlin, over one of gran/hertz/history"),
    ("24 389 grains that settle, the whole loop", 0, 1, "the loop of settling grains over that of gran/hertz/history"),
    ("24 389 grains that settle, the whole loop", 0, 2, "and over that of granular"),
]


def rounds(arguments):
    """title -> costs of its cases in ns, one list a round; and the share of the pair part in the intact solid, per cent"""
    found, shares = {title: [] for title in TABLES}, []
    for number in range(arguments.repeats):
        bench = Bench(arguments.size, arguments.steps)
        for title, cases in TABLES.items():
            found[title].append([bench.cost(case) for case in cases])
        shares.append(100 * bench.run(replace(SOLID, parts=("Pair",)))[0] / bench.run(SOLID)[0])
        print(f"round {number + 1} of {arguments.repeats} done", file=sys.stderr, flush=True)
    return found, shares


def report(found, shares):
    parts = []
    for title, cases in TABLES.items():
        rows = [(case.name, spread(costs), case.per) for case, costs in zip(cases, zip(*found[title]))]
        parts.append(writing.table((title, "ns each and step", "per"), rows))
    ratios = [f"* {text}: {spread([costs[ours] / costs[theirs] for costs in found[title]], 2)}"
              for title, ours, theirs, text in COMPARED]
    return "\n\n".join([*parts, "\n".join([*ratios, f"* pair part of the loop in the intact solid: {spread(shares)} %"])])


def known(case, build):
    """says so where the other build does not know what is timed"""
    try:
        Bench(6, 1, build / "lmp").run(case)
    except SystemExit as reason:
        print(f"left out: {case.name}: {str(reason).strip().splitlines()[-1]}", file=sys.stderr)
        return False
    return True


def against(arguments):
    """each case with another build's LAMMPS and with ours, in turn: seconds of the parts of the loop that count, ours over theirs"""
    cases = [case for listed in TABLES.values() for case in listed if "LAMMPS" not in case.name and known(case, arguments.against)]
    ratios = {id(case): [] for case in cases}
    costs = {id(case): [] for case in cases}
    for number in range(arguments.repeats):
        for case in cases:
            benches = [Bench(arguments.size, arguments.steps, lmp) for lmp in (arguments.against / "lmp", None)]
            seconds = {bench.lmp: bench.run(case)[0] for bench in (benches if number % 2 else benches[::-1])}
            theirs, ours = seconds[benches[0].lmp], seconds[None]
            ratios[id(case)].append(ours / theirs)
            costs[id(case)].append(benches[0].cost(replace(case, base=None)))
        print(f"round {number + 1} of {arguments.repeats} done", file=sys.stderr, flush=True)
    rows = [(case.name, "+".join(case.parts), spread(costs[id(case)]), spread(ratios[id(case)], 3)) for case in cases]
    return writing.table(("case", "part of the loop", "theirs, ns each and step", "ours over theirs"), rows)


PAGE = """# What each feature costs

Made by `bench/run --page`. {size} particles of [in.cost](../../bench/in.cost), {steps} steps on one core, all cases in turn; median
(least to most) of {repeats} rounds. Costs of bonds and contacts are those of LAMMPS's Bond and Pair sections, what a feature adds is
the difference of two loops, and the cost of walls that of the Modify section without the integration. That a feature which a script does
not use runs no code and communicates nothing is what `unittest/python/test_left_out.py` shows.

{machine}

{tables}
"""
