# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""What happens while a run goes on: grains and bodies that come, particles that grow, minimisers, coefficients that
are given again. Each small case was wrong once; the right value is beside it. (That a new LAMMPS finds the same from
a restart file is test_set_up_anew.py.)"""

import math
import subprocess
import sys

import numpy as np
import pytest

from potdem import dumps, formulas, running, scripts
from potdem.text import replaced

ROUNDING = 1e-12    # a few operations
# trajectories of a few hundred steps that differ by the order of sums
SAME_PATH = 1e-8


def periodic_distances(x, size):
    d = x[:, None, :] - x[None, :, :]
    d -= size * np.round(d / size)
    return np.sqrt((d**2).sum(axis=2))


def last_dump(tmp_path, name):
    table = dumps.read(tmp_path / name)[-1]
    order = np.argsort(table["id"])
    return {key: column[order] for key, column in table.items()}


# --- minimisers --------------------------------------------------------------------------------------------

@pytest.mark.parametrize("nprocs", [1, 2])
@pytest.mark.parametrize("style", ["cg", "quickmin", "fire"])
def test_a_shaken_crystal_finds_its_rest(run_lammps, style, nprocs):
    """through rebuilds of the neighbour lists, with sites on the box's faces, so that particles change their periodic
    image. The start has 0.3 J; a force of 1e-9 N at a stiffness of 1e3 N/m is 1e-21 J for each bond. (min_modify
    after min_style, which forgets it: the default dmax is longer than the box.)"""
    script = scripts.box(0.06, "p p p", skin=0.0002, centre=0.03) + f"""
lattice sc 0.01
create_atoms 1 box
set group all diameter 0.01 mass 0.002
potdem_bonds all 1 2.0 diameters
bond_style potdem/truss
bond_coeff 1 1e6 area lattice
pair_style potdem/truss
pair_coeff 1 1 1e6 0.4
thermo_style custom step pe nbuild
run 0
displace_atoms all random 0.0004 0.0004 0.0004 12 units box
reset_timestep 1
timestep 2e-4
min_style {style}
min_modify dmax 1e-4
minimize 0 1e-9 1000 5000
"""
    run = run_lammps(script, nprocs=nprocs)
    assert run.thermo["Nbuild"][-1] >= 2
    assert run.thermo["PotEng"].max() > 0.1
    assert run.thermo["PotEng"][-1] < 1e-11    # cg stops where a step changes the energy by its rounding


# --- insertion ---------------------------------------------------------------------------------------------

@pytest.mark.parametrize("law", ["potdem/hertz", "potdem/truss"])
def test_grains_poured_into_an_empty_box_make_a_heap(run_lammps, tmp_path, law):
    """about 3 contacts each and overlaps of 1 % of the radius, as with LAMMPS's gran/hertz/history (2.8, 1.1 %);
    without contacts they would lie in each other"""
    coeff = {"potdem/hertz": "1e7 0.3 viscous 1e-3", "potdem/truss": "1e6 0.4 friction 0.3 auto"}[law]
    script = f"""units si
