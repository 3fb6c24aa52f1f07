# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""To go on is to set up anew: at any step of a run, whatever has just happened in it, the forces, energies, counts and
bonds are those that a new LAMMPS finds from the restart file of that step.

What a style learns when a run begins (cutoffs, largest radii, sections, lists of bonds) must follow what happens to
the particles later. Each event below is a piece of script that makes one thing happen; the rest is shared. Where the
event is one of a run, the forces compared are those of its last step, with no set-up in between. (The restart file is
written after that: for one written in a run LAMMPS rebuilds its neighbour lists at that step.)

(Data files are in test_dead_bonds.py: they keep neither reference lengths nor what contacts remember.)
"""

import itertools
import math
import re
from dataclasses import dataclass, field
from typing import Callable

import numpy as np
import pytest

from potdem import dumps, scripts
from potdem.text import replaced

# Positions come back to the last bit, but for a shift by the periodic box: 1e-16 of ten diameters, in overlaps and
# stretches of 1e-2 diameters 1e-13 of a force; sums of some tens of forces in another order add as much. A missed
# contact or bond is of order 1.
SAME = 1e-11
RESTART = "state.restart"
# numbers of ranks: the first runs the event, each of the others reads the restart file of the one before
CHAINS = [(1, 3, 2), (2, 3)]


@dataclass(frozen=True)
class Event:
    """world: up to the run; settings: what a restart file does not hold, given again after it; act: what happens;
    happened: whether it did, from thermo's first and last rows (a function of the run, first, last);
    again: what only the new LAMMPS is told"""

    world: str
    settings: str
    act: str
    happened: Callable
    again: str = ""
    columns: str = ""    # for happened() only


@dataclass
class State:
    totals: dict
    particles: dict
    bonds: dict = field(default_factory=dict)

    def pairs(self):
        return self.bonds["c_pair[1]"], self.bonds["c_pair[2]"]


# --- measurement -------------------------------------------------------------------------------------------

GRAIN_TOTALS = "atoms vol evdwl pe c_radii"
BODY_TOTALS = GRAIN_TOTALS + " bonds ebond f_fail f_fail[1] f_fail[2] f_fail[3]"
PARTICLES = ["radius", "mass", "fx", "fy", "fz", "tqx", "tqy", "tqz"]
BONDS = ["c_bond[1]", "c_bond[2]", "c_bond[3]", "c_bond[4]"]    # energy, force, section, reference length


def instruments(bonded, columns=""):
    bonds = "compute pair all property/local batom1 batom2\ncompute bond all bond/local engpot force b3 b4\n"
    return f"""
