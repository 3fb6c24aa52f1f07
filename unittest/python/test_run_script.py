# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""examples/run with a script of the user: runs in its folder, shows progress, makes a picture of what it dumps."""

import os
import re
import subprocess
import sys
import time

import numpy as np
import pytest
from PIL import Image

from potdem import running
from potdem.paths import BUILD, TOOLS
from potdem.progress import OfScript
from potdem.scenes import run_script
from potdem.text import replaced

pytestmark = pytest.mark.built_in

SCRIPT = """
units si
atom_style sphere
boundary f f f
variable speed index 1.0
region box block -1 5 -1 1 -1 1 units box
create_box 2 box
create_atoms 1 single 0 0 0 units box
create_atoms 2 single 2 0 0 units box
set group all diameter 0.5 density 1000
pair_style none
comm_modify cutoff 1.0
velocity all set ${speed} 0 0 units box
fix move all nve
timestep 0.01
thermo 10
dump see all custom 20 fall.dump id type x y z radius
run 40
run 60
"""


@pytest.fixture
def run(lmp, tmp_path):
    """examples/run without the build"""
    environment = {**os.environ, "PYTHONPATH": str(TOOLS), "POTDEM_BUILD": str(BUILD)}
    folder = tmp_path / "mine"
    folder.mkdir()
    (folder / "in.fall").write_text(SCRIPT)

    def start(*arguments):
        return subprocess.run([sys.executable, "-m", "potdem.scenes.run_scene", *arguments], env=environment, cwd=tmp_path, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)

    start.folder = folder
    return start


@pytest.mark.parametrize("ranks", [1, 2])
def test_a_script_runs_in_its_folder_and_is_shown(run, ranks):
    done = run("mine/in.fall", "-np", str(ranks), "-var", "speed", "2.0")
    assert done.returncode == 0, done.stdout
    log = (run.folder / "log.lammps").read_text()
    assert f"{ranks} by 1 by 1 MPI processor grid" in log
    assert f"in.fall on {ranks} rank(s)" in done.stdout and str(run.folder / "fall.png") in done.stdout
    image = np.asarray(Image.open(run.folder / "fall.png").convert("RGB")).astype(int)
    assert np.sum(image[..., 0] > image[..., 2] + 60) > 500, "the red of type 2"
    # 100 steps of 0.01 s with 2 m/s
    last = (run.folder / "fall.dump").read_text().splitlines()[-1].split()
    assert float(last[2]) == pytest.approx(2.0 * float(last[1]) if last[1] == "1" else 4.0)


def test_a_dump_at_the_end_is_shown(run):
    text = replaced(SCRIPT, "dump see all custom 20 fall.dump id type x y z radius\n", "")
    (run.folder / "in.fall").write_text(text + "write_dump all custom end.dump id type x y z radius\n")
    done = run("mine/in.fall")
    assert done.returncode == 0 and str(run.folder / "end.png") in done.stdout, done.stdout


def test_a_folder_with_one_script_will_do(run):
    done = run("mine", "--animate", "--paraview")
    assert done.returncode == 0, done.stdout
    assert all((run.folder / name).exists() for name in ("fall.mp4", "fall.vtk/fall.pvd", "fall.png"))


def test_a_folder_with_several_scripts_asks_for_one(run):
    (run.folder / "in.other").write_text(SCRIPT)
    done = run("mine")
    assert done.returncode == 1 and "mine has several scripts: in.fall, in.other; name one of them" in done.stdout


@pytest.mark.parametrize("old, new, message", [
    ("run 60", "fix wrong all no/such/style\nrun 60", "ERROR: Unrecognized fix style 'no/such/style'"),
    ("dump see all custom 20 fall.dump id type x y z radius", "", "no picture, because the script dumps no particles"),
    (" radius", "", "no picture: .*has no column radius")])
def test_what_is_missing_is_said(run, old, new, message):
    (run.folder / "in.fall").write_text(replaced(SCRIPT, old, new))
    done = run("mine/in.fall")
    assert done.returncode == (1 if "ERROR" in message else 0)
    assert re.search(message, done.stdout), done.stdout


def test_a_script_has_no_variants_and_a_scene_no_variables(run):
    assert "is a script, not a scene" in run("mine/in.fall", "slow").stdout
    assert "-var is for a script of your own" in run("hopper", "-var", "x", "1").stdout
    assert "no scene 'nothing'; there are:" in run("nothing").stdout


@pytest.mark.parametrize("text, steps", [
    ("run 20\nrun 30\n", [20, 30]), ("run ${n}\n  run 5 post no\n", [None, 5]), ("run 100 upto\n", [None]), ("run &\n 20\n", [20]),
    ("label a\nrun 5\nnext i\njump SELF a\n", None), ('if "1" then "run 5"\n', None), ("# run 5\n", [])])
def test_the_steps_of_a_script_are_counted_before_it_runs(text, steps):
    assert run_script.planned(text) == steps


def fed(plan, lines):
    """fractions after each line with a step"""
    progress, found = OfScript("mine", plan), []
    progress.show = lambda: found.append(round(progress.fraction, 3))
    for line in lines.splitlines():
        progress.read(line)
    return progress, found


TWO_RUNS = """run 20
  Current step  : 100
   Step KinEng
   100 1
   110 1
   120 1
Loop time of 1
run 60
  Current step  : 120
   Step KinEng
   120 1
   150 1
   180 1
Loop time of 1
"""


def test_progress_is_of_all_runs_where_their_steps_are_known():
    assert fed([20, 60], TWO_RUNS)[1] == pytest.approx([0, 0.125, 0.25, 0.25, 0.625, 1])
    progress, fractions = fed(None, TWO_RUNS)
    assert fractions == pytest.approx([0, 0.5, 1, 0, 0.5, 1]) and "mine, run 2: [#" in progress.text()


def test_progress_is_shown_while_a_run_goes_on(lmp, tmp_path):
    """its lines come through the pipe while its steps are done: from the first to the last it takes the time of the loop"""
    slow = replaced(replaced(SCRIPT, "thermo 10", "thermo 100000"), "run 40\nrun 60", "run 400000")
    (tmp_path / "in.slow").write_text(replaced(slow, "dump see all custom 20 fall.dump id type x y z radius\n", ""))
    progress, seen = OfScript("slow", None), []
    progress.show = lambda: seen.append(time.monotonic())
    arguments = [*running.command("in.slow", {"speed": 0}, "log.slow", lmp=lmp), "-echo", "both"]
    assert running.watched(arguments, tmp_path, progress) is None
    loop = float(re.search(r"^Loop time of (\S+)", (tmp_path / "log.slow").read_text(), re.MULTILINE)[1])
    assert len(seen) == 5 and seen[-1] - seen[0] > 0.8 * loop > 0.05
