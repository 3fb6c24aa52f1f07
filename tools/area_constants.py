#!/usr/bin/env python3
# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""What the constants of `area body` do: stiffness of two bars in tension, bending and torsion of docs/area.md, over the exact values, with
each chosen constant halved and doubled (whole numbers rounded down, at least 1).

A copy of src/core/areas is compiled in which the constants come from the environment instead of constants.h; the package's
own code knows nothing of it. Networks are solved by potdem/networks.py.

Usage: tools/area_constants.py [--only NAME ...] [--factors 0.5 2] [--compiler g++]     prints the table of docs/area.md in Markdown
"""

import argparse
import os
import re
import shutil
import subprocess
import tempfile
from pathlib import Path
from typing import NamedTuple

import numpy as np

from potdem import networks
from potdem.paths import ROOT
from potdem.text import replaced

AREAS = ROOT / "src" / "core" / "areas"
LINE = re.compile(r"^static constexpr (int|double) (\w+) = (\S+);$", re.MULTILINE)
REACH = 2.0


class Constant(NamedTuple):
    kind: str     # int or double
    name: str
    value: str    # as written
    origin: str   # derived, rounding or chosen
    meaning: str

    def times(self, factor):
        if self.kind == "int":
            return str(max(1, int(factor * int(self.value))))
        return f"{factor * float(self.value):.12g}"


def constants():
    """of constants.h, in its order"""
    text = (AREAS / "constants.h").read_text()
    found = []
    for match in LINE.finditer(text):
        comment = []
        for line in reversed(text[:match.start()].rstrip().splitlines()):
            if not line.startswith("// "):
                break
            comment.insert(0, line[3:])
        origin, meaning = " ".join(comment).split(": ", 1)
        found.append(Constant(*match.groups(), origin, meaning))
    return found


def build(folder, compiler):
    """the solver for one body, constants from the environment"""
    copy = folder / "areas"
    shutil.copytree(AREAS, copy)
    text = (copy / "constants.h").read_text()
    given = ("\ninline double given(const char *name, double value)\n"
             "{ const char *text = std::getenv(name); return text ? std::atof(text) : value; }\n")
    text = LINE.sub(r'inline const \1 \2 = static_cast<\1>(given("POTDEM_\2", \3));', text)
    text = replaced(replaced(text, "namespace POTDEM", "#include <cstdlib>\nnamespace POTDEM", 1), "{\n", "{\n" + given, 1)
    (copy / "constants.h").write_text(text)
    subprocess.run([compiler, "-std=c++17", "-O2", "-I", copy, "-I", ROOT / "src", ROOT / "tools" / "area_constants.cpp", *copy.glob("*.cpp"),
                    "-o", folder / "solve"], check=True)
    return folder / "solve"


def solve_solid(program, body, pairs, poisson, changes=None):
    """of the solid of this Poisson's ratio and E = 1: section of each pair, and its networks.Dilatation; None where the body is refused.
    pairs: the particle of the lower number first"""
    rows = [f"{len(body.x)} {len(pairs)}"]
    rows += [" ".join(f"{value:.17g}" for value in (*x, d, v)) for x, d, v in zip(body.x, body.d, body.v)]
    rows += [f"{i} {j}" for i, j in pairs]
    done = subprocess.run([program, str(poisson)], input="\n".join(rows), env={**os.environ, **(changes or {})}, capture_output=True,
                          text=True, check=True)
    found = np.array(done.stdout.split(), dtype=float)
    if len(found) != 3 * len(pairs) + len(body.x) or not np.isfinite(found).all():
        return None
    of_bonds = found[:3 * len(pairs)].reshape(-1, 3)
    dilatation = networks.Dilatation.of_solid(poisson, found[3 * len(pairs):], of_bonds[:, 1:])
    return 1.25 / (1 + poisson) * of_bonds[:, 0], dilatation


def solve(program, body, pairs, changes):
    """section of each pair, bonds alone; None where the body is refused"""
    found = solve_solid(program, body, np.sort(pairs, axis=1), 0.25, changes)
    return found and found[0]


def stiffness(program, body, pairs, changes):
    """in tension, bending and torsion, over the exact ones"""
    areas = solve(program, body, pairs, changes)
    if areas is None:
        return None
    ratio = networks.measure(body, pairs, areas, REACH)
    return np.array([ratio[load] for load in ("axial", "bending", "torsion")])


def change(now, before):
    """in percent of the exact stiffness"""
    return "refused" if now is None else ", ".join(f"{100 * d:+.1f}".replace("-0.0", "0.0").replace("+0.0", "0.0")
                                                    for d in now - before)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--only", nargs="+", default=[], metavar="NAME")
    parser.add_argument("--factors", nargs=2, type=float, default=(0.5, 2.0), help="other than half and double")
    parser.add_argument("--compiler", default=os.environ.get("CXX", "g++"))
    arguments = parser.parse_args()
    bodies = [networks.packing(6, 48, spread=0.2), networks.beam("sc", 5, 50)]
    cases = [(body, body.pairs(REACH)) for body in bodies]
    with tempfile.TemporaryDirectory() as folder:
        program = build(Path(folder), arguments.compiler)
        before = [stiffness(program, *case, {}) for case in cases]
        print("as they are: " + "; ".join(", ".join(f"{value:.4f}" for value in case) for case in before) + "\n")
        names = [{0.5: "half", 2.0: "double"}.get(factor, f"× {factor:g}") for factor in arguments.factors]
        print("| constant | value | what it is, where it comes from | " +
              " | ".join(f"{body}: {name}" for body in ("random", "cubic") for name in names) + " |")
        print("|---|---|---|---|---|---|---|")
        for constant in constants():
            if arguments.only and constant.name not in arguments.only:
                continue
            cells = ["–" for _ in range(4)]
            if constant.origin == "chosen":
                changes = [{"POTDEM_" + constant.name: constant.times(factor)} for factor in arguments.factors]
                cells = [change(stiffness(program, *case, which), start)
                         for case, start in zip(cases, before) for which in changes]
            print(f"| `{constant.name}` | {constant.value} | {constant.origin}: {constant.meaning} | " + " | ".join(cells) + " |",
                  flush=True)


if __name__ == "__main__":
    main()
