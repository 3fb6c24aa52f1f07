# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""A run that is stopped (kill -9, end of the queue's time) and continued from the last file of `restart N` is the run that was
not stopped, to the last bit, on the same number of ranks. Compared as text with all digits: there is no tolerance."""

import itertools
import random
import struct

import numpy as np
import pytest

from potdem import dumps, scripts
from potdem.text import replaced

FORMAT = f"thermo_modify format float {scripts.ALL_DIGITS}\n"
EVERY, AFTER = 40, 120

# --- scenes: what a restart file holds, and what it does not (fixes and output) ------------------------------------------------


SPRING = "friction 0.3 spring 0.7 damping 0.2"
ROLLS = SPRING + " rolling 0.1 0.2 0.1 twisting 0.05 0.3 0.1"


def block(bond="penetration 2 damping 0.05", friction=SPRING, rotation="no", area="lattice"):
    """a block that breaks on a heap of its like"""
    text = scripts.box(24) + "region body block -2 2 -1.5 1.5 -4 4\n" + scripts.crystal(region="body")
    text += scripts.elastic(100.0, area=area, bond=bond, contact=0.4, pair_options=friction)
    text = replaced(text, "pair_style potdem/truss\n", f"pair_style potdem/truss rotation {rotation}\n")
    return text + "potdem_bonds all 1 1.42\nvelocity all ramp vz -1.2 1.2 z -4 4\nvelocity all ramp vx -0.1 0.12 y -1.5 1.5 sum yes\n"


def of_block(step="timestep 0.01", damping="fix drag all potdem/damping 0.3"):
    return f"""
neighbor 0.3 bin
region floor plane 0 0 -4 0.1 0 1 units box
fix floor all potdem/wall/region floor law hertz 100 0.2 friction 0.4 spring 0.6 damping 0.1
fix failure all potdem/failure 1 tension 3.0 compression 5.0
fix move all nve
fix weight all gravity 0.3 vector 0 0 -1
{damping}
compute books all potdem/energy
{step}
thermo 20
thermo_style custom step dt time pe ke f_failure f_failure[1] bonds c_books c_books[*] f_floor[3]
""" + FORMAT


def grains(law="potdem/hertz rotation yes", coefficients="1e4 0.3 friction 0.4 mindlin rolling 0.2 0.3 0.2 restitution 0.5"):
    """grains that have hit each other and roll"""
    text = scripts.box((8, 8, 16)) + "region heap block -3 3 -3 3 -7 3\n"
    text += scripts.crystal(region="heap", spacing=0.99, diameter=1.0)
    text += f"bond_style none\npair_style {law}\npair_coeff * * {coefficients}\ncomm_modify vel yes\n"
    return text + "velocity all create 1.0 4711 loop geom\n" + scripts.velocities_by_formula(0.5)


GRAINS = """
neighbor 0.3 bin
region cup block -4 4 -4 4 -7.4 8 open 6 units box
fix cup all potdem/wall/region cup law hertz 1e4 0.3 friction 0.4 mindlin restitution 0.5
fix move all nve/sphere
fix weight all gravity 1 vector 0.1 0 -1
compute books all potdem/energy
timestep 2e-3
thermo 20
thermo_style custom step pe ke c_books c_books[*] f_cup[3]
""" + FORMAT

# a lid that presses and turns, a drum that opens
MOVING = replaced(GRAINS, "fix move", """variable down equal -0.3*time
variable turn equal 0.5*time*time
variable wide equal 4.36-0.5*time
region lid plane 0 0 2.7 0 0 -1 move NULL NULL v_down rotate v_turn 0 0 0 0 0 1 units box
fix lid all potdem/wall/region lid law hertz 1e4 0.3 friction 0.4 mindlin restitution 0.5
region drum cylinder z 0 0 v_wide -7.4 INF open 1 units box
fix drum all potdem/wall/region drum law hertz 1e4 0.3 friction 0.4 spring 0.7 restitution 0.5
fix move""")
MOVING = replaced(MOVING, "f_cup[3]", "f_cup[3] f_lid[1] f_lid[3] f_lid[6] f_drum f_drum[4]")

PACE = "fix pace all potdem/timestep 7 0.3 max 0.02"

SCENES = {
    "elastic": (block(bond="", friction=""), of_block(damping="")),
    "another Poisson's ratio": (block(bond="", friction="", area="nu 0.1 area body"), of_block(damping="")),
    "bonds with dashpots": (block(friction=""), of_block(damping="")),
    "damping": (block(bond="", friction=""), of_block()),
    "viscous friction": (block(friction="friction 0.3 2.0"), of_block()),
    "springs of friction": (block(), of_block()),
    "rolling": (block(friction=ROLLS, rotation="yes"), replaced(of_block(), "nve\n", "nve/sphere\n")),
    "a step that adapts": (block(), of_block(step=PACE)),
    "walls that move": (grains(), MOVING),
    "grains": (grains(), GRAINS),
    "grains, viscous": (grains(coefficients="1e4 0.3 friction 0.4 auto restitution 0.5"), GRAINS),
    "grains, a step that adapts": (grains(), replaced(GRAINS, "timestep 2e-3", replaced(PACE, "max 0.02", "max 4e-3"))),
}


def end(tmp_path, name):
    return (tmp_path / name).read_text(encoding="utf-8")


def dump(name):
    return scripts.write_dump(name, "x y z vx vy vz fx fy fz omegax omegay omegaz tqx tqy tqz")


def rows(run):
    """of thermo output, the clock's aside"""
    return {name: list(values) for name, values in run.thermo.items()}