atom_style sphere
comm_modify vel yes
boundary f f f
region box block -0.03 0.03 -0.03 0.03 -0.05 0.5
create_box 1 box
pair_style {law}
pair_coeff * * {coeff}
fix move all nve/sphere
fix weight all gravity 9.81 vector 0 0 -1
region slab block -0.01 0.01 -0.01 0.01 0.1 0.3
fix ins all pour 60 1 4711 region slab diam range 0.006 0.01 dens 2500 2500 vol 0.3 200
region bin block -0.015 0.015 -0.015 0.015 0 INF
fix walls all potdem/wall/region bin 1e7 0.3 particle 1e7 0.3 viscous 1e-3
fix drag all viscous 1e-3
timestep 2e-5
thermo 5000
thermo_style custom step atoms
compute cn all contact/atom
run 30000
write_dump all custom end.dump id x y z radius c_cn
"""
    run_lammps(script)
    end = last_dump(tmp_path, "end.dump")
    x, radius = scripts.vectors(end, "x", "y", "z"), end["radius"]
    assert len(x) == 60
    overlap = radius[:, None] + radius[None, :] - periodic_distances(x, 1.0)
    np.fill_diagonal(overlap, -1)
    assert end["c_cn"].mean() > 2.5
    assert overlap.max() < 0.05 * radius.min()


INSERTED = 4 / 3 * 1e6 / (2 * (1 - 0.25**2)) * math.sqrt(0.005) * 0.005**1.5    # Hertz, overlap of half a radius
BALL = scripts.ball(0.02)
FIRST = {"none": "", "small": scripts.particles([(0, 0, 0.09, 0.004)], 1000),
         "large": scripts.particles([(0, 0, 0.09, 0.02)], 1000)}


def insertions(places):
    text = "molecule ball ball.mol\n"
    for number, place in enumerate(places):
        sides = " ".join(f"{c - 1e-7:.17g} {c + 1e-7:.17g}" for c in place)
        text += f"region r{number} block {sides} units box\n"
        text += f"fix ins{number} all deposit 1 0 1 {11 + number} region r{number} mol ball id max units box\n"
    return text


@pytest.mark.parametrize("nprocs", [1, 2])
@pytest.mark.parametrize("first", FIRST)
def test_inserted_grains_push_each_other_at_once(run_lammps, tmp_path, first, nprocs):
    """a pair inside and one across the periodic boundary, whatever was there before"""
    (tmp_path / "ball.mol").write_text(BALL)
    places = [(-0.0925, -0.05, -0.05), (0.0925, -0.05, -0.05), (-0.0075, 0.05, -0.05), (0.0075, 0.05, -0.05)]
    script = scripts.box(0.2, "p p p", atom_style="sphere", skin=0.001) + FIRST[first] + """
pair_style potdem/hertz
pair_coeff 1 1 1e6 0.25
fix none all nve/noforce
timestep 1e-9
""" + insertions(places) + "run 3\nwrite_dump all custom at_once.dump id fx radius\n" + \
        "run 0\nwrite_dump all custom set_up.dump id fx radius\n"
    run_lammps(script, nprocs=nprocs)
    for name in ("at_once.dump", "set_up.dump"):
        table = last_dump(tmp_path, name)
        push = np.abs(table["fx"][-4:])
        # the places are random within 1e-7 of an overlap of 5e-3, with a power of 1.5
        assert push == pytest.approx(4 * [INSERTED], rel=1e-4), name


def test_a_grain_that_comes_later_finds_the_other(run_lammps, tmp_path):
    """grains of 2 cm among one of 4 mm, the second some steps after the first: set-up has seen neither"""
    (tmp_path / "ball.mol").write_text(BALL)
    script = scripts.box(0.2, "p p p", atom_style="sphere", skin=0.001) + FIRST["small"] + """
pair_style potdem/hertz
pair_coeff 1 1 1e6 0.25
molecule ball ball.mol
fix move all nve
timestep 1e-4
region r block -1e-7 1e-7 -1e-7 1e-7 -1e-7 1e-7 units box
fix ins all deposit 2 0 50 11 region r mol ball id max vx 3 3 units box
run 51
""" + scripts.write_dump("end.dump", "x vx fx")
    run_lammps(script)
    end = last_dump(tmp_path, "end.dump")
    x, force = end["x"][1:], end["fx"][1:]
    # the first has gone 50 steps, and nothing has touched it
    assert x[0] - x[1] == pytest.approx(50 * 1e-4 * 3, abs=3e-7)
    overlap = 0.02 - (x[0] - x[1])
    push = 4 / 3 * 1e6 / (2 * (1 - 0.25**2)) * math.sqrt(0.005) * overlap**1.5
    assert force == pytest.approx([push, -push], rel=1e-8)    # the places are random by 1e-7 in y and z


def cube_file():
    """27 spheres of 1 cm on a cubic lattice, bonded up to two diameters"""
    sites = np.array([(x, y, z) for x in (-1, 0, 1) for y in (-1, 0, 1) for z in (-1, 0, 1)])
    distance = np.linalg.norm(sites[:, None] - sites[None], axis=2)
    pairs = [(i, j) for i in range(27) for j in range(i + 1, 27) if distance[i, j] < 2.001]
    sections = {"Coords": [" ".join(f"{0.01 * c:g}" for c in site) for site in sites], "Types": 27 * ["1"],
                "Diameters": 27 * ["0.01"], "Masses": 27 * ["0.002"], "Bonds": [f"1 {i + 1} {j + 1}" for i, j in pairs]}
    text = f"# a cube\n\n27 atoms\n{len(pairs)} bonds\n"
    for name, rows in sections.items():
        text += f"\n{name}\n\n" + "".join(f"{k} {row}\n" for k, row in enumerate(rows, start=1))
    return text


def bodies(area):
    return scripts.box(0.4, "f f f", newton="on off", room=32, skin=0.001, centre=0.2) + f"""
