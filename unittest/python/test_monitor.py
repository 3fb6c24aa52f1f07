# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""What a run says when it goes wrong: one warning for each reason, and none where nothing is wrong."""

import itertools
import re

import pytest

from potdem import formulas, scripts
from potdem.text import replaced

NAMES = {
    "critical": "is longer than the critical step",
    "contact": "The contact of",
    "bond": "The bond of",
    "crushed bond": "The crushed bond of",
    "deep": "too deep",
    "crushed": "is crushed to",
    "fast": "contacts may be missed",
    "skin": "The neighbour skin",
    "minimiser": "in one step of this minimisation",
}


def warnings(run):
    """those of this package"""
    return re.findall(r"^WARNING: (.*?) \(\S*fix_potdem_monitor.cpp:\d+\)$", run.log, re.MULTILINE)


def kinds(run):
    found = [name for text in warnings(run) for name, words in NAMES.items() if words in text]
    assert len(found) == len(warnings(run))
    return sorted(found)


def chain(more, step, steps=10, bonds="factor 0.5", E=1000.0, spacing=1.0, count=3):
    rows = [(k * spacing, 0, 0, 1.0) for k in range(count)]
    text = scripts.box(40) + scripts.particles(rows) + "set group all mass 1\n" + scripts.elastic(E, bonds, "", 0.5)
    return text + f"potdem_bonds all 1 1.1\n{more}\nfix move all nve\ntimestep {step:.17g}\nrun {steps}\n"


# k = E A / d of a bond; the middle one of three particles sets the bound: 4 k / m
STIFFNESS = 1000.0 * formulas.section(1.0, 0.5)
BOUND = 2 / (4 * STIFFNESS) ** 0.5


@pytest.mark.parametrize("factor, expected", [(0.999, False), (1.001, True)])
def test_the_critical_step(run_lammps, factor, expected):
    run = run_lammps(chain("", factor * BOUND))
    assert ("critical" in kinds(run)) == expected
    if expected:
        text = next(text for text in warnings(run) if NAMES["critical"] in text)
        assert f"{BOUND:g} of" in text and "atom 2 sets it" in text and "step 0" in text


def test_particles_that_are_held_set_no_step(run_lammps):
    script = chain("group ends id 1 3\nset group ends mass 1e-6", 0.5 * BOUND)
    assert "critical" in kinds(run_lammps(script))
    # two bonds and no partner that moves: omega^2 = 2 k / m over the middle one's share in the bound
    held = replaced(script, "fix move all nve", "group middle id 2\nfix move middle nve")
    assert kinds(run_lammps(replaced(held, "mass 1e-6", "mass 1"))) == []


def test_nothing_is_said_of_a_run_of_no_steps_or_a_minimization(run_lammps):
    script = replaced(chain("", 10 * BOUND), "run 10", "run 0\nminimize 0 1e-6 5 5")
    assert kinds(run_lammps(script)) == []


def test_once_in_each_run(run_lammps):
    run = run_lammps(replaced(chain("", 1.1 * BOUND, 3000), "run 3000", "run 2\nrun 2"))
    assert kinds(run) == ["bond", "bond", "critical", "critical"]


def test_a_step_that_becomes_too_long(run_lammps):
    """bonds that stiffen: the bond itself is seen when it does, the critical step at the next check, each 1000 steps"""
    stiffen = "variable E equal 1000*(1+15*(step>500))\nfix stiffen all adapt 1 bond potdem/truss E * v_E"
    run = run_lammps(chain(stiffen, 0.3 * BOUND, 1500))
    assert kinds(run) == ["bond", "critical"]
    assert any("step 1000" in text and NAMES["critical"] in text for text in warnings(run))


# --- pairs and walls --------------------------------------------------------------------------------------------------

def collision(law, coeff, speed, step, steps=60, gap=0.02):
    rows = [(0, 0, 0, 1.0), (1.0 + gap, 0, 0, 1.0)]
    return scripts.box(40) + scripts.particles(rows) + f"""
set group all mass 1
set atom 2 vx {-speed}
pair_style potdem/{law}
pair_coeff * * {coeff}
fix move all nve
timestep {step:.17g}
run {steps}
"""


# half a period of a truss contact near first touch, k = E A / d, with two masses of 1
HALF_PERIOD = 3.14159265 / (2 * STIFFNESS) ** 0.5


@pytest.mark.parametrize("steps, expected", [(5.5, ["contact"]), (6.5, [])])
def test_a_contact_too_stiff_for_the_step(run_lammps, steps, expected):
    run = run_lammps(collision("truss", "1000 0.5", 0.1, HALF_PERIOD / steps))
    assert kinds(run) == expected
    if expected:
        assert "atoms 1 and 2" in warnings(run)[0] or "atoms 2 and 1" in warnings(run)[0]


