# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""The documentation: every example runs, every style has a page, every page has its sections in order."""

import re
from pathlib import Path

import pytest

from potdem import scripts as inputs
from potdem import stl

ROOT = Path(__file__).resolve().parent.parent.parent
DOCS = ROOT / "docs"
README = ROOT / "README.md"

OUTPUT_SECTION = {
    "pair": "Mixing, shift, table, tail correction, restart, rRESPA info",
    "bond": "Restart and other info",
    "fix": "Restart, fix_modify, output, run start/stop, minimize info",
    "compute": "Output info",
    "command": "Output and restart info",
    "region": "Restart and output info",
}

HEAD = """
units si
atom_style bpm/sphere
boundary f f f
lattice sc 0.005
region box block -10 20 -10 20 -10 20
create_box 2 box bond/types 2
region beam block 0 9 0 4 0 4
region block block 3 7 0 4 8 12
create_atoms 1 region beam
create_atoms 2 region block
group beam type 1
group block type 2
set group all diameter 0.005 mass $(2400*0.005^3)
velocity block set 0 0 -3
"""
NETWORKS = """
potdem_bonds beam 1 2.0 diameters
potdem_bonds block 2 2.0 diameters
"""
BONDS = """
bond_style potdem/truss
bond_coeff * 3e6 area factor 0.4
"""
PAIRS = """
pair_style potdem/truss
pair_coeff * * 3e6 0.4
"""
RUN = """
timestep 5e-6
thermo 10
run 20
"""


def law_header(kind, style):
    """core/laws/*.h of a pair or bond style, by its row of CONTACT_LAWS or BOND_LAWS"""
    laws = ROOT / "src" / "core" / "laws"
    law = dict(inputs.laws_of(ROOT, kind))[style.split("/")[1]]
    (header,) = [header for header in laws.glob("*.h") if re.search(rf"^struct {law}\b[^;]*$", header.read_text(), re.MULTILINE)]
    return header


HEADERS = {header.name: header.read_text() for header in (ROOT / "src" / "core" / "laws").glob("*.h")}


def struct(law):
    """the text of a law's struct"""
    (found,) = [match.group() for match in (re.search(rf"^struct {law}\b[^;]*\n.*?^}};", text, re.MULTILINE | re.DOTALL)
                                            for text in HEADERS.values()) if match]
    return found


def coefficients(text):
    """rows of the table of a law: (kind, word, symbol, range, unit, what follows)"""
    body = "".join(text.split("coefficients()")[1].split("};")[0].split("\n"))
    return re.findall(r'(required|option|continued_by)\("(\w+)",\s*(?:"(\w+)",\s*)?&\w+::\w+,\s*(\w+\([^)]*\)),\s*"([^"]+)"\)'
                      r'((?:\s*\.\w+\([^)]*\))*)', body)


def laws_of(table):
    (rows,) = re.findall(rf"#define {table}\(X\)((?:.*\\\n)*.*)", HEADERS["law_list.h"])
    return re.findall(r"X\((\w+)\)", rows)


def laws_beside(kind, name):
    """the structs of the rate laws, the laws of friction and the resistance to rolling that a pair style or the wall takes"""
    if (kind, name) == ("fix", "potdem/wall/region"):
        normal = [header for header in (ROOT / "src" / "core" / "laws").glob("*.h")
                  if re.search(r"contact_only = \w+, rate_dependent = \w+", header.read_text())]
    elif kind == "pair":
        normal = [law_header(kind, name)]
    else:
        return []
    texts = [header.read_text() for header in normal]
    found = [struct("RollingResistance")]
    for law in laws_of("RATE_LAWS"):
        (trait,) = re.findall(r"bool serves\(\) \{ return Law::(\w+); \}", struct(law))
        if any(f"{trait} = true" in text for text in texts):
            found.append(struct(law))
    for law in laws_of("TANGENTIAL_LAWS"):
        if "needs_shear_ratio" not in struct(law) or any("shear_ratio" in text for text in texts):
            found.append(struct(law))
    return found


