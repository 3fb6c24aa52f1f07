# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Runs a scene's variants, compares each with its reference log and draws its picture (see examples/run)."""

import argparse
import hashlib
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

from potdem import compare, logs, paraview, running
from potdem.paths import with_package
from potdem.progress import Progress
from potdem.scenes import resume, run_script
from potdem.scenes import scene as scenes


SETTINGS = "settings.json"    # of a run with restart files: its variables


class Failure(Exception):
    """what ends the whole run"""


def list_scenes():
    for name in scenes.names():
        scene = scenes.Scene(name)
        print(f"{name}: {scene.title}")
        for variant, settings in scene.variants.items():
            if variant:
                mark = "*" if variant in scene.default_variants else " "
                print(f"  {mark} {variant:<20} {(settings or {}).get('description', '')}".rstrip())
    print("\nThe variants marked * run when none is named.")


def of_run(variant):
    """what must be the same when a run goes on"""
    script = (variant.scene.folder / variant.scene.script).read_bytes()
    return {"variables": variant.variables, "script": hashlib.sha256(script).hexdigest()}


def can_resume(variant):
    if not run_script.takes((variant.scene.folder / variant.scene.script).read_text(encoding="utf-8"), "resume"):
        raise Failure(f"{variant.scene.name} writes no restart files: its runs take seconds. Begin anew without --restart and --resume")


def begin(variant, nprocs, restart):
    """(variables of a new run, None)"""
    folder = variant.output(nprocs)
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    if not restart:
        return {}, None
    can_resume(variant)
    (folder / SETTINGS).write_text(json.dumps({"restart": restart, **of_run(variant)}), encoding="utf-8")
    return {"restart": restart}, None


def go_on(variant, nprocs, restart):
    """(variables of a run that goes on, what the one before left)"""
    can_resume(variant)
    folder = variant.output(nprocs)
    stopped = resume.Stopped(folder / "log.running", variant.scene.folder)
    file = resume.newest(sorted(folder.glob("*.restart")))
    if not file or not (folder / SETTINGS).exists():
        others = {path.parent.name for path in folder.parent.glob(f"{folder.name.rsplit('.np', 1)[0]}.np*/*.restart")} - {folder.name}
        raise Failure(f"{variant.label} on {nprocs} rank(s) has no complete restart file in {folder}: --restart N writes one every N steps"
                      + (f". There are some in {', '.join(sorted(others))}" if others else ""))
    written = json.loads((folder / SETTINGS).read_text(encoding="utf-8"))
    before = written.pop("restart")
    if written != json.loads(json.dumps(of_run(variant))):
        raise Failure(f"{variant.label} was begun with another {variant.scene.script} or other variables than now: {folder}. Begin anew")
    path, step = file
    print(f"{variant.label} goes on from step {step}, {path}", flush=True)
    stopped.cut(step)
    return {"restart": restart or before, "resume": os.path.relpath(path, variant.scene.folder)}, stopped


def simulate(variant, nprocs, progress, restart=None, resumes=False):
    """the log of a run that is made, or of one that was stopped and goes on; restart: steps between restart files"""
    folder = variant.output(nprocs)
    ended = [path for path in folder.glob("log.*") if path.name != "log.running"]
    if resumes and ended:
        print(f"{variant.label} on {nprocs} rank(s) had come to its end")
        return ended[0]
    more, stopped = (go_on if resumes else begin)(variant, nprocs, restart)
    log = folder / "log.running"
    # relative, because LAMMPS repeats it in the log, which may become a reference
    out = os.path.relpath(folder, variant.scene.folder)
    arguments = running.command(variant.scene.script, {**variant.variables, "out": out, **more}, log, nprocs)
    problem = running.watched(arguments, variant.scene.folder, progress)
    if problem:
        raise Failure(f"{problem}\nlog: {log}\ncommand: {' '.join(arguments)}")
    if stopped:
        stopped.join()
    return log.rename(folder / variant.log_name(scenes.version_of(log), nprocs))


def make_reference(variant, log):
    shutil.copy(log, variant.scene.folder / log.name)


