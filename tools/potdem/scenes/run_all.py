# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Runs every scene, as many runs at once as there are cores, compares each with its reference log, and prints the table of
the thesis's claims (see examples/run)."""

import argparse
import os
import re
import sys
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

from potdem import compare, logs
from potdem.paths import DOCS
from potdem.progress import Together
from potdem.scenes import claim, run_scene
from potdem.scenes import scene as scenes

PAGE = DOCS / "claims.md"
MARKS = ("<!-- made by examples/run all --update-reference -->", "<!-- end of the table -->")


@dataclass
class Outcome:
    variant: scenes.Variant
    failed: int
    passed: int
    text: str


def work(variant, progress, together, update):
    """runs, compares and draws one variant"""
    try:
        log = run_scene.simulate(variant, 1, progress)
        if update and variant.has_reference:
            run_scene.make_reference(variant, log)
        _, checks = run_scene.check(variant, log, 1)
        passed, failed = run_scene.count(checks)
        text = f"{passed} checks passed, {failed} failed" + (f"\n{compare.report(checks)}" if failed else "")
        if variant.has_reference:
            run_scene.draw(variant, log.parent)
    except (run_scene.Failure, scenes.SceneError, logs.LogError, compare.RuleError) as problem:
        passed, failed, text = 0, 1, str(problem)
    together.say(f"{variant.label:36s} {text}")
    return Outcome(variant, failed, passed, text)


def seconds(variant):
    """about what a run takes; all draws take the same"""
    return scenes.seconds_of(variant.scene.variant(variant.name).reference("*", 1))


def run(variants, update):
    """the longest first, so that no core is left waiting for it at the end"""
    weights = {variant.label: seconds(variant) for variant in variants}
    together = Together(weights)
    ordered = sorted(variants, key=lambda variant: -weights[variant.label])

    def one(variant):
        return work(variant, together.part(variant.label), together, update)

    with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        return list(pool.map(one, ordered))


def measured(every, outcomes):
    """the claims of all scenes whose runs ended well"""
    failed = {outcome.variant.scene.name for outcome in outcomes if outcome.passed == 0}
    claims = []
    for scene in every:
        if scene.name not in failed:
            claims += claim.of_scene(scene, lambda name, draw=1, scene=scene: scene.variant(name, draw).output(1))
        elif scene.claims:
            print(f"claims of {scene.name} are left out: a run of it failed")
    return claims


def update_page(page, claims):
    """puts the table between the marks of docs/claims.md"""
    before, _, after = (part for part in re.split(f"({MARKS[0]}.*{MARKS[1]})", page.read_text(encoding="utf-8"), flags=re.DOTALL))
    page.write_text(f"{before}{MARKS[0]}\n{claim.table(claims, linked=True)}\n{MARKS[1]}{after}", encoding="utf-8")


def main(argv):
    parser = argparse.ArgumentParser(prog="examples/run all")
    parser.add_argument("--update-reference", action="store_true")
    update = parser.parse_args(argv).update_reference
    every = [scenes.Scene(name) for name in scenes.names()]
    outcomes = run([variant for scene in every for variant in scene.runs()], update)
    claims = measured(every, outcomes)
    print(f"\n{claim.table(claims)}\n")
    if update:
        update_page(PAGE, claims)
    passed, failed = (sum(getattr(outcome, which) for outcome in outcomes) for which in ("passed", "failed"))
    print(f"{len(outcomes)} runs; {passed} checks passed, {failed} failed")
    return 0 if failed == 0 and passed > 0 else 1


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except scenes.SceneError as problem:
        sys.exit(str(problem))
