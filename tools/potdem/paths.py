# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Where things are: the project's tree and its build, or what was installed of them."""

import os
from pathlib import Path

TOOLS = Path(__file__).resolve().parent.parent
ROOT = TOOLS.parent
EXAMPLES = ROOT / "examples"
DOCS = ROOT / "docs"
SOURCES = not (TOOLS / "lammps").exists()    # the module that an install puts there
# what is installed has no build: results go to the folder where a command is started
BUILD = Path(os.environ.get("POTDEM_BUILD", ROOT / "build" if SOURCES else Path.cwd())).resolve()
LMP = BUILD / "lmp" if SOURCES else Path(os.environ.get("POTDEM_LMP", "lmp"))


def with_package():
    """environment of a Python of its own that can import this package"""
    return {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, [str(TOOLS), os.environ.get("PYTHONPATH")]))}
