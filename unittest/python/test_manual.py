# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""The manual: every page is in its contents; Sphinx makes all without a warning; a browser shows formulas, images and links of each."""

import html
import importlib.util
import json
import re
import shutil
import subprocess
from pathlib import Path
from urllib.parse import unquote, urlsplit

import pytest

from potdem.paths import DOCS, ROOT

MANUAL = DOCS / "manual"
PAGES = sorted([*ROOT.glob("*.md"), *DOCS.glob("*.md"), *DOCS.glob("report/*.md"), *ROOT.glob("examples/*/README.md")])
PARTS = ["Begin", "How to", "Bodies and bonds", "Contacts and grains", "Walls", "Output and time step", "Examples", "Reports",
         "Background and for developers"]
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


# made beside the site, to see that the browser's look finds what is wrong
WRONG = r"""<!DOCTYPE html><html><head><meta charset="utf-8"><script src="_static/mathjax/MathJax.js?config=TeX-AMS_SVG"></script></head><body>
<p>Not read as a formula: $x$. <img src="none.png"></p>
<span class="math notranslate nohighlight">\(x^2\)</span>
<span class="math notranslate nohighlight">\(\nonesuch\)</span>
<span class="math notranslate nohighlight">\(\frac{a\)</span>
</body></html>
"""


@pytest.fixture(scope="module")
def seen(site, tmp_path_factory):
    """page -> what a browser found there; all pages in one start of it"""
    if not shutil.which("chromium"):
        pytest.skip("chromium is not installed (tools/manual --pdf installs it)")
    (site / "wrong.html").write_text(WRONG, encoding="utf-8")
    pages = sorted(str(page.relative_to(site)) for page in site.rglob("*.html") if page.relative_to(site).parts[0] != "_static")
    driver = (Path(__file__).parent / "every_page.html").read_text(encoding="utf-8")
    (site / "every_page.html").write_text(driver.replace("PAGES = []", f"PAGES = {json.dumps(pages)}"), encoding="utf-8")
    # the pages are files: one may look into another only with the second option. The budget, in milliseconds of which idle ones pass at
    # once, is longer than any look takes
    command = ["chromium", "--headless", "--allow-file-access-from-files", "--no-sandbox", "--disable-gpu",
               "--virtual-time-budget=10000000", "--enable-logging=stderr", f"--user-data-dir={tmp_path_factory.mktemp('chromium')}",
               "--dump-dom", (site / "every_page.html").as_uri()]
    done = subprocess.run(command, capture_output=True, text=True, timeout=300, check=False)
    found = re.search(r'<pre id="seen">(.+?)</pre>', done.stdout, re.DOTALL)
    assert found, f"the browser did not get through the pages:\n{done.stderr}"
    assert re.findall(r"CONSOLE.*", done.stderr) == []
    return dict(zip(pages, json.loads(html.unescape(found.group(1))), strict=True))


def without_wrong(seen):
    return {page: look for page, look in seen.items() if page != "wrong.html"}


def test_a_browser_draws_every_formula(site, seen):
    """as many drawings as formulas in Sphinx's text of the page, and none of them an error"""
    for page, look in without_wrong(seen).items():
        formulas = len(re.findall(r'class="math notranslate', (site / page).read_text(encoding="utf-8")))
        assert (look["formulas"], look["drawn"], look["wrong"]) == (formulas, formulas, []), page
    assert seen["docs/area.html"]["drawn"] > 50


def test_no_formula_is_left_as_text(seen):
    assert {page: look["dollars"] for page, look in without_wrong(seen).items() if look["dollars"]} == {}


def test_a_browser_shows_every_image(seen):
    assert {page: look["missing"] for page, look in without_wrong(seen).items() if look["missing"]} == {}


def test_every_link_within_the_site_leads_to_its_place(site, seen):
    ids = {look["address"]: set(look["ids"]) for look in seen.values()}
    within = 0
    for page, look in without_wrong(seen).items():
        for link in look["links"]:
            address, _, place = link.partition("#")
            if not address.startswith(site.as_uri()):
                assert address.startswith("https://"), (page, link)
                continue
            assert Path(unquote(urlsplit(address).path)).is_file(), (page, link)
            assert not place or place in ids[address], (page, link)
            within += 1
    assert within > 500


def test_what_is_wrong_is_seen(seen):
    look = seen["wrong.html"]
    assert (look["formulas"], look["missing"]) == (3, ["none.png"])
    assert look["wrong"] == [r"\nonesuch", r"\frac{a"]
    assert len(look["dollars"]) == 1
