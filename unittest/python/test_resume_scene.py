# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Scenes and scripts of the user that are stopped and go on: examples/run --resume, and the scenes' variables restart and resume. The rows
of thermo output and the frames are those of a run that was not stopped, as they are printed: there is no tolerance."""

import os
import re
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

from potdem import commands, dumps, logs, running
from potdem.paths import BUILD, EXAMPLES, TOOLS
from potdem.scenes import resume
from potdem.scenes.scene import load
from potdem.text import replaced

pytestmark = pytest.mark.built_in    # test_resume.py is repeated through the plugin

# --- every scene, from both files of a run that was not stopped ------------------------------------------------------------------

# variables that make it short, with what matters of the whole one; steps between restart files. Of two runs: files in the first, at
# its end, in the second
SCENES = {
    "hopper": ("hopper", {"time": 0.05, "mu_grain": 0.3, "mu_wall": 0.3}, 300),
    "blade-cut": ("blade-cut", {"way": 0.01}, 150),
    "beam-impulse": ("beam-impulse", {"time": 0.001}, 300),
    "beam-impact": ("beam-impact", {"time": 0.012, "speed": 5}, 700),
    "concrete-beam": ("concrete-beam", {"time": 0.0048, "speed": 6}, 190),
    "cylinder-impact": ("cylinder-impact", {"time": 0.05, "d": 0.25}, 400),
    "column-drop, first run": ("column-drop", {"settling": 0.05, "spreading": 0.0005}, 500),
    "column-drop, second run": ("column-drop", {"settling": 0.02, "spreading": 0.03, "law": "spring", "rotation": "yes"}, 300),
    "disc-bed, first run": ("disc-bed", {"settle": 0.01, "time": 0.002}, 100),
    "disc-bed, second run": ("disc-bed", {"settle": 0.01, "time": 0.12}, 900),
}
LISTS = ("dump.earlier", "dump.failed")    # of what broke since the run began or went on


def run_in(folder, scene, variables):
    """the Run"""
    script = EXAMPLES / scene / f"in.{scene}"
    done = running.run(script, {**variables, "out": "."}, folder, log="log.run")
    assert done.ended_well, done.error or done.stdout[-1000:]
    return done


def same_frames(one, other):
    return [frame.step for frame in one] == [frame.step for frame in other] and all(
        np.array_equal(first[column], second[column]) for first, second in zip(one, other) for column in first)


def rows_of(thermo):
    return np.array(list(thermo.values()))


def broken_pairs(folder):
    scan = load(EXAMPLES / "beam-impact" / "scan.py")
    return scan.broken(folder, dumps.read(folder / "dump.beam-impact"), 0.2)


@pytest.mark.parametrize("name", SCENES)
def test_a_scene_goes_on_as_if_it_had_not_been_stopped(tmp_path, name):
    scene, variables, every = SCENES[name]
    whole = tmp_path / "whole"
    expected = run_in(whole, scene, {**variables, "restart": every}).thermo
    files = sorted(whole.glob("*.restart"))
    assert len(files) == 2
    for file in files:
        step = resume.step_of(file)
        rest = shutil.copytree(whole, tmp_path / f"from-{step}")
        stopped = resume.Stopped(rest / "log.run")
        stopped.cut(step)
        run_in(rest, scene, {**variables, "restart": every, "resume": file})
        stopped.join()
        found = logs.read_thermo(rest / "log.run")
        assert list(found) == list(expected) and np.array_equal(rows_of(found), rows_of(expected), equal_nan=True)
        for path in whole.glob("dump.*"):
            if not path.name.startswith(LISTS):
                assert same_frames(dumps.read(path), dumps.read(rest / path.name)), path.name
        for path in whole.glob("reaction.txt"):
            assert np.array_equal(np.loadtxt(path), np.loadtxt(rest / path.name))
        if scene == "beam-impact":
            assert broken_pairs(rest) == broken_pairs(whole) and broken_pairs(whole)[0] > 100


# --- examples/run: kill -9 -------------------------------------------------------------------------------------------------------

SETTINGS = """
title: grains fall
variants:
  short: {vars: {time: 0.2, mu_grain: 0.3, mu_wall: 0.3}}
  long: {vars: {time: 40}}
