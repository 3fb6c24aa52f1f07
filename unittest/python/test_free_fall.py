# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""What falls in the scenes falls with g, whatever their numerical damping."""

import numpy as np
import pytest

from potdem import dumps, logs
from potdem.scenes import scanning
from potdem.scenes.scene import Scene, load

GRAVITY = 9.81
WITHIN = 0.01


def run(name, folder, **variables):
    scene = Scene(name)
    scanning.run(scene.folder, variables, folder)
    return scene, logs.read_thermo(folder / "log.scan")


def test_grains_fall_into_the_box(tmp_path):
    """column-drop: those of the upper half, which nothing has reached yet"""
    run("column-drop", tmp_path, settling=0.05, spreading=0)
    frame = dumps.at(dumps.read_run(tmp_path, "dump.column-drop"), 0.05)
    assert np.median(frame["vz"][frame["z"] > 0.8]) == pytest.approx(-GRAVITY * 0.05, rel=WITHIN)


def test_a_hammer_that_vibrates_falls(tmp_path):
    """concrete-beam: from 10 ms on nothing touches the hammer, which the impact has left vibrating"""
    _, thermo = run("concrete-beam", tmp_path, speed=2, time=0.02)
    late = thermo["Time"] > 0.01
    assert np.polyfit(thermo["Time"][late], thermo["v_hammer"][late], 1)[0] == pytest.approx(-GRAVITY, rel=WITHIN)


@pytest.mark.parametrize("weight, share", [("no", 1.0), ("yes", 0.8)])
def test_grains_fall_out_of_the_hopper(tmp_path, weight, share):
    """hopper: those that touch nothing in the exit; eq. 5.30 on the weight, too, would leave (1 - lambda) g"""
    scene, _ = run("hopper", tmp_path, time=0.4, weight=weight)
    falls = load(scene.claims).falls(dumps.read_run(tmp_path, "dump.hopper"))
    assert len(falls) > 100
    assert np.median(falls) == pytest.approx(share, rel=WITHIN)
