# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Bodies in free flight fall with g in the scenes: the numerical damping acts on weight too, and where a body rings it can hold it in
the air, so that it must be kept away from what flies."""

import re

import numpy as np
import pytest

from potdem import dumps, logs
from potdem.paths import EXAMPLES
from potdem.scenes import scanning
from potdem.scenes.scene import Scene, load

GRAVITY = 9.81
WITHIN = 0.01
BEGIN = "the fall begins"

# scene, variables of its script, the group that falls, the seconds between which nothing touches it
FALLS = [
    ("beam-impact", {"position": "i", "speed": 5}, "block", (0.0, 0.004)),
    # after the impact, so that the block rings
    ("beam-impact", {"position": "i", "speed": 3}, "block", (0.016, 0.026)),
    # likewise the hammer, which nothing touches from 10 ms on
    ("concrete-beam", {"speed": 2}, "hammer", (0.01, 0.02)),
    ("cylinder-impact", {"strength": 2e8}, "all", (0.0, 0.0004)),
    # after its rebound it rings
    ("cylinder-impact", {"strength": 2e8}, "all", (0.19, 0.22)),
    # after the impact grains hit the disc
    ("disc-bed", {"settle": 0}, "disc", (0.0, 0.04)),
]


def shortened(script, group, end):
    """the script of a scene with the end of its last run put forward, and with the speed of a group as its output"""
    start = [match.start() for match in re.finditer(r"^run\s", script, re.MULTILINE)][-1]
    return script[:start] + f"""
print "{BEGIN}"
variable     falls equal vcm({group},z)
thermo_style custom step time v_falls
thermo_modify format float %.10g lost ignore lost/bond ignore
thermo       $(round(0.0002/dt))
run          $(round({end}/dt))
"""


@pytest.mark.parametrize("scene, variables, group, window", FALLS)
def test_a_body_in_free_flight_falls_with_g(run_lammps, tmp_path, scene, variables, group, window):
    script = (EXAMPLES / scene / f"in.{scene}").read_text(encoding="utf-8")
    run = run_lammps(shortened(script, group, window[1]), vars={**variables, "out": tmp_path})
    thermo = logs.thermo(run.log.split(BEGIN)[-1])
    flight = thermo["Time"] >= window[0]
    time, speed = thermo["Time"][flight], thermo["v_falls"][flight]
    slope, start = np.polyfit(time, speed, 1)
    assert slope == pytest.approx(-GRAVITY, rel=WITHIN)
    # nothing has touched it
    assert np.abs(speed - slope * time - start).max() < 0.01 * GRAVITY * (window[1] - window[0])


def run_scene(name, folder, **variables):
    scene = Scene(name)
    scanning.run(scene.folder, variables, folder)
    return scene


def test_grains_fall_into_the_box(tmp_path):
    """column-drop: those of the upper half, which nothing has reached yet"""
    run_scene("column-drop", tmp_path, settling=0.05, spreading=0)
    frame = dumps.at(dumps.read_run(tmp_path, "dump.column-drop"), 0.05)
    assert np.median(frame["vz"][frame["z"] > 0.8]) == pytest.approx(-GRAVITY * 0.05, rel=WITHIN)


@pytest.mark.parametrize("weight, share", [("no", 1.0), ("yes", 0.8)])
def test_grains_fall_out_of_the_hopper(tmp_path, weight, share):
    """hopper: those that touch nothing in the exit; eq. 5.30 on the weight, too, would leave (1 - lambda) g"""
    scene = run_scene("hopper", tmp_path, time=0.4, weight=weight)
    falls = load(scene.claims).falls(dumps.read_run(tmp_path, "dump.hopper"))
    assert len(falls) > 100
    assert np.median(falls) == pytest.approx(share, rel=WITHIN)
