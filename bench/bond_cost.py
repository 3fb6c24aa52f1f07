"""Cost of a bond and share of the pair part in an intact solid, beside LAMMPS's own bond_style bpm/spring on the
same network, run in turn on one core. Prints a table; asserts nothing: times belong to the machine."""

import argparse
import re
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
LMP = HERE.parent / "build" / "lmp"


def run(style, n, steps):
    """seconds of the loop's parts and the number of bonds"""
    command = [LMP, "-in", HERE / "in.bond-cost", "-log", "none", "-var", "style", style, "-var", "n", str(n),
               "-var", "steps", str(steps)]
    text = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    parts = {name: float(value) for name, value in re.findall(r"^(\w+) +\| +\S+ +\| (\S+)", text, re.M)}
    parts["Loop"] = float(re.search(r"Loop time of (\S+)", text).group(1))
    last_row = text[: text.index("Loop time")].splitlines()[-1].split()
    return parts, int(last_row[3])


def median(values):
    return sorted(values)[len(values) // 2]


def main(argv):
    parser = argparse.ArgumentParser(prog="bench/run")
    parser.add_argument("--size", type=int, default=40, help="particles along an edge (default 40: 64 000)")
    parser.add_argument("--steps", type=int, default=100)
    parser.add_argument("--repeats", type=int, default=5)
    arguments = parser.parse_args(argv)
    results = {"potdem": [], "bpm": []}
    for repeat in range(arguments.repeats):
        for style, found in results.items():
            parts, bonds = run(style, arguments.size, arguments.steps)
            found.append((1e9 * parts["Bond"] / bonds / arguments.steps, parts["Pair"] / parts["Loop"]))
            print(f"  run {repeat + 1}: {style:7s} {found[-1][0]:6.2f} ns per bond and step", flush=True)
    print(f"\n{arguments.size**3} particles, {bonds} bonds, {arguments.steps} steps, one core, "
          f"median (least to most) of {arguments.repeats}")
    print(f"{'':24s}{'ns per bond and step':>28s}{'pair part of the loop':>24s}")
    for style, name in (("potdem", "bond_style potdem/truss"), ("bpm", "bond_style bpm/spring")):
        costs, shares = zip(*results[style])
        print(f"{name:24s}{median(costs):12.2f} ({min(costs):.2f} to {max(costs):.2f}){100 * median(shares):20.1f} %")
    ratios = [ours[0] / theirs[0] for ours, theirs in zip(results["potdem"], results["bpm"])]
    print(f"a bond of potdem/truss costs {median(ratios):.2f} ({min(ratios):.2f} to {max(ratios):.2f}) of one of bpm/spring")


if __name__ == "__main__":
    main(sys.argv[1:])
