# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Runs a script of the user in its own folder, with progress and time left, and shows what it dumps (see examples/run)."""

import re
from pathlib import Path

from potdem import commands, dumps, logs, look, running, see
from potdem.progress import OfScript
from potdem.scenes import resume

LOG = "log.lammps"


class Failure(Exception):
    """what ends the command"""


def script_of(path):
    """a file, or the only in.* of a folder"""
    path = Path(path)
    if not path.is_dir():
        return path
    found = sorted(path.glob("in.*"))
    if len(found) != 1:
        names = f"several scripts: {', '.join(file.name for file in found)}; name one of them" if found else "no script in.*"
        raise Failure(f"{path} has {names}")
    return found[0]


def planned(text):
    """steps of the script's runs, None where a variable gives them; None if it has loops, so that they cannot be counted"""
    text = text.replace("&\n", " ")
    if re.search(r"^\s*(jump|next|include|if\b.*\brun)\b", text, re.MULTILINE):
        return None
    runs = re.findall(r"^\s*run\s+(\S+)(.*)$", text, re.MULTILINE)
    return [int(steps) if steps.isdecimal() and "upto" not in more else None for steps, more in runs]


def takes(text, name):
    """whether a script reads a variable"""
    return re.search(rf"\$\{{{name}\}}|\bv_{name}\b", text) is not None


def needs(script, text, name):
    if not takes(text, name):
        raise Failure(f"{script} reads no variable {name}. How to write a script that goes on: docs/howto_restart.md")


def go_on(script, text, stopped):
    """the newest restart file of a run that was stopped"""
    needs(script, text, "resume")
    file = resume.newest(resume.files_of_log(stopped.log)) if stopped.log.exists() else None
    if not file:
        raise Failure(f"{script} has no complete restart file to go on from: the command restart of {stopped.log} names none that is there")
    path, step = file
    print(f"{script} goes on from step {step}, {path}", flush=True)
    stopped.cut(step)
    return path


def run(arguments):
    """with the arguments of examples/run; the folder of the run"""
    script = script_of(arguments.scene)
    folder = script.resolve().parent
    text = script.read_text(encoding="utf-8", errors="replace")
    plan = planned(text)
    variables = {name: values for name, *values in arguments.var}
    stopped = resume.Stopped(folder / LOG)
    if arguments.restart:
        needs(script, text, "restart")
        variables["restart"] = arguments.restart
    if arguments.resume:
        variables["resume"] = go_on(script, text, stopped)
    else:
        stopped.forget()
    line = [*running.command(script.name, variables, LOG, arguments.np), "-echo", "both"]
    problem = running.watched(line, folder, OfScript(f"{script.name} on {arguments.np} rank(s)", plan))
    if problem:
        raise Failure(f"{problem}\nlog: {folder / LOG}\ncommand, in {folder}: {' '.join(line)}")
    stopped.join()
    warnings = re.findall(r"^WARNING: (.*)", logs.read(folder / LOG), re.MULTILINE)
    for text in dict.fromkeys(warnings):
        print(f"WARNING: {text}")
    print(f"log:     {folder / LOG}")
    return folder


def show(folder, arguments):
    """pictures of the dumps of particles"""
    wishes = [option for option, wanted in (("--film", arguments.animate), ("--vtk", arguments.paraview)) if wanted]
    shown = False
    written = [(words[3], words[5]) if words[0] == "dump" else words[2:4] for words in commands.of_log(folder / LOG).dumps]
    for style, name in dict.fromkeys(map(tuple, written)):
        file = folder / name
        if style in ("custom", "atom") and file.exists():
            shown = True
            try:
                see.main([str(file), "--log", str(folder / LOG), "--still", *wishes])
            except (look.SeeError, dumps.DumpError) as problem:
                print(f"no picture: {problem}")
    if not shown:
        print("no picture, because the script dumps no particles. To have one, put before its run:\n"
              "  dump see all custom N run.dump id type x y z radius vx vy vz")


def main(arguments):
    if arguments.variants or arguments.update_reference:
        raise Failure(f"{arguments.scene} is a script, not a scene: it has no variants and no reference. "
                      "Values of its variables: -var NAME VALUE")
    show(run(arguments), arguments)
    return 0
