# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Bonds that fail: when, with what energy, and what is left between the two particles."""

import math
import re

import numpy as np
import pytest

from potdem import dumps, formulas, scripts
from potdem.text import replaced

E, A = 1000.0, 0.5
MODULUS = E * formulas.section(1.0, A)    # A E of two particles of diameter 1
MASS = formulas.sphere_mass(1.0)
COLUMNS = ("step", "time", "tag1", "tag2", "x", "y", "z", "strain", "energy", "contact")


def pair_script(failure, distance=1.0, speed=(0.0, 0.0), bond="", step=1e-4, every=1, group="all"):
    """two bonded particles on the x axis with a speed each, positive to the right; thermo each step"""
    return scripts.box(20) + scripts.particles([(0, 0, 0, 1.0), (distance, 0, 0, 1.0)]) + scripts.elastic(
        E, f"factor {A}", bond, A) + f"""
potdem_bonds all 1 {1.1 * distance:.17g}
group one id 1
group two id 2
velocity one set {speed[0]:.17g} 0 0
velocity two set {speed[1]:.17g} 0 0
fix move all nve
fix failure {group} potdem/failure 1 {failure}
timestep {step:.17g}
variable r equal x[2]-x[1]
variable f equal fx[2]
thermo {every}
thermo_style custom step v_r v_f pe ke etotal ebond evdwl f_failure f_failure[1] f_failure[2] f_failure[3] bonds
thermo_modify format float {scripts.ALL_DIGITS}
dump events all local 1 events.dump index f_failure[*]
dump_modify events format float {scripts.ALL_DIGITS}
"""


def events(tmp_path):
    """rows of the last snapshot of the events as dictionaries"""
    table = dumps.read(tmp_path / "events.dump")[-1]
    count = len(table["index"])
    return [{name: table[f"f_failure[{k}]"][row] for k, name in enumerate(COLUMNS, 1)} for row in range(count)]


def stress(r, length=1.0, m=0, normalized=False):
    """E c eps of the bond"""
    return formulas.truss_tension(r / length, E, m, normalized)


@pytest.mark.parametrize("bond, m, normalized", [("", 0, False), ("penetration 2", 2, False),
                                                 ("penetration 3 normalized", 3, True)])
def test_fails_at_the_strength_and_not_before(run_lammps, tmp_path, bond, m, normalized):
    """pulled apart at a steady speed: the bond holds on the step where the stress reaches ft and is gone on the next"""
    strength = 80.0
    script = pair_script(f"tension {strength}", speed=(-2.0, 2.0), bond=bond)
    run = run_lammps(script + "fix hold all setforce 0 0 0\nrun 400\n")
    r, broken = run.thermo["v_r"], run.thermo["f_failure"]
    sigma = stress(r, m=m, normalized=normalized)
    first = int(np.argmax(sigma >= strength))
    assert 0 < first < 398
    assert np.all(broken[:first + 1] == 0) and np.all(broken[first + 1:] == 1)
    assert np.all(run.thermo["Bonds"] == 1 - broken)
    assert np.all(run.thermo["E_bond"][first + 1:] == 0) and np.all(run.thermo["E_vdwl"] == 0)
    (event,) = events(tmp_path)
    x = r[first + 1]    # where the two are when the bond is taken out
    assert event["step"] == first + 1
    assert event["time"] == pytest.approx((first + 1) * 1e-4, rel=1e-12)
    assert {event["tag1"], event["tag2"]} == {1, 2}
    assert (event["x"], event["y"], event["z"]) == pytest.approx((0.5, 0, 0), abs=1e-12)
    assert event["strain"] == pytest.approx(0.5 * (x * x - 1), rel=1e-12)
    # the mean over the step in between: the bond's force acts for its first half (velocity Verlet)
    expected = np.mean([formulas.truss_energy(k, 1.0, MODULUS, m, normalized) for k in (r[first], x)])
    assert event["energy"] == pytest.approx(expected, rel=1e-10)
    assert event["contact"] == 0.0
    assert run.thermo["f_failure[1]"][-1] == event["energy"]
    assert (run.thermo["f_failure[2]"][-1], run.thermo["f_failure[3]"][-1]) == (1, 0)


