#!/usr/bin/python3
"""Where does the beam part, as a function of what the thesis does not state?

  scan.py NAME=VALUE[,VALUE ...] ...      e.g. scan.py position=i speed=3,5 damping=0,0.01,0.02,0.03,0.05

Runs in.beam-impact for every combination (two at a time) and prints, for each, the number of broken bonds,
the pieces of the beam that have at least 20 particles with the stretch of the undeformed beam they came from
(in beam lengths, from the clamp), and the verdict: parts at the clamp, breaks where it is hit.
"""

import itertools
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
LMP = HERE.parent.parent / "build" / "lmp"
sys.path.insert(0, str(HERE.parent / "harness"))
import dumpfile  # noqa: E402
import logfile  # noqa: E402

LENGTH, SPACING = 0.24, 0.005
PIECE = 20       # particles: less is debris
CLAMP_END = 0.1  # a cut this near to the clamp (in beam lengths) is a failure of the clamped section


def run(case, folder):
    variables = [word for name, value in case.items() for word in ("-var", name, *value.split())]
    subprocess.run([LMP, "-in", "in.beam-impact", *variables, "-var", "out", folder, "-log", f"{folder}/log",
                    "-screen", "none"], cwd=HERE, check=True)
    return logfile.read_thermo(Path(folder) / "log"), dumpfile.read(Path(folder) / "dump.beam-impact")


def pieces(frames):
    """(start, end, particles) of each piece, in beam lengths of the undeformed beam"""
    first, last = frames[0], frames[-1]
    beam = first["type"] == 1
    found = []
    for fragment in np.unique(last["c_fragment"][beam]):
        x = first["x"][beam & (last["c_fragment"] == fragment)]
        if x.size >= PIECE:
            found.append(((x.min() - SPACING / 2) / LENGTH, (x.max() + SPACING / 2) / LENGTH, x.size))
    return sorted(found)


def verdict(found):
    stump_end = found[0][1]
    clamp = "clamp parts" if stump_end < CLAMP_END else "clamp holds"
    rest = [piece for piece in found[1:] if piece[0] > CLAMP_END] or stump_end < 0.95 <= found[-1][1]
    return f"{clamp}, {'breaks where hit' if rest or found[-1][1] < 0.95 else 'whole where hit'}"


def measure(case):
    with tempfile.TemporaryDirectory() as folder:
        table, frames = run(case, folder)
    found = pieces(frames)
    ranges = "  ".join(f"{start:.2f}-{end:.2f} ({count})" for start, end, count in found)
    return f"{table['v_broken'][-1]:5.0f} broken  {verdict(found):32s} {ranges}"


def main(words):
    settings = dict(word.split("=", 1) for word in words)
    cases = [dict(zip(settings, values)) for values in itertools.product(*(v.split(",") for v in settings.values()))]
    with ThreadPoolExecutor(2) as pool:
        for case, line in zip(cases, pool.map(measure, cases)):
            print(" ".join(f"{name}={value}" for name, value in case.items()).ljust(44), line, flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
