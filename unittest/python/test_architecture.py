# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Where a line belongs (docs/developer.md): what may include what, and that nothing is written twice."""

import itertools
import re
from pathlib import Path

import pytest

pytestmark = pytest.mark.built_in


def sources(root):
    return sorted(path for path in (root / "src").rglob("*") if path.suffix in (".h", ".cpp"))


def unit(path):
    """x.h and x.cpp are one"""
    return path.with_suffix("")


@pytest.fixture(scope="module")
def includes(root):
    """{unit: the units of this package that it includes}, as paths below src"""
    src, found = root / "src", {}
    for path in sources(root):
        name = path.relative_to(src)
        named = re.findall(r'^#include "([^"]+)"', path.read_text(), re.MULTILINE)
        ours = {Path(*target.relative_to(src).parts) for text in named for target in ((src / text), (path.parent / text))
                if target.exists()}
        found.setdefault(unit(name), set()).update(unit(target) for target in ours if unit(target) != unit(name))
    return found


def circles(graph):
    """a circle of each unit that is in one, by Tarjan's strongly connected components"""
    index, low, stack, on, out = {}, {}, [], set(), []

    def visit(node):
        index[node] = low[node] = len(index)
        stack.append(node)
        on.add(node)
        for other in graph.get(node, ()):
            if other not in index:
                visit(other)
                low[node] = min(low[node], low[other])
            elif other in on:
                low[node] = min(low[node], index[other])
        if low[node] == index[node]:
            members = []
            while not members or members[-1] != node:
                members.append(stack.pop())
                on.discard(members[-1])
            if len(members) > 1:
                out.append(sorted(map(str, members)))

    for node in graph:
        if node not in index:
            visit(node)
    return out


def test_nothing_includes_itself_by_way_of_others(includes):
    assert len(includes) > 50
    assert circles(includes) == []


def test_circles_are_found():
    a, b, c = Path("a"), Path("b"), Path("c")
    assert circles({a: {b}, b: {c}, c: {a}}) == [["a", "b", "c"]]
    assert circles({a: {b, c}, b: {c}, c: set()}) == []


# a folder may include these, and itself
BELOW = {
    "core/laws": set(),
    "core/stability": {"core/laws"},
    "core/contact": {"core/laws", "core/stability"},
    "core/areas": {"core/laws", "core/geometry"},
    "core/geometry": set(),
    "lammps/glue": {"core/laws", "core/stability"},
    "lammps/output": {"core/laws", "core/stability", "lammps/glue"},
    "lammps/pair": {"core/laws", "core/stability", "core/contact", "lammps/glue", "lammps/output"},
    "lammps/bond": {"core/laws", "core/stability", "core/areas", "lammps/glue", "lammps/output"},
    "lammps/wall": {"core/laws", "core/stability", "core/contact", "core/geometry", "lammps/glue", "lammps/output"},
}


def test_folders_depend_one_way(includes):
    wrong = []
    for name, others in includes.items():
        folder = str(name.parent)
        if folder == "lammps":    # registration
            continue
        allowed = BELOW[folder] | {folder}
        wrong += [f"{name} includes {other}" for other in sorted(others) if str(other.parent) not in allowed]
    assert wrong == []


def test_core_knows_no_lammps(root):
    """only its own headers and the standard library; no allocation by hand, no virtual function in a law"""
    wrong = []
    for path in sources(root):
        if "core" not in path.relative_to(root / "src").parts:
            continue
        text = path.read_text()
        for name in re.findall(r'^#include "([^"]+)"', text, re.MULTILINE):
            if not ((root / "src" / name).exists() or (path.parent / name).exists()):
                wrong.append(f"{path.name}: {name}")
        if "LAMMPS_NS" in text or (path.parent.name == "laws" and re.search(r"\bvirtual\b|\bthrow\b|\bnew\b(?! law)", strip(text))):
            wrong.append(path.name)
    assert wrong == []


def strip(text):
    """without comments and strings"""
    return re.sub(r"/\*.*?\*/|//[^\n]*|\"[^\"\n]*\"", "", text, flags=re.DOTALL)


def test_a_law_is_named_in_its_file_and_its_row_only(root):
    """but for those that serve others: the truss's strain and section, and Hertz under a soft layer at a wall"""
    listed = (root / "src" / "core" / "laws" / "law_list.h").read_text()
    laws = re.findall(r"X\((?:\w+, )?(\w+)\)", strip(listed.split("// clang-format on")[0].split("// clang-format off")[1]))
    assert {"Hertz", "Truss", "Sliding", "ShiftedLJ"} <= set(laws)
    wrong = []
    for path in sources(root):
        for law in laws:
            if re.search(rf"\b{law}\b", strip(path.read_text())) and not re.search(rf"^struct {law}\b.*{{", path.read_text(), re.MULTILINE):
                wrong.append((law, path.name))
    allowed = {("Sliding", "fix_potdem_wall_region.h"), ("Sliding", "fix_potdem_wall_region.cpp"),    # holds at rest
               ("Sliding", "potdem_friction.cpp"),                                                   # 'auto'
               ("Hertz", "dmt.h"),                                                                   # Hertz, pulled
               ("Truss", "truss_contact.h")}                                                         # a truss that only pushes
    assert {(law, name) for law, name in wrong if name != "law_list.h"} <= allowed


def tracked(root):
    """our own sources in any language"""
    for folder in ("src", "unittest", "examples", "tools", "bench", "cmake"):
        for path in sorted((root / folder).rglob("*")):
            if path.suffix in (".h", ".cpp", ".cu", ".py", ".sh", ".cmake") and "__pycache__" not in path.parts:
                yield path


def test_every_source_says_its_licence(root):
    missing = [str(path.relative_to(root)) for path in tracked(root)
               if "GNU General Public License, version 2" not in "\n".join(path.read_text().splitlines()[:8])]
    assert missing == []


WINDOW = 6


def code_lines(path):
    """without comments, includes and what holds no code"""
    lines = [line.strip() for line in strip(path.read_text()).splitlines()]
    return [line for line in lines if len(line) > 2 and not line.startswith("#")]


def windows(lines):
    return {tuple(lines[k:k + WINDOW]) for k in range(len(lines) - WINDOW + 1)}


def test_no_two_files_share_a_fifth_of_their_lines(root):
    """in runs of six or more"""
    files = {path: code_lines(path) for path in sources(root)}
    runs = {path: windows(lines) for path, lines in files.items()}
    wrong = []
    for a, b in itertools.combinations(files, 2):
        shared = runs[a] & runs[b]
        less = min(len(files[a]), len(files[b]))
        if shared and (len(shared) + WINDOW - 1) > 0.2 * less:
            wrong.append(f"{a.name} and {b.name}: {len(shared) + WINDOW - 1} of {less}")
    assert wrong == []


def test_programs_find_the_package_by_their_environment(root):
    """and none edits the path of its modules"""
    edits = [path.name for path in tracked(root) if path.suffix == ".py" and re.search(r"sys\.path\b(?!`)", path.read_text())]
    assert [name for name in edits if name != Path(__file__).name] == []