compute radius all property/atom radius
compute radii all reduce sum c_radius
{bonds if bonded else ""}
thermo 1
thermo_style custom step {BODY_TOTALS if bonded else GRAIN_TOTALS} {columns}
thermo_modify format float {scripts.ALL_DIGITS} lost error
"""


def write_state(bonded):
    """no set-up: forces as the last step left them"""
    local = "write_dump all local bonds.dump index c_pair[*] c_bond[*] modify format float %.17g\n"
    return f"write_dump all custom state.dump id {' '.join(PARTICLES)} modify format float %.17g\n" + (
        local if bonded else "")


def sorted_by(table, *keys):
    """the last key counts most"""
    order = np.lexsort([table[key] for key in keys])
    return {name: column[order] for name, column in table.items()}


def read_state(run, tmp_path, bonded):
    columns = (BODY_TOTALS if bonded else GRAIN_TOTALS).split()
    totals = dict(zip(columns, [values[-1] for values in run.thermo.values()][1:]))
    particles = sorted_by(dumps.read(tmp_path / "state.dump")[0], "id")
    if not bonded:
        return State(totals, particles)
    table = dumps.read(tmp_path / "bonds.dump")[0]
    ends = np.sort(scripts.vectors(table, "c_pair[1]", "c_pair[2]"), axis=1)
    table["c_pair[1]"], table["c_pair[2]"] = ends.T
    return State(totals, particles, sorted_by(table, "c_pair[2]", "c_pair[1]"))


def largest_force(state):
    """of one particle or one bond, so that a body in equilibrium has a scale too"""
    forces = [state.particles[name] for name in ("fx", "fy", "fz")]
    return max(np.abs(values).max(initial=0.0) for values in [*forces, state.bonds.get("c_bond[2]", np.zeros(0))])


def assert_same(going, anew):
    assert anew.totals == pytest.approx(going.totals, rel=SAME, abs=SAME * max(1.0, abs(going.totals["pe"])))
    assert np.array_equal(anew.particles["id"], going.particles["id"])
    assert largest_force(going) > 0
    scale = max(1.0, largest_force(going))    # in these worlds a stretch or overlap of 1e-2 diameters
    for name in PARTICLES:
        unit = 1.0 if name in ("radius", "mass") else scale
        assert anew.particles[name] == pytest.approx(going.particles[name], abs=SAME * unit), name
    if going.bonds:
        assert np.array_equal(anew.pairs(), going.pairs())
        for name in BONDS:
            unit = scale if name == "c_bond[2]" else 1.0
            assert anew.bonds[name] == pytest.approx(going.bonds[name], rel=SAME, abs=SAME * unit), name


# --- the worlds --------------------------------------------------------------------------------------------
# No viscosity and no friction where particles are accelerated: LAMMPS computes the forces of a step from velocities
# half a step old, and set-up from those of the step itself.

LAWS = {
    "potdem/hertz": "1000 0.3",
    "potdem/granular": "300 3 0.2",
    "potdem/truss": "1000 0.5",
    "potdem/lj": "3000 0.2 3 0.2",
}
RUBBING = "potdem/hertz rotation yes"
LAWS_BY_VELOCITY = {RUBBING: "1000 0.3 viscous 1e-3 friction 0.3 2"}
MOVE = "fix move all nve/sphere\ntimestep 0.002\n"
REST = "fix move all nve/noforce\ntimestep 0.002\n"
WEIGHT = "fix weight all gravity 10 vector 0 0 -1\n"
UNBROKEN = "fix fail all potdem/failure 1 tension 1e9\n"
BREAKING = MOVE + "fix fail all potdem/failure 1 tension 60 compression 80\n"


def grains(law="potdem/hertz", created="", size=6, boundary="p p p", atom_style="sphere", skin=0.3):
    return scripts.box(size, boundary, atom_style=atom_style, skin=skin) + created + f"""
pair_style {law}
pair_coeff * * {(LAWS | LAWS_BY_VELOCITY)[law]}
"""


def packed(diameter=1.03, law="potdem/hertz", size=5, atom_style="sphere", skin=0.3):
    """a periodic crystal of grains in touch that move about"""
    return grains(law, scripts.crystal(diameter=diameter), size, atom_style=atom_style,
                  skin=skin) + scripts.velocities_by_formula(0.5)


def block(diameter=1.0, area="lattice", reach=1.42, size=(3, 3, 6), shift=0.0, contact=0.5, skin=0.3):
    """a bonded body in a box with room around it"""
    x, y, z = size
    sides = f"{shift} {x + shift} 0 {y} 0 {z}"
    created = f"region body block {sides} units box\n" + scripts.crystal(region="body", diameter=diameter)
    return scripts.box(30, skin=skin, room=30) + created + scripts.elastic(
        1000.0, area, contact=contact) + f"potdem_bonds all 1 {reach}\n"


def torn(diameter=1.0, area="lattice", speed=10, skin=0.3):
    """one that is torn apart, bonds failing at most steps from the 5th on"""
    return block(diameter, area, skin=skin) + scripts.velocities_by_formula(speed)


def ruined():
    """so much that no particle keeps the neighbours by which area lattice knows its lattice"""
    return torn(0.7, speed=30)


def periodic_body(skin=0.3, area="lattice"):
    return scripts.box((4, 5, 6), "p p p", skin=skin) + scripts.crystal() + scripts.elastic(
        1000.0, area) + "potdem_bonds all 1 1.42\n"


# --- the events --------------------------------------------------------------------------------------------

def more(name):
    return lambda run, first, last: last[name] > first[name]


def fewer(name):
    return lambda run, first, last: last[name] < first[name]


def changed(name):
    return lambda run, first, last: last[name] != first[name]


def every(*conditions):
    return lambda *state: all(condition(*state) for condition in conditions)


def at_the_last_step(name):
    """it changed at the very step that is compared"""
    return lambda run, first, last: run.thermo[name][-1] != run.thermo[name][-2]


def in_touch(run, first, last):
    return last["E_vdwl"] != 0 and last["Atoms"] > first["Atoms"]    # (lj attracts)


FLOOR = "region floor plane 0 0 -5 0 0 1 units box\nfix floor all potdem/wall/region floor 1e4 0.3 particle 1e4 0.3\n"


def poured(law, created="", diameter=1.0, number=18, fall=5.0, steps=500):
    """into a narrow shaft, so that many touch at the last step"""
    act = f"""region slab block -1.5 1.5 -1.5 1.5 {-4.4 + diameter} {-4.4 + diameter + fall} units box
