# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""tools/report race: its inputs run at a tiny size, POTDEM and LAMMPS's pair_style granular follow the same motion as long as chaos
lets them, and the page says what was measured and what was not."""

import dataclasses

import numpy as np
import pytest

from potdem.reports import race, race_programs, writing
from potdem.reports.race_programs import Outcome

TINY = {"silo": {"softer": 100, "time": 0.03, "dt": 2.5e-5, "most": 150}, "ball": {"softer": 100, "time": 0.002, "dt": 1e-5, "most": 700}}


def test_restitution_of_the_dashpot():
    """of the motion y'' + 2 zeta y' + y = 0, y(0) = 0, until its force y + 2 zeta y' falls to zero: the closed form of the collision"""
    zeta = race_programs.damping_of(0.5)
    omega = np.sqrt(1 - zeta**2)
    end = 2 * np.arccos(zeta) / omega
    away = np.exp(-zeta * end) * (np.cos(omega * end) - zeta / omega * np.sin(omega * end))
    force = np.exp(-zeta * end) / omega * np.sin(omega * end) + 2 * zeta * away
    assert force == pytest.approx(0, abs=1e-9) and away == pytest.approx(-0.5, rel=1e-9)
    # where it may attract, half a period, and more of the speed is lost
    assert race_programs.with_attraction(zeta) == pytest.approx(np.exp(-zeta * np.pi / omega))
    assert race_programs.with_attraction(zeta) < 0.5


def tiny(name):
    """the case with few grains and steps, soft"""
    case = race.CASES[name](True)
    settling = [{**case.settling[0], "time": 0.05, "put": "yes"}]
    return dataclasses.replace(case, variables={**case.variables, **TINY[name]}, settling=settling, every=0.001, found={})


def run_tiny(case, programs, folder):
    """what the programs find, from one packing"""
    packing = folder / "packing.data"
    race_programs.settle(case, packing)
    return [race_programs.PROGRAMS[name](case, packing, 1, folder / name) for name in programs]


def programs_here():
    return [name for name in race_programs.PROGRAMS if name != "YADE" or not race_programs.missing_yade()]


def test_programs_let_the_same_grains_out(lmp, tmp_path):
    """a layer on the lid falls: most of it in 30 ms, and hardly anything collides"""
    found = run_tiny(tiny("silo"), programs_here(), tmp_path)
    assert all(one.processor > 0 and one.clock > 0 and one.values[0] == 150 for one in found)
    assert found[0].values[-1] < 140
    assert np.ptp([one.values[-1] for one in found]) <= 2


def test_programs_have_the_same_laws(lmp, tmp_path):
    """by how much a ball of 5 m/s falls behind in 2 ms. They share normal force and stiffness; where a contact slips POTDEM limits the
    spring, then spring and dashpot, LAMMPS both at once, YADE the spring: seen 1.5 % and 8 % apart"""
    ours, *theirs = (one.values[-1] - one.values[0] + 5 * 0.002 for one in run_tiny(tiny("ball"), programs_here(), tmp_path))
    assert ours > 2e-4
    for found, bound in zip(theirs, (0.04, 0.15)):
        assert found == pytest.approx(ours, rel=bound)


def measured(case, programs):
    time = race.times(case)
    runs = [*((name, run) for name in programs for run in (race.WHOLE, race.ON_TWO)), ("POTDEM", race.OTHER_LISTS)]
    for name, run in runs:
        k = programs.index(name)
        case.found[name, run] = Outcome(time, 0.09 - 5 * time - 1e-3 * k * time, 5.0 * (k + 1), 8.0 * (k + 1))
    return case


@pytest.mark.parametrize("programs", [("POTDEM", "LAMMPS granular"), ("POTDEM", "LAMMPS granular", "YADE")])
def test_page_and_table(programs, tmp_path):
    case = measured(race.CASES["ball"](True), programs)
    rows = [race.row(case, name) for name in race_programs.PROGRAMS]
    steps = case.variables["time"] / case.variables["dt"]
    assert rows[0][2:5] == pytest.approx([8.0, 8e9 / steps / case.grains, 5e9 / steps / case.grains], abs=0.5)
    assert (rows[2][2] is None) == ("YADE" not in programs)
    text = race.page(" --short", [case], rows, [("processor", "any")])
    assert "POTDEM takes 0.50 of the seconds of LAMMPS granular on one core, 0.50 on two" in text
    assert ("the two others are" in text) == ("YADE" in programs)
    race.write_data(case, tmp_path)
    assert (tmp_path / "race-ball.png").stat().st_size > 10000
    assert len(writing.read_csv(tmp_path / "race-ball.csv")) == len(race.times(case))


@pytest.mark.parametrize("case", list(race.CASES))
def test_grains_are_of_the_material(lmp, case, tmp_path):
    """the packing has the density that the paper gives"""
    made = race.CASES[case](True)
    packing = tmp_path / "packing.data"
    settling = [{**made.settling[0], "time": 10 * made.variables["dt"], "put": "no"}]
    race_programs.settle(dataclasses.replace(made, variables={**made.variables, "most": 5}, settling=settling), packing)
    rows = packing.read_text().split("Atoms", 1)[1].splitlines()[2:7]
    assert {float(row.split()[3]) for row in rows} == {{"silo": 2500.0, "silo-m2": 2000.0, "ball": 2500.0}[case]}


def test_steel_is_that_of_the_yade_script():
    """its numbers stand in the YADE script once more, because it runs in YADE's Python"""
    script = (race_programs.INPUTS / "yade_race.py").read_text()
    laws = (race_programs.INPUTS / "in.laws").read_text()
    assert f"poisson={race_programs.POISSON}" in script and "variable nu       equal 0.2" in laws
    assert "210e9/v_softer" in laws and "(210e9, 7200)" in script
    assert "mu_steel equal 0.2" in laws and "(mu, 0.2, 0.2)" in script
