# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Writes docs/errors.md: every error message and every warning of src/lammps, by the command that says it, and some of LAMMPS's own errors.

Usage: tools/python -m potdem.errors
"""

import re
from pathlib import Path

from potdem.paths import DOCS, ROOT

SOURCES = ROOT / "src" / "lammps"
PAGE = DOCS / "errors.md"
ERROR = re.compile(r"(?:error->(?:all|one)|\bfail|std::runtime_error)\(")
WARNING = re.compile(r"(?:error->warning|\bwarn|\blammps_error)\(")
FORMAT = re.compile(r"fmt::format\(")
# of fix_potdem_monitor: words that are kept until the warning is written
SAYS = re.compile(r"\bsay\([A-Z]+,|const auto text = fmt::format\(")
STIFF_PAIR = re.compile(r'warn_of_stiff_pair\("([^"]*)"')       # the first words of one warning
LITERAL = r'"((?:[^"\\]|\\.)*)"'
CONSTANT = re.compile(rf"const char \*const (\w+) = ((?:{LITERAL}\s*)+);")
WRAPPED = re.compile(r"(?:std::string|fmt::format|)\(")
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
    ("what is checked during a run", "warnings.md#warnings", ["fix_potdem_monitor", "fix_potdem_refresh"]),
    ("the plugin", "install.md#the-plugin-for-a-lammps-that-is-there", ["plugin"]),
    ("every command", "index.md",
     ["potdem_input", "potdem_law_io", "potdem_any_law", "potdem_width", "potdem_gather", "potdem_swap", "potdem_restart_block",
      "fix_potdem_resume"]),
]

HEAD = """# Errors and warnings

