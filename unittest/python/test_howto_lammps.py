# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""docs/howto_lammps.md: what LAMMPS adds works with the styles of this package. The scripts run as they stand there, and show
what the page says."""

import json
import re
import subprocess

import numpy as np
import pytest

from potdem import scripts
from potdem.paths import DOCS
from potdem.picture import plt
from potdem.text import replaced

PAGE = DOCS / "howto_lammps.md"
SCRIPTS = scripts.of_page(PAGE)
G, DENSITY, DIAMETER, PRESSED = 9.81, 1800.0, 0.01, 5.0
CLUMPS = 36 * np.pi / 6 * DENSITY * DIAMETER**3


def without_pictures(script):
    return re.sub(r"^(dump|dump_modify) .*\n", "", script, flags=re.MULTILINE)


def loose_blocks():
    """blocks of the page that are no script"""
    blocks = re.findall(r"^```(\w*)\n(.*?)^```$", PAGE.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)
    return [text for language, text in blocks if not language]


def test_every_block_is_a_script_with_a_name():
    assert PAGE.read_text(encoding="utf-8").count("```LAMMPS\n") == len(SCRIPTS)
    assert list(SCRIPTS) == ["clump.lmp", "press.lmp", "plate.lmp"]


# --- clumps -----------------------------------------------------------------------------------------------

def test_clumps_bounce_without_loss_and_take_no_momentum_from_anywhere(run_lammps):
    """elastic and without friction: the energy to what the step allows, here 2e-4 of it; the floor pushes upwards only, and what it
    gives is the change of momentum"""
    script = replaced(without_pictures(SCRIPTS["clump.lmp"]), "thermo          1000", "thermo 10\nthermo_modify format float %.15g")
    script = replaced(script, "run             60000", "run 20000")    # later some jump out of the box
    thermo = run_lammps(script, vars={"e": 1, "mu": 0}).thermo
    energy, upward = thermo["c_ledger"], thermo["v_pz"]
    assert np.ptp(energy) < 2e-4 * energy[0]
    assert np.abs(upward).max() > 0.5 * CLUMPS * np.sqrt(2 * G * 0.025)
    for sideways in ("v_px", "v_py"):
        assert np.abs(thermo[sideways]).max() < 1e-10 * np.abs(upward).max()
    # the impulse of weight and floor, by the trapezoidal rule over every tenth step: contacts last some hundred steps
    force = -thermo["v_load"]
    impulse = np.concatenate([[0], np.cumsum(0.5 * (force[1:] + force[:-1]) * np.diff(thermo["Time"]))])
    assert np.abs(upward - upward[0] - impulse).max() < 0.01 * np.abs(upward).max()


def test_clumps_come_to_rest_on_the_floor_and_are_drawn(run_lammps, tmp_path):
    thermo = run_lammps(SCRIPTS["clump.lmp"]).thermo
    assert thermo["c_ledger[1]"][-1] < 1e-5 * thermo["c_ledger[1]"].max()
    assert thermo["f_floor[3]"][-1] == pytest.approx(-G * CLUMPS, rel=1e-3)
    assert np.ptp(thermo["c_ledger"]) < 1e-3 * thermo["c_ledger"][0]
    pictures = sorted(tmp_path.glob("clump.*.png"))
    assert len(pictures) == 7
    check_picture(pictures[-1], (500, 800))
    probe = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-show_entries", "stream=width,height,nb_read_frames", "-of", "json",
                            tmp_path / "clump.mp4"], text=True, check=True, stdout=subprocess.PIPE).stdout
    (stream,) = json.loads(probe)["streams"]
    assert (stream["width"], stream["height"], int(stream["nb_read_frames"])) == (640, 400, 121)


def check_picture(path, size):
    """particles on a white background: coloured pixels are some, and not all"""
    image = plt.imread(path)[..., :3].astype(float)
    image /= image.max()
    assert image.shape[:2] == size
    coloured = np.ptp(image, axis=2) > 0.2
    assert 0.005 < coloured.mean() < 0.5


# --- press and plate --------------------------------------------------------------------------------------

def test_the_press_holds_the_force_that_is_wanted(run_lammps):
    thermo = run_lammps(SCRIPTS["press.lmp"]).thermo
    assert thermo["f_plate[3]"][0] == 0.0
    assert thermo["f_plate[3]"][-1] == pytest.approx(PRESSED, rel=0.01)
    # the floor carries the grains as well
    weight = 150 * np.pi / 6 * 2500 * 0.0098**3 * G
    assert -thermo["f_bin[3]"][-1] == pytest.approx(PRESSED + weight, rel=0.01)
    assert 0.05 < thermo["v_height"][-1] < 0.061


def test_the_plate_brings_its_load_to_the_floor(run_lammps):
    thermo = run_lammps(SCRIPTS["plate.lmp"]).thermo
    volume = np.pi / 6 * (75 * 0.0098**3 + 100 * 0.008**3)
    assert thermo["v_carried"][-1] == pytest.approx(2500 * volume * G + PRESSED, rel=1e-6)
    assert -thermo["f_bin[3]"][-1] == pytest.approx(thermo["v_carried"][-1], rel=0.01)
    assert 0.02 < thermo["v_height"][-1] < thermo["v_height"][0]


# --- pictures of bonds, cells -----------------------------------------------------------------------------

BODY = scripts.box(0.06, newton="on", skin=0.001) + """
region body block -0.02 0.02 -0.02 0.02 -0.02 0.02 units box
lattice sc 0.005
create_atoms 1 region body
set group all diameter 0.005 density 2500
potdem_bonds all 1 0.0051
bond_style potdem/truss
bond_coeff 1 3e6 area lattice
pair_style potdem/truss
pair_coeff * * 3e6 0.4
fix move all nve
"""


def test_bonds_are_drawn(run_lammps, tmp_path):
    (line,) = [block for block in loose_blocks() if "bond type" in block]
    run_lammps(BODY + line + "run 0\n")
    (picture,) = tmp_path.glob("beam.*.jpg")
    assert picture.read_bytes()[:3] == b"\xff\xd8\xff"
    image = plt.imread(picture)
    assert image.std() > 10


def test_cells_around_the_particles_fill_the_box(run_lammps):
    """a simple cubic lattice in a periodic box: cubes of the spacing, with six faces that matter; PI/6 is their solid fraction"""
    (lines,) = [block for block in loose_blocks() if "voronoi" in block]
    script = scripts.box(0.08, boundary="p p p", skin=0.001) + scripts.crystal(spacing=0.01) + """
pair_style potdem/hertz
pair_coeff * * 5e6 0.3
fix move all nve
""" + lines + """
compute solid all reduce ave v_solid
compute volume all reduce sum c_cells[1]
thermo_style custom step c_solid c_volume
thermo_modify format float %.15g
run 0
"""
    thermo = run_lammps(script).thermo
    assert thermo["c_volume"][0] == pytest.approx(0.08**3, rel=1e-9)
    assert thermo["c_solid"][0] == pytest.approx(np.pi / 6, rel=1e-9)