@pytest.mark.parametrize("failure, speed, vector", [("tension 80", 2.0, (1, 0)), ("compression 80", -2.0, (0, 1)),
                                                    ("tension 80 compression 80", -2.0, (0, 1)),
                                                    ("compression 80", 2.0, (0, 0)), ("tension 80", -2.0, (0, 0))])
def test_each_strength_acts_on_its_side(run_lammps, failure, speed, vector):
    run = run_lammps(pair_script(failure, speed=(-speed, speed)) + "fix hold all setforce 0 0 0\nrun 600\n")
    assert (run.thermo["f_failure[2]"][-1], run.thermo["f_failure[3]"][-1]) == vector
    assert run.thermo["f_failure"][-1] == sum(vector)


def imbalance(thermo):
    """range of total energy + fracture energy, relative. All is of second order in the step: (omega dt)^2/8 is
    1e-6 at the step of 5e-5 used here"""
    total = thermo["TotEng"] + thermo["f_failure[1]"]
    return np.ptp(total) / total[0]


def test_energy_balance_of_a_free_pair(run_lammps):
    """total energy + fracture energy is constant; later contact is with compression only and elastic.
    They are thrown together after the failure, so that they collide at the mean diameter."""
    script = pair_script("tension 80", speed=(-3.0, 3.0), step=5e-5, every=4) + "run 1000\n"
    script += "velocity one set 3 0 0\nvelocity two set -3 0 0\nrun 3000\n"
    run = run_lammps(script)
    step, r, force = run.thermo["Step"], run.thermo["v_r"], run.thermo["v_f"]
    assert run.thermo["f_failure"][-1] == 1
    assert imbalance({name: values[step <= 1000] for name, values in run.thermo.items()}) < 5e-6
    collision = run.thermo["TotEng"][step > 1000]
    assert np.ptp(collision) < 2e-6 * collision[0]
    late = run.thermo["Bonds"] == 0
    assert np.all(force[late & (r >= 1.0)] == 0.0)
    assert np.any(late & (r < 1.0))
    touching = late & (r < 1.0)
    assert force[touching] == pytest.approx(-formulas.truss_tension(r[touching], MODULUS), rel=1e-9, abs=1e-9 * MODULUS)


def overlapping(run_lammps, tmp_path, failure, speed, steps=6000, bond="", distance=0.8):
    """two particles bonded at 0.8 of their diameter, so that they overlap while the bond fails"""
    run = run_lammps(pair_script(failure, distance, speed, bond, step=5e-5, every=4) + f"run {steps}\n")
    return run, events(tmp_path)


def test_energy_balance_is_second_order_in_the_step(run_lammps):
    """a quarter of the step leaves a sixteenth of the error; a tenth is asked for, as the step on which the bond
    fails falls differently"""
    def error(dt):
        steps = int(round(0.05 / dt))
        script = pair_script("tension 80", speed=(-3, 3), step=dt, every=steps)
        return imbalance(run_lammps(script + f"run {steps}\n").thermo)

    assert error(1e-4) < 0.1 * error(4e-4)


@pytest.mark.parametrize("failure, speed", [("tension 60", (-3.0, 3.0)), ("compression 60", (3.0, -3.0))])
def test_failure_of_an_overlapping_pair_injects_no_energy(run_lammps, tmp_path, failure, speed):
    """the contact that replaces the bond starts from zero force and energy at the distance of failure"""
    run, rows = overlapping(run_lammps, tmp_path, failure, speed)
    assert len(rows) == 1
    contact = rows[0]["contact"]
    assert contact < 1.0    # it did overlap
    assert contact == pytest.approx(np.sqrt(2 * rows[0]["strain"] + 1) * 0.8, rel=1e-12)
    assert imbalance(run.thermo) < 5e-6
    after = run.thermo["TotEng"][run.thermo["Bonds"] == 0]
    assert np.ptp(after) < 2e-6 * after[0]
    late = run.thermo["Bonds"] == 0
    r, force = run.thermo["v_r"][late], run.thermo["v_f"][late]
    assert np.all(force >= 0.0)
    assert np.all(force[r >= contact] == 0.0)
    inside = r < contact
    push = -formulas.truss_tension(r[inside] / contact, MODULUS)
    assert force[inside] == pytest.approx(push, rel=1e-9, abs=1e-9 * MODULUS)
    if failure.startswith("compression"):
        assert np.any(inside)


