# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""tools/report accuracy: fronts and recommendations of known points, error functions on known data, references against closed forms, one
small case from end to end."""

from types import SimpleNamespace

import numpy as np
import pytest
import test_collisions

from potdem import collisions, struck_beam
from potdem.reports import accuracy, work_precision, writing
from potdem.reports.cases import breaking, bulk, case, contacts, solids
from potdem.reports.work_precision import Point


def point(seconds, error, series="a", **settings):
    return Point(series, f"{seconds}", [seconds, 0.9 * seconds, 1.1 * seconds], {"x": error}, **settings)


POINTS = [point(4.0, 0.0004), point(1.0, 0.2), point(2.0, 0.02), point(3.0, 0.05), point(0.5, np.inf), point(2.5, 0.0199)]


# --- work_precision ---------------------------------------------------------------------------------------

def test_front_has_what_nothing_beats():
    """neither the dearer and worse point, nor the one that is better by less than 1 %, nor the failed one"""
    found = work_precision.front(POINTS, lambda p: p.worst)
    assert [p.median for p in found] == [1.0, 2.0, 4.0]


def test_cheapest_below_a_limit():
    assert work_precision.cheapest(POINTS, 0.1).median == 2.0
    assert work_precision.cheapest(POINTS, 0.01).median == 4.0
    assert work_precision.cheapest(POINTS, 1e-5) is None


def test_an_error_below_its_uncertainty_counts_as_that():
    vague = point(1.0, 0.001, bars={"x": 0.05})
    assert vague.worst == 0.05
    assert work_precision.cheapest([vague, *POINTS], 0.01).median == 4.0
    assert work_precision.cheapest([vague, *POINTS], 0.1) is vague


def test_what_cannot_be_told_from_the_reference():
    found = work_precision.indistinct([point(1.0, 0.03, bars={"x": 0.01}), point(3.0, 0.01, bars={"x": 0.01}), point(2.0, 0.02, bars={"x": 0.01})])
    assert len(found) == 1 and "**a, 2.0**" in found[0]
    assert work_precision.indistinct(POINTS) == []


def test_recommendations_name_each_setting_once_and_end_with_what_cannot_be_had():
    lines = work_precision.recommendations(POINTS)
    assert len(lines) == 4
    assert lines[0].startswith("error below 30 %: **a, 1.0**")
    assert lines[1].startswith("error below 3 %: **a, 2.0** (2 s, error 2 %)")
    assert lines[2].startswith("error below 0.1 %: **a, 4.0**")
    assert lines[3] == "error below 0.01 %: no setting that was tried reaches it"


def test_peers_are_compared_at_their_own_error():
    text, hopeless = work_precision.against_peers([*POINTS, point(4.0, 0.03, "other", peer=True), point(1.0, 1e-6, "exact", peer=True)])
    assert "Beside other" in text and "in 0.5 of its seconds" in text
    assert "Beside exact: no setting reaches its error" in hopeless


def test_order_of_a_power_law():
    steps = np.array([0.1, 0.2, 0.4])
    assert work_precision.order(steps, 3 * steps**2.5) == pytest.approx(2.5)


# --- writing ----------------------------------------------------------------------------------------------

def test_table_and_csv(tmp_path):
    assert writing.table(["a", "b"], [["x", 1.23456], [2, None]]) == "| a | b |\n|---|---|\n| x | 1.23 |\n| 2 |  |"
    writing.write_csv(tmp_path / "t.csv", ["a, b", "c"], [["Δ, 1", 0.125], ["y", 3]])
    assert writing.read_csv(tmp_path / "t.csv") == [{"a, b": "Δ, 1", "c": "0.125"}, {"a, b": "y", "c": "3"}]


# --- errors of known data ---------------------------------------------------------------------------------

def test_peak_and_period_of_two_modes():
    """the peak is looked for in steps of 20 us, in which the second mode turns by 0.07: 3e-3 of it, 1e-4 of the peak at most"""
    time = np.arange(0, 0.02, 5e-5)
    deflection = 0.017 * np.sin(2 * np.pi * time / 0.0101) + 5e-4 * np.sin(2 * np.pi * time / 0.0017)
    peak, period = solids.peak_and_period(time, deflection)
    fine = np.linspace(0, 0.005, 200001)
    exact = np.max(0.017 * np.sin(2 * np.pi * fine / 0.0101) + 5e-4 * np.sin(2 * np.pi * fine / 0.0017))
    assert peak == pytest.approx(exact, rel=1e-4)
    assert period == pytest.approx(0.0101, rel=1e-6)


def history(shift, broken_from):
    time = np.linspace(0, 1, 101)
    return {"time": time, "paths": [np.sin(3 * time) + shift * time], "broken so far": (time >= broken_from).astype(float)}


def test_motion_is_compared_until_the_first_break():
    """the deviation grows as the time; the range of the reference is 1 from pi/6 on, up to 1.1e-4 between two samples"""
    assert breaking.path_error(history(0.1, 0.9), history(0.0, 0.605)) == pytest.approx(0.06, rel=1.1e-4)
    assert breaking.path_error(history(0.1, 0.405), history(0.0, 0.605)) == pytest.approx(0.04 / np.sin(3 * 0.4), rel=1e-6)


def test_means_over_seeds():
    """means 11 and 10, variances 1 and 4: 2.5 in the mean, twice over the number of seeds, 3"""
    found = [[{"n": value} for value in values] for values in ([10.0, 11.0, 12.0], [8.0, 10.0, 12.0])]
    (errors, bars), (none, _) = bulk.against_reference(["n"], {})(found)
    assert errors["n"] == pytest.approx(0.1) and none["n"] == 0.0
    assert bars["n"] == pytest.approx(np.sqrt(2 * 2.5 / 3) / 10)


def test_a_setting_that_is_far_off_lends_no_scatter():
    found = [[{"n": value} for value in values] for values in ([100.0, 300.0], [9.0, 11.0])]
    (_, bars), _ = bulk.against_reference(["n"], {})(found)
    assert bars["n"] == pytest.approx(np.sqrt(2 * 2.0 / 2) / 10)


def test_failed_runs_have_infinite_errors():
    found = [[case.FAILED, case.FAILED], [{"n": 1.0}, {"n": 2.0}]]
    (errors, _), _ = bulk.against_reference(["n"], {"path": lambda a, b: 0.0})(found)
    assert errors == {"n": np.inf, "path": np.inf}


# --- references -------------------------------------------------------------------------------------------

def test_collision_of_the_reference_is_the_closed_form():
    (meeting, *_) = contacts.hertz_meetings()
    assert meeting.exact[0] == pytest.approx(collisions.duration(1.0), rel=1e-9)
    assert contacts.TOUCH - meeting.nearest == pytest.approx(collisions.overlap_at_rest(1.0), rel=1e-9)


def test_restitution_of_the_reference():
    (meeting, *_) = contacts.hertz_meetings(speed=0.5, viscous=2e-3)
    assert meeting.exact[1] == pytest.approx(test_collisions.restitution(0.5, 2e-3, False), rel=1e-9)


def test_reference_of_the_beam_is_the_scene_s():
    """the scene's own measure of the same history, over three periods, from samples at 40 us"""
    known = struck_beam.calculix("2d-layer", "f1")
    peak, period = solids.reference()
    assert peak == pytest.approx(known.peak, rel=1e-3)
    assert period == pytest.approx(known.period, rel=1e-3)


