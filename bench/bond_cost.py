"""Cost of a bond, of its options and of a contact in nanoseconds a step, beside LAMMPS's own bond_style bpm/spring on
the same network and its gran/hertz/history on the same contacts; all run in turn on one core, several times. Asserts nothing: times belong to the machine."""

import argparse
import re
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
LMP = HERE.parent / "build" / "lmp"

# name, style and option of in.bond-cost, the parts of the loop that count, per what
CASES = [
    ("bond, potdem/truss", "potdem", "plain", ("Bond",), "bond"),
    ("bond, LAMMPS's bpm/spring", "bpm", "plain", ("Bond",), "bond"),
    ("  with penetration 6", "potdem", "penetration", ("Bond",), "bond"),
    ("  with damping", "potdem", "damping", ("Bond",), "bond"),
    ("  with fix potdem/failure", "potdem", "failure", ("Bond",), "bond"),
    ("contact, potdem/truss", "contact", "truss", ("Pair",), "contact"),
    ("  with friction", "contact", "truss_friction", ("Pair",), "contact"),
    ("contact, potdem/hertz", "contact", "hertz", ("Pair",), "contact"),
    ("  with friction (no history)", "contact", "hertz_friction", ("Pair",), "contact"),
    ("  LAMMPS's gran/hertz/history", "gran", "friction", ("Pair",), "contact"),
    ("strain, when evaluated", "potdem", "strain", ("Modify",), "particle"),
    ("critical step, when evaluated", "potdem", "pace", ("Modify",), "bond"),
    ("  of Hertz contacts", "contact", "hertz_pace", ("Modify",), "contact"),
]
COMPARED = [
    (CASES[0][0], CASES[1][0], "a bond of potdem/truss over one of bpm/spring"),
    (CASES[8][0], CASES[9][0], "a sliding contact of potdem/hertz over one of gran/hertz/history"),
]


def run(style, option, n, steps):
    """seconds of the loop's parts and the number of bonds or contacts"""
    variables = {"style": style, "option": option, "n": n, "steps": steps}
    command = [LMP, "-in", HERE / "in.bond-cost", "-log", "none"]
    command += [str(word) for name, value in variables.items() for word in ("-var", name, value)]
    text = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    parts = {name: float(value) for name, value in re.findall(r"^(\w+) +\| +\S+ +\| (\S+)", text, re.M)}
    parts["Loop"] = float(re.search(r"Loop time of (\S+)", text).group(1))
    return parts, int(text[: text.index("Loop time")].splitlines()[-1].split()[3])


def median(values):
    return sorted(values)[len(values) // 2]


def spread(values, digits=2):
    return f"{median(values):8.{digits}f} ({min(values):.{digits}f} to {max(values):.{digits}f})"


def measure(arguments):
    """name of the case -> its costs in ns, and the share of the pair part, one of each per repeat"""
    costs, shares = {}, {}
    for repeat in range(arguments.repeats):
        for name, style, option, counted, per in CASES:
            parts, links = run(style, option, arguments.size, arguments.steps)
            count = arguments.size**3 if per == "particle" else links
            costs.setdefault(name, []).append(1e9 * sum(parts[part] for part in counted) / count / arguments.steps)
            shares.setdefault(name, []).append(100 * parts["Pair"] / parts["Loop"])
        print(f"round {repeat + 1} of {arguments.repeats} done", file=sys.stderr, flush=True)
    return costs, shares


def main(argv):
    parser = argparse.ArgumentParser(prog="bench/run")
    parser.add_argument("--size", type=int, default=40, help="particles along an edge (default 40: 64 000)")
    parser.add_argument("--steps", type=int, default=100)
    parser.add_argument("--repeats", type=int, default=5)
    arguments = parser.parse_args(argv)
    costs, shares = measure(arguments)
    print(f"{arguments.size**3} particles, {arguments.steps} steps, one core; median (least to most) of {arguments.repeats}\n")
    print(f"{'':30s}{'ns each and step':>28s}")
    for name, _, _, _, per in CASES:
        print(f"{name:30s}{spread(costs[name]):>28s} per {per}")
    print()
    for ours, theirs, text in COMPARED:
        ratios = [a / b for a, b in zip(costs[ours], costs[theirs])]
        print(f"{text}:{spread(ratios)}")
    print(f"pair part of the loop in the intact solid:{spread(shares[CASES[0][0]], 1)} %")


if __name__ == "__main__":
    main(sys.argv[1:])
