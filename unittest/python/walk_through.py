# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Applies a patch of unittest/walk-through to a copy of the sources and builds the plugin from it: what the patch touches, and
what includes that, is compiled anew, a new normal law from the template that CMake fills; all else is taken from the build under test."""

import re
import shutil
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from potdem.scripts import laws_of
from potdem.text import replaced

LIST = "src/core/laws/law_list.h"
STYLES = "potdemstyles.so"


def output_of(*command, cwd):
    done = subprocess.run(command, cwd=cwd, text=True, check=False, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    assert done.returncode == 0, done.stdout[-3000:]
    return done.stdout


def apply(root, patch, folder):
    """a copy of src with the patch; returns the files that it touches"""
    shutil.copytree(root / "src", folder / "src")
    touched = re.findall(r"^\+\+\+ b/(\S+)", patch.read_text(), re.MULTILINE)
    output_of("git", "apply", "-p1", str(patch), cwd=folder)
    return touched


def check_touched(root, touched):
    """one new header, and a row and its include in the list of laws"""
    others = [Path(name) for name in touched if name != LIST]
    assert LIST in touched and len(others) == 1, touched
    assert others[0].suffix == ".h" and not (root / others[0]).exists(), touched


def objects(build):
    """{object of the plugin's styles, most of them LAMMPS's as well: (its command, what it was made from)}"""
    commands = output_of("ninja", "-t", "commands", STYLES, cwd=build).splitlines()
    made = {re.search(r" -o (\S+\.o) ", line).group(1): line for line in commands if " -c " in line}
    known = output_of("ninja", "-t", "deps", *made, cwd=build)
    needed = dict(re.findall(r"^(\S+\.o): .*\n((?: +\S+\n)*)", known, re.MULTILINE))
    # a path may be relative to the build
    return {name: (line, {str((build / file).resolve()) for file in needed[name].split()}) for name, line in made.items()}, commands[-1]


def add_pair_styles(root, folder, made, anew):
    """the sources of the normal laws that the patch adds, compiled as that of another one"""
    template = (folder / "src" / "lammps" / "pair" / "pair_potdem_law.cpp.in").read_text()
    like = next(name for name in made if name.endswith("pair_potdem_hertz.cpp.o"))
    line, _ = made[like]
    for name, law in set(laws_of(folder, "pair")) - set(laws_of(root, "pair")):
        source = folder / f"pair_potdem_{name}.cpp"
        source.write_text(template.replace("@name@", name).replace("@law@", law))
        made_from_it = like.replace("hertz", name)
        anew[made_from_it] = re.sub(r" -c \S+$", f" -c {source}", replaced(line, f" -o {like} ", f" -o {made_from_it} "))


def build_plugin(root, build, patch, folder, *options):
    """the plugin with the patch, in the folder; options: of the compiler, after those of the build"""
    if not (build / "build.ninja").exists():
        pytest.skip("needs a build by Ninja")
    touched = apply(root, patch, folder)
    check_touched(root, touched)
    changed = {str((root / name).resolve()) for name in touched}
    made, link = objects(build)
    anew = {name: line for name, (line, needed) in made.items() if changed & needed}
    assert anew
    add_pair_styles(root, folder, made, anew)

    def compile_copy(item):
        name, line = item
        local = folder / Path(name).name
        line = re.sub(r" -MD -MT \S+ -MF \S+", "", replaced(line, f" -o {name} ", f" -o {local} "))
        output_of("sh", "-c", " ".join([replaced(line, f"{root}/src", f"{folder}/src"), *options]), cwd=build)
        return name, local

    with ThreadPoolExecutor(2) as workers:
        for name, local in workers.map(compile_copy, anew.items()):
            link = replaced(link, name, str(local)) if name in made else replaced(link, f" -o {STYLES} ", f" -o {STYLES} {local} ")
    output_of("sh", "-c", replaced(link, f"-o {STYLES}", f"-o {folder / STYLES}"), cwd=build)
    shutil.copy(build / "potdemplugin.so", folder)
    return folder / "potdemplugin.so"