def test_bonded_pairs_do_not_touch(run_lammps):
    """no contact force between two bonded particles, however far they overlap"""
    script = pair_script("tension 1e6", 0.5) + "run 0\nset atom 2 x 0.3\nrun 0\n"
    evdwl, ebond, force = scripts.results(run_lammps(script + scripts.result("evdwl", "ebond", "fx[2]")).stdout)[-1]
    assert evdwl == 0.0
    assert ebond == pytest.approx(formulas.truss_energy(0.6, 0.5, MODULUS), rel=1e-13)
    assert force == pytest.approx(-formulas.truss_tension(0.6, MODULUS), rel=1e-13)


def test_nothing_fails_during_set_up(run_lammps):
    """far over the strength: run 0 leaves the bond in place, any number of times; the first step takes it"""
    script = pair_script("tension 10", speed=(0, 0)) + "set atom 2 x 1.5\nrun 0\nrun 0\n"
    script += scripts.result("f_failure", "bonds", "ebond")
    script += "run 1\n" + scripts.result("f_failure", "bonds", "ebond")
    still, gone = scripts.results(run_lammps(script).stdout)
    assert tuple(still) == pytest.approx((0, 1, formulas.truss_energy(1.5, 1.0, MODULUS)), rel=1e-13)
    assert tuple(gone) == (1, 0, 0)


def test_only_bonds_inside_the_group_fail(run_lammps):
    """both ends must belong to the group"""
    for group, broken in (("one", 0), ("all", 1)):
        run = run_lammps(pair_script("tension 10", speed=(-2, 2), group=group) + "run 300\n")
        assert run.thermo["f_failure"][-1] == broken


def test_only_its_own_bond_type_fails(run_lammps):
    """two pairs with two types, both overstretched, two fixes with different strengths"""
    script = scripts.box(30, bond_types=2)
    script += scripts.particles([(x, y, 0, 1.0) for x in (0, 1) for y in (-5, 5)])
    script += scripts.elastic(E) + """
group a id 1 3
group b id 2 4
potdem_bonds a 1 1.2
potdem_bonds b 2 1.2
fix weak all potdem/failure 1 tension 10
fix strong all potdem/failure 2 tension 1e5
fix move all nve
velocity all set 0 0 0
group right id 3 4
velocity right set 3 0 0
timestep 1e-4
thermo_style custom step f_weak f_strong bonds
run 300
"""
    run = run_lammps(script)
    assert (run.thermo["f_weak"][-1], run.thermo["f_strong"][-1], run.thermo["Bonds"][-1]) == (1, 0, 1)


def test_strength_of_a_dashpot_bond_is_elastic(run_lammps):
    """the stress that counts is E c eps: a viscous force alone breaks nothing"""
    script = pair_script("tension 10 compression 10", speed=(-50, 50), bond="damping 1.0", step=1e-7)
    run = run_lammps(script + "run 3\n")
    assert np.abs(run.thermo["v_f"][0]) > 10 * formulas.section(1.0, A)
    assert run.thermo["f_failure"][-1] == 0


def test_events_are_not_lost_between_dumps(run_lammps, tmp_path):
    """a row per broken bond, whatever the rank, cumulative; the energies add up to the fix's own"""
    script = scripts.box((8, 8, 20)) + "region body block -1.5 1.5 -1.5 1.5 -4 4\n" + scripts.crystal(region="body")
    script += scripts.elastic(100.0) + """potdem_bonds all 1 1.42
fix failure all potdem/failure 1 tension 3.0 compression 3.0
fix move all nve
velocity all ramp vz -2 2 z -4 4
timestep 0.005
thermo 10
thermo_style custom step f_failure f_failure[1] f_failure[2] f_failure[3] bonds
thermo_modify format float %.17g
dump events all local 10 events.dump index f_failure[*]
dump_modify events format float %.17g
run 100
"""
    for nprocs in (1, 2):
        run = run_lammps(script, nprocs=nprocs)
        snapshots = dumps.read(tmp_path / "events.dump")
        for table, broken, energy in zip(snapshots, run.thermo["f_failure"], run.thermo["f_failure[1]"]):
            assert len(table["index"]) == broken
            assert np.all(table["f_failure[1]"] <= table.step)
            assert np.sum(table["f_failure[9]"]) == pytest.approx(energy, rel=1e-12)
        assert run.thermo["f_failure"][-1] > 10
        assert np.all(run.thermo["f_failure[2]"] + run.thermo["f_failure[3]"] == run.thermo["f_failure"])
        assert run.thermo["Bonds"][-1] + run.thermo["f_failure"][-1] == run.thermo["Bonds"][0]


