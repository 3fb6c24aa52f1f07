# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Errors of bulk quantities of chaotic runs: means over seeds beside the reference's."""

import numpy as np

from potdem.reports.cases.case import FAILED


def seeded(variables):
    """those of a round: each has its own draw of the diameters"""
    return lambda repeat: {**variables, "seed": repeat + 1}


def standard_error(groups):
    """of the difference of two means, relative to the mean of the last group. The scatter of a few seeds is hardly known, so it is taken
    from all groups together, but those that are far off, whose scatter is another"""
    known, number = np.mean(groups[-1]), len(groups[-1])
    near = [group for group in groups if abs(np.mean(group) - known) < 0.5 * abs(known)]
    variance = np.mean([np.var(group, ddof=1) for group in near]) if number > 1 else 0.0
    return float(np.sqrt(2 * variance / number) / abs(known))


def against_reference(bulk, of_runs):
    """Case.errors where the last setting is the reference. bulk: names of quantities, compared as means over the rounds; of_runs: name
    -> function of (quantities, the reference's of the same round), the worst counts"""
    def of_setting(runs, known, bars):
        if any(run is FAILED for run in runs):
            return dict.fromkeys([*of_runs, *bulk], np.inf), {}
        errors = {name: max(function(*pair) for pair in zip(runs, known)) for name, function in of_runs.items()}
        means = {name: [np.mean([run[name] for run in group]) for group in (runs, known)] for name in bulk}
        return {**errors, **{name: abs(found / wanted - 1) for name, (found, wanted) in means.items()}}, bars

    def errors(quantities):
        whole = [runs for runs in quantities if FAILED not in runs]
        bars = {name: standard_error([[run[name] for run in runs] for runs in whole]) for name in bulk}
        return [of_setting(runs, quantities[-1], bars) for runs in quantities]

    return errors
