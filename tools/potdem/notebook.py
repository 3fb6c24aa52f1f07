# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""A Jupyter notebook from a plain script whose cells begin with `# %%`, and its text cells with `# %% [markdown]`.

tools/python -m potdem.notebook SCRIPT.py    writes SCRIPT.ipynb"""

import json
import re
import sys
from pathlib import Path

MARK = re.compile(r"^# %%( \[markdown\])?\n", re.MULTILINE)


def cells(script):
    """(is text, lines) of each cell; what stands before the first mark is left out"""
    marks = list(MARK.finditer(script))
    for mark, following in zip(marks, [*marks[1:], None]):
        body = script[mark.end() : following.start() if following else None].strip("\n")
        text = mark.group(1) is not None
        yield text, re.sub(r"^# ?", "", body, flags=re.MULTILINE) if text else body


def notebook(script):
    """in Jupyter's format 4.5, without outputs"""
    listed = []
    for number, (text, body) in enumerate(cells(script)):
        cell = {"cell_type": "markdown" if text else "code", "id": f"cell-{number}", "metadata": {},
                "source": body.splitlines(keepends=True)}
        listed.append(cell if text else {**cell, "execution_count": None, "outputs": []})
    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    return {"cells": listed, "metadata": {"kernelspec": kernel, "language_info": {"name": "python"}}, "nbformat": 4, "nbformat_minor": 5}


def text_of(script):
    return json.dumps(notebook(script), indent=1, ensure_ascii=False) + "\n"


def main(path):
    Path(path).with_suffix(".ipynb").write_text(text_of(Path(path).read_text(encoding="utf-8")), encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