fix ins all pour {number} 1 4711 region slab diam one {diameter} dens 1 1 vol 0.2 200 vel -0.5 0.5 -0.5 0.5 -1
run {steps}
"""
    return Event(grains(law, created, (3, 3, 12), "p p f", skin=0.1), MOVE + WEIGHT + FLOOR, act, in_touch)


BED = "region bed block -1.5 1.5 -1.5 1.5 -5 -4 units box\n" + scripts.crystal(
    spacing=0.5, region="bed", diameter=0.5)
SMALL = scripts.particles([(0, 0, 2, 0.2)])
ATOM = ("1", "", "")
BALL = ("0", "molecule ball ball.mol\n", "mol ball id max")
INSIDE = [(-0.45, 0.1, 0.2), (0.45, 0.1, 0.2)]
ACROSS = [(-2.55, 0.1, 0.2), (2.55, 0.1, 0.2)]


def deposited(law, what=BALL, places=INSIDE, there=SMALL):
    """two grains in touch, five times as large as the one that is there, compared at the step of their insertion"""
    kind, template, keywords = what
    act = template
    for number, (x, y, z) in enumerate(places):
        act += f"region spot{number} block {x} {x + 1e-6} {y} {y + 1e-6} {z} {z + 1e-6} units box\n" + \
            f"fix ins{number} all deposit 1 {kind} 1 99 region spot{number} {keywords} units box\n"
    return Event(grains(law, there, skin=0.1), REST, act + "run 1\n", every(more("Atoms"), changed("PotEng")))


def deposited_bodies(area):
    """two cubes of 27 bonded particles, the first into an empty box; it has struck a floor when the second comes at the
    last step"""
    world = scripts.box(16, "p p f", newton="on off", room=40) + \
        "special_bonds lj 0 1 1 coul 0 1 1\n" + scripts.elastic(1000.0, area)
    floor = "region floor plane 0 0 -7.1 0 0 1 units box\n" + \
        "fix floor all potdem/wall/region floor 1000 0.3 particle 1000 0.3\n"
    act = """molecule cube cube.mol
region drop block -0.1 0.1 -0.1 0.1 -7.9 5 units box
fix ins all deposit 2 0 60 99 region drop global 2.6 2.6 mol cube orient 0 0 1 vz -2 -2 id max units box
run 61
"""
    return Event(world, "fix move all nve/sphere\ntimestep 0.005\n" + floor + UNBROKEN, act,
                 lambda run, first, last: last["Atoms"] == 54 and last["E_bond"] > 0)


def grown(law, moves=MOVE, displaced=0.0, period=1):
    """the diameters of grains that do not touch grow until they do"""
    shake = f"displace_atoms all random {displaced} {displaced} {displaced} 7 units box\n" if displaced else ""
    act = f"variable d equal 0.9+0.0032*step\nfix grow all adapt {period} atom diameter v_d\n{shake}run 50\n"
    world = packed(0.9, law, atom_style="sphere 1", skin=0.05)
    return Event(world, moves, act, every(more("c_radii"), changed("E_vdwl")))


def minimised(style, world=None, relax="", happened=None, displaced=0.1):
    """some way towards the minimum, with rebuilds on the way that sort the particles; forces are left over"""
    act = f"""atom_modify sort 1 1.5
