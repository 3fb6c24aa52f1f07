# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""The manual: every page is in its contents; Sphinx finds no broken link or image; a browser draws all formulas."""

import importlib.util
import re
import shutil
import subprocess

import pytest

from potdem.paths import DOCS, ROOT

MANUAL = DOCS / "manual"
PAGES = sorted([*ROOT.glob("*.md"), *DOCS.glob("*.md"), *DOCS.glob("report/*.md"), *ROOT.glob("examples/*/README.md")])
PARTS = ["Begin", "How to", "Bodies and bonds", "Contacts and grains", "Walls", "Output and time step", "Examples", "Reports",
         "Background and for developers"]
WITH_FORMULAS = ["area", "fix_potdem_wall_region"]
SPHINX = ["sphinx", "myst_parser", "furo", "sphinx_copybutton"]


def test_every_page_is_once_in_the_contents():
    text = (MANUAL / "contents.md").read_text(encoding="utf-8")
    assert re.findall(r"^:caption: (.*)$", text, re.MULTILINE) == PARTS
    listed = [(MANUAL / f"{line}.md").resolve() for line in re.findall(r"^(\.\./\S+)$", text, re.MULTILINE)]
    assert sorted(listed) == PAGES


@pytest.fixture(scope="module")
def site(tmp_path_factory):
    missing = [name for name in SPHINX if importlib.util.find_spec(name) is None]
    if missing:
        pytest.skip(f"not installed: {', '.join(missing)} (tools/manual installs them)")
    out = tmp_path_factory.mktemp("manual")
    command = ["/usr/bin/python3", "-m", "sphinx", "-q", "-n", "-W", "--keep-going", "-d", out / "pages", "-c", MANUAL, ROOT, out / "site"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=300, check=False)
    assert done.returncode == 0, done.stderr
    return out / "site"


def test_sphinx_makes_every_page_without_a_warning(site):
    for page in PAGES:
        assert (site / page.relative_to(ROOT)).with_suffix(".html").exists(), page
    first = (site / "README.html").read_text(encoding="utf-8")
    assert '<span class="k">potdem_bonds</span>' in first
    assert '<span class="nc">potdem/truss</span>' in first
    assert (site / "_images" / "scenes.gif").exists()


@pytest.mark.parametrize("name", WITH_FORMULAS)
def test_a_browser_draws_every_formula(site, name, tmp_path):
    """as many drawings as formulas, none of them an error, and no script that fails"""
    if not shutil.which("chromium"):
        pytest.skip("chromium is not installed (tools/manual --pdf installs it)")
    page = site / "docs" / f"{name}.html"
    command = ["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--virtual-time-budget=30000", "--enable-logging=stderr",
               f"--user-data-dir={tmp_path}", "--dump-dom", page.as_uri()]
    done = subprocess.run(command, capture_output=True, text=True, timeout=120, check=False)
    formulas = len(re.findall(r'class="math notranslate', page.read_text(encoding="utf-8")))
    assert formulas > 50
    assert done.stdout.count('class="MathJax_SVG"') == formulas
    assert 'data-mml-node="merror"' not in done.stdout and 'class="MathJax_SVG_Error"' not in done.stdout
    assert re.findall(r"CONSOLE.*", done.stderr) == []