ON_FOUR = ["springs of friction", "walls that move", "a step that adapts"]


@pytest.mark.parametrize("scene, ranks", [*itertools.product(SCENES, [1, 2]), *((scene, 4) for scene in ON_FOUR)])
def test_to_the_last_bit(run_lammps, tmp_path, scene, ranks):
    setup, settings = SCENES[scene]
    whole = run_lammps(setup + settings + f"restart {EVERY} run.*\nrun {AFTER}\n" + dump("whole"), nprocs=ranks)
    expected = rows(whole)
    for start in range(EVERY, AFTER, EVERY):
        rest = f"read_restart run.{start}\n{settings}restart {EVERY} again.*\nrun {AFTER} upto\n"
        again = run_lammps(rest + dump("again"), nprocs=ranks)
        assert end(tmp_path, "again") == end(tmp_path, "whole"), start
        found = rows(again)
        first = expected["Step"].index(start)
        for name, values in expected.items():
            assert found[name] == values[first:], (start, name)


# --- what is changed between reading and running -------------------------------------------------------------------------------


def test_a_velocity_that_is_set_after_reading_counts(run_lammps, tmp_path):
    """the forces of dashpots are those of the new velocities, as without a file: all at rest, none is left"""
    setup, settings = SCENES["bonds with dashpots"]
    settings = replaced(settings, "fix weight all gravity 0.3 vector 0 0 -1\n", "")
    run_lammps(setup + settings + f"restart {EVERY} run.*\nrun {EVERY}\nwrite_restart after\n")
    of = {}
    for file in (f"run.{EVERY}", "after"):
        run_lammps(f"read_restart {file}\n{settings}velocity all set 0 0 0\nrun 0\n" + dump("now"))
        of[file] = end(tmp_path, "now")
        run_lammps(f"read_restart {file}\n{settings}run 0\n" + dump("now"))
        assert end(tmp_path, "now") != of[file]    # dashpots matter
    assert of[f"run.{EVERY}"] == of["after"]


# --- a file that was damaged ---------------------------------------------------------------------------------------------------

DAMAGED = ("damaged", "another version of POTDEM")
MARK = b"PTDM"
NFLIPS = 24


def places_of_ours(data, values):
    """what there is of the package in a file: texts of coefficients, blocks of fixes, values of bonds and contacts; first and last
    byte of each"""
    places = []
    start = data.find(MARK)
    while start >= 0:
        length, = struct.unpack_from("i", data, start + 8)
        places.append(("coefficients", start, start + 16 + length))
        start = data.find(MARK, start + 16 + length)
    block = struct.pack("d", 6.0)
    start = data.find(block)
    while start >= 0:
        size, = struct.unpack_from("i", data, start - 4)
        count, = struct.unpack_from("d", data, start + 8)
        if size == 32 + 8 * count:
            places.append(("state of a fix", start, start + size))
        start = data.find(block, start + 8)
    for kind, numbers in values.items():
        for number in numbers:
            start = data.find(struct.pack("d", number))
            if start >= 0:
                places.append((kind, start, start + 8))
    return places


def test_a_bit_that_flips_in_what_we_keep_is_seen(run_lammps, tmp_path):
    """in coefficients, in what fixes have counted, in reference lengths, areas and springs: no run goes on from it as if nothing were"""
    setup, settings = block(friction="friction 0.3 spring 0.7"), of_block()
    contacts = "compute springs all pair/local p5 p6 p7\ndump springs all local 40 springs.* c_springs[1] c_springs[2] c_springs[3]\n"
    contacts += f"dump_modify springs format float {scripts.ALL_DIGITS}\n"
    run_lammps(setup + settings + contacts + f"restart {EVERY} run.*\nrun {EVERY}\n")
    path = tmp_path / f"run.{EVERY}"
    whole = path.read_bytes()
    springs = dumps.read(tmp_path / f"springs.{EVERY}")[0]
    springs = np.concatenate([springs[f"c_springs[{k}]"] for k in (1, 2, 3)])
    places = places_of_ours(whole, {"length": [np.sqrt(2.0)], "spring": springs[springs != 0.0]})
    kinds = {kind for kind, _, _ in places}
    assert kinds == {"coefficients", "state of a fix", "length", "spring"}
    chance = random.Random(4)
    for _ in range(NFLIPS):
        kind, first, last = chance.choice(places)
        at, bit = chance.randrange(first, last), chance.randrange(8)
        path.write_bytes(whole[:at] + bytes([whole[at] ^ 1 << bit]) + whole[at + 1:])
        error = run_lammps(f"read_restart {path.name}\n{settings}run 1\n", expect_error="").error
        assert any(words in error for words in DAMAGED), (kind, at - first, bit, error)
