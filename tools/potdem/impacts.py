# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""One impact of two elastic spheres, or of a sphere and a plane, in three theories that share no code with LAMMPS.

* closed forms: the elastic impact of Hertz, and the sliding of rigid bodies
* `no_slip`: Hertz's force, Mindlin's tangential stiffness without slip and Coulomb's limit, an ordinary differential equation
  (Di Renzo and Di Maio, Chem. Eng. Sci. 59, 2004, 525-541), with a force that falls as its stiffness does (Thornton, Cummins and
  Cleary, Powder Technol. 210, 2011, 189-197) or stays
* `partial_slip`: the physics behind it, friction that slips in a ring of the contact and sticks inside (Maw, Barber and Fawcett,
  Wear 38, 1976, 101-114), by a row of springs that slip each for itself (Lyashenko and Popov, Sci. Rep. 5, 2015, 8479)

Velocities are over the speed of approach, lengths over Hertz's largest overlap w0, forces over m* v^2/w0. Then Hertz's force is
5/4 w^(3/2), and what is left of two bodies are e, mu and kappa = 4 G*/E*, tangential stiffness over normal stiffness."""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq
from scipy.special import gamma

PRECISE = {"method": "DOP853", "rtol": 1e-10, "atol": 1e-13}
BEGIN = 1e-10    # overlap with which an integration begins, so that rates of w^(1/4) are finite
TINY = 1e-30     # that trial steps beyond the end see
END = 1e-13      # force and overlap that are none
BEYOND = 1e-7    # time to step over an instant without force
LONGEST = 50.0   # no contact lasts as long
SPIN = 2.5       # m r^2/I of a solid sphere


def hertz_force(w):
    return 1.25 * w**1.5


DURATION = 2 * np.sqrt(np.pi) * gamma(0.4) / (2.5 * gamma(0.9))    # of an elastic contact, 2.943 w0/v


@dataclass(frozen=True)
class Bodies:
    """two spheres that touch; a plane is a sphere of infinite mass and radius. modulus, shear: E* and G*"""

    masses: tuple
    radii: tuple
    modulus: float
    shear: float
    mu: float = 0.0
    e: float = 1.0

    @property
    def mass(self):
        return 1 / sum(1 / m for m in self.masses)

    @property
    def hertz(self):
        """K in F = K w^(3/2)"""
        return 4 / 3 * self.modulus * np.sqrt(1 / sum(1 / r for r in self.radii))

    @property
    def kappa(self):
        return 4 * self.shear / self.modulus

    def overlap(self, speed):
        """the largest of an elastic impact, w0"""
        return (1.25 * self.mass * speed**2 / self.hertz) ** 0.4

    def largest_force(self, speed):
        return self.hertz * self.overlap(speed) ** 1.5

    def duration(self, speed):
        return DURATION * self.overlap(speed) / speed

    def shortening(self, speed):
        """how much shorter the arms of friction are at the largest overlap, over their length"""
        return self.overlap(speed) / sum(r for r in self.radii if np.isfinite(r))


# --- the normal direction -------------------------------------------------------------------------------------------------------
# A dashpot that goes with w^(1/4) makes e independent of the speed. At the end it would pull. Either it may (Antypov and Elliott,
# Europhys. Lett. 94, 2011, 50004), or the contact ends where the force does (Thornton, Cummins and Cleary, Powder Technol. 233,
# 2013, 30-46).

def repulsion(w, rate, damping):
    w = max(w, 0.0)
    return hertz_force(w) + damping * w**0.25 * rate


def restitution(damping):
    """e of a dashpot that does not pull"""
    def motion(_, state):
        return [state[1], -repulsion(*state, damping)]

    def force(_, state):
        return repulsion(*state, damping) - END

    force.terminal, force.direction = True, -1
    return -solve_ivp(motion, (0, LONGEST), [BEGIN, 1.0], events=force, **PRECISE).y[1, -1]


@lru_cache(maxsize=None)
def damping_for(e, pulls=False):
    """inverse, and the closed form of a dashpot that pulls"""
    if pulls:
        return -2.5 * np.log(e) / np.hypot(np.pi, np.log(e))
    return 0.0 if e == 1.0 else brentq(lambda c: restitution(c) - e, 0.0, 20.0, xtol=1e-11)


# --- friction -------------------------------------------------------------------------------------------------------------------

def rigid_sliding(e, mu):
    """(change of the tangential velocity, of the surfaces' spin) where the surfaces slide throughout, forwards: the tangential
    impulse is mu times the normal one"""
    return -mu * (1 + e), -SPIN * mu * (1 + e)


@dataclass
class Outcome:
    """velocity: of the centres along the contact; spin: sum of r omega of both surfaces; slides: all the time, but for an overlap
    below w0/10 at the beginning, as long as the spring is weaker than the friction that a dashpot's force allows"""

    velocity: float
    spin: float
    slides: bool

    @property
    def surface(self):
        return self.velocity + self.spin


class NoSlip:
    """the equation of an impact; state: overlap, its rate, velocity of the centres, spin of the surfaces, tangential force

    shortening: see Bodies; 0 as published, where overlaps are small
    pulls: the dashpot may, and friction goes by the size of the force
    rescaled: the tangential force falls as its stiffness does"""

    def __init__(self, kappa, mu, e, shortening=0.0, pulls=False, rescaled=True):
        self.kappa, self.mu, self.damping, self.pulls = kappa, mu, damping_for(e, pulls), pulls
        self.shortening, self.rescaled = shortening, rescaled

    def normal(self, state):
        return repulsion(state[0], state[1], self.damping)

    def most(self, state):
        """that friction can be"""
        return self.mu * abs(self.normal(state))

    def rate_of_most(self, state):
        w, rate, normal = max(state[0], TINY), state[1], self.normal(state)
        change = 1.875 * np.sqrt(w) * rate + self.damping * (0.25 * w**-0.75 * rate**2 - w**0.25 * normal)
        return self.mu * np.sign(normal) * change

    def arm(self, state):
        return 1 - self.shortening * state[0]

    def spring_rate(self, state, force):
        """dT/dt of what sticks"""
        w, rate, velocity, spin = max(state[0], TINY), *state[1:4]
        loses = force * rate / (2 * w) if rate < 0 and self.rescaled else 0.0
        return -1.875 * self.kappa * np.sqrt(w) * (velocity + self.arm(state) * spin) + loses

    def motion(self, state, sign):
        """sign: of the force that slides; 0: sticks"""
        friction = sign * self.most(state) if sign else state[4]
        change = 0.0 if sign else self.spring_rate(state, friction)
        return [state[1], -self.normal(state), friction, SPIN * self.arm(state) * friction, change]

    def turns(self, state, sign):
        """falls through 0 where sticking becomes sliding, or sliding sticking"""
        if not sign:
            return self.most(state) - abs(state[4])
        return sign * self.spring_rate(state, sign * self.most(state)) - self.rate_of_most(state)

    def stretch(self, state, sign):
        """until something changes: (state, event), 0: sticking or sliding, 1: no force, 2: no overlap"""
        events = [lambda _, y: self.turns(y, sign), lambda _, y: self.normal(y) - END, lambda _, y: y[0] - END]
        for event in events:
            event.terminal, event.direction = True, -1
        found = solve_ivp(lambda _, y: self.motion(y, sign), (0, LONGEST), state, events=events, **PRECISE)
        return found.y[:, -1], next(k for k in (2, 1, 0) if len(found.t_events[k]))

    def __call__(self, velocity, spin):
        state, sign, slides, event = np.array([BEGIN, 1.0, velocity, spin, 0.0]), 0, True, 0
        last = 2 if self.pulls else 1
        while event < last:
            state, event = self.stretch(state, sign)
            slides &= bool(sign) or (state[0] < 0.1 and state[1] > 0)
            if event == 1:    # the force changes its sign, just beyond that the spring begins anew
                state[4] = 0.0
                sign, state = 0, state + BEYOND * np.array(self.motion(state, 0))
                state[4] = 0.0
            elif sign:
                sign, state[4] = 0, sign * self.most(state)
            else:
                sign = np.sign(state[4])
        return Outcome(state[2], state[3], slides)


def no_slip(kappa, mu, e, velocity, spin, **settings):
    """Outcome of an impact of that velocity and spin, over the speed of approach; settings of NoSlip"""
    return NoSlip(kappa, mu, e, **settings)(velocity, spin)


def partial_slip(kappa, mu, velocities, springs=400, steps=6000):
    """Outcomes of elastic impacts without spin, by springs along a line, over a parabola: each has the normal force
    P (w - x^2), P = 15/16, and sticks up to mu times that"""
    velocity = np.asarray(velocities, dtype=float)
    spin = np.zeros_like(velocity)
    x = (np.arange(springs) + 0.5) / springs
    width, stiff = 2 / springs, 0.9375
    dt = 1.02 * DURATION / steps
    shear = np.zeros((len(velocity), springs))
    w, rate = 0.0, 1.0
    for _ in range(steps):
        rate -= 0.5 * dt * hertz_force(w)
        w = max(w + dt * rate, 0.0)
        pressure = stiff * np.maximum(w - x**2, 0.0)
        shear -= np.where(pressure > 0, kappa * stiff * dt, 0.0) * (velocity + spin)[:, None]
        np.clip(shear, -mu * pressure, mu * pressure, out=shear)
        force = width * shear.sum(axis=1)
        velocity = velocity + dt * force
        spin = spin + SPIN * dt * force
        rate -= 0.5 * dt * hertz_force(w)
    return [Outcome(v, s, False) for v, s in zip(velocity, spin)]
