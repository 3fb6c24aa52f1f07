# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""The comparison with reference logs: what must fail fails."""

import numpy as np
import pytest

from potdem import compare

STEPS = np.arange(0.0, 1000.0, 100.0)
RULES = {
    "break_column": "v_broken",
    "columns": {
        "Step": {"all": True, "abs": 0},
        "PotEng": [{"before": "first_break", "rel": 1e-6}, {"final": True, "rel": 0.10}],
        "v_tip": {"max": True, "rel": 0.05},
        "v_broken": {"final": True, "rel": 0.10},
        "CPU": {"ignore": "depends on the machine"},
    },
}


def table(**columns):
    broken = np.where(STEPS >= 500, 100.0, 0.0)
    made = {"Step": STEPS, "PotEng": 1.0 + STEPS, "v_tip": -STEPS, "v_broken": broken, "CPU": STEPS}
    return {name: np.array(values) for name, values in {**made, **columns}.items()}


def changed(name, row, factor):
    values = table()[name]
    values[row] *= factor
    return table(**{name: values})


def failures(new, reference=None, rules=None):
    checks = compare.compare(new, reference or table(), rules or RULES)
    return [(check.column, check.what or check.remark) for check in checks if not check.passed]


def test_equal_tables_pass():
    assert failures(table()) == []


def test_a_changed_number_before_the_first_break_fails():
    assert failures(changed("PotEng", 2, 1.01)) == [("PotEng", "before step 500")]


def test_the_scale_is_the_largest_value_before_the_break():
    # 401 is the largest: 3e-4 is within 1e-6 of it, 5e-4 is not
    assert failures(table(PotEng=table()["PotEng"] + np.where(STEPS == 0, 3e-4, 0))) == []
    assert failures(table(PotEng=table()["PotEng"] + np.where(STEPS == 0, 5e-4, 0))) != []


def test_a_number_between_first_break_and_end_may_differ():
    assert failures(changed("PotEng", 7, 3.0)) == []


def test_until_ends_the_comparison_in_time():
    """no Time column: the step is the time"""
    rules = {**RULES, "columns": {**RULES["columns"], "PotEng": {"before": "first_break", "until": 200, "rel": 1e-6}}}
    assert failures(changed("PotEng", 2, 1.01), rules=rules) == [("PotEng", "before step 500")]
    assert failures(changed("PotEng", 3, 1.01), rules=rules) == []


def test_bulk_quantities_are_compared_within_their_tolerance():
    assert failures(changed("PotEng", -1, 1.09)) == []
    assert failures(changed("PotEng", -1, 1.11)) == [("PotEng", "final")]
    assert failures(changed("v_tip", -1, 1.04)) == []
    assert failures(changed("v_tip", -1, 1.06)) == [("v_tip", "max")]


def test_the_first_break_may_move_by_one_output_interval():
    assert failures(table(v_broken=np.where(STEPS >= 600, 100.0, 0.0))) == []
    assert ("v_broken", "first break") in failures(table(v_broken=np.where(STEPS >= 700, 100.0, 0.0)))


def test_a_run_that_never_breaks_fails():
    assert ("v_broken", "first break") in failures(table(v_broken=0 * STEPS))


def test_a_break_at_once_leaves_nothing_to_compare_and_fails():
    assert ("PotEng", "before step 0") in failures(table(v_broken=np.full(STEPS.size, 100.0)))


def test_unbroken_runs_are_compared_to_the_end():
    intact = table(v_broken=0 * STEPS)
    late = changed("PotEng", 8, 1.01)
    late["v_broken"] = 0 * STEPS
    assert failures(intact, intact) == []
    assert failures(late, intact) == [("PotEng", "all, unbroken")]


@pytest.mark.parametrize("value", [np.nan, np.inf])
def test_numbers_that_are_not_finite_fail_in_either_table(value):
    spoiled = changed("v_tip", 7, value)
    assert failures(spoiled) == [("v_tip", "not a finite number")]
    assert failures(table(), spoiled) == [("v_tip", "not a finite number")]


def test_missing_columns_fail():
    short = table()
    del short["v_tip"]
    assert failures(short) == [("v_tip", "no such column in this run")]
    assert failures(table(), short) == [("v_tip", "no such column in the reference")]


def test_a_column_without_a_rule_fails():
    assert failures(table(c_new=STEPS), table(c_new=STEPS)) == [("c_new", "no rule in scene.yaml")]


def test_a_shorter_run_fails():
    short = {name: values[:-1] for name, values in table().items()}
    assert ("Step", "all") in failures(short)


def test_a_window_of_time_is_compared_alone():
    rules = {"columns": {name: {"ignore": "not judged here"} for name in table()}}
    rules["columns"]["PotEng"] = {"window": [100, 300], "rel": 1e-6}
    assert failures(changed("PotEng", 4, 2.0), rules=rules) == []
    assert failures(changed("PotEng", 3, 2.0), rules=rules) == [("PotEng", "window")]


@pytest.mark.parametrize("rule", [{"rel": 1}, {"final": True}, {"final": True, "max": True, "rel": 1},
                                  {"final": True, "tol": 1}, {"before": "lunch", "rel": 1}])
def test_rules_that_cannot_be_understood_are_refused(rule):
    with pytest.raises(compare.RuleError, match="PotEng"):
        failures(table(), rules={"columns": {**RULES["columns"], "PotEng": rule}})


def test_the_report_shows_the_worst_deviation():
    text = compare.report(compare.compare(changed("PotEng", 2, 1.01), table(), RULES))
    assert "2.01" in text and "FAIL" in text
