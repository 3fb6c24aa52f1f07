# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Collisions of two grains and of a grain with a wall, against solutions of their equation of motion."""

from dataclasses import dataclass, field
from typing import Callable

import numpy as np
from scipy.integrate import solve_ivp

from potdem import dumps, formulas
from potdem.reports.cases.case import HERE, Case, exact_errors, lammps
from potdem.reports.work_precision import order

SCRIPT = HERE / "in.collisions"
D1, D2, DENSITY = 1.0, 1.6, 2.0    # as in the script
MASSES = [np.pi / 6 * DENSITY * d**3 for d in (D1, D2)]
REDUCED = MASSES[0] * MASSES[1] / sum(MASSES)
TOUCH = (D1 + D2) / 2
ATTRIBUTES = {"d1": D1, "d2": D2, "E1": 3e6, "E2": 3e6, "nu1": 0.3, "nu2": 0.3, "area": 0.4, "K0": 1e6, "alpha": 0.2, "n": 3.0, "R": 0.26,
              "layer": 0.1, "m": 2.0}
HERTZ = formulas.hertz(ATTRIBUTES)
PREFACTOR = float(HERTZ.force(TOUCH - 1.0))    # K in F = K w^1.5
RADIUS = D1 * D2 / 2 / (D1 + D2)               # of the two together
PRECISE = {"method": "DOP853", "rtol": 1e-12}


@dataclass
class Meeting:
    """a law, what LAMMPS calls it, and how fast the particles come; force: of the distance, mass: the reduced one, viscous: H"""

    series: str
    variables: dict
    law: Callable
    reach: float = TOUCH
    speed: float = 1.0
    mass: float = REDUCED
    lightest: float = MASSES[0]
    viscous: float = 0.0
    peer: bool = False
    exact: tuple = field(init=False)    # duration, velocity after over that before
    nearest: float = field(init=False)

    def __post_init__(self):
        self.exact, self.nearest = (collision if self.viscous else elastic_collision)(self)

    @property
    def critical(self):
        """the critical step at the nearest: 2/omega, omega^2 = 2 max(K/m) or, at a wall, K/m"""
        h = 1e-6 * self.reach
        stiffness = (self.law(self.nearest) - self.law(self.nearest + h)) / h
        return 2 / np.sqrt((2 if self.mass == REDUCED else 1) * stiffness / self.lightest)


def elastic_collision(meeting):
    """(duration, 1), nearest distance: the way in to rest, twice; nothing is rough on it"""
    def motion(_, state):
        return [-state[1], -float(meeting.law(state[0])) / meeting.mass]

    def rest(_, state):
        return state[1]

    rest.terminal = True
    start = meeting.reach * (1 - 1e-13)    # a law may begin with a jump
    done = solve_ivp(motion, (0, 10 * meeting.reach / meeting.speed), [start, meeting.speed], events=rest,
                     atol=1e-14 * meeting.reach, **PRECISE)
    return (2 * done.t_events[0][0], 1.0), done.y_events[0][0][0]


def collision(meeting):
    """the same of Hertz with viscosity, eq. 5.17 without attraction. With the overlap w = q^2 and dt = q ds all is polynomial:
    q' = v/2, v' = -K/m q^2 (q^2 + H v), t' = q; the push ends at q^2 + H v = 0, and they part freely"""
    H, rate = meeting.viscous, PREFACTOR / meeting.mass
    scale = np.sqrt((1.25 * meeting.mass * meeting.speed**2 / PREFACTOR) ** 0.4)

    def motion(_, state):
        q, v, _ = state
        return [0.5 * v, -rate * q * q * (q * q + H * v), q]

    def push(_, state):
        return state[0] ** 2 + H * state[1]

    push.terminal, push.direction = True, -1
    first = solve_ivp(motion, (0, 1e-3 * scale / meeting.speed), (0.0, meeting.speed, 0.0), atol=1e-15, **PRECISE)
    rest = solve_ivp(motion, (0, 1e4 * scale / meeting.speed), first.y[:, -1], events=push, atol=1e-14 * scale, dense_output=True, **PRECISE)
    q, v, t = rest.y_events[0][0]
    return (t + q * q / -v, -v / meeting.speed), meeting.reach - np.max(rest.y[0]) ** 2


def bare_wall(z):
    return 4 / 3 * formulas.modulus(ATTRIBUTES) * np.sqrt(D2 / 2) * np.maximum(D2 / 2 - z, 0.0) ** 1.5


def hertz_meetings(**settings):
    """POTDEM's Hertz contact and LAMMPS's two; viscous: H of eq. 5.17"""
    H = settings.get("viscous", 0.0)
    ours = {"style": "potdem/hertz", "coeff": "3e6 0.3" + (f" viscous {H}" if H else "")}
    return [Meeting("potdem/hertz", ours, HERTZ.force, **settings), Meeting("gran/hertz/history", gran(H), HERTZ.force, peer=True, **settings),
            Meeting("granular", granular_style(H), HERTZ.force, peer=True, **settings)]