special_bonds lj 0 1 1 coul 0 1 1
molecule cube cube.mol
bond_style potdem/truss
bond_coeff 1 1e6 area {area}
pair_style potdem/truss
pair_coeff 1 1 1e6 0.4
region drop block 0.15 0.25 0.15 0.25 0.1 0.12 units box
timestep 1e-5
"""


@pytest.mark.parametrize("area", ["body", "lattice", "factor 0.281"])
def test_bodies_dropped_into_an_empty_box(run_lammps, tmp_path, area):
    """their bonds have sections and carry, so that they come to lie on the floor and do not go through it"""
    (tmp_path / "cube.mol").write_text(cube_file())
    script = bodies(area) + """
region floor plane 0 0 0.02 0 0 1 units box
fix floor all potdem/wall/region floor 1e8 0.25 particle 1e6 0.25
fix g all gravity 9.81 vector 0 0 -1
fix move all nve
fix ins all deposit 2 0 12000 99 region drop mol cube near 0.05 vz -0.5 -0.5 id max
compute b all bond/local dist b1 b3 b4
compute amin all reduce min c_b[3] inputs local
compute longest all reduce max c_b[2] inputs local
compute zmin all reduce min z
thermo_style custom step atoms bonds c_amin c_longest c_zmin
thermo 2000
run 20000
"""
    thermo = run_lammps(script).thermo
    assert thermo["Atoms"][-1] == 54 and thermo["Bonds"][-1] == 370
    assert thermo["c_amin"][-1] > 0
    assert thermo["c_zmin"][-1] > 0.02    # the floor
    assert abs(thermo["c_longest"][-1]) < 0.1    # the bodies hold together


def test_strain_of_bodies_that_come_during_the_run(run_lammps, tmp_path):
    """nothing has strained them: 0 to rounding, and neighbours on all sides"""
    (tmp_path / "cube.mol").write_text(cube_file())
    script = bodies("factor 0.281") + """
create_atoms 0 single 0.2 0.2 0.05 mol cube 5 units box
run 0
fix move all nve
fix ins all deposit 1 0 500 99 region drop mol cube near 0.02 vz -0.5 -0.5 id max
compute s all potdem/strain/atom
compute smax all reduce max c_s[1]
compute smin all reduce min c_s[1]
compute rank all reduce min c_s[8]
thermo_style custom step atoms c_smax c_smin c_rank
run 2000
""" + scripts.result("atoms", "c_smax", "c_smin", "c_rank")
    atoms, largest, least, rank = scripts.results(run_lammps(script).stdout)[0]
    assert atoms == 54 and rank == 6
    # it has moved by 1 cm: at worst 1e-16 of 0.2 m, in lengths of 1e-2 m, at every one of 2000 steps
    assert abs(largest) < 1e-11 and abs(least) < 1e-11


# --- growth ------------------------------------------------------------------------------------------------

GROWN = {"potdem/hertz": "1e6 0.25", "potdem/truss": "1e6 0.4", "potdem/granular": "1e3 4 0.3"}


@pytest.mark.parametrize("law", GROWN)
def test_a_packing_that_grows(run_lammps, tmp_path, law):
    """in one run and in one that is set up anew at every change of the diameters: the same path, so no pair is
    deeper. No viscosity: a set-up sees velocities half a step later than the run does"""
    script = scripts.box(0.07, "p p p", atom_style="sphere 1", skin=0.001) + f"""
