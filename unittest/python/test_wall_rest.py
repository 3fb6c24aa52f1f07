# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""A grain at rest in a corner, and one that falls on a wall with a soft layer, against hand calculation."""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from potdem import formulas, scripts

G, DIAMETER, DENSITY = 9.81, 0.01, 2000.0
RADIUS, MASS = 0.5 * DIAMETER, formulas.sphere_mass(DIAMETER, DENSITY)
LAYER, EXPONENT = 0.1 * RADIUS, 2
HERTZ = 4 / 3 / ((1 - 0.2**2) / 3e6 + (1 - 0.2**2) / 3e8) * math.sqrt(RADIUS)
WALL = "3e8 0.2 particle 3e6 0.2"


def push(w):
    """Hertz under the soft layer, w from its outer face"""
    return HERTZ * w**1.5 * min(1.0, (w / LAYER) ** (1 / EXPONENT)) if w > 0 else 0.0


def grain(place, walls, steps, more="", step=1e-5, columns="", gravity="0 0 -1"):
    return scripts.box(2) + scripts.particles([(*place, DIAMETER)], DENSITY) + f"""
pair_style none
bond_style none
comm_modify cutoff 0.02
{walls}
fix move all nve
fix weight all gravity {G} vector {gravity}
fix wall all potdem/wall/region walls {WALL} {more}
compute ledger all potdem/energy
timestep {step:.17g}
thermo {max(1, steps // 1000)}
variable x equal x[1]
variable z equal z[1]
variable v equal vz[1]
variable fx equal fx[1]
variable fz equal fz[1]
thermo_style custom step v_x v_z v_v v_fx v_fz f_wall[1] f_wall[3] c_ledger c_ledger[8] {columns}
thermo_modify format float {scripts.ALL_DIGITS}
run {steps}
"""


CORNER = "region walls block 0 1 -1 1 0 1 units box"


@pytest.mark.parametrize("friction", ["", "friction 0.3 auto"])
def test_at_rest_in_a_corner(run_lammps, friction):
    """put where the walls carry its weight by hand calculation, it is in balance to rounding, and stays for 1e5 steps"""
    gravity = np.array([-0.4, 0, -1]) / math.hypot(0.4, 1)
    places = [RADIUS + LAYER - brentq(lambda w, load=load: push(w) - load, 0, RADIUS, xtol=1e-19, rtol=1e-15)
              for load in -MASS * G * gravity[[0, 2]]]
    thermo = run_lammps(grain((places[0], 0, places[1]), CORNER, 100000, friction,
                              gravity=" ".join(f"{k:.17g}" for k in gravity))).thermo
    # the place is known to 1e-16 of the radius, the overlap to 1e-15
    for axis, wall, weight in (("v_fx", "f_wall[1]", gravity[0]), ("v_fz", "f_wall[3]", gravity[2])):
        assert abs(thermo[axis][0]) < 1e-13 * MASS * G
        assert thermo[wall][0] == pytest.approx(MASS * G * weight, rel=1e-13)
    # 1e5 steps are one second; not even 1e-6 d of the allowance is used
    for place in ("v_x", "v_z"):
        assert np.ptp(thermo[place]) < 1e-12 * DIAMETER


HEIGHT = 0.1


def fall(H, rtol=1e-12):
    """z, vz at the end of the first bounce where the force has fallen to zero, and the viscous work: integrated"""
    v0 = -math.sqrt(2 * G * (HEIGHT - RADIUS - LAYER))

    def force(z, v):
        w = RADIUS + LAYER - z
        return max(0.0, push(w) * (1 - H * v / w)) if w > 0 else 0.0

    def motion(_, state):
        z, v, _ = state
        w = RADIUS + LAYER - z
        f = force(z, v)
        return v, f / MASS - G, -(f - push(w)) * v

    def leaves(_, state):
        return state[0] - RADIUS - LAYER
    leaves.terminal, leaves.direction = True, 1
    end = solve_ivp(motion, (0, 0.1), (RADIUS + LAYER * (1 - 1e-9), v0, 0.0), "DOP853", events=leaves, rtol=rtol,
                    atol=1e-16, max_step=1e-5)
    return end.y_events[0][0]


def bounce(run_lammps, H, step):
    """speed at the same height after the bounce, speed by the ledger, viscous heat"""
    steps = round((math.sqrt(2 * HEIGHT / G) + 0.005) / step)
    thermo = run_lammps(grain((0, 0, HEIGHT), "region walls plane 0 0 0 0 0 1", steps, f"viscous {H}", step)).thermo
    assert thermo["v_z"][-1] > RADIUS + LAYER and thermo["v_v"][-1] > 0
    assert thermo["v_z"].min() < RADIUS    # through the layer
    z, v, heat = thermo["v_z"][-1], thermo["v_v"][-1], thermo["c_ledger[8]"][-1]
    up = math.sqrt(v**2 + 2 * G * (z - RADIUS - LAYER))
    by_ledger = math.sqrt(2 * G * (HEIGHT - RADIUS - LAYER) - 2 * heat / MASS)
    return up, by_ledger, heat


@pytest.mark.parametrize("H", [0.0, 2e-5])
def test_rebound_from_the_soft_layer(run_lammps, H):
    """the rebound is that of the equation of motion, and what it lacks is what the ledger says. An elastic one is of second
    order in the step; a viscous one of first, because its force takes the velocity of half a step before: 1.5e-6 here"""
    _, expected, work = fall(H)
    step = 2e-6
    coarse, fine = (bounce(run_lammps, H, k * step) for k in (2, 1))
    # within these falls where in a step the contact begins: a few 1e-6 of the speed
    assert coarse[0] == pytest.approx(coarse[1], rel=5e-6)
    assert fine[0] == pytest.approx(fine[1], rel=2e-6)
    if H == 0:
        assert expected == pytest.approx(math.sqrt(2 * G * (HEIGHT - RADIUS - LAYER)), rel=1e-9)
        assert fine[0] == pytest.approx(expected, rel=1e-6)
        assert fine[2] == 0.0
    else:
        assert expected < 0.96 * math.sqrt(2 * G * (HEIGHT - RADIUS - LAYER))
        assert 2 * fine[0] - coarse[0] == pytest.approx(expected, rel=5e-6)
        assert 2 * fine[2] - coarse[2] == pytest.approx(work, rel=1e-4)
