"""The cases of tools/report accuracy: name -> function of (short, folder) that makes the case."""

from .case import Unavailable
from .contacts import hertz_collision, restitution
from .solids import bar, beam_impulse

CASES = {"beam-impulse": beam_impulse, "bar": bar, "collision": hertz_collision, "restitution": restitution}

__all__ = ["CASES", "Unavailable"]