SKIN = 0.3    # of scripts.box()


def swinging(run_lammps, length, swing, nprocs=1):
    """two bonded particles that swing apart and together by `swing` each, across the border of two ranks; the bond
    fails at nine tenths of the way out"""
    strength = stress(length + 1.8 * swing, length)
    script = replaced(replaced(pair_script(f"tension {strength:.17g}", length), "fix move all nve", f"""
comm_modify cutoff 4.0
displace_atoms all move {-0.5 * length:.17g} 0 0 units box
fix move1 one move wiggle {-swing:.17g} NULL NULL 0.1 units box
fix move2 two move wiggle {swing:.17g} NULL NULL 0.1 units box
compute fragment all fragment/atom single yes
compute pieces all reduce max c_fragment"""), " bonds\n", " bonds c_pieces\n")
    return run_lammps(script + "run 1000\n", nprocs=nprocs)


def in_lists(run):
    """rebuilds of the neighbour list, and the pairs that are in it at the end"""
    return tuple(int(re.search(text + r" = (\d+)", run.log).group(1)) for text in ("Neighbor list builds", "Total # of neighbors"))


@pytest.mark.parametrize("nprocs", [1, 2])
@pytest.mark.parametrize("length, swing", [(1.02, 0.1), (1.25, 0.49 * SKIN), (1.6, 0.4), (2.0, 0.6)])
def test_a_failed_pair_is_in_the_list_when_it_touches(run_lammps, length, swing, nprocs):
    """whatever the gap at failure. In the second case the particles move as far as they may without a regular rebuild,
    and the gap, 1.8 skins, closes"""
    run = swinging(run_lammps, length, swing, nprocs)
    r, force = run.thermo["v_r"], run.thermo["v_f"]
    late = run.thermo["Bonds"] == 0
    touching = late & (r < 1.0)
    assert np.sum(touching) > 50
    assert force[touching] == pytest.approx(-formulas.truss_tension(r[touching], MODULUS), rel=1e-9, abs=1e-9 * MODULUS)
    assert np.all(force[late & (r >= 1.0)] == 0.0)


@pytest.mark.parametrize("gap, expected", [(1.9 * SKIN, 1), (2.1 * SKIN, 0)])
def test_pairs_that_may_touch_come_into_the_list_without_a_rebuild(run_lammps, gap, expected):
    """two skins: as far as two particles can approach each other until the next regular rebuild"""
    swing = 0.07    # less than half a skin in all
    run = swinging(run_lammps, 1.0 + gap - 1.8 * swing, swing)
    assert run.thermo["f_failure"][-1] == 1
    assert in_lists(run) == (0, expected)
    assert np.all(run.thermo["c_pieces"] == 1 + run.thermo["f_failure"])    # LAMMPS's special lists know at once


# --- scatter ---------------------------------------------------------------------------------------------

def many_pairs(scatter, count=20, more=""):
    """count^2 bonds side by side, all pulled at the same speed to 1.4 times their length"""
    width = 3 * count
    return scripts.box((width, width, 8), units="si", skin=0.3) + f"""
lattice sc 3.0 origin 0.5 0.5 0
region low block INF INF INF INF -0.1 0.1 units box
create_atoms 1 region low
lattice sc 3.0 origin 0.5 0.5 {1 / 3:.17g}
region high block INF INF INF INF 0.9 1.1 units box
create_atoms 1 region high
reset_atoms id sort yes
set group all diameter 1.0
set group all density 1.0
group high region high
{scripts.elastic(E=E)}
potdem_bonds all 1 1.2
fix failure all potdem/failure 1 tension 100 {scatter}
{more}
fix hold all move linear 0 0 0
fix pull high move linear 0 0 0.4
timestep 5e-4
run 2000
write_dump all local events.dump index f_failure[3] f_failure[4] f_failure[8]
"""