def words_beside(kind, name):
    """their keywords"""
    return {word for text in laws_beside(kind, name) for word in re.findall(r'(?:keyword = |option\(|setting\(|or_word\()"(\w+)"', text)}


def registered_styles():
    """(kind, name) of the styles a user can name"""
    return [(kind, name) for kind, name in inputs.registered_styles(ROOT) if not name.isupper()]


def accelerated(name):
    return name.endswith("/omp")


def page_of(kind, name):
    stem = re.sub(r"\W", "_", name)
    return DOCS / f"{stem if kind == 'command' else f'{kind}_{stem}'}.md"


STYLES = [(kind, name) for kind, name in registered_styles() if not accelerated(name)]
VARIANTS = [(kind, name) for kind, name in registered_styles() if accelerated(name)]
PAGES = sorted(DOCS.glob("*.md"))


def without_code(text):
    """text whose fenced blocks are gone, so that a # in them is no heading"""
    return re.sub(r"^```.*?^```$", "", text, flags=re.MULTILINE | re.DOTALL)


def sections(text):
    return re.findall(r"^## (.*)$", without_code(text), re.MULTILINE)


def section(text, title):
    match = re.search(rf"^## {re.escape(title)}\n(.*?)(?=^## |\Z)", text, re.MULTILINE | re.DOTALL)
    assert match, f"no section {title}"
    return match.group(1)


