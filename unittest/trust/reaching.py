# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""A plugin of pytest (-p reaching): to which faults does each test come? Programs of the build with all faults append their numbers to the file
POTDEM_REACHED (mutants.py); a line of JSON for each test goes to the folder POTDEM_REACHING."""

import json
import os
import time
from pathlib import Path

import pytest


@pytest.hookimpl(hookwrapper=True)
def pytest_runtest_protocol(item):
    folder = Path(os.environ["POTDEM_REACHING"])
    numbers = folder / f"numbers.{os.getpid()}"
    os.environ["POTDEM_REACHED"] = str(numbers)
    begun = time.monotonic()
    yield
    reached = sorted(set(map(int, numbers.read_text(encoding="ascii").split()))) if numbers.exists() else []
    numbers.unlink(missing_ok=True)
    line = {"test": item.nodeid, "seconds": time.monotonic() - begun, "reached": reached}
    with open(folder / f"tests.{os.getpid()}", "a", encoding="utf-8") as file:
        file.write(json.dumps(line) + "\n")
