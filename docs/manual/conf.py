# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""The manual: what Sphinx makes of the Markdown pages where they lie. tools/manual runs it; contents.md has the order."""

import re
import shutil
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
sys.path.insert(0, str(HERE))

import lammps_lexer  # noqa: E402

project = "POTDEM"
author = "the authors of POTDEM"
copyright = "the authors; GNU General Public License, version 2"
html_title = "POTDEM"
html_theme = "furo"
html_static_path = ["static"]
html_css_files = ["print.css"]

extensions = ["myst_parser", "sphinx.ext.mathjax", "sphinx_copybutton"]
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 4
root_doc = "docs/manual/contents"
include_patterns = ["README.md", "CONTRIBUTING.md", "CHANGELOG.md", "docs/**.md", "examples/*/README.md"]
exclude_patterns = ["build*", "src", ".git"]
suppress_warnings = ["myst.header"]    # the contents go from a title to the parts of it

highlight_language = "none"
html_show_sphinx = False
html_copy_source = False
html_show_sourcelink = False

# the formulas are drawn by Debian's MathJax, of which a copy comes with the site: it needs no network
MATHJAX = Path("/usr/share/javascript/mathjax")
MATHJAX_PARTS = ["MathJax.js", "config/TeX-AMS_SVG.js", "extensions", "jax/element", "jax/input/TeX", "jax/output/SVG/*.js",
                 "jax/output/SVG/autoload", "jax/output/SVG/fonts/TeX"]
mathjax_path = "mathjax/MathJax.js?config=TeX-AMS_SVG"
mathjax2_config = {"tex2jax": {"inlineMath": [["\\(", "\\)"]], "processClass": "math"}, "showMathMenu": False, "messageStyle": "none"}
myst_update_mathjax = False    # it speaks to MathJax 3

INDEX = """<!DOCTYPE html>
<html><head><meta charset="utf-8"><title>POTDEM</title><meta http-equiv="refresh" content="0; url=docs/manual/contents.html"></head>
<body><a href="docs/manual/contents.html">POTDEM</a></body></html>
"""


def folder(app, env, node, text):
    """links to folders, which a site has not, are words"""
    if (Path(env.srcdir) / node["refdoc"]).parent.joinpath(node["reftarget"]).is_dir():
        return text
    return None


def complete(app, failure):
    """what Sphinx does not make: MathJax, furo's script, and a first page at the top"""
    if failure or app.builder.format != "html":
        return
    out = Path(app.outdir)
    for pattern in MATHJAX_PARTS:
        for part in MATHJAX.glob(pattern):
            copy = out / "_static" / "mathjax" / part.relative_to(MATHJAX)
            if part.is_dir():
                shutil.copytree(part, copy, dirs_exist_ok=True)
            else:
                copy.parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(part, copy)
    # Debian's furo comes with two files that are meant to be joined
    scripts = out / "_static" / "scripts"
    joined = [(scripts / name).read_text(encoding="utf-8") for name in ("gumshoe-patched.js", "furo.js")]
    (scripts / "furo.js").write_text("\n".join(re.sub(r"^import .*\n", "", text) for text in joined), encoding="utf-8")
    (out / "index.html").write_text(INDEX, encoding="utf-8")


def setup(app):
    app.set_html_assets_policy("always")    # MathJax on the one page of all, too, whose own text has no formula
    app.add_lexer("LAMMPS", lammps_lexer.LammpsLexer)
    app.connect("missing-reference", folder)
    app.connect("build-finished", complete)
