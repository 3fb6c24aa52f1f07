"""The cases of tools/report accuracy: name -> function of (short, folder) that makes the case."""

from .breaking import beam_impact, cylinder_impact
from .case import Unavailable
from .contacts import hertz_collision, restitution
from .grains import bed, hopper
from .solids import bar, beam_impulse

CASES = {"beam-impulse": beam_impulse, "bar": bar, "collision": hertz_collision, "restitution": restitution,
         "beam-impact-3": beam_impact(3), "beam-impact-5": beam_impact(5), "cylinder-impact": cylinder_impact,
         "hopper": hopper, "bed": bed}

__all__ = ["CASES", "Unavailable"]
