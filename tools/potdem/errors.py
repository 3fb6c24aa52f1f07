# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Writes docs/errors.md: every error message of src/lammps, by the command that says it.

Usage: tools/python -m potdem.errors
"""

import re
from pathlib import Path

from potdem.paths import DOCS, ROOT

SOURCES = ROOT / "src" / "lammps"
PAGE = DOCS / "errors.md"
CALL = re.compile(r"(?:error->(?:all|one)|\bfail|std::runtime_error)\(")
LITERAL = r'"((?:[^"\\]|\\.)*)"'
PLACE = re.compile(r"\{[^{}]*\}")
NO_MESSAGE = '"{}: {}", command, text'    # by which PotdemInput::fail passes on what it is given

# title, page, and the names with which the files of a group begin
GROUPS = [
    ("potdem_bonds", "potdem_bonds.md", ["potdem_bonds", "potdem_bond_network", "fix_potdem_bond_history"]),
    ("bond_style potdem/truss", "bond_potdem_truss.md", ["bond_potdem", "potdem_bond_area", "potdem_body_area", "potdem_lattice_area"]),
    ("fix potdem/failure", "fix_potdem_failure.md", ["fix_potdem_failure", "potdem_bond_strengths"]),
    ("pair styles", "pair_potdem_truss.md", ["pair_potdem", "fix_potdem_contacts", "potdem_pair_lists"]),
    ("friction and restitution, of pair styles and walls", "pair_potdem_truss.md#friction-and-rotation",
     ["potdem_friction", "potdem_rate"]),
    ("fix potdem/wall/region", "fix_potdem_wall_region.md", ["fix_potdem_wall", "potdem_wall"]),
    ("region potdem/mesh", "region_potdem_mesh.md", ["region_potdem_mesh", "potdem_stl"]),
    ("material files and potdem_material", "materials.md", ["potdem_material"]),
    ("computes, fix potdem/damping and fix potdem/timestep", "index.md",
     ["compute_potdem", "fix_potdem_damping", "fix_potdem_timestep", "fix_potdem_ledger", "fix_potdem_reference", "potdem_stiffness"]),
    ("warnings and what is kept in step", "warnings.md", ["fix_potdem_monitor", "fix_potdem_refresh"]),
    ("every command", "index.md",
     ["potdem_input", "potdem_law_io", "potdem_any_law", "potdem_width", "potdem_gather", "potdem_swap", "potdem_restart_block", "plugin"]),
]

HEAD = """# Errors

Made by `tools/python -m potdem.errors` from the sources, with … for what a run fills in. LAMMPS prints `ERROR:` before a message, mostly the command
as well, and the line of the script after it. A message says what is wrong and, where there is one, the remedy; the page of the command, linked in each
heading, says more. What warnings mean is on [a page of its own](warnings.md#warnings). Errors of LAMMPS itself are explained in
[its manual](https://docs.lammps.org/Errors_messages.html).

Not listed: the ranges and keywords of single coefficients. They all read *… = … is out of range, it must be …*, or *unknown keyword …, expected …*, and
the table of each style's page has them. Nor parts of a message that are chosen from several.
"""


def argument(text, start):
    """what is between the parenthesis that ends before start and its partner; literals may have parentheses"""
    depth, at = 1, start
    while depth:
        literal = re.compile(LITERAL).match(text, at)
        if literal:
            at = literal.end()
            continue
        depth += {"(": 1, ")": -1}.get(text[at], 0)
        at += 1
    return text[start:at - 1]


def message(call):
    """the words of a call, or None if it passes on those of another"""
    run = re.search(rf"(?:{LITERAL}\s*)+", call)
    if not run or NO_MESSAGE in call:
        return None
    words = PLACE.sub("…", "".join(re.findall(LITERAL, run.group()))).replace(r"\"", '"').replace(r"\n", "")
    before, after = call[:run.start()].rstrip().endswith("+"), call[run.end():].startswith("+")
    return f"{'…' if before else ''}{words}{'…' if after else ''}"


def messages(path):
    text = path.read_text(encoding="utf-8")
    text = re.sub(r"^\s*//[^\n]*$|/\*.*?\*/", "", text, flags=re.MULTILINE | re.DOTALL)
    calls = [argument(text, match.end()) for match in CALL.finditer(text)]
    return [words for words in map(message, calls) if words and re.search("[a-z]{2}", words)]


def group_of(path):
    """the group with the longest name with which the file's begins"""
    fitting = [(len(stem), title) for title, _, stems in GROUPS for stem in stems if path.stem.startswith(stem)]
    if not fitting:
        raise ValueError(f"potdem.errors: {path} has messages but belongs to no group")
    return max(fitting)[1]


def collected():
    """title -> the messages of its files, each once, in the order of the files"""
    found = {title: [] for title, _, _ in GROUPS}
    for path in sorted([*SOURCES.rglob("*.cpp"), *SOURCES.rglob("*.h")]):
        words = messages(path)
        if words:
            found[group_of(path)] += [one for one in words if one not in found[group_of(path)]]
    return found


def escaped(words):
    return re.sub(r"([*|<>\\`])", r"\\\1", words)


def page():
    parts = [HEAD]
    found = collected()
    for title, link, _ in GROUPS:
        if found[title]:
            parts.append(f"## [{title}]({link})\n\n" + "".join(f"* {escaped(words)}\n" for words in found[title]))
    return "\n".join(parts)


def main():
    Path(PAGE).write_text(page(), encoding="utf-8")


if __name__ == "__main__":
    main()
