# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""The cases of tools/report accuracy: name -> function of (short, folder) that makes the case."""

from potdem.reports.cases.breaking import beam_impact, cylinder_impact
from potdem.reports.cases.contacts import collision_of_grains, other_laws, restitution
from potdem.reports.cases.grains import bed, column, hopper
from potdem.reports.cases.solids import bar, beam_impulse, keep_calculix

CASES = {
    "beam-impulse": beam_impulse,
    "bar": bar,
    "collision": collision_of_grains,
    "restitution": restitution,
    "laws": other_laws,
    "beam-impact-3": beam_impact(3),
    "beam-impact-5": beam_impact(5),
    "cylinder-impact": cylinder_impact,
    "hopper": hopper,
    "column": column,
    "bed": bed,
}

__all__ = ["CASES", "keep_calculix"]