displace_atoms all random {displaced} {displaced} {displaced} 12 units box
min_style {style}
min_modify dmax 0.02
{relax}
minimize 0 0 8 400
"""
    rebuilt = lambda run, first, last: last["Nbuild"] > 2
    bonded = world is None
    return Event(world or periodic_body(0.02), MOVE + (UNBROKEN if bonded else ""), act,
                 every(fewer("PotEng"), happened or rebuilt), columns="nbuild")


def balanced(run, first, last):
    """(on one rank there is nothing to balance)"""
    found = re.search(r"initial/final imbalance factor *= *(\S+) (\S+)", run.stdout)
    if "2 by 1 by 1" in run.stdout or "1 by 2 by 1" in run.stdout or "1 by 1 by 2" in run.stdout:
        return float(found.group(1)) > 1.5 > 1.2 > float(found.group(2))
    return True


def balanced_in_the_run(run, first, last):
    return "1 by 1 by 1" in run.stdout or run.thermo["f_bal[3]"].max() > 1.5 > 1.2 > last["f_bal"]


def bonded_anew(run, first, last):
    return run.thermo["Bonds"].min() < min(first["Bonds"], last["Bonds"]) and last["f_fail"] > 0


CORNER = block(size=(4, 4, 4), shift=2)
TWO_BODIES = replaced(block(size=(3, 3, 6)), "potdem_bonds all 1 1.42", """region high block 0 3 0 3 3 6 units box
group high region high
group low subtract all high
set group low mol 1
set group high mol 2
velocity all ramp vx -2 2 x 0 3 units box
potdem_bonds low 1 1.42
potdem_bonds high 1 1.42""")

EVENTS = {
    # insertion
    **{f"pour into an empty box, {law}": poured(law) for law in LAWS},
    "pour large grains onto small ones": poured("potdem/hertz", BED, 1.2, 3, 3, 200),
    "pour small grains onto large ones": poured("potdem/hertz", scripts.particles([(0, 0, -4, 2.0)]), 0.5, 40),
    **{f"deposit grains, {law}": deposited(law) for law in LAWS},
    "deposit grains that rub": deposited(RUBBING, (*BALL[:2], BALL[2] + " vx 1 1 vy 0.2 0.3")),
    "deposit grains without a molecule": deposited("potdem/hertz", ATOM),
    "deposit grains across the periodic boundary": deposited("potdem/hertz", BALL, ACROSS),
    "deposit grains into an empty box": deposited("potdem/hertz", BALL, INSIDE, ""),
    "deposit grains into an empty box, across its boundary": deposited("potdem/truss", BALL, ACROSS, ""),
    "deposit bodies, area factor": deposited_bodies("factor 0.5"),
    "deposit bodies, area lattice": deposited_bodies("lattice"),
    "deposit bodies, area body": deposited_bodies("body"),
    "deposit bodies, nu": deposited_bodies("nu 0.1 area body"),
    "create_atoms between runs": Event(
        packed(0.8), MOVE, "run 20\ncreate_atoms 1 single 0.05 0.05 0.05 units box\n"
        "set atom 126 diameter 1.2 density 1\nrun 1\n", every(more("Atoms"), more("E_vdwl"))),
    # growth
    **{f"fix adapt of diameters, {law}": grown(law) for law in LAWS},
    "fix adapt of diameters of particles at rest": grown("potdem/hertz", "velocity all set 0 0 0\n" + REST, 0.05),
    "fix adapt of diameters now and then": grown("potdem/hertz", period=7),
    "fix adapt of diameters of a bonded body": Event(
        replaced(torn(0.7, skin=0.05), "bpm/sphere", "bpm/sphere 1"), BREAKING,
        "variable d equal 0.7+0.01*step\nfix grow all adapt 1 atom diameter v_d\nrun 30\n",
        every(more("c_radii"), at_the_last_step("f_fail"), more("E_vdwl"))),
    "set diameters between runs": Event(packed(0.8), MOVE, "run 5\nset group all diameter 1.2\nrun 5\n",
                                        every(more("c_radii"), more("E_vdwl"))),
    # deletion
    "delete_atoms between runs": Event(
        packed(), MOVE, "run 20\nregion gone sphere 0 0 0 1.6 units box\n"
        "delete_atoms region gone compress no\nrun 1\n", every(fewer("Atoms"), changed("E_vdwl"))),
    "delete_atoms from a body": Event(
        torn(), BREAKING, "run 20\nregion gone block 0 1 0 1 0 1 units box\n"
        "delete_atoms region gone bond yes compress no\nrun 1\n", every(fewer("Atoms"), fewer("Bonds"))),
    "fix evaporate in a run": Event(packed(), MOVE, "fix gone all evaporate 5 3 box 4711\nrun 21\n", fewer("Atoms")),
    "fix evaporate of bonded bodies": Event(
        TWO_BODIES, MOVE + UNBROKEN, "fix gone all evaporate 7 1 box 4711 molecule yes\nrun 7\n",
        every(fewer("Atoms"), fewer("Bonds"))),
    # minimisation
    **{f"minimise a body, {style}": minimised(style) for style in ("cg", "fire", "quickmin")},
    "minimise grains": minimised("cg", packed(skin=0.02)),
    "fix box/relax": minimised("cg", relax="fix relax all box/relax iso 20 vmax 0.002", happened=changed("Volume"),
                               displaced=0.02),
    # the box
    "change_box of a body": Event(periodic_body(), MOVE + UNBROKEN,
                                  "run 5\nchange_box all x scale 1.02 remap\nrun 5\n",
                                  every(more("Volume"), more("E_bond"))),
    "change_box of grains": Event(packed(), MOVE, "run 5\nchange_box all x scale 0.97 remap\nrun 5\n",
                                  every(fewer("Volume"), changed("E_vdwl"))),
    # (fix deform moves the particles after the forces of its steps: the last of them is five steps back)
    "fix deform of a body": Event(periodic_body(), MOVE + UNBROKEN,
                                  "fix d all deform 10 x erate 0.5 remap x\nrun 45\n",
                                  every(more("Volume"), more("E_bond"))),
    "fix deform of grains": Event(packed(), MOVE, "fix d all deform 10 x erate -0.5 remap x\nrun 45\n",
                                  every(fewer("Volume"), changed("E_vdwl"))),
    # ranks and order
    "balance between runs": Event(CORNER, MOVE + UNBROKEN, "velocity all ramp vx -2 2 x 2 6 units box\nrun 5\n"
                                  "balance 1.0 shift xyz 20 1.0\nrun 5\n", balanced),
    "fix balance in a run": Event(CORNER, MOVE + UNBROKEN, "velocity all ramp vx -2 2 x 2 6 units box\n"
                                  "fix bal all balance 5 1.0 shift xyz 20 1.0\n"
                                  f"thermo_style custom step {BODY_TOTALS} f_bal f_bal[3]\n"
                                  f"thermo_modify format float {scripts.ALL_DIGITS}\nrun 23\n",
                                  balanced_in_the_run),
    "atoms are sorted at every rebuild": Event(
        "atom_modify sort 1 1.5\n".join(["", packed(skin=0.02)]), MOVE, "run 40\n", at_the_last_step("PotEng")),
    # failure
    "bonds fail that overlap": Event(torn(1.2), BREAKING, "run 30\n",
                                     every(at_the_last_step("f_fail"), more("E_vdwl"))),
    "bonds fail that do not overlap": Event(torn(0.7), BREAKING, "run 30\n", at_the_last_step("f_fail")),
    "bonds fail of a solid with another nu": Event(torn(0.7, area="nu 0.4 area body"), BREAKING, "run 30\n", at_the_last_step("f_fail")),
    "bonds fail within reach of lj": Event(
        replaced(torn(0.7), "potdem/truss\npair_coeff * * 1000 0.5", "potdem/lj\npair_coeff * * 300 0.5 3 0.2"), BREAKING,
        "run 30\n", every(at_the_last_step("f_fail"), changed("E_vdwl"))),
    "bonds fail that overlap, sorted at every rebuild": Event(
        "atom_modify sort 1 1.5\n".join(["", torn(1.2, skin=0.05)]), BREAKING, "run 30\n",
        every(at_the_last_step("f_fail"), more("E_vdwl"))),
    "bonds fail that overlap, balanced": Event(
        torn(1.2, skin=0.05), BREAKING, "fix bal all balance 5 1.0 shift xyz 20 1.0\nrun 33\n",
        every(more("f_fail"), more("E_vdwl"))),
    "bonds fail that overlap, in tiled domains": Event(
        torn(1.2, skin=0.05), "comm_style tiled\n" + BREAKING, "fix bal all balance 5 1.0 rcb\nrun 33\n",
        every(more("f_fail"), more("E_vdwl"))),
    "bonds fail that overlap, then a second run": Event(torn(1.2), BREAKING, "run 30\nrun 4\n",
                                                        every(more("f_fail"), more("E_vdwl"))),
    # bonding anew
    "potdem_bonds where bonds failed that overlap": Event(
        torn(1.2), BREAKING, "run 30\npotdem_bonds all 1 1.7\nrun 5\n", bonded_anew),
    "potdem_bonds on a damaged body": Event(
        torn(0.7), BREAKING, "run 30\npotdem_bonds all 1 1.7\nrun 5\n", bonded_anew),
    "create_bonds on a damaged body": Event(
        torn(0.7), BREAKING, "run 30\nneighbor 1.2 bin\ncreate_bonds many all all 1 0.5 1.7\nrun 5\n", bonded_anew),
    # coefficients
    "fix adapt of a bond's E": Event(
        ruined(), BREAKING, "variable e equal 1000*(1-step/200)\n"
        "fix change all adapt 1 bond potdem/truss E * v_e\nrun 30\n", more("f_fail")),
    "fix adapt of a pair's E": Event(
        packed(), MOVE, "variable e equal 1000*(1-step/60)\n"
        "fix change all adapt 1 pair potdem/hertz E * * v_e\nrun 30\n", fewer("E_vdwl")),
    "friction that begins during the run": Event(
        packed(law=RUBBING) + "pair_coeff * * 1000 0.3 friction 0 2\n", REST, "variable mu equal 0.01*step\n"
        "fix change all adapt 1 pair potdem/hertz mu * * v_mu\nrun 20\n", at_the_last_step("E_vdwl")),
    "bond_coeff between runs": Event(
        torn(0.7, "factor 0.5"), BREAKING, "run 30\nbond_coeff * 700 area factor 0.6\nrun 5\n", more("f_fail")),
    "bond_coeff between runs, area lattice": Event(
        ruined(), BREAKING, "run 30\nbond_coeff * 1000 area lattice\nrun 5\n", more("f_fail")),
    "bond_coeff after the restart, area lattice": Event(
        ruined(), BREAKING, "run 30\n", more("f_fail"), again="bond_coeff * 1000 area lattice\n"),
    # neighbour lists
    "a larger skin between runs": Event(packed(), MOVE, "run 10\nneighbor 0.7 bin\nrun 10\n", changed("E_vdwl")),
    "a larger skin after the restart": Event(torn(0.7), BREAKING, "run 30\n", more("f_fail"),
                                             again="neighbor 0.9 bin\n"),
    "a smaller skin after the restart": Event(torn(0.7), BREAKING, "run 30\n", more("f_fail"),
                                              again="neighbor 0.1 bin\n"),
}


# --- the test ----------------------------------------------------------------------------------------------

BALL_FILE = scripts.ball(1)


def cube_file():
    """27 spheres on a cubic lattice, bonded up to twice their distance"""
    sites = list(itertools.product((-1, 0, 1), repeat=3))
    pairs = [(i, j) for i, j in itertools.combinations(range(27), 2) if math.dist(sites[i], sites[j]) < 2.1]
    rows = {
        "Coords": [f"{x} {y} {z}" for x, y, z in sites],
        "Types": 27 * ["1"],
        "Diameters": 27 * ["1"],
        "Masses": 27 * ["1"],
        "Bonds": [f"1 {i + 1} {j + 1}" for i, j in pairs],
    }
    text = f"# a bonded cube\n\n27 atoms\n{len(pairs)} bonds\n"
    for name, lines in rows.items():
        text += f"\n{name}\n\n" + "".join(f"{k} {line}\n" for k, line in enumerate(lines, start=1))
    return text


def go_on(run_lammps, tmp_path, event, nprocs):
    bonded = "bond_style potdem" in event.world
    (tmp_path / "ball.mol").write_text(BALL_FILE)
    (tmp_path / "cube.mol").write_text(cube_file())
    script = event.world + event.settings + instruments(bonded, event.columns)
    script += event.act + write_state(bonded) + f"write_restart {RESTART}\n"
    run = run_lammps(script, nprocs=nprocs)
    first, last = ({name: values[k] for name, values in run.thermo.items()} for k in (0, -1))
    assert event.happened(run, first, last), "the event did not happen"
    return read_state(run, tmp_path, bonded)


def set_up_anew(run_lammps, tmp_path, event, nprocs):
    """and a restart file for the next number of ranks"""
    bonded = "bond_style potdem" in event.world
    skin = re.search(r"^neighbor .*\n", event.world, re.MULTILINE).group()
    script = f"read_restart {RESTART}\n" + skin + event.again + event.settings + instruments(bonded) + "run 0\n"
    run = run_lammps(script + write_state(bonded) + f"write_restart {RESTART}\n", nprocs=nprocs)
    return read_state(run, tmp_path, bonded)


@pytest.mark.parametrize("chain", CHAINS, ids=lambda chain: "-".join(map(str, chain)))
@pytest.mark.parametrize("event", EVENTS.values(), ids=EVENTS.keys())
def test_to_go_on_is_to_set_up_anew(run_lammps, tmp_path, event, chain):
    going = go_on(run_lammps, tmp_path, event, chain[0])
    for nprocs in chain[1:]:
        assert_same(going, set_up_anew(run_lammps, tmp_path, event, nprocs))


# --- runs that leave the set-up out ---------------------------------------------------------------------------

BEAM = block() + scripts.velocities_by_formula(2.0) + MOVE + "region floor plane 0 0 -0.2 0 0 1 units box\n" + UNBROKEN
WALL = "fix wall all potdem/wall/region floor law truss 1000 0.5\n"
# what happens between two runs: before the first, between
CHANGES = {
    "another pair style": ("", "pair_style potdem/hertz\npair_coeff * * 1000 0.3\n"),
    "no pair style": ("", "pair_style none\n"),
    "the bond style anew": ("", "bond_style potdem/truss\nbond_coeff * 500 area lattice\n"),
    "a wall": ("", WALL),
    "no wall any more": (WALL, "unfix wall\n"),
    "damping": ("", "fix damp all potdem/damping 0.5\n"),
    "no damping any more": ("fix damp all potdem/damping 0.5\n", "unfix damp\n"),
    "a lower strength": ("", "unfix fail\nfix fail all potdem/failure 1 tension 20\n"),
    "an adaptive step": ("", "fix step all potdem/timestep 2 0.1 max 0.01\n"),
}


@pytest.mark.parametrize("before, between", CHANGES.values(), ids=CHANGES.keys())
def test_a_style_that_comes_or_goes_is_set_up_without_being_asked_for(run_lammps, before, between):
    """LAMMPS leaves the set-up out with 'pre no', and trusts that nothing has changed"""
    script = BEAM + before + "thermo 10\nthermo_style custom step ke pe ebond bonds dt\n" \
        f"thermo_modify format float {scripts.ALL_DIGITS}\nrun 20\n" + between + "run 60"
    asked, not_asked = (run_lammps(script + more).thermo for more in ("\n", " pre no\n"))
    assert asked["KinEng"][-1] > 0
    for name, values in asked.items():
        assert np.array_equal(not_asked[name], values), name


def test_nothing_is_set_up_where_nothing_has_changed(run_lammps):
    """LAMMPS counts the neighbour lists that a run builds, without those of set-up; and says when it sets up"""
    run = run_lammps(BEAM + "run 5\nrun 5 pre no\n")
    assert run.stdout.count("Setting up Verlet run") == 1
