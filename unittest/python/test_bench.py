# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""bench/run: what it reads, counts and judges, and its tables from end to end on small bodies. Never a time."""

from dataclasses import replace

import cluster
import cost
import limits
import main
import measure
import pytest
import targets

from potdem.reports import writing

pytestmark = pytest.mark.built_in

TWO_LOOPS = """
Per MPI rank memory allocation (min/avg/max) = 3.5 | 4.25 | 5 Mbytes
   Step          KinEng        v_links
         0   1.0              24389
      1000   2.0              24389
Loop time of 0.75 on 1 procs for 1000 steps with 24389 atoms

50.0% CPU use with 1 MPI tasks x 1 OpenMP threads

MPI task timing breakdown:
Section |  min time  |  avg time  |  max time  |%varavg| %total
---------------------------------------------------------------
Pair    | 0.25       | 0.5        | 0.6        |   0.0 | 50.00
Modify  | 0.125      | 0.125      | 0.125      |   0.0 | 12.50
Other   |            | 0.125      |            |       | 12.50

Loop time of 0.5 on 2 procs for 1000 steps with 24389 atoms

50.0% CPU use with 2 MPI tasks x 1 OpenMP threads

Section |  min time  |  avg time  |  max time  |%varavg| %total
Modify  | 0.0625     | 0.0625     | 0.0625     |   0.0 | 12.50
"""


def rows_of(table):
    return [[cell.strip() for cell in line.split("|")[1:-1]] for line in table.splitlines()[2:]]


# --- what is read -----------------------------------------------------------------------------------------

def test_loops_of_a_log():
    """a process alone by the time it had the processor, ranks by the clock"""
    assert measure.loops_of(TWO_LOOPS) == [{"Pair": 0.25, "Modify": 0.0625, "Loop": 0.375, "Clock": 0.75},
                                            {"Modify": 0.0625, "Loop": 0.5, "Clock": 0.5}]
    assert measure.last_number(TWO_LOOPS) == 24389
    assert targets.own_memory(TWO_LOOPS) == 5.0
    assert measure.Timed(measure.loops_of(TWO_LOOPS), 0, 3.0, 0, "").set_up == 2.125


def test_instructions_are_those_of_the_styles_compute(tmp_path, monkeypatch):
    said = ("1,234,567 (50.0%)  bond_potdem_base.cpp:LAMMPS_NS::BondPotdemBase::compute(int, int) [lmp]\n"
            "  900,000 (40.0%)  x.h:LAMMPS_NS::PairPotdem<POTDEM::Hertz>::compute(int, int) [lmp]\n"
            "9,999,999 (99.0%)  verlet.cpp:LAMMPS_NS::Verlet::run(int) [lmp]\n")
    monkeypatch.setattr(limits.subprocess, "run", lambda *_, **__: type("Done", (), {"stdout": said}))
    assert limits.counted(tmp_path, "Bond") == 1234567
    assert limits.counted(tmp_path, "Pair") == 900000


# --- what is judged ---------------------------------------------------------------------------------------

def verdict(values, **settings):
    target = targets.Target("x", "ns", None, "peer", lambda bench: None, **settings)
    return targets.row(target, values)


def test_a_ratio_is_judged_round_by_round():
    row = verdict([(1.0, 2.0), (3.0, 4.0), (0.9, 1.0)], ratio=True, sign="≤", limit=0.8)
    assert row == ("x", "1.00 ns", "peer: 2.00 ns", "0.75 (0.50 to 0.90)", "ratio ≤ 0.8", "yes; in 2 of 3 rounds")
    assert verdict([(1.0, 1.0)], ratio=True, sign="≤", limit=0.8)[-1] == "no"
    assert verdict([(1.0, 2.0)], ratio=True, sign="≥", limit=0.4)[-1] == "yes"


def test_a_number_is_judged_by_itself_and_some_are_not():
    assert verdict([(1.9, 1.5), (1.8, 1.5)], ratio=False, sign="≥", limit=1.85)[-2:] == ("≥ 1.85 ns", "yes; in 1 of 2 rounds")
    assert verdict([(1.9, 1.5)])[-2:] == ("", "")


# --- what is worked out -----------------------------------------------------------------------------------