create_atoms 1 random 300 77 NULL overlap 0.005 maxtry 2000
set group all diameter 0.005 density 2000
pair_style {law}
pair_coeff 1 1 {GROWN[law]}
variable d equal 0.005+0.005*step/2000
fix grow all adapt 10 atom diameter v_d
fix move all nve/sphere
timestep 1e-5
"""
    paths = []
    for how in ("", " every 10 NULL"):
        run_lammps(script + f"run 2000{how}\n" + scripts.write_dump("end.dump", "x y z radius"))
        end = last_dump(tmp_path, "end.dump")
        assert end["radius"] == pytest.approx(300 * [0.005], rel=ROUNDING)
        paths.append(scripts.vectors(end, "x", "y", "z"))
    one, pieces = (periodic_distances(x, 0.07) + np.eye(300) for x in paths)
    assert np.count_nonzero(one < 0.01) > 300    # they do touch
    assert one.min() == pytest.approx(pieces.min(), rel=1e-4)
    assert np.abs(one - pieces).max() < 1e-4 * 0.01


# --- coefficients and cutoffs given again ------------------------------------------------------------------

def torn_block(area="lattice"):
    """5 x 5 x 5 particles that are pulled apart; most bonds fail within 300 steps"""
    return scripts.box(20) + "region body block 0 5 0 5 0 5 units box\n" + scripts.crystal(region="body") + f"""
potdem_bonds all 1 2.0 diameters
bond_style potdem/truss
bond_coeff * 1e6 area {area}
pair_style potdem/truss
pair_coeff * * 1e6 0.4
velocity all ramp vz -50 50 z 0 5 units box
timestep 1e-4
"""


DAMAGE = """fix move all nve
fix cracks all potdem/failure 1 tension 2e4
compute b all bond/local b3
compute section all reduce max c_b inputs local
thermo 50
thermo_style custom step pe ebond bonds f_cracks c_section
"""


def last_row(run):
    return {name: values[-1] for name, values in run.thermo.items()}


@pytest.mark.parametrize("style_too", [False, True])
@pytest.mark.parametrize("lattice, reach", [("sc", "2.0"), ("fcc", "1.0")])
def test_bond_coeff_again_after_a_restart(run_lammps, lattice, reach, style_too):
    """as most restart scripts do; no particle of the damaged body shows its lattice any more. The bonds keep the
    section they were made with"""
    spacing = {"sc": 1.0, "fcc": math.sqrt(2)}[lattice]
    script = scripts.box(20) + "region body block 0 5 0 4 0 4 units box\n" + scripts.crystal(
        lattice, spacing, "body", 1.0) + f"""
potdem_bonds all 1 {reach} diameters
bond_style potdem/truss
bond_coeff * 1000 area lattice
pair_style potdem/truss
pair_coeff * * 1000 0.4
{scripts.velocities_by_formula(25)}
timestep 0.002
"""
    damage = replaced(DAMAGE, "tension 2e4", "tension 60 compression 80") + \
        f"thermo_modify format float {scripts.ALL_DIGITS}\n"
    before = last_row(run_lammps(script + damage + "run 60\nwrite_restart damaged.restart\n"))
    again = "read_restart damaged.restart\nneighbor 0.3 bin\n" + ("bond_style potdem/truss\n" if style_too else "")
    after = last_row(run_lammps(again + "bond_coeff * 1000 area lattice\n" + damage + "run 0\n"))
    assert before["f_cracks"] > 100 and before["E_bond"] > 1
    for name in ("Bonds", "f_cracks", "c_section", "E_bond", "PotEng"):
        assert after[name] == pytest.approx(before[name], rel=1e-11), name


def test_fix_adapt_on_a_damaged_lattice(run_lammps):
    """the same path as with the section given as a number, which nothing has to find"""
    change = DAMAGE + f"""thermo_modify format float {scripts.ALL_DIGITS}
variable modulus equal 1e6*(1-step/4000)
fix change all adapt 10 bond potdem/truss E 1 v_modulus
run {{}}
"""
    whole = last_row(run_lammps(torn_block() + change.format(0)))
    factor = whole["c_section"] / formulas.section(1.0)
    plain = last_row(run_lammps(torn_block(f"factor {factor:.17g}") + change.format(300)))
    found = last_row(run_lammps(torn_block() + change.format(300)))
    assert plain["f_cracks"] > 100
    for name, value in plain.items():
        assert found[name] == pytest.approx(value, rel=SAME_PATH), name


def test_a_restart_with_a_larger_skin(run_lammps):
    """the communication cutoff that the bonds had set is not taken for the user's"""
    script = scripts.box(0.2, skin=0.001) + "region body block 0 0.04 0 0.04 0 0.04 units box\n" + scripts.crystal(
        spacing=0.01, region="body", density=2000) + """
potdem_bonds all 1 2.0 diameters
bond_style potdem/truss
bond_coeff 1 1e6 area lattice
pair_style potdem/truss
pair_coeff 1 1 1e6 0.4
run 0
write_restart body.restart
clear
read_restart body.restart
neighbor 0.02 bin
run 0
""" + scripts.result("bonds", "pe")
    bonds, energy = scripts.results(run_lammps(script).stdout)[0]
    assert bonds > 500 and energy == pytest.approx(0.0, abs=1e-20)