def strengths(run_lammps, tmp_path, script, nprocs=1):
    """pair of IDs -> stress at which its bond failed, over the mean strength"""
    run_lammps(script, nprocs=nprocs)
    table = dumps.read(tmp_path / "events.dump")[0]
    rows = scripts.vectors(table, *(f"f_failure[{k}]" for k in (3, 4, 8)))
    return {(int(a), int(b)): E * strain / 100 for a, b, strain in rows}


def test_scattered_strengths_follow_their_law(run_lammps, tmp_path):
    """the stresses at which 400 bonds fail, against Weibull's distribution with mean 1, and on any number of ranks"""
    k = 4.0
    found = strengths(run_lammps, tmp_path, many_pairs(f"scatter weibull {k} 4711"))
    assert len(found) == 400
    values = np.sort(list(found.values()))
    exact = 1 - np.exp(-(values * math.gamma(1 + 1 / k)) ** k)
    # distance of 400 draws from their law: 0.0975 is passed once in a thousand draws
    assert np.abs(exact - (np.arange(400) + 0.5) / 400).max() < 0.0975
    assert strengths(run_lammps, tmp_path, many_pairs(f"scatter weibull {k} 4711"), 4) == pytest.approx(found, rel=1e-9)
    assert strengths(run_lammps, tmp_path, many_pairs(f"scatter weibull {k} 4712")) != pytest.approx(found, rel=0.1)


def test_a_normal_scatter_is_cut(run_lammps, tmp_path):
    found = strengths(run_lammps, tmp_path, many_pairs("scatter normal 0.2 9"))
    values = np.array(list(found.values()))
    late = 0.4 * 5e-4 * 1.4 * E / 100    # stress gained in the step until a bond is removed
    assert len(values) == 400 and values.min() >= 0.4 and values.max() <= 1.6 + late
    assert values.mean() == pytest.approx(1.0, abs=4 * 0.2 / 20 + late)
    assert values.std() == pytest.approx(0.2, abs=4 * 0.2 / np.sqrt(800))


# --- a fix that nothing can happen to --------------------------------------------------------------------

def idle_warnings(run):
    return re.findall(r"^WARNING: (Fix potdem/failure .*?) \(\S*fix_potdem_failure.cpp:\d+\)$", run.log, re.MULTILINE)


def two_types(failure, group="all"):
    """a pair bonded with type 2 of three"""
    script = pair_script(failure, speed=(-2.0, 2.0), group=group)
    return replaced(replaced(replaced(script, "bond/types 1", "bond/types 3"), "potdem_bonds all 1", "potdem_bonds all 2"), "potdem/failure 1", "potdem/failure {}")


@pytest.mark.parametrize("nprocs", [1, 2])
@pytest.mark.parametrize("btype, group", [(1, "all"), (3, "all"), (2, "one")])
def test_bonds_that_no_fix_is_for_are_named_once_in_each_run(run_lammps, nprocs, btype, group):
    script = two_types("tension 80", group).format(btype)
    run = run_lammps(script + "run 0\nrun 2\nrun 2\n", nprocs=nprocs)
    found = idle_warnings(run)
    assert len(found) == 2
    for text in found:
        assert f"no bond of type {btype} has both ends in group {group}" in text
        assert "there are bonds of type 2;" in text


def test_no_bonds_at_all(run_lammps):
    script = re.sub(r"^potdem_bonds.*$", "", pair_script("tension 80"), flags=re.MULTILINE)
    script = replaced(script, "newton", "newton on off\nnewton", 1) if "newton" in script else "newton on off\n" + script
    script += "special_bonds lj 0 1 1 coul 0 1 1\nrun 2\n"
    (text,) = idle_warnings(run_lammps(script))
    assert "there are no bonds at all" in text and "potdem_bonds" in text


@pytest.mark.parametrize("nprocs", [1, 2])
def test_nothing_is_said_where_bonds_are_or_all_have_failed(run_lammps, nprocs):
    """the pair is pulled apart in the first run; the second and third have no bond left"""
    run = run_lammps(two_types("tension 80").format(2) + "run 400\nrun 2\nrun 2\n", nprocs=nprocs)
    assert run.thermo["f_failure"][-1] == 1 and run.thermo["Bonds"][-1] == 0
    assert idle_warnings(run) == []
