# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""docs/errors.md: is what potdem.errors makes of the sources now, and has what LAMMPS says; docs/warnings.md explains each warning."""

import re

import pytest

from potdem import errors
from potdem.paths import DOCS

PAGE = (DOCS / "errors.md").read_text(encoding="utf-8")
ROWS = [re.sub(r"\\(.)", r"\1", line[2:]) for line in PAGE.splitlines() if line.startswith("* ")]
HEAD = """units si
atom_style bpm/sphere
boundary f f f
region box block -1 1 -1 1 -1 1
create_box 1 box bond/types 1
create_atoms 1 single 0 0 0
create_atoms 1 single 0.5 0 0
"""
PAIR = "set group all diameter 0.5 mass 1\npair_style potdem/hertz\npair_coeff * * 1e6 0.3\n"
WRONG = ["set group all diameter 0\npotdem_bonds all 1 0.6\n", PAIR + "potdem_bonds all 1 0.1\n",
         PAIR + "fix wall all potdem/wall/region nowhere law hertz 1e6 0.3\n",
         "pair_style potdem/hertz\npair_coeff * * none.potdem steel\n", PAIR + "compute e all potdem/energy\ncompute f all potdem/energy\n",
         PAIR + "fix fail all potdem/failure 1\n", "pair_style potdem/hertz\npair_coeff * * 1e6 0.3 rolling 0.1 0.1 0.1\n"]


def test_page_is_up_to_date():
    assert PAGE == errors.page(), "tools/python -m potdem.errors updates it"


def test_page_has_a_message_of_each_file_that_stops():
    """counted by lines of the sources, not by the reader of calls"""
    for path in errors.SOURCES.rglob("*.cpp"):
        text = path.read_text(encoding="utf-8")
        if re.search(r'error->(all|one)\([^;"]*"[^"{}]{9}', text):
            assert errors.messages(path), path
    assert len(ROWS) > 100 and all(re.search("[a-z]{2}", row) for row in ROWS)


def test_page_has_every_warning():
    """as many as the sources have calls; two calls write words that others have kept, one is made with words of three callers"""
    other = {"fix_potdem_monitor.cpp": 3 - 1 - 2}
    counted = 0
    for path in errors.SOURCES.rglob("*.cpp"):
        text = path.read_text(encoding="utf-8")
        calls = sum(map(text.count, ("error->warning(", " warn(lmp,", "LMP_ERROR_WARNING", " say(")))
        assert len(errors.warnings(path)) == calls + other.get(path.name, 0), path
        counted += calls
    assert counted > 15
    rows = [row for part in re.findall(r"^Warnings:\n\n((?:\* .*\n)*)", PAGE, re.MULTILINE) for row in part.splitlines()]
    assert len(rows) == len({words for path in errors.sources() for words in errors.warnings(path)})


def shown(words):
    """where an explanation and a message have the same words, whatever stands for …"""
    return ".*".join(re.escape(part) for part in words.split("…"))


def test_warnings_are_explained():
    """each on docs/warnings.md, in a row that begins with its words, with when and what to do"""
    rows = re.findall(r"^\| (\*.*?) \| (.+?) \| (.+?) \|$", (DOCS / "warnings.md").read_text(encoding="utf-8"), re.MULTILINE)
    quoted = [words for first, _, _ in rows for words in re.findall(r"\*([^*]+)\*", first)]
    warned = [words for path in errors.sources() for words in errors.warnings(path)]
    # what follows 'plugin not loaded' is one row
    of_plugin = errors.warnings(errors.SOURCES / "plugin.cpp")[1:]
    for words in set(warned) - set(of_plugin):
        assert [row for row in quoted if re.match(shown(row), words)], words
    for row in quoted:
        assert [words for words in warned if re.match(shown(row), words)], f"no warning reads {row}"


@pytest.mark.parametrize("commands", WRONG)
def test_what_lammps_says_is_on_the_page(run_lammps, commands):
    said = " ".join(run_lammps(HEAD + commands, expect_error="").error.split())
    assert [row for row in ROWS if re.search(".*".join(re.escape(part) for part in row.split("…")), said)], said