This page lists the messages of the package. `tools/python -m potdem.errors` makes it from the sources; … stands for what a run fills in.
LAMMPS prints `ERROR:` before an error, in most cases the command as well, and the line of the script after it; it prints `WARNING:` before a
warning. A message says what is wrong and, where there is one, the remedy. The page linked in each heading says more, and
[another page](warnings.md#warnings) explains when each warning comes. Errors of LAMMPS itself are explained in
[its manual](https://docs.lammps.org/Errors_messages.html).

The ranges and keywords of single coefficients are not listed: such errors all read *… = … is out of range, it must be …* or
*unknown keyword …, expected …*, and each style's page has a table of its coefficients. Words that a message chooses from several are not
listed either.
"""


# what LAMMPS says itself where bonded bodies meet it, why, and what to do
OF_LAMMPS = [
    ("Bond atoms … missing; Bond atom missing in image check, in box size check",
     "One end of a bond is too far from the other. Where it was deleted, left the box or was torn away in a run POTDEM says so; in a periodic "
     "box a run begins with LAMMPS's own check",
     "The particle was moved, by `displace_atoms` or `set`, further from its body than bonds may be long: move whole bodies"),
    ("Lost atoms: original … current …",
     "Particles are gone. One that leaves the box through a fixed side POTDEM names before; this is said of particles that have crossed the part "
     "of the box of another rank in one step, or where no style of POTDEM is used",
     "A smaller timestep, a larger box, or `thermo_modify lost ignore lost/bond ignore`"),
    ("Cannot replicate with fixes that store per-atom quantities",
     "Bonds remember their lengths, and contacts where they begin",
     "`replicate` first, then `potdem_bonds`"),
    ("Cannot hybridize bond styles with different topology settings",
     "`bond_style hybrid` takes potdem/truss and BPM's styles, and none of LAMMPS's ordinary ones: they list their bonds differently",
     "potdem/truss for all bonds, or BPM's styles beside it"),
    ("With overlay/pair no, and break yes, BPM bond styles requires special Coulomb weights = 1,1,1",
     "`potdem_bonds` has set the weights that potdem/truss needs",
     "`bond_style potdem/truss`, or the `special_bonds` that BPM asks for after `potdem_bonds`"),
    ("Cannot use neighbor bins - box size << cutoff",
     "The skin or a diameter is far larger than the box: other units than those of the script",
     "`neighbor` with a fifth of the smallest diameter; `set ... diameter`"),
    ("Neighbor list overflow, boost neigh_modify one",
     "More particles than expected are within reach of one: a skin or an r_infl of many diameters, or particles that lie in each other",
     "A smaller skin; `neigh_modify one 10000 page 1000000` where it is meant"),
    ("Molecule topology/atom exceeds system topology/atom",
     "Bonds of a molecule template need room when the box is created; `potdem_bonds` makes room for its own only",
     "`create_box ... extra/bond/per/atom 32 extra/special/per/atom 100`, and `newton on off` before it"),
    ("No bonds allowed with atom style …; Bond_style command when no bonds allowed",
     "The particles of this atom style have no bonds", "`atom_style bpm/sphere`"),
]


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


def parts(text, separator):
    """text cut at the separators that are in no literal and in no parentheses"""
    found, depth, begin, at = [], 0, 0, 0
    while at < len(text):
        literal = re.compile(LITERAL).match(text, at)
        if literal:
            at = literal.end()
            continue
        depth += {"(": 1, "[": 1, "{": 1, ")": -1, "]": -1, "}": -1}.get(text[at], 0)
        if text[at] == separator and depth == 0:
            found.append(text[begin:at])
            begin = at + 1
        at += 1
    return [*found, text[begin:]]


def words_of(expression, constants):
    """what an expression of strings says, with … for all but literals and named constants; empty without any"""
    said = ""
    for term in parts(expression, "+"):
        term = constants.get(term.strip(), term.strip())
        wrapped = WRAPPED.match(term)
        if wrapped:
            said += words_of(parts(argument(term, wrapped.end()), ",")[0], constants) or "…"
        elif term.startswith('"'):
            # a name between two literals is a macro
            said += "".join(PLACE.sub("…", one.group(1)) if one.group(1) is not None else "…"
                            for one in re.finditer(rf"{LITERAL}|\w+", term))
        else:
            said += "…"
    said = re.sub("…+", "…", said)
    return "" if said == "…" else said.replace(r"\"", '"').replace(r"\n", "")


def message(call, constants):
    """the words of a call, or empty if it passes on those of another"""
    if NO_MESSAGE in call:
        return ""
    return next(filter(None, (words_of(one, constants) for one in parts(call, ","))), "")


def without_comments(path):
    return re.sub(r"^\s*//[^\n]*$|/\*.*?\*/", "", path.read_text(encoding="utf-8"), flags=re.MULTILINE | re.DOTALL)


def messages(path, call=ERROR):
    text = without_comments(path)
    constants = {match.group(1): match.group(2) for match in CONSTANT.finditer(text)}
    found = [message(argument(text, match.end()), constants) for match in call.finditer(text)]
    return [words for words in found if re.search("[a-z]{2}", words)]


def warnings(path):
    """also those that a file keeps before it writes them"""
    text = without_comments(path)
    found = messages(path, WARNING)
    for match in SAYS.finditer(text):
        form = FORMAT.search(text, match.start())
        words = message(argument(text, form.end()), {})
        leads = STIFF_PAIR.findall("".join(map(without_comments, sources()))) if words.startswith("…") else [""]
        found += [lead + words.removeprefix("…") for lead in sorted(leads)]
    return found


def sources():
    return sorted([*SOURCES.rglob("*.cpp"), *SOURCES.rglob("*.h")])


def group_of(path):
    """the group with the longest name with which the file's begins"""
    fitting = [(len(stem), title) for title, _, stems in GROUPS for stem in stems if path.stem.startswith(stem)]
    if not fitting:
        raise ValueError(f"potdem.errors: {path} has messages, but belongs to no group")
    return max(fitting)[1]


def collected(read):
    """title -> what is read of its files, each once, in the order of the files"""
    found = {title: [] for title, _, _ in GROUPS}
    for path in sources():
        words = read(path)
        if words:
            found[group_of(path)] += [one for one in words if one not in found[group_of(path)]]
    return found


def escaped(words):
    return re.sub(r"([*|<>\\`])", r"\\\1", words)


def rows(found):
    return "".join(f"* {escaped(words)}\n" for words in found)


def page():
    text = [HEAD]
    errors, warned = collected(messages), collected(warnings)
    for title, link, _ in GROUPS:
        both = [rows(errors[title]), f"Warnings:\n\n{rows(warned[title])}" if warned[title] else ""]
        if any(both):
            text.append(f"## [{title}]({link})\n\n" + "\n".join(filter(None, both)))
    of_lammps = "".join(f"| *{escaped(words)}* | {why}. | {remedy}. |\n" for words, why, remedy in OF_LAMMPS)
    text.append(f"## LAMMPS's own, with bonded bodies\n\n| LAMMPS says | why | what to do |\n|---|---|---|\n{of_lammps}")
    return "\n".join(text)


def main():
    Path(PAGE).write_text(page(), encoding="utf-8")


if __name__ == "__main__":
    main()
