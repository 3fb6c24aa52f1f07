# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Reading dumps and the times of their frames."""

import numpy as np
import pytest

from potdem import dumps

FRAME = """ITEM: TIMESTEP
{step}
ITEM: NUMBER OF ATOMS
{count}
ITEM: BOX BOUNDS ff ff ff
0 1
0 1
0 1
ITEM: ATOMS id x
"""

LOG = """LAMMPS (4 Feb 2025 - Update 1)
   Step          Time
         0   0.5
        10   0.7
Loop time of 1 on 1 procs for 10 steps with 2 atoms
"""


@pytest.fixture
def frames(tmp_path):
    """a run of ten steps of 0.02 that begins at 0.5 and loses one of its two atoms"""
    text = FRAME.format(step=0, count=2) + "1 0.25\n2 0.75\n" + FRAME.format(step=5, count=1) + "2 0.5\n"
    (tmp_path / "dump.flight").write_text(text)
    (tmp_path / "log.4Feb2025.flight.g++.1").write_text(LOG)
    return dumps.read_run(tmp_path, "dump.flight")


def test_frames_have_columns_and_times(frames):
    assert [frame.step for frame in frames] == [0, 5]
    assert [frame["time"] for frame in frames] == pytest.approx([0.5, 0.6])
    assert np.array_equal(frames[0]["x"], [0.25, 0.75]) and np.array_equal(frames[1]["id"], [2])


def test_the_nearest_frame_is_taken(frames):
    assert dumps.at(frames, 0.54).step == 0
    assert dumps.at(frames, 0.56).step == 5
    assert dumps.at(frames, 9.0).step == 5