def test_an_ending_replaces_the_run(tmp_path):
    script = tmp_path / "in.x"
    script.write_text("timestep 1\nrun          ${steps} upto\n")
    assert case.ending(script, "run 0") == "timestep 1\nrun 0\n"
    script.write_text("run 10\n")
    with pytest.raises(ValueError, match="no line"):
        case.ending(script, "run 0")


# --- from end to end --------------------------------------------------------------------------------------

@pytest.fixture(scope="module")
def small_case():
    """the Hertz collision of potdem/hertz and gran/hertz/history, 16 pairs"""
    met = contacts.hertz_meetings()[:2]
    made = contacts.case_of("small", "Small", "text", met, True)
    made.settings = [contacts.setting_of(meeting, number, 4) for meeting in met for number in (20, 40)]
    return made


def test_a_case_from_end_to_end(lmp, small_case, tmp_path):
    """second order, and the same errors for both styles: they have the same equation of motion"""
    points, text = accuracy.points_of(small_case, 2, tmp_path)
    coarse, fine = (p.errors["duration"] for p in points[:2])
    assert coarse < 0.01 and coarse / fine == pytest.approx(4, abs=0.3)
    for ours, theirs in zip(points[:2], points[2:]):
        assert theirs.errors == pytest.approx(ours.errors, rel=1e-6)
    assert all(len(p.seconds) == 2 for p in points)
    accuracy.write_data(small_case, points, tmp_path)
    assert (tmp_path / "accuracy-small.png").stat().st_size > 10000
    rows = writing.read_csv(tmp_path / "accuracy-small.csv")
    assert [row["POTDEM"] for row in rows] == ["yes", "yes", "no", "no"]
    assert float(rows[1]["error of the duration"]) == pytest.approx(fine)
    arguments = SimpleNamespace(short=True, repeats=2)
    page = accuracy.page(arguments, [(small_case, points, text)], [], [("processor", "any")], 1.0)
    assert "**potdem/hertz, T/" in page and "Beside gran/hertz/history" in page
