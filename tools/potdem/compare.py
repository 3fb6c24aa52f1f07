# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Compares the thermo output of a run with a reference, column by column, by the rules of scene.yaml.

  reference:
    break_column: v_broken       # counts broken bonds; without it nothing ever breaks
    break_within: 500            # steps by which the first break may move (default: one output interval)
    columns:
      Step: {all: true, abs: 0}
      PotEng:
        - {before: first_break, until: 0.3, rel: 1e-6}
        - {final: true, rel: 0.10}
      v_tip: {max: true, rel: 0.05}
      c_wall: {window: [0.0, 0.02], rel: 1e-6}
      CPU: {ignore: depends on the machine}

What a rule compares: `all` rows, those `before: first_break` in either log (and `until` a Time), the `window` of Time (of Step where
there is no Time), the `final` row, or the `max`imum absolute value of the run. The tolerance is
abs + rel * scale; the scale is the reference's largest absolute value among the rows compared (scale: range,
the default) or each row's own value (scale: value).
"""

from dataclasses import dataclass

import numpy as np

SELECTIONS = ("all", "before", "window", "final", "max", "ignore")
SETTINGS = ("rel", "abs", "scale", "until")


class RuleError(Exception):
    """a rule in scene.yaml that cannot be understood"""


@dataclass
class Check:
    """one comparison: the worst deviation and its tolerance, in the column's unit"""

    column: str
    what: str
    passed: bool
    deviation: float = np.nan
    tolerance: float = np.nan
    step: float = np.nan
    remark: str = ""


def _selection(column, rule):
    named = [key for key in rule if key in SELECTIONS]
    unknown = set(rule) - set(SELECTIONS) - set(SETTINGS)
    if len(named) != 1 or unknown:
        raise RuleError(f"{column}: {rule} must have exactly one of {', '.join(SELECTIONS)}"
                        f" and may have {', '.join(SETTINGS)}")
    if named[0] != "ignore" and not {"rel", "abs"} & set(rule):
        raise RuleError(f"{column}: {rule} has no tolerance (rel, abs)")
    if rule.get("before", "first_break") != "first_break":
        raise RuleError(f"{column}: {rule}: 'before' knows first_break only")
    if rule.get("scale", "range") not in ("range", "value"):
        raise RuleError(f"{column}: {rule}: 'scale' is range or value")
    return named[0]


def first_break(table, column):
    """the first step at which bonds are broken; infinite when none is"""
    if column is None:
        return np.inf
    broken = np.flatnonzero(table[column] > 0)
    return table["Step"][broken[0]] if broken.size else np.inf


def _rows(kind, rule, table, break_step):
    steps = table["Step"]
    time = table.get("Time", steps)
    if kind == "before":
        return (steps < break_step) & (time <= rule.get("until", np.inf))
    if kind == "window":
        start, end = rule["window"]
        return (time >= start) & (time <= end)
    return np.full(steps.shape, True)


def _series(kind, rule, table, column, break_step):
    """steps and values that a rule compares"""
    rows = _rows(kind, rule, table, break_step)
    steps, values = table["Step"][rows], table[column][rows]
    if values.size and kind == "final":
        return steps[-1:], values[-1:]
    if values.size and kind == "max":
        place = np.argmax(np.abs(values))
        return steps[place : place + 1], np.abs(values[place : place + 1])
    return steps, values


def _check(column, rule, new, reference, break_step):
    kind = _selection(column, rule)
    what = f"before step {break_step:g}" if kind == "before" and np.isfinite(break_step) else kind
    if kind == "before" and not np.isfinite(break_step):
        what = "all, unbroken"
    if kind == "ignore":
        return None
    steps, values = _series(kind, rule, new, column, break_step)
    reference_steps, expected = _series(kind, rule, reference, column, break_step)
    if kind != "max" and not np.array_equal(steps, reference_steps):
        return Check(column, what, False, remark=f"the rows differ: {steps.size} here, "
                                                 f"{expected.size} in the reference, or other steps")
    if not values.size:
        return Check(column, what, False, remark="no rows to compare")
    scale = np.abs(expected) if rule.get("scale") == "value" else np.abs(expected).max()
    absolute, relative = (float(rule.get(name, 0.0)) for name in ("abs", "rel"))    # YAML takes 1e-6 for a text
    tolerance = np.broadcast_to(absolute + relative * scale, values.shape)
    deviation = np.abs(values - expected)
    worst = np.argmax(deviation - tolerance)
    return Check(column, what, bool(deviation[worst] <= tolerance[worst]), deviation[worst],
                 tolerance[worst], steps[worst])


def _break_check(new, reference, rules):
    """the first break is deterministic, so its step is compared as well"""
    column = rules["break_column"]
    steps = [first_break(table, column) for table in (new, reference)]
    interval = float(np.diff(reference["Step"]).max()) if reference["Step"].size > 1 else 0.0
    tolerance = rules.get("break_within", interval)
    if np.isinf(steps).all():
        return Check(column, "first break", True, 0.0, tolerance, remark="nothing breaks in either log")
    if np.isinf(steps).any():
        return Check(column, "first break", False, np.inf, tolerance, min(steps),
                     remark="breaks in one of the logs only")
    deviation = abs(steps[0] - steps[1])
    return Check(column, "first break", deviation <= tolerance, deviation, tolerance, steps[0])


def _column_checks(column, rules, new, reference, break_step):
    if column not in new or column not in reference:
        place = "this run" if column not in new else "the reference"
        return [Check(column, "", False, remark=f"no such column in {place}")]
    if column not in rules:
        return [Check(column, "", False, remark="no rule in scene.yaml")]
    if not (np.isfinite(new[column]).all() and np.isfinite(reference[column]).all()):
        return [Check(column, "", False, remark="not a finite number")]
    wanted = rules[column] if isinstance(rules[column], list) else [rules[column]]
    checks = [_check(column, rule, new, reference, break_step) for rule in wanted]
    return [check for check in checks if check]


def compare(new, reference, rules):
    """checks of all columns of both tables and of all columns that have a rule"""
    columns = list(dict.fromkeys([*reference, *new, *rules["columns"]]))
    break_column = rules.get("break_column")
    if break_column and not (break_column in new and break_column in reference):
        return [Check(break_column, "first break", False, remark="no such column")]
    break_step = min(first_break(table, break_column) for table in (new, reference))
    checks = [_break_check(new, reference, rules)] if break_column else []
    for column in columns:
        checks += _column_checks(column, rules["columns"], new, reference, break_step)
    return checks


def report(checks):
    """a table, one line per check"""
    lines = [f"{'column':<18} {'compared':<22} {'worst deviation':>15} {'at step':>10} {'tolerance':>11}"]
    for check in checks:
        numbers = " " * 38
        if not np.isnan(check.tolerance):
            step = "" if np.isnan(check.step) else f"{check.step:.0f}"
            numbers = f"{check.deviation:>15.3g} {step:>10} {check.tolerance:>11.3g}"
        lines.append(f"{check.column:<18} {check.what:<22} {numbers}  "
                     f"{'pass' if check.passed else 'FAIL'}  {check.remark}".rstrip())
    return "\n".join(lines)