def test_only_with_what_moves(run_lammps):
    """a wall of held particles: the other mass does not count"""
    script = collision("truss", "1000 0.5", 0.1, HALF_PERIOD / 5.5)
    assert kinds(run_lammps(replaced(script, "fix move all nve", "group one id 2\nfix move one nve"))) == []


def test_a_step_that_grows(run_lammps):
    """fix dt/reset changes the step during the run"""
    script = replaced(collision("truss", "1000 0.5", 0.5, HALF_PERIOD / 500, 2000, gap=0.2), "run 2000", f"fix longer all dt/reset 1 NULL {HALF_PERIOD / 4:.17g} 0.01\nrun 2000")
    assert kinds(run_lammps(script)) == ["contact"]


@pytest.mark.parametrize("law, coeff", [("hertz", "30 0.2"), ("truss", "30 0.5"), ("lj", "10 0.2 2 0.2 linear 0.19"),
                                        ("granular", "10 4 0.2 linear 0.9")])
def test_too_deep(run_lammps, law, coeff):
    assert "deep" in kinds(run_lammps(collision(law, coeff, 8.0, 0.002, 400)))
    assert "deep" not in kinds(run_lammps(collision(law, coeff, 0.1, 0.002, 400)))


@pytest.mark.parametrize("diameter", [0.01, 100.0])
def test_too_deep_at_any_size(run_lammps, diameter):
    """a quarter of the diameter apart, which is no length of 1"""
    script = scripts.box(20 * diameter, skin=0.1 * diameter) + scripts.particles([(0, 0, 0, diameter), (0.25 * diameter, 0, 0, diameter)])
    script += "pair_style potdem/hertz\npair_coeff * * 1e-3 0.2\nfix move all nve\ntimestep 1e-9\nrun 1\n"
    assert kinds(run_lammps(script)) == ["deep"]


def test_too_fast(run_lammps):
    """particles pass each other between two steps"""
    run = run_lammps(collision("truss", "1000 0.5", 1.0, 3.2, 1, gap=0.6))
    assert kinds(run) == ["fast"]
    assert "Atom 2 moves 6.4 times its radius" in warnings(run)[0]


def on_wall(step, speed, wall="1000 0.2 particle 1000 0.2 layer none", steps=100):
    return scripts.box(20) + scripts.particles([(0, 0, 0.52, 1.0)]) + f"""
set group all mass 1
set group all vz {-speed}
pair_style zero 1.0
pair_coeff * *
region floor plane 0 0 0 0 0 1 units box
fix floor all potdem/wall/region floor {wall}
fix move all nve
timestep {step}
run {steps}
"""


def test_walls(run_lammps):
    assert kinds(run_lammps(on_wall(1e-3, 0.1))) == []
    run = run_lammps(on_wall(0.08, 1.0))
    assert kinds(run) == ["contact"] and "wall floor" in warnings(run)[0]
    run = run_lammps(on_wall(1e-3, 30.0), expect_error="has passed the wall")
    assert kinds(run) == ["deep"]


# --- bonds --------------------------------------------------------------------------------------------------------------

@pytest.mark.parametrize("steps, expected", [(5.5, ["bond"]), (6.5, [])])
def test_a_bond_too_stiff_for_the_step(run_lammps, steps, expected):
    assert kinds(run_lammps(chain("", HALF_PERIOD / steps, count=2))) == expected


@pytest.mark.parametrize("options, expected", [("", ["crushed"]), ("penetration 6", ["crushed bond"])])
def test_crushed_bonds(run_lammps, options, expected):
    """without the factor nothing holds it any more; with it the bond is much stiffer than at rest"""
    script = replaced(chain("run 0\nset atom 2 x 0.1\n", 0.01, count=2), "area factor 0.5", f"area factor 0.5 {options}")
    assert kinds(run_lammps(script)) == expected
    assert kinds(run_lammps(replaced(replaced(script, "x 0.1", "x 0.5"), "timestep 0.01", "timestep 0.001"))) == []


# 3 x 3 x 3 particles, number 14 in the middle and 13 below it
CUBE = scripts.box(20, room=30) + scripts.particles([(*place, 1.0) for place in itertools.product((-1, 0, 1), repeat=3)]) + scripts.elastic(
    1000.0, "factor 0.5", contact=0.5) + "potdem_bonds all 1 1.42\nfix move all nve\ntimestep 1e-6\n"


@pytest.mark.parametrize("width", ["plain", "avx2"])
def test_a_crushed_bond_among_many(run_lammps, monkeypatch, width):
    """also where bonds are taken four at a time: one is a tenth as long as it was, the others of its ends are not so short"""
    monkeypatch.setenv("POTDEM_WIDTH", width)
    assert kinds(run_lammps(CUBE + "run 0\nset atom 14 z -0.9\nrun 3\n")) == ["crushed"]
    run_lammps(CUBE + "run 0\nset atom 14 z -1\nrun 3\n", expect_error="has length 0")


