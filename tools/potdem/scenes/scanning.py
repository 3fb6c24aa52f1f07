# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Measures finished runs of a scene, or makes a run for every combination of some variables and measures those."""

import itertools
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from potdem import running


def run(scene, variables, folder):
    """runs the script of a scene's folder on one core; what it writes goes to the other folder"""
    folder = Path(folder).resolve()
    running.must_run(scene / f"in.{scene.name}", {**variables, "out": folder}, scene, log=folder / "log.scan", screen=folder / "screen")


def combinations(words):
    """'a=1,2' 'b=3' -> {a: 1, b: 3}, {a: 2, b: 3}"""
    settings = dict(word.split("=", 1) for word in words)
    values = (value.split(",") for value in settings.values())
    return [dict(zip(settings, chosen)) for chosen in itertools.product(*values)]


def _cases(scene, measure, words):
    def new(variables):
        with tempfile.TemporaryDirectory() as folder:
            run(scene, variables, folder)
            return measure(Path(folder))

    cases = combinations(words)
    labels = [" ".join(f"{name}={value}" for name, value in case.items()) for case in cases]
    with ThreadPoolExecutor(2) as pool:
        yield from zip(labels, pool.map(new, cases))


def main(scene, measure, words):
    """words: folders of runs, or NAME=VALUE[,VALUE ...]; prints measure(folder) of each run, two at a time"""
    folders = [Path(word) for word in words if "=" not in word]
    if folders:
        found = ((folder.name, measure(folder)) for folder in folders)
    else:
        found = _cases(scene, measure, words)
    for label, text in found:
        print(label.ljust(44), text, flush=True)
