"""What the references of this scene have in common: the beam, where it is taken to be clamped, and the pulses."""

WIDTH = DEPTH = 0.025    # m
MODULUS, POISSON, DENSITY = 5e9, 0.1, 2400.0
FORCE = 1000.0           # N
TIME = 0.03              # s, three periods

# (length, place of the load) from the clamp. half: the clamp acts midway between the last clamped and the first free
# layer of particles; layer: in the last clamped layer. The load acts on the last layer, half a spacing before the end.
CLAMPS = {"half": (0.24, 0.2375), "layer": (0.2425, 0.24)}

# steps and changes of slope: (time, step, change of slope) over the force
PULSES = {"f1": [(0.0, 1.0, 0.0), (1e-3, -1.0, 0.0)],
          "f2": [(0.0, 0.0, 1e3), (1e-3, 0.0, -2e3), (2e-3, 0.0, 1e3)]}