@pytest.mark.parametrize("width", ["plain", "avx2"])
def test_four_crushed_bonds_at_once(run_lammps, monkeypatch, width):
    """the only ones that there are, of one particle"""
    monkeypatch.setenv("POTDEM_WIDTH", width)
    star = scripts.box(20, room=30) + scripts.particles([(0, 0, 0, 1.0), (1, 0, 0, 1.0), (-1, 0, 0, 1.0), (0, 1, 0, 1.0), (0, -1, 0, 1.0)])
    star += scripts.elastic(1000.0, "factor 0.5", contact=0.5) + "potdem_bonds all 1 1.1\nfix move all nve\ntimestep 1e-6\nrun 0\n"
    star += "".join(f"displace_atoms all ramp {axis} 0.9 -0.9 {axis} -1 1 units box\n" for axis in "xy")
    assert "crushed" in kinds(run_lammps(star + "run 1\n"))


# --- ranks, threads, switching off ------------------------------------------------------------------------------------

@pytest.mark.parametrize("place", [-8.0, 8.0])
def test_the_log_has_what_another_rank_has_seen(run_lammps, place):
    script = replaced(collision("truss", "1000 0.5", 0.1, HALF_PERIOD / 5.5), "pair_style", f"displace_atoms all move {place} 0 0 units box\npair_style")
    run = run_lammps(replaced(script, "boundary f f f", "boundary f f f\nprocessors 2 1 1"), nprocs=2)
    assert kinds(run) == ["contact"]


@pytest.mark.parametrize("script", [collision("truss", "1000 0.5", 0.1, HALF_PERIOD / 5.5), chain("", HALF_PERIOD / 5.5, count=2)])
def test_threads(run_lammps, script):
    usual = kinds(run_lammps(script))
    assert len(usual) == 1
    assert kinds(run_lammps("package omp 2\nsuffix omp\n" + script)) == usual


def test_lammps_can_hush_it(run_lammps):
    script = chain("thermo_modify warn ignore", 1.1 * BOUND)
    assert kinds(run_lammps(script)) == []


# --- the laws continued straight ----------------------------------------------------------------------------------------

@pytest.mark.parametrize("law, coeff", [("lj", "1000 0.2 2 0.2"), ("granular", "1000 4 0.2")])
def test_a_bounded_law_survives_what_the_law_itself_does_not(run_lammps, law, coeff):
    """placed beyond r0"""
    script = collision(law, coeff, 0.0, 1e-5, 10, gap=-0.3)
    run_lammps(script, expect_error="not beyond the smallest distance")
    ends = {"lj": "linear 0.1", "granular": "linear 0.5"}[law]
    assert kinds(run_lammps(replaced(script, coeff, f"{coeff} {ends}"))) == []


def test_a_bounded_law_at_a_wall(run_lammps):
    wall = "law granular 10 4 0.2"
    script = replaced(on_wall(1e-4, 0.0, wall, 5), "0.52", "0.38")    # r0 = 0.4
    run_lammps(script, expect_error="not beyond the smallest distance 0.4")
    assert kinds(run_lammps(replaced(script, wall, f"{wall} linear 0.5"))) == []


def force_of(run_lammps, law, first, second, explicit=""):
    rows = [(0, 0, 0, 1.0, 1), (0.82, 0, 0, 1.0, 2)]
    script = scripts.box(20, types=2) + scripts.particles(rows) + f"""
pair_style potdem/{law}
pair_coeff 1 1 {first}
pair_coeff 2 2 {second}
{explicit and f'pair_coeff 1 2 {explicit}'}
run 0
""" + scripts.result("fx[2]", "pe")
    return scripts.results(run_lammps(script).stdout)[-1]


@pytest.mark.parametrize("law, one, other, mixed", [
    ("lj", "100 0.2 2 0.2 linear 0.1", "300 0.2 2 0.2 linear 0.16", "150 0.2 2 0.2 linear 0.13"),
    ("lj", "100 0.2 2 0.2 linear 0.1", "300 0.2 2 0.2", "150 0.2 2 0.2"),
    ("granular", "100 4 0.2 linear 0.5", "300 4 0.2 linear 0.9", "150 4 0.2 linear 0.9"),
    ("granular", "100 4 0.2", "300 4 0.2 linear 0.9", "150 4 0.2"),
])
def test_mixed_ends(run_lammps, law, one, other, mixed):
    """s = 0.02: far in the straight part, if there is one"""
    assert force_of(run_lammps, law, one, other) == pytest.approx(force_of(run_lammps, law, one, other, mixed), rel=1e-12)


# --- settings that do not fit the particles -------------------------------------------------------------------------

SPECIAL = "special_bonds lj 0 1 1 coul 0 1 1\n"


