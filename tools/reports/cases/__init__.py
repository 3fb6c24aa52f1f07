"""The cases of tools/report accuracy: name -> function of (short, folder) that makes the case."""

from .breaking import beam_impact, cylinder_impact
from .contacts import collision_of_grains, other_laws, restitution
from .grains import bed, column, hopper
from .solids import bar, beam_impulse, keep_calculix

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