# --- errors ------------------------------------------------------------------------------------------------

WITH_LEDGER = torn_block() + """fix move all nve
fix cracks all potdem/failure 1 tension 2e4
compute books all potdem/energy
thermo_style custom step pe f_cracks c_books
"""


# as docs/internal_fixes.md has it
TAKEN_AWAY = {
    "POTDEM_BONDS": True, "POTDEM_BONDS_FIX_PROP_ATOM": True, "POTDEM_BONDS_AREAS": True,
    "POTDEM_BONDS_AREAS_FIX_PROP_ATOM": True, "POTDEM_CONTACTS_1": True, "strain_REFERENCE": True,
    "pace_CRITICAL": True, "POTDEM_MONITOR": False, "POTDEM_REFRESH": False, "POTDEM_RESUME": False
}


@pytest.mark.parametrize("part", TAKEN_AWAY)
def test_another_internal_part_is_taken_away(lmp, run_lammps, tmp_path, part):
    """one error that names it, or the same results as without"""
    script = WITH_LEDGER + "compute strain all potdem/strain/atom\nfix pace all potdem/timestep 1 0.5 max 1e-4\n"
    script += f"thermo_modify format float {scripts.ALL_DIGITS}\nrestart 1000 kept.a kept.b\nrun 50\n"
    usual = last_row(run_lammps(script + "run 50\n"))
    command = "uncompute" if part == "pace_CRITICAL" else "unfix"
    done = running.run(script + f"{command} {part}\nrun 50\n", {}, tmp_path, log="log.unfix", lmp=lmp)
    if TAKEN_AWAY[part]:
        assert done.status > 0 and done.stdout.count("ERROR") == 1, done.stdout[-2000:]
        assert part in done.error, done.stdout[-2000:]
    else:
        assert last_row(done) == usual


CAUGHT = '''"""potdem_bonds fails for want of room in a neighbour list; the error is caught and the work goes on"""
import ctypes
import sys

lib = ctypes.CDLL(sys.argv[1], ctypes.RTLD_GLOBAL)
lib.lammps_open_no_mpi.restype = ctypes.c_void_p
words = [b"lmp", b"-log", b"none", b"-screen", b"none"]
lmp = ctypes.c_void_p(lib.lammps_open_no_mpi(len(words), (ctypes.c_char_p * len(words))(*words), None))


def commands(text):
    lib.lammps_commands_string(lmp, text.encode())
    if not lib.lammps_has_error(lmp):
        return True
    text = ctypes.create_string_buffer(2000)
    lib.lammps_get_last_error_message(lmp, text, 2000)
    print("error:", text.value.decode().strip())
    return False


assert not commands("""units si
newton on off
atom_style bpm/sphere
boundary f f f
lattice sc 1.0
region box block -2 12 -2 12 -2 12
create_box 1 box bond/types 1
region body block 0 9 0 9 0 9
create_atoms 1 region body
set group all diameter 1 mass 1
pair_style potdem/truss
pair_coeff 1 1 1 0.5
neigh_modify one 10 page 100
potdem_bonds all 1 2.0 diameters
""")
assert commands("neigh_modify one 2000 page 100000\\npotdem_bonds all 1 2.0 diameters")
assert commands("bond_style potdem/truss\\nbond_coeff 1 1 area lattice\\nrun 0")
lib.lammps_close(lmp)
print("closed")
'''


def test_an_error_inside_potdem_bonds_is_caught(lmp, tmp_path):
    """through LAMMPS's library: pair and bond style are whole afterwards"""
    (tmp_path / "caught.py").write_text(CAUGHT)
    done = subprocess.run([sys.executable, "caught.py", lmp.parent / "liblammps.so"], cwd=tmp_path, text=True,
                          env=running.environment(), stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          check=False)
    assert "Neighbor list overflow" in done.stdout
    assert done.returncode == 0 and done.stdout.splitlines()[-1] == "closed", done.stdout[-2000:]