def scripts(text):
    """fenced LAMMPS blocks; an empty line separates examples that are not meant to follow each other"""
    blocks = re.findall(r"^```LAMMPS\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)
    return [part.strip() + "\n" for block in blocks for part in re.split(r"\n\s*\n", block) if part.strip()]


def in_scaffold(kind, example):
    parts = {"command": NETWORKS, "bond": BONDS, "pair": PAIRS}
    if kind in parts:
        parts[kind] = example
        after = ""
    else:
        after = example
    return HEAD + parts["command"] + parts["bond"] + parts["pair"] + "fix move all nve\n" + after + RUN


def examples():
    for kind, name in STYLES:
        page = page_of(kind, name)
        if page.exists():
            for number, example in enumerate(scripts(section(page.read_text(encoding="utf-8"), "Examples")), start=1):
                yield pytest.param(kind, name, example, id=f"{page.stem}-{number}")


def anchors(text):
    """the anchors that GitHub gives to headings"""
    headings = re.findall(r"^#+ (.*)$", without_code(text), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


@pytest.mark.parametrize("kind, name", STYLES, ids=[f"{kind}-{name}" for kind, name in STYLES])
def test_style_has_a_page_with_its_sections_in_order(kind, name):
    page = page_of(kind, name)
    assert page.exists(), f"{kind} style {name} has no page {page.name}"
    text = page.read_text(encoding="utf-8")
    assert sections(text) == ["Syntax", "Examples", "Description", "From the thesis", OUTPUT_SECTION[kind], "Restrictions",
                              "Related commands", "Default", "References"]
    assert name in text.splitlines()[0]
    assert page.name in (DOCS / "index.md").read_text(encoding="utf-8")
    assert f"docs/{page.name}" in README.read_text(encoding="utf-8")


@pytest.mark.parametrize("kind, name", VARIANTS, ids=[f"{kind}-{name}" for kind, name in VARIANTS])
def test_page_names_the_variant_on_threads(kind, name):
    text = page_of(kind, name.removesuffix("/omp")).read_text(encoding="utf-8")
    assert f"Accelerator variant: *{name}*" in text.splitlines()


@pytest.mark.parametrize("kind, name", STYLES, ids=[f"{kind}-{name}" for kind, name in STYLES])
def test_page_names_every_keyword_that_the_style_reads(kind, name):
    stem = page_of(kind, name).stem
    sources = [*(ROOT / "src" / "lammps").rglob(f"{stem if kind != 'command' else name}.cpp")]
    if kind == "pair":
        sources = [ROOT / "src" / "lammps" / "pair" / "pair_potdem_coeff.h", law_header(kind, name)]
    if kind == "bond":
        bond = ROOT / "src" / "lammps" / "bond"
        sources = [bond / "bond_potdem_base.cpp", bond / "potdem_bond_area.cpp", law_header(kind, name)]
    text = "".join(source.read_text() for source in sources)
    keywords = re.findall(r'(?:next_is|option|flag|setting|or_word)\("(\w+)"', text)
    keywords += ["length"] * ("FROM_MATERIAL_LENGTH" in text) + ["file"] * ("potdem_read_friction(" in text)
    beside = words_beside(kind, name)
    if kind == "fix":
        beside -= {"attract"}    # a setting of pair_style
    keywords += sorted(beside)
    if "CONTACT_LAWS(POTDEM_TRY)" in text:
        keywords += [law_name for law_name, _ in inputs.laws_of(ROOT, "pair")]
    assert keywords or kind in ("compute", "command")
    page = page_of(kind, name).read_text(encoding="utf-8")
    syntax = section(page, "Syntax")
    assert [word for word in keywords if not re.search(rf"\b{word}\b", syntax)] == []


RANGES = {"positive()": "> 0", "nonnegative()": "≥ 0", "fraction()": "≥ 0, < 1", "poisson_ratio()": "> −1, ≤ 0.5",
          "whole(MAX_PENETRATION)": "whole number, 1 to 64", "up_to_one()": "> 0, ≤ 1"}


def allowed(words, bound):
    """a range of core/laws/coefficients.h as the pages have it; bound: the coefficient below which it must be"""
    numbers = [f"{float(number):g}" for number in re.findall(r"-?[\d.]+", words)]
    if words.startswith("between"):
        return f"> {numbers[0]}, < {numbers[1]}"
    text = {"above": "> ", "at_least": "≥ "}[words.split("(")[0]] + numbers[0] if words not in RANGES else RANGES[words]
    return f"{text}, < {bound}" if bound else text


ABBREVIATED = {"gamma_over_r": "g"}


def table_rows(page):
    """rows of four cells, by the symbols in the first"""
    rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in page.splitlines() if line.startswith("| ")]
    return {symbol: cells for cells in rows if len(cells) == 4 for symbol in cells[0].split(", ")}


def check_row(listed, row):
    """unit and range; of a law that shares a symbol with another, such as the mu of rolling, the keyword is in the meaning"""
    given, word, symbol, words, unit, more = row
    bound = re.findall(r"below\(&\w+::(\w+)\)", more)
    found = listed[word if given == "required" else ABBREVIATED.get(symbol, symbol)]
    assert found[2].startswith("–" if unit == "1" else unit), found
    assert found[3].startswith(allowed(words, bound[0] if bound else "")), found
    if word in ("rolling", "twisting"):
        assert f"*{word}*" in found[1], found


@pytest.mark.parametrize("kind, name", [one for one in STYLES if one[0] in ("pair", "bond") or "wall" in one[1]])
def test_page_has_the_units_and_ranges_of_the_tables_of_its_laws(kind, name):
    """required coefficients by their names, those of options by the symbol after the keyword"""
    own = law_header(kind, name).read_text() if kind in ("pair", "bond") else HEADERS["hertz_wall.h"]
    listed = table_rows(page_of(kind, name).read_text(encoding="utf-8"))
    rows = [row for text in [own, *laws_beside(kind, name)] for row in coefficients(text)]
    assert rows
    if kind != "bond":
        words = {row[1] for row in rows}
        assert {"rolling", "twisting", "mu"} <= words
        assert ("restitution" in words) == (name not in ("potdem/granular", "potdem/lj"))
    for row in rows:
        if "FROM_MATERIAL_LENGTH" not in row[5]:    # a stiffness, whose row says what may stand for it
            check_row(listed, row)


@pytest.mark.parametrize("kind, name", [one for one in STYLES if one[0] == "pair" or "wall" in one[1]])
def test_every_keyword_of_the_laws_has_an_example(kind, name):
    examples_of_page = section(page_of(kind, name).read_text(encoding="utf-8"), "Examples")
    missing = [word for word in words_beside(kind, name) - {""} if not re.search(rf"\b{word}\b", examples_of_page)]
    assert missing == ([] if kind == "pair" else ["attract"])


@pytest.mark.parametrize("name", [name for kind, name in STYLES if kind == "pair"])
def test_page_says_what_fix_adapt_can_change(name):
    """all but flags and settings, whole numbers, and the values that follow a keyword's first"""
    text = page_of("pair", name).read_text(encoding="utf-8")
    (said,) = re.findall(rf"`fix adapt` with `pair {name}` can change (.*?)\.\s", text, re.DOTALL)
    for law in laws_beside("pair", name):
        for given, word, *_ in coefficients(law):
            if given != "continued_by":
                assert f"*{word}*" in said, word


# what the examples read: around the beam and the block, beside and below them
STL_FILES = {"hopper.stl": stl.box([-45, -45, -45], [95, 95, 95], 3), "blade.stl": stl.box([60, -10, 0], [70, 40, 5]),
             "stone.stl": stl.sphere([0.02, 0.02, -0.03], 0.015, 6)}


@pytest.mark.parametrize("kind, name, example", examples())
def test_example_runs(run_lammps, tmp_path, kind, name, example):
    assert name in example
    for file in STL_FILES.keys() & example.split():
        stl.write(tmp_path / file, STL_FILES[file])
    run = run_lammps(in_scaffold(kind, example))
    assert run.thermo["Step"][-1] == 20


def test_script_of_the_readme_breaks_the_beam_off_at_the_clamp(run_lammps):
    (script,) = scripts(README.read_text(encoding="utf-8"))
    # the piece with atom 1, which is clamped, has the number 1
    run = run_lammps(script + """
compute piece all potdem/piece/atom
compute least free reduce min c_piece
run 0
print "LEAST $(c_least)"
""")
    thermo = run.thermo
    assert 100 < thermo["f_cracks"][-1] < 400
    assert thermo["Bonds"][-1] + thermo["f_cracks"][-1] == thermo["Bonds"][0]
    assert int(re.search(r"^LEAST (\d+)", run.stdout, re.MULTILINE).group(1)) > 1


def test_script_of_the_readme_is_explained_line_by_line():
    text = README.read_text(encoding="utf-8")
    (script,) = scripts(text)
    table = section(text, "A first script").split("| line |")[1]
    explained = " ".join(re.findall(r"^\| (`.*?) \|", table, re.MULTILINE))
    phrases = re.findall(r"`(.*?)`", explained)
    for line in script.splitlines():
        words = " ".join(line.split())
        assert any(words.startswith(phrase) for phrase in phrases), f"not explained: {line}"


@pytest.mark.parametrize("page", [README, *PAGES], ids=lambda page: page.name)
def test_links_lead_somewhere(page):
    text = page.read_text(encoding="utf-8")
    for target in re.findall(r"\]\(([^)\s]+)\)", text):
        if re.match(r"https?:", target):
            continue
        file, _, anchor = target.partition("#")
        linked = (page.parent / file).resolve() if file else page
        assert linked.exists(), f"{target} does not exist"
        if anchor:
            assert anchor in anchors(linked.read_text(encoding="utf-8")), f"{target}: no such heading"


@pytest.mark.parametrize("page", [README, *PAGES], ids=lambda page: page.name)
def test_files_named_in_tables_exist(page):
    for name in re.findall(r"`((?:core|lammps)/[\w/]+\.(?:h|cpp))`", page.read_text(encoding="utf-8")):
        assert (ROOT / "src" / name).exists(), f"{name} does not exist"


def test_page_of_the_thesis_covers_every_equation_of_the_model():
    rows = re.findall(r"^\| ([^|]*) \|", (DOCS / "thesis.md").read_text(encoding="utf-8"), re.MULTILINE)
    covered = set()
    for row in rows:
        for first, last in re.findall(r"5\.(\d+)a?b?(?: – 5\.(\d+))?(?!\.)", row):
            covered |= set(range(int(first), int(last or first) + 1))
    assert set(range(6, 35)) <= covered


TUTORIAL = (DOCS / "tutorial.md").read_text(encoding="utf-8")
STEPS = re.findall(r"^## Step (\d): .*?^```LAMMPS\n(.*?)^```$(.*?)(?=^## )", TUTORIAL, re.MULTILINE | re.DOTALL)


@pytest.mark.parametrize("last", range(len(STEPS)))
def test_tutorial_runs_after_every_step_and_says_what_the_page_quotes(run_lammps, last):
    assert [number for number, _, _ in STEPS] == list("12345678")
    script = "".join(lines for _, lines, _ in STEPS[: last + 1])
    printed = " ".join(run_lammps(script + "thermo 100\nrun 200\n").stdout.split())
    for quoted in re.findall(r"LAMMPS\s+says\s+`([^`]+)`(?:\s+and\s+`([^`]+)`)?", STEPS[last][2]):
        assert all(" ".join(words.split()) in printed for words in quoted)


EXAMPLE_PAGES = sorted((ROOT / "examples").glob("*/README.md"))


@pytest.mark.parametrize("page", EXAMPLE_PAGES, ids=lambda page: page.parent.name)
def test_commands_of_an_example_name_programs_where_they_are(page):
    """from the scene's folder if they begin with a dot, else from the top of the tree"""
    commands = [line.split() for block in re.findall(r"^```\n(.*?)^```", page.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)
                for line in block.splitlines() if line.strip()]
    named = [words for words in commands if re.match(r"(\.|examples/|tools/|build/|bench/)", words[0])]
    assert [words for words in named if words[0].endswith(".py")] == [], "tools/python runs them"
    assert any(words[0] == "examples/run" for words in named)
    for words in named:
        folder = page.parent if words[0].startswith(".") else ROOT
        program = (folder / words[0]).resolve()
        if program.name == "lmp":
            assert program == ROOT / "build" / "lmp", words
            assert (folder / words[words.index("-in") + 1]).exists(), words
        else:
            assert program.exists(), words
        if words[0] == "tools/python":
            assert (ROOT / words[1]).exists(), words


# pages with code beyond the Examples of a style, and the test that runs it, whose text has the page's name
RUN_BY = {
    "README.md": "test_docs", "developer.md": "test_walk_through", "howto_body.md": "test_howtos",
    "howto_grains.md": "test_howto_grains", "howto_lammps.md": "test_howto_lammps", "howto_mixed.md": "test_howtos",
    "howto_parallel.md": "test_howtos", "howto_python.md": "test_simulation", "howto_restart.md": "test_howtos", "howto_translate.md": "test_howtos",
    "howto_walls.md": "test_howtos", "materials.md": "test_materials", "see.md": "test_see", "tutorial.md": "test_docs",
}


def test_every_block_of_code_is_run():
    """blocks of scripts, Python and C++: none is on a page that no test runs"""
    found = set()
    for page in [README, ROOT / "CONTRIBUTING.md", *DOCS.rglob("*.md"), *EXAMPLE_PAGES]:
        text = re.sub(r"^## Examples\n.*?(?=^## |\Z)", "", page.read_text(encoding="utf-8"), flags=re.MULTILINE | re.DOTALL)
        if re.search(r"^```\w+\n", text, re.MULTILINE):
            found.add(page.name)
    assert found == set(RUN_BY)
    for page, test in RUN_BY.items():
        assert Path(page).stem.removeprefix("howto_") in (Path(__file__).parent / f"{test}.py").read_text(encoding="utf-8"), page
