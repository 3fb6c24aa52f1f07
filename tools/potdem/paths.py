# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Where things are: the project's tree and its build."""

import os
from pathlib import Path

TOOLS = Path(__file__).resolve().parent.parent
ROOT = TOOLS.parent
EXAMPLES = ROOT / "examples"
DOCS = ROOT / "docs"
BUILD = Path(os.environ.get("POTDEM_BUILD", ROOT / "build")).resolve()
LMP = BUILD / "lmp"


def with_package():
    """environment of a Python of its own that can import this package"""
    return {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, [str(TOOLS), os.environ.get("PYTHONPATH")]))}
