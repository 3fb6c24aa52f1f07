"""Errors of bulk quantities of chaotic runs: means over seeds beside the reference's."""

import numpy as np

from .case import FAILED


def seeded(variables):
    """those of a round: each has its own draw of the diameters"""
    return lambda repeat: {**variables, "seed": repeat + 1}


def difference(found, known):
    """relative difference of the means and its standard error"""
    scale = abs(np.mean(known))
    noise = np.sqrt(sum(np.var(values, ddof=1) / len(values) for values in (found, known))) if len(found) > 1 else 0.0
    return abs(np.mean(found) - np.mean(known)) / scale, noise / scale


def against_reference(bulk, of_runs):
    """Case.errors where the last setting is the reference. bulk: names of quantities, compared as means over the rounds; of_runs: name
    -> function of (quantities, the reference's of the same round), the worst counts"""
    def of_setting(runs, known):
        if any(run is FAILED for run in runs):
            return dict.fromkeys([*of_runs, *bulk], np.inf), {}
        errors = {name: max(function(*pair) for pair in zip(runs, known)) for name, function in of_runs.items()}
        pairs = {name: difference(*([run[name] for run in group] for group in (runs, known))) for name in bulk}
        return {**errors, **{name: pair[0] for name, pair in pairs.items()}}, {name: pair[1] for name, pair in pairs.items()}

    return lambda quantities: [of_setting(runs, quantities[-1]) for runs in quantities]