def test_scaling_on_paper_of_a_cube():
    """a rank of 1000 particles with two layers of ghosts, beside a body of 8^3 on 2 and 8 ranks; latency and bandwidth as assumed"""
    of_ranks = {2: cluster.Sent(0, 0, 0, 128, 128), 8: cluster.Sent(3, 24 * 160, 1, 152, 160)}
    computing, messages, volume, reductions, ghosts = cluster.on_paper(1000, 64, of_ranks, 8, 100.0)
    assert ghosts == pytest.approx(14**3 - 10**3)
    assert computing == pytest.approx(1e-4)
    assert messages == pytest.approx(6 * cluster.LATENCY)
    assert volume == pytest.approx(24 * ghosts / cluster.BANDWIDTH)
    assert reductions == pytest.approx(6 * cluster.LATENCY)


def test_blocks_of_a_page():
    page = "a\n<!-- block one -->\nold\n<!-- end of one -->\nb\n"
    once = writing.with_blocks(page, {"one": "new"})
    assert once == "a\n<!-- block one -->\n\nnew\n\n<!-- end of one -->\nb\n"
    assert writing.with_blocks(once, {"one": "new"}) == once
    with pytest.raises(ValueError, match="no block two"):
        writing.with_blocks(page, {"two": "new"})


def test_the_page_has_every_block_and_picture(root):
    page = (root / "docs" / "performance.md").read_text(encoding="utf-8")
    for name in ("machine", "roof", "counted", "halo", "paper", "balance", "threads"):
        assert f"<!-- block {name} -->" in page and f"<!-- end of {name} -->" in page
    assert "(performance.png)" in page and (root / "docs" / "performance.png").exists()


def test_needs_of_a_bond():
    machine = {"plain-4": 21.0, "root-4": 0.5, "read-memory": 29.0}
    assert limits.needs(limits.Work("", None, added=21, divided=2, own=24, particle=80), 16.0, machine) == pytest.approx((1.5, 1.0))


# --- from end to end --------------------------------------------------------------------------------------

def test_every_target_has_a_row(lmp, capsys):
    main.main(["--targets", "--short", "--repeats", "1"])
    rows = rows_of(capsys.readouterr().out)
    listed = targets.targets(targets.SHORT)
    assert [row[0] for row in rows] == [target.what for target in listed]
    for row, target in zip(rows, listed):
        assert row[1] and bool(row[2]) == bool(row[3]) == bool(target.peer)
        assert row[5] in (("yes", "no") if target.sign else ("",))


def test_bonds_fail_at_an_even_rate(lmp):
    """in.breaking: the share that was asked for, half of it in half the run; none in the body that is to stay whole"""
    def failed(share, part=1.0):
        steps = 100
        strain = 1e-3 * part
        given = {"n": 10, "steps": round(steps * part), "share": share * part, "strain": strain}
        whole = measure.launch("in.breaking", {**given, "share": 1e-12}).links
        return 1 - measure.launch("in.breaking", given).links / whole
    assert failed(0.04) == pytest.approx(0.04, rel=0.25)
    assert failed(0.04, 0.5) == pytest.approx(0.02, rel=0.25)


@pytest.mark.parametrize("newton, messages, numbers", [("off", 1, 3), ("on", 2, 9)])
def test_what_a_solid_sends(lmp, newton, messages, numbers):
    """positions of each particle that is a ghost of another rank, to each neighbour in each step; with newton on, forces and torques
    come back, which LAMMPS's atom_style bpm/sphere has"""
    case = replace(cost.SOLID, variables={"newton": newton})
    (of_ranks,) = cluster.halos({"solid": (case, 8)}, (2, 4)).values()
    for ranks, neighbours in ((2, 1), (4, 2)):
        assert of_ranks[ranks].messages == pytest.approx(messages * neighbours)
        assert of_ranks[ranks].bytes == pytest.approx(8 * numbers * of_ranks[ranks].most_ghosts)


def test_balance_of_a_scene(lmp):
    as_it_is, *_, tiled = cluster.WAYS.values()
    load, even = (cluster.balanced("column-drop", way, cluster.SCENES["column-drop"][1], 2)[0] for way in (as_it_is, tiled))
    assert load == pytest.approx(2.0, abs=0.1)    # the column stands in one half of the box
    assert even == pytest.approx(1.0, abs=0.1)
