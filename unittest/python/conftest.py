# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Fixtures for tests that drive build/lmp, or with POTDEM_STYLES=plugin a LAMMPS without our styles that loads the
plugin."""

import os
import shutil

import pytest

from potdem import running
from potdem.paths import BUILD, ROOT, TOOLS

PLAIN = BUILD / "unittest" / "plain" / "lmp"
THROUGH_PLUGIN = os.environ.get("POTDEM_STYLES") == "plugin"

MARKERS = {
    "every_style": "one of a selection that together uses every style; unittest/run runs it through the plugin too",
    "built_in": "about the build itself; not repeated through the plugin",
}

# Open MPI starts without a look for fast networks. Several tests run at a time, on more ranks than there are cores: one that waits for
# another lets it have the core. After an error it does not wait a second before it ends the other ranks
OPEN_MPI = {"OMPI_MCA_pml": "ob1", "OMPI_MCA_mpi_yield_when_idle": "1", "OMPI_MCA_odls_base_sigkill_timeout": "0"}


def pytest_configure(config):
    for name, text in MARKERS.items():
        config.addinivalue_line("markers", f"{name}: {text}")
    for name, value in OPEN_MPI.items():
        os.environ.setdefault(name, value)
    config.named_by_every_style = []    # scripts and what LAMMPS said to them
    if THROUGH_PLUGIN:
        os.environ["LAMMPS_PLUGIN_PATH"] = str(BUILD)


def pytest_collection_modifyitems(config, items):
    """through the plugin only what drives LAMMPS; the test of the selection after the selection"""
    repeated = [item for item in items if "lmp" in item.fixturenames and not item.get_closest_marker("built_in")]
    if THROUGH_PLUGIN:
        config.hook.pytest_deselected(items=[item for item in items if item not in repeated])
        items[:] = repeated
    items.sort(key=lambda item: "every_style_is_named" in item.name)
    if hasattr(config, "workerinput"):    # one of several processes: none has all scripts. It runs in the pass through the plugin
        items[:] = [item for item in items if "every_style_is_named" not in item.name]


@pytest.fixture(scope="session")
def root():
    return ROOT


@pytest.fixture(scope="session")
def build():
    """the build folder under test"""
    return BUILD


@pytest.fixture(scope="session")
def lmp(build):
    path = PLAIN if THROUGH_PLUGIN else build / "lmp"
    if not path.exists():
        pytest.fail(f"{path} has not been built (unittest/run builds it)")
    return path


@pytest.fixture
def project(lmp, tmp_path):
    """tmp_path as a folder of the project, with a copy of its Python package and the build; the environment of programs that run there"""
    shutil.copytree(TOOLS / "potdem", tmp_path / "tools" / "potdem")
    (tmp_path / "build").mkdir()
    (tmp_path / "build" / "lmp").symlink_to(lmp)
    (tmp_path / "build" / "CMakeCache.txt").symlink_to(BUILD / "CMakeCache.txt")
    return {**os.environ, "PYTHONPATH": str(tmp_path / "tools"), "POTDEM_BUILD": str(tmp_path / "build")}


@pytest.fixture
def run_lammps(lmp, tmp_path, request):
    """runs a script given as text; without expect_error the run must end well, with it the ERROR message
    must contain that text"""

    def run(script_text, nprocs=1, vars=None, cwd=None, expect_error=None, timeout=300):
        result = running.run(script_text, vars or {}, cwd or tmp_path, nprocs, name="test", log="log.test", limit=timeout, lmp=lmp)
        if request.node.get_closest_marker("every_style"):
            request.config.named_by_every_style.append(script_text + result.stdout)
        if expect_error is None:
            assert result.status == 0, result.stdout[-3000:]
        else:
            assert result.status != 0 and result.error, result.stdout[-3000:]
            assert expect_error in result.error
        return result

    return run