def check(variant, log, nprocs):
    """reference log and the checks of the comparison with it; of a draw without a reference, that it has come so far"""
    if not variant.has_reference:
        return None, [compare.Check("", "the run ends", True)]
    reference = variant.reference(scenes.version_of(log), nprocs)
    return reference, compare.compare(logs.read_thermo(log), logs.read_thermo(reference), variant.scene.rules)


def count(checks):
    """(passed, failed)"""
    passed = sum(check.passed for check in checks)
    return passed, len(checks) - passed


def draw(variant, folder):
    """the picture, or None where the scene draws none"""
    if not variant.scene.plot:
        return None
    picture = folder / f"{variant.label}.png"
    drawn = subprocess.run([sys.executable, str(variant.scene.plot), str(folder), str(picture)],
                           cwd=variant.scene.folder, env=with_package(), check=False)
    if drawn.returncode != 0 or not picture.exists():
        raise Failure(f"{variant.scene.plot} drew no picture")
    return picture


def film_of(scene):
    """how to show the scene's frames (picture.Film); the scene's plot.py has one where there is a dump"""
    film = getattr(scenes.load(scene.plot), "FILM", None) if scene.plot else None
    if not film:
        raise Failure(f"{scene.name} has no animation: it dumps no frames")
    return film


def animate(variant, folder):
    path = folder / f"{variant.label}.gif"
    film_of(variant.scene).animate(folder, path)
    return path


def write_for_paraview(variant, folder):
    return paraview.write(film_of(variant.scene).frames(folder), folder / "paraview", variant.label)


def run_variant(variant, arguments):
    progress = Progress(f"{variant.label} on {arguments.np} rank(s)")
    log = simulate(variant, arguments.np, progress, arguments.restart, arguments.resume)
    if arguments.update_reference and variant.has_reference:
        make_reference(variant, log)
    reference, checks = check(variant, log, arguments.np)
    print(f"\ncompared with {reference.name}" if reference else "\nanother draw: compared with nothing")
    if reference and reference.name != log.name:
        print(f"  (there is no reference {log.name})")
    print(compare.report(checks))
    picture = draw(variant, log.parent)
    print(f"\nlog:     {log}")
    if picture:
        print(f"picture: {picture}")
    if arguments.animate:
        print(f"film:    {animate(variant, log.parent)}")
    if arguments.paraview:
        print(f"frames:  {write_for_paraview(variant, log.parent)}")
    return count(checks)


def parse(argv):
    parser = argparse.ArgumentParser(prog="examples/run")
    parser.add_argument("scene", nargs="?")
    parser.add_argument("variants", nargs="*")
    parser.add_argument("-np", type=int, default=1, metavar="N")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--update-reference", action="store_true")
    parser.add_argument("--animate", action="store_true")
    parser.add_argument("--paraview", action="store_true")
    parser.add_argument("--restart", type=int, metavar="N")
    parser.add_argument("--resume", action="store_true")
    parser.add_argument("-var", nargs="+", action="append", default=[], metavar=("NAME", "VALUE"))
    arguments = parser.parse_intermixed_args(argv)
    if not arguments.list and not arguments.scene:
        parser.error("which scene? (--list names them)")
    if arguments.np < 1:
        parser.error("-np must be at least 1")
    if arguments.restart is not None and arguments.restart < 1:
        parser.error("--restart must be at least 1: steps between two restart files")
    return arguments


def main(argv):
    arguments = parse(argv)
    if arguments.list:
        list_scenes()
        return 0
    if arguments.scene not in scenes.names() and Path(arguments.scene).exists():
        return run_script.main(arguments)
    if arguments.var:
        raise Failure("-var is for a script of your own; a scene has variants (--list names them)")
    scene = scenes.Scene(arguments.scene)
    variants = [scene.variant(name) for name in arguments.variants or scene.default_variants]
    counts = [run_variant(variant, arguments) for variant in variants]
    passed, failed = (sum(count) for count in zip(*counts))
    print(f"{passed} checks passed, {failed} failed")
    return 0 if failed == 0 and passed > 0 else 1


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except (Failure, resume.Failure, run_script.Failure, scenes.SceneError, logs.LogError, compare.RuleError) as problem:
        sys.exit(str(problem))