def other_meetings():
    truss, granular, lj = (law({**ATTRIBUTES, "n": n}) for law, n in
                           ((formulas.truss_contact, 0), (formulas.granular, 6.0), (formulas.lennard_jones, 3.0)))
    wall = formulas.wall(ATTRIBUTES)
    on_wall = {"mass": MASSES[1], "lightest": MASSES[1]}
    bare, soft = ({"against": "wall", "wall": f"3e6 0.3 particle 3e6 0.3 {layer}"} for layer in ("layer none", "layer 0.1 2"))
    return [
        Meeting("potdem/truss", {"style": "potdem/truss", "coeff": "3e6 0.4"}, truss.force),
        Meeting("potdem/granular", {"style": "potdem/granular", "coeff": "1e6 6 0.2", "shift": "yes"}, granular.force, granular.ends[0],
                speed=30.0),
        Meeting("potdem/lj", {"style": "potdem/lj", "coeff": "1e6 0.26 3 0.2", "shift": "yes"}, lj.force, lj.ends[0], speed=30.0),
        Meeting("wall, no layer", bare, bare_wall, D2 / 2, **on_wall),
        Meeting("wall, soft layer", soft, wall.force, wall.ends[0], **on_wall),
    ]


def gran(H):
    """sqrt(R w) (k w + m gamma w') is eq. 5.17"""
    k = PREFACTOR / np.sqrt(RADIUS)
    gamma = f"{k * H / REDUCED:.17g}" if H else "0"
    return {"style": f"gran/hertz/history {k:.17g} 0 {gamma} 0 0 0" + (" limit_damping" if H else ""), "coeff": ""}


def granular_style(H):
    """hertz with k, damping m a eta w'"""
    k = PREFACTOR / np.sqrt(RADIUS)
    damping = f"hertz {k:.17g} {k * H / REDUCED:.17g} tangential linear_nohistory 0 0"
    return {"style": "granular", "coeff": damping + (" damping viscoelastic limit_damping" if H else " damping viscoelastic")}


def outcome(meeting, dt):
    """function of a run: root mean squares, over the pairs, of the errors of duration and velocity"""
    def quantities(run):
        (frame,) = dumps.read(run.folder / "end.dump")
        order_of = np.lexsort((frame["z"], frame["y"], frame["type"]))
        x, v = frame["x"][order_of], frame["vx"][order_of]
        if meeting.mass == REDUCED:
            x, v = (np.diff(values.reshape(2, -1), axis=0)[0] for values in (x, v))
        lead = dt * (2 + (np.arange(x.size) + 0.5) / x.size)
        duration = run.thermo["Step"][-1] * dt - (x - meeting.reach) / v - lead
        return {"duration": rms(duration / meeting.exact[0] - 1), "velocity": rms(v / meeting.speed / meeting.exact[1] - 1)}

    return quantities


def rms(values):
    return float(np.sqrt(np.mean(values**2)))


def setting_of(meeting, number, edge):
    """a step of so many to the duration; edge: the root of the number of pairs"""
    dt = meeting.exact[0] / number
    variables = {**meeting.variables, "speed": meeting.speed, "dt": f"{dt:.17g}", "steps": int(np.ceil(1.1 * number)) + 6,
                 "reach": f"{meeting.reach:.17g}", "n": edge}
    return lammps(meeting.series, f"T/{number} = {dt / meeting.critical:.2g} Δt_c", SCRIPT, variables, outcome(meeting, dt), loop=True,
                  peer=meeting.peer)


def orders(points):
    """sentences: exponents of the step, by the three finest"""
    lines = []
    for series in dict.fromkeys(p.series for p in points):
        finest = [p for p in points if p.series == series][-3:]
        steps = [1 / float(p.knob[2:].split()[0]) for p in finest]
        found = {name: order(steps, [p.errors[name] for p in finest]) for name in finest[0].errors}
        lines.append(f"{series}: the error of the duration goes with the step to the power {found['duration']:.1f}, "
                     f"of the velocity {found['velocity']:.1f}.")
    return lines


def case_of(name, title, text, met, short, apart=False):
    labels = {"duration": "the duration", "velocity": "the velocity after"}
    numbers, edge = ((10, 40, 160), 100) if short else ((10, 20, 40, 80, 160, 320), 150)
    return Case(name, title, text, "law", "step", labels, [setting_of(meeting, number, edge) for meeting in met for number in numbers],
                exact_errors(tuple(labels), dict), remarks=orders, apart=apart)


COLLISION_TEXT = """Elastic collisions of two grains of 1 and 1.6 m ([in.collisions](../../tools/potdem/reports/cases/in.collisions)), thousands at once,
each beginning at another place within a step; the errors are root mean squares over them. Reference: the equation of motion, integrated to
10⁻¹² with the laws of [formulas.py](../../tools/potdem/formulas.py). *T*: exact duration, from the distance at which the force begins
to where it ends. $\\Delta t_c$: critical step where the particles turn back.

Peers: LAMMPS's `gran/hertz/history` and `granular` with the same Hertz contact."""

RESTITUTION_TEXT = """As above, with viscosity (eq. 5.17, $H$ = {H:g} s, no attraction): the grains leave at {e:.3f} of the speed with which they came.
LAMMPS's two styles have the same equation in other words, `limit_damping` included. All three take the velocity half a step too early, so
the errors are of first order."""

LAWS_TEXT = """As the collision of two grains, with other laws, and of a grain of 1.6 m with a wall. `potdem/granular` and `potdem/lj` begin with a
jump of the force, at their cut, which makes the errors of first order. One law is no substitute for another: each has its own recommendation."""


def collision_of_grains(short, _):
    return case_of("collision", "Collision of two grains", COLLISION_TEXT, hertz_meetings(), short)


def restitution(short, _):
    met = hertz_meetings(speed=0.5, viscous=2e-3)
    return case_of("restitution", "Viscoelastic restitution", RESTITUTION_TEXT.format(H=met[0].viscous, e=met[0].exact[1]), met, short)


def other_laws(short, _):
    return case_of("laws", "Collisions with other laws", LAWS_TEXT, other_meetings(), short, apart=True)