@pytest.mark.parametrize("skin, expected", [(0.5, []), (0.51, ["skin"])])
def test_a_skin_larger_than_half_the_smallest_diameter(run_lammps, skin, expected):
    """with the line that helps; the smallest of two diameters, 1 and 3, counts"""
    script = scripts.box(40, newton="on off") + SPECIAL + scripts.particles([(0, 0, 0, 1.0), (9, 0, 0, 3.0)]) + scripts.elastic()
    script = replaced(script, "neighbor 0.3 bin", f"neighbor {skin} bin") + "fix move all nve\ntimestep 1e-6\nrun 1\n"
    run = run_lammps(script)
    assert kinds(run) == expected
    if expected:
        helps = re.search(r"'(neighbor .*)'", warnings(run)[0]).group(1)
        assert kinds(run_lammps(replaced(script, f"neighbor {skin} bin", helps))) == []
    assert kinds(run_lammps(replaced(script, "run 1", "run 0"))) == []


@pytest.mark.parametrize("least, expected", [(0.2, []), (0.19, ["minimiser"])])
def test_a_step_of_a_minimiser_longer_than_a_radius(run_lammps, least, expected):
    """dmax is 0.1, whatever the units, unless min_modify comes after min_style"""
    script = scripts.box(40, newton="on off") + SPECIAL + scripts.particles([(0, 0, 0, least), (9, 0, 0, 3.0)]) + scripts.elastic()
    script += "min_modify dmax 0.001\nmin_style cg\nminimize 0 1e-6 5 5\n"
    run = run_lammps(script)
    assert kinds(run) == expected
    if expected:
        helps = re.search(r"'(min_modify .*)'", warnings(run)[0]).group(1)
        assert kinds(run_lammps(replaced(script, "minimize", f"{helps}\nminimize"))) == []


BLOCK = scripts.box(12, newton="on off") + SPECIAL + scripts.particles([(k, 0, 0, 1.0) for k in range(3)] + [(4, 0, 0, 1.0)])


@pytest.mark.parametrize("bonded", [False, True])
@pytest.mark.parametrize("rotation", ["no", "yes"])
@pytest.mark.parametrize("friction", ["", "friction 0.5 auto"])
def test_bonded_particles_that_spin(run_lammps, bonded, rotation, friction):
    """a body rolls away on particles that spin: by pairs and by walls, with friction, and only where there is a body"""
    script = BLOCK + replaced(scripts.elastic(pair_options=friction), "potdem/truss\npair", f"potdem/truss rotation {rotation}\npair")
    script += "potdem_bonds all 1 1.1\n" if bonded else ""
    script += f"region floor plane 0 0 -1 0 0 1\nfix move all nve\nfix wall all potdem/wall/region floor 5 0.3 particle 5 0.3 "
    script += f"{friction} rotation {rotation}\ntimestep 1e-6\nrun 1\n"
    said = re.findall(r"WARNING: (.*?): rotation lets bonded particles spin freely", run_lammps(script).log)
    expected = bonded and rotation == "yes" and friction
    assert said == (["pair_style potdem/truss", "Fix potdem/wall/region wall"] if expected else [])


def test_bonded_particles_that_a_wall_does_not_touch(run_lammps):
    """the wall's own group counts"""
    script = BLOCK + scripts.elastic() + "potdem_bonds all 1 1.1\ngroup grain id 4\nregion floor plane 0 0 -1 0 0 1\n"
    script += "fix move all nve\nfix wall grain potdem/wall/region floor 5 0.3 particle 5 0.3 friction 0.5 auto rotation yes\n"
    assert "spin freely" not in run_lammps(script + "timestep 1e-6\nrun 1\n").log


def growing(jump, skin=0.3):
    """two particles 1.05 apart, their diameters 1, then 1 + jump from the third step on"""
    text = scripts.box(12, atom_style="sphere 1", skin=skin, bond_types=0)
    text += scripts.particles([(0, 0, 0, 1.0), (1.05, 0, 0, 1.0)]) + f"""
pair_style potdem/truss
pair_coeff * * 1000 0.5
variable d equal 1+{jump}*(step>2)
fix grow all adapt 1 atom diameter v_d
fix hold all nve/noforce
timestep 1e-6
thermo 1
thermo_style custom step pe
thermo_modify format float %.17g
run 4
"""
    return text


@pytest.mark.parametrize("jump, warned", [(0.25, False), (0.35, True)])
def test_diameters_that_grow_by_more_than_the_skin_in_one_step(run_lammps, jump, warned):
    """both are in the list already, so the contact is seen; another one might not be"""
    run = run_lammps(growing(jump))
    assert ("contacts may have been missed on step 3" in run.log) == warned
    assert (run.thermo["PotEng"] > 0).tolist() == [False, False, False, True, True]