reference:
  columns:
    Step: {all: true, abs: 0}
    Time: {all: true, abs: 0}
    Atoms: {all: true, abs: 0}
    v_above: {all: true, abs: 0}
    v_ledge: {all: true, abs: 0}
    v_right: {all: true, abs: 0}
    PotEng: {all: true, abs: 0}
    KinEng: {all: true, abs: 0}
"""
PLOT = "import sys\nfrom pathlib import Path\nPath(sys.argv[2]).write_text('a picture')\n"


def children(pid):
    """of a process, and theirs"""
    found = [int(one) for path in Path("/proc").glob(f"{pid}/task/*/children") for one in path.read_text().split()]
    return found + [deeper for child in found for deeper in children(child)]


class Started:
    """examples/run without the build, in a folder"""

    def __init__(self, environment, folder):
        self.environment, self.folder = environment, folder

    def begin(self, *arguments):
        return subprocess.Popen([sys.executable, "-m", "potdem.scenes.run_scene", *arguments], env=self.environment, cwd=self.folder,
                                text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)

    def __call__(self, *arguments):
        process = self.begin(*arguments)
        output = process.communicate()[0]
        return process.returncode, output

    def kill_after(self, log, step, *arguments):
        """kill -9 of everything, once the log has come to a step; what was shown"""
        process = self.begin(*arguments)
        while process.poll() is None:
            text = logs.read(log) if log.exists() else ""
            if any(row >= step for _, row in resume.rows(text.splitlines(keepends=True))):
                for pid in [*children(process.pid), process.pid]:
                    os.kill(pid, signal.SIGKILL)
                break
            time.sleep(0.002)
        output = process.communicate()[0]
        assert process.returncode == -signal.SIGKILL, output
        return output


@pytest.fixture
def examples(project, tmp_path):
    """a tree with a copy of the package and of the scene hopper, with variants of its own"""
    scene = tmp_path / "examples" / "hopper"
    scene.mkdir(parents=True)
    shutil.copy(EXAMPLES / "hopper" / "in.hopper", scene)
    (scene / "scene.yaml").write_text(SETTINGS)
    (scene / "plot.py").write_text(PLOT)
    started = Started(project, tmp_path)
    started.scene = scene
    started.output = lambda ranks=1: tmp_path / "build" / "examples" / "hopper" / f"short.np{ranks}"
    return started


EVERY = 450


@pytest.mark.parametrize("ranks", [1, 2])
def test_a_scene_that_is_killed_twice_has_the_rows_and_frames_of_one_that_was_not(examples, ranks):
    on = ("-np", str(ranks))
    status, output = examples("hopper", "short", "--restart", str(EVERY), "--update-reference", *on)
    assert status == 0, output
    folder = examples.output(ranks)
    frames = dumps.read(folder / "dump.hopper")
    running_log = folder / "log.running"
    examples.kill_after(running_log, 1200, "hopper", "short", "--restart", str(EVERY), *on)
    assert "goes on from step" in examples.kill_after(running_log, 2400, "hopper", "short", "--resume", *on)
    status, output = examples("hopper", "short", "--resume", *on)
    # the harness compares every row of the joined log with the reference, to the last digit
    assert status == 0 and "8 checks passed, 0 failed" in output, output
    (step,) = map(int, re.findall(r"goes on from step (\d+)", output))
    assert step % EVERY == 0 and 2250 <= step < 4000
    assert same_frames(frames, dumps.read(folder / "dump.hopper"))
    (log,) = folder.glob("log.*")
    assert logs.read(log).count("goes on below") == 2 and not list(folder.glob("before.*"))
    assert [words[5] for words in commands.of_log(log).dumps][0].endswith("dump.hopper")
    status, output = examples("hopper", "short", "--resume", *on)
    assert status == 0 and "had come to its end" in output and "goes on" not in output


def test_what_a_scene_cannot_go_on_from_is_said(examples):
    status, output = examples("hopper", "short", "--resume")
    assert status == 1 and "has no complete restart file" in output and "--restart N writes one every N steps" in output
    log = examples.output().with_name("long.np1") / "log.running"
    examples.kill_after(log, 800, "hopper", "long", "--restart", "100")
    assert "There are some in long.np1" in examples("hopper", "long", "--resume", "-np", "2")[1]
    script = examples.scene / "in.hopper"
    script.write_text(replaced(script.read_text(), "sin(v_key*78.233)", "sin(v_key*77.233)"))
    status, output = examples("hopper", "long", "--resume")
    assert status == 1 and "was begun with another in.hopper or other variables than now" in output
    status, output = examples("hopper", "long", "--restart", "0")
    assert status == 2 and "--restart must be at least 1" in output


def test_a_scene_of_seconds_says_so():
    environment = {**os.environ, "PYTHONPATH": str(TOOLS), "POTDEM_BUILD": str(BUILD)}
    for option in (["--resume"], ["--restart", "10"]):
        done = subprocess.run([sys.executable, "-m", "potdem.scenes.run_scene", "contact-laws", "lj", *option], env=environment, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        assert done.returncode == 1 and "contact-laws writes no restart files: its runs take seconds" in done.stdout
    integrated = {scene for scene, _, _ in SCENES.values()}
    assert integrated == {path.parent.name for path in EXAMPLES.glob("*/in.*") if "${resume}" in path.read_text(encoding="utf-8")}


# --- a script of the user --------------------------------------------------------------------------------------------------------

SCRIPT = """
variable restart index 0
variable resumed equal is_defined(variable,resume)
if "${resumed}" then "read_restart ${resume}" "jump SELF resumed"
units si
atom_style sphere
boundary f f f
region box block 0 1 0 1 0 1 units box
create_box 1 box
lattice sc 0.05
region fill block 0.1 0.9 0.1 0.9 0.1 0.9 units box
create_atoms 1 region fill
set group all diameter 0.05 density 1000
pair_style potdem/hertz
pair_coeff * * 1e5 0.3 restitution 0.5
label resumed
region cup block 0 1 0 1 0 1 units box
fix cup all potdem/wall/region cup law hertz 1e5 0.3 restitution 0.5
fix move all nve
fix weight all gravity 9.81 vector 0.1 0 -1
variable height equal xcm(all,z)
fix mean all ave/time 5 10 100 v_height file mean.txt
timestep 2e-4
thermo 50
thermo_modify format float %.17g flush yes
dump see all custom 50 fall.dump id type x y z radius
if "${resumed}" then "dump_modify see append yes"
if "${restart} > 0" then "restart ${restart} a.restart b.restart"
run 3000 upto
"""


@pytest.fixture
def mine(lmp, tmp_path):
    folder = tmp_path / "mine"
    folder.mkdir()
    (folder / "in.fall").write_text(SCRIPT)
    return Started({**os.environ, "PYTHONPATH": str(TOOLS), "POTDEM_BUILD": str(BUILD)}, folder)


def test_a_script_of_the_user_goes_on(mine):
    status, output = mine("in.fall", "--restart", "170")
    assert status == 0, output
    whole, frames = logs.read_thermo(mine.folder / "log.lammps"), dumps.read(mine.folder / "fall.dump")
    mine.kill_after(mine.folder / "log.lammps", 900, "in.fall", "--restart", "170")
    status, output = mine("in.fall", "--restart", "170", "--resume")
    assert status == 0 and "in.fall goes on from step" in output, output
    found = logs.read_thermo(mine.folder / "log.lammps")
    assert list(found) == list(whole) and np.array_equal(rows_of(found), rows_of(whole))
    assert same_frames(dumps.read(mine.folder / "fall.dump"), frames)
    assert output.count("fall.png") == 1 and not list(mine.folder.glob("before.*"))


def test_what_a_script_cannot_go_on_from_is_said(mine):
    status, output = mine("in.fall", "--resume")
    assert status == 1 and "has no complete restart file to go on from" in output
    (mine.folder / "in.fall").write_text("units si\n")
    for option in (["--resume"], ["--restart", "10"]):
        status, output = mine("in.fall", *option)
        assert status == 1 and f"reads no variable {option[0][2:]}" in output and "docs/howto_restart.md" in output


# --- restart files, logs, dumps --------------------------------------------------------------------------------------------------

def test_a_file_that_was_not_written_to_its_end_is_left_out(run_lammps, tmp_path):
    run_lammps(replaced(SCRIPT, "run 3000 upto", "run 60"), vars={"restart": 20})
    older, newer = tmp_path / "b.restart", tmp_path / "a.restart"
    assert (resume.step_of(older), resume.step_of(newer)) == (40, 60)
    assert resume.newest([older, newer]) == (newer, 60)
    newer.write_bytes(newer.read_bytes()[:-1000])
    assert resume.newest([older, newer, tmp_path / "none"]) == (older, 40)
    older.write_text("no restart file")
    assert resume.newest([older, newer]) is None


@pytest.mark.parametrize("command, names", [
    ("restart 20 a.restart b.restart", ["a.restart", "b.restart"]), ("restart 20 run", ["run.20", "run.40"]),
    ("restart 20 run.*.bin", ["run.20.bin", "run.40.bin"]), ("restart 0", [])])
def test_files_are_found_by_the_command_of_the_log(run_lammps, tmp_path, command, names):
    run_lammps(replaced(SCRIPT, "run 3000 upto", command + "\nrun 40"))
    assert sorted(path.name for path in resume.files_of_log(tmp_path / "log.test")) == names


HEAD = "thermo 10\n   Step KinEng\n"
LONG = HEAD + "0 5\n10 6\n20 7\n3"    # killed while it wrote
RUNS = HEAD + "0 5\n10 6\nLoop time of 1 on 1 procs for 10 steps\n   Step KinEng\n10 6\n20 7\n30 8\n"


@pytest.mark.parametrize("text, step, after, steps", [
    (LONG, 20, "   Step KinEng\n20 7\n30 8\n", [0, 10, 20, 30]), (LONG, 15, "   Step KinEng\n15 9\n20 7\n", [0, 10, 20]),
    (LONG, 25, "   Step KinEng\n25 9\n30 8\n", [0, 10, 20, 30]), (HEAD + "0 5\n", 10, "   Step KinEng\n10 9\n20 8\n", [0, 10, 20]),
    (RUNS, 25, "   Step KinEng\n25 6\n30 7\n", [0, 10, 20, 30]), (RUNS, 10, "   Step KinEng\n10 6\n20 7\n", [0, 10, 20])])
def test_a_joined_log_has_the_rows_of_a_run_that_was_not_stopped(text, step, after, steps):
    assert logs.thermo(resume.joined(resume.cut_log(text, step), after))["Step"].tolist() == steps


def test_steps_are_counted_through_a_joined_log(tmp_path):
    """a wall of the second run stands from the step of its fix on"""
    text = resume.joined(resume.cut_log(RUNS, 25), "fix lid all wall/gran/region box\n   Step KinEng\n25 6\n30 7\n")
    (tmp_path / "log").write_text("region box block 0 1 0 1 0 1\n" + text.replace("wall/gran/region box", "wall/gran/region granular box"))
    assert commands.of_log(tmp_path / "log").walls["lid"].start == 25


def frame(step, x, rows=2):
    return (f"ITEM: TIMESTEP\n{step}\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\nITEM: ATOMS id x\n"
            + "".join(f"{number} {x}\n" for number in (1, 2)[:rows]))


def test_a_dump_is_cut_at_a_step_and_of_a_step_that_is_there_twice_the_last_counts(tmp_path):
    path = tmp_path / "dump"
    path.write_text(frame(0, 1.0) + frame(10, 2.0) + frame(20, 3.0) + frame(30, 4.0, rows=1))
    resume.cut_dump(path, 15)
    assert path.read_text() == frame(0, 1.0) + frame(10, 2.0)
    path.write_text(path.read_text() + frame(10, 2.5) + frame(20, 3.5))
    found = dumps.read(path)
    assert [one.step for one in found] == [0, 10, 20] and found[1]["x"].tolist() == [2.5, 2.5]
    resume.cut_dump(path, -1)
    assert path.read_text() == ""


def test_a_table_is_cut_at_a_step(tmp_path):
    path = tmp_path / "table"
    path.write_text("# words\n10 1\n20 2\n30 3\n4")
    resume.cut_table(path, 20)
    assert path.read_text() == "# words\n10 1\n20 2\n"
