# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""The eight benchmark tests of Chung and Ooi: impacts of two spheres and of a sphere with a plane, as input for POTDEM and for
LAMMPS's GRANULAR package, what comes out of it, and what should.

Y. C. Chung and J. Y. Ooi, Benchmark tests for verifying discrete element modelling codes at particle impact level, Granular
Matter 13, 2011, 643-656, doi 10.1007/s10035-011-0277-0. Materials, sizes and speeds are those with which YADE, Kratos and PySPH
keep these tests; which has which, what differs, and what is chosen here, is on the page of reports/impacts.py."""

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from potdem import dumps, formulas, impacts, scripts
from potdem.text import replaced

RIGID = 1000.0    # E of a plane, and of the large sphere of test 8a, over that of the sphere
STEPS = 3000      # of a contact
FLIGHT = 5.37     # steps before the contact
LONGEST = 2.5     # time of a run over Hertz's duration


@dataclass(frozen=True)
class Material:
    name: str
    E: float
    nu: float
    density: float


GLASS = Material("glass", 4.8e10, 0.20, 2800)
LIMESTONE = Material("limestone", 2.0e10, 0.25, 2500)
ALLOY_2 = Material("aluminium alloy", 7.0e10, 0.30, 2699)
MAGNESIUM = Material("magnesium alloy", 4.0e10, 0.35, 1800)
OXIDE = Material("aluminium oxide", 3.8e11, 0.23, 4000)
IRON = Material("cast iron", 1.0e11, 0.25, 7000)
ALLOY = Material("aluminium alloy", 7.0e10, 0.33, 2700)
STEEL = Material("steel", 2.08e11, 0.30, 7850)
POLYETHYLENE = Material("polyethylene", 1.0e9, 0.40, 1400)
COPPER = Material("copper", 1.2e11, 0.35, 8900)
NYLON = Material("nylon", 2.5e9, 0.40, 1000)

TITLES = {
    "1": "elastic normal impact of two equal spheres",
    "2": "elastic normal impact of a sphere with a rigid plane",
    "3": "normal impact with different coefficients of restitution",
    "4": "oblique impact with a rigid plane, constant speed, varying angle",
    "5": "oblique impact with a rigid plane, constant normal speed, varying tangential speed",
    "6": "impact with a rigid plane, constant normal speed, varying spin",
    "7": "two equal spheres, constant normal speed, opposite spins",
    "7*": "two equal spheres, constant normal speed, like spins (ours)",
    "8a": "two unlike spheres, varying spin; the large one stiff and heavy",
    "8b": "two unlike spheres, varying spin; the large one heavy",
}


@dataclass(frozen=True)
class Impact:
    """speeds of both towards the contact, tangential velocity of the first, r omega of both, positive where the surface of the
    first goes forwards over that of the second"""

    towards: tuple
    velocity: float = 0.0
    spins: tuple = (0.0, 0.0)

    @property
    def approach(self):
        return sum(self.towards)


@dataclass(frozen=True)
class Scene:
    """impacts of one material. partner: radius, E and density of the second sphere over those of the first, None: a plane; fine:
    steps of the shortest contact"""

    test: str
    material: Material
    radius: float
    impacts: tuple
    partner: tuple = None
    mu: float = 0.0
    e: float = 1.0
    fine: int = STEPS

    @property
    def name(self):
        return f"{self.test} {self.material.name}" + (f" e={self.e:g}" if self.test == "3" else "")

    @cached_property
    def bodies(self):
        """what the theories know of it"""
        E, nu = self.material.E, self.material.nu
        first = formulas.sphere_mass(2 * self.radius, self.material.density)
        size, stiff, dense = self.partner or (np.inf, RIGID, np.inf)
        second = first * size**3 * dense
        softness = (1 + 1 / stiff) / E
        return impacts.Bodies((first, second), (self.radius, self.radius * size), 1 / ((1 - nu**2) * softness),
                              1 / (2 * (2 - nu) * (1 + nu) * softness), self.mu, self.e)

    @property
    def mixed(self):
        return self.partner is not None and self.partner != TWIN

    @property
    def step(self):
        return self.bodies.duration(max(i.approach for i in self.impacts)) / self.fine

    @property
    def steps(self):
        slowest = min(i.approach for i in self.impacts)
        return int(FLIGHT + LONGEST * self.bodies.duration(slowest) / self.step) + 1


TWIN = (1.0, 1.0, 1.0)


def degrees(*angles):
    return [np.tan(np.radians(a)) for a in angles]


FIVE_TO_85 = [5.0 * k for k in range(1, 18)]


def oblique(speed, tangents):
    return tuple(Impact((speed, 0.0), speed * t) for t in tangents)


def spinning(speed, tangents):
    return tuple(Impact((speed, 0.0), 0.0, (speed * t, 0.0)) for t in tangents)


def both_spin(speed, tangents, second):
    return tuple(Impact((speed, speed), 0.0, (speed * t, second * speed * t)) for t in tangents)


def scenes():
    """all of them"""
    angles = degrees(*FIVE_TO_85)
    found = [Scene("1", m, 0.01, (Impact((10.0, 10.0)),), TWIN, 0.35) for m in (GLASS, LIMESTONE)]
    found += [Scene("2", m, 0.1, (Impact((0.2, 0.0)),)) for m in (ALLOY_2, MAGNESIUM)]
    two_speeds = Impact((3.9, 0.0)), Impact((0.39, 0.0))
    found += [Scene("3", m, 0.0025, two_speeds, e=e) for m in (OXIDE, IRON) for e in (0.2, 0.4, 0.6, 0.8, 1.0)]
    by_angle = tuple(Impact((3.9 * np.cos(np.radians(a)), 0.0), 3.9 * np.sin(np.radians(a))) for a in FIVE_TO_85)
    found += [Scene("4", m, 0.0025, by_angle, mu=0.092, e=0.98) for m in (OXIDE, ALLOY)]
    found += [Scene("5", m, 1e-5, oblique(5.0, angles), mu=0.3) for m in (STEEL, POLYETHYLENE)]
    found += [Scene("6", m, 0.1, spinning(0.2, angles), mu=0.4, e=0.5) for m in (ALLOY, NYLON)]
    for test, second in (("7", -1), ("7*", 1)):
        found += [Scene(test, m, 0.1, both_spin(0.2, angles, second), TWIN, 0.4, 0.5) for m in (ALLOY, COPPER)]
    for test, stiff in (("8a", RIGID), ("8b", 1.0)):
        found += [Scene(test, m, 0.1, spinning(0.2, angles), (5.0, stiff, 1000.0), 0.4, 0.5) for m in (ALLOY, NYLON)]
    return found


# --- input ----------------------------------------------------------------------------------------------------------------------

def potdem(scene):
    """pair style, or wall"""
    E, nu = scene.material.E, scene.material.nu
    law = (f" restitution {scene.e:.17g}" if scene.e < 1 else "") + (f" friction {scene.mu:.17g} mindlin" if scene.mu else "")
    if scene.partner is None:
        return f"""pair_style zero {2 * scene.radius:.17g}
pair_coeff * *
region plane plane 0 0 0 0 0 1 units box
fix plane all potdem/wall/region plane {RIGID * E:.17g} {nu} particle {E:.17g} {nu} layer none{law} rotation yes
"""
    style = "pair_style potdem/hertz rotation yes\n"
    if not scene.mixed:
        return style + f"pair_coeff * * {E:.17g} {nu}{law}\n"
    return style + f"""pair_coeff 1 1 {E:.17g} {nu}
pair_coeff 2 2 {scene.partner[1] * E:.17g} {nu}
pair_coeff 1 2 mixed{law}
"""


DAMPING, TANGENTIAL = "damping coeff_restitution", "tangential mindlin_rescale/force"    # of GRANULAR


def lammps_law(scene, E):
    return f"hertz/material {E:.17g} {scene.e:.17g} {scene.material.nu} {DAMPING} {TANGENTIAL} NULL 0 {scene.mu:.17g}"


def lammps(scene):
    """the same of the GRANULAR package. It takes two bodies for equal, so that it gets the E that has the same E* and G*"""
    law = lammps_law(scene, 2 * (1 - scene.material.nu**2) * scene.bodies.modulus)
    if scene.partner is None:
        return f"pair_style zero {2 * scene.radius:.17g}\npair_coeff * *\nfix plane all wall/gran granular {law} zplane 0 NULL\n"
    return f"pair_style granular\npair_coeff * * {law}\n"


def lammps_mixed(scene):
    """the same, as a user would give two types"""
    one, two = (lammps_law(scene, factor * scene.material.E) for factor in (1.0, scene.partner[1]))
    return f"pair_style granular\npair_coeff 1 1 {one}\npair_coeff 2 2 {two}\n"


def lammps_with(old, new):
    """the same with other words in the law"""
    return lambda scene: replaced(lammps(scene), old, new)


FIRST, SECOND = "first.dump", "second.dump"


def places(scene):
    """(x, y, z, diameter, type), (vx, vz, omegay) of each sphere: a row of impacts along y, each along z"""
    size = scene.partner[0] if scene.partner else 1.0
    spacing = 4 * scene.radius * size
    for number, impact in enumerate(scene.impacts):
        y = (number - 0.5 * (len(scene.impacts) - 1)) * spacing
        above, below = (v * FLIGHT * scene.step for v in impact.towards)
        motion = impact.velocity, -impact.towards[0], -impact.spins[0] / scene.radius
        yield (0.0, y, scene.radius + above, 2 * scene.radius, 1), motion
        if scene.partner:
            radius = scene.radius * size
            yield (0.0, y, -radius - below, 2 * radius, 2), (0.0, impact.towards[1], -impact.spins[1] / radius)


def script(scene, laws, every=False):
    """every: with force and overlap at each step"""
    rows, motions = zip(*places(scene))
    size = scene.partner[0] if scene.partner else 1.0
    far = scene.radius * size
    travel = max(abs(i.velocity) + i.approach for i in scene.impacts) * scene.step * scene.steps
    wide, long = 2 * travel + 10 * far, (len(scene.impacts) + 2) * 4 * far
    text = scripts.box((wide, long, wide), types=2, atom_style="sphere", skin=0.2 * scene.radius)
    text += scripts.particles(rows, scene.material.density)
    if scene.partner:
        text += f"set type 2 density {scene.material.density * scene.partner[2]:.17g}\n"
    text += "comm_modify vel yes\n"
    for number, (vx, vz, spin) in enumerate(motions, start=1):
        text += f"set atom {number} vx {vx:.17g} vz {vz:.17g} omega 0 {spin:.17g} 0\n"
    text += laws(scene) + f"fix move all nve/sphere\ntimestep {scene.step:.17g}\ngroup first type 1\ngroup second type 2\n"
    if every:
        text += "compute force all reduce max fz\ncompute place all reduce max z\nthermo_style custom step time c_force c_place\n"
        text += f"thermo_modify format float {scripts.ALL_DIGITS}\n"
    text += f"thermo {1 if every else scene.steps}\nrun {scene.steps}\n"
    for group, file in (("first", FIRST), ("second", SECOND)):
        text += scripts.write_dump(file, "z vx vz omegay").replace("write_dump all", f"write_dump {group}")
    return text


# --- what comes out -------------------------------------------------------------------------------------------------------------

@dataclass
class Rebound:
    """of one impact, over its speed of approach: velocity of the centres, spins of both surfaces, e; duration: over Hertz's"""

    velocity: float
    spins: tuple
    e: float
    duration: float

    @property
    def spin(self):
        return sum(self.spins)

    @property
    def surface(self):
        return self.velocity + self.spin


@dataclass
class Measured:
    """rebounds in the order of the impacts; force and overlap: the largest, where each step was looked at"""

    rebounds: list
    force: float = None
    overlap: float = None
    history: tuple = field(default=None, repr=False)    # time, force, overlap


def read(scene, folder, thermo=None):
    """Measured, from the folder of a run"""
    (first,) = dumps.read(folder / FIRST)
    still = {name: np.zeros(len(scene.impacts)) for name in ("vx", "vz", "omegay", "z")}
    second = dumps.read(folder / SECOND)[0] if scene.partner else still
    outer = scene.radius * scene.partner[0] if scene.partner else 0.0
    time, found = scene.step * scene.steps, []
    for number, impact in enumerate(scene.impacts):
        one, two = ({name: frame[name][number] for name in still} for frame in (first, second))
        speed, leaves = impact.approach, one["vz"] - two["vz"]
        gap = one["z"] - two["z"] - scene.radius - outer
        duration = time - FLIGHT * scene.step - gap / leaves
        spins = -one["omegay"] * scene.radius / speed, -two["omegay"] * outer / speed
        found.append(Rebound((one["vx"] - two["vx"]) / speed, spins, leaves / speed, duration / scene.bodies.duration(speed)))
    if thermo is None:
        return Measured(found)
    sides = 2 if scene.partner else 1    # equal spheres
    overlap = sides * (scene.radius - thermo["c_place"])
    history = thermo["Time"], thermo["c_force"], overlap
    return Measured(found, thermo["c_force"].max(), overlap.max(), history)


def expected(scene, own_arms=False, **settings):
    """Outcomes of the no-slip theory; own_arms: as POTDEM has them, from the centres to the contact point"""
    b = scene.bodies
    return [impacts.no_slip(b.kappa, b.mu, b.e, i.velocity / i.approach, sum(i.spins) / i.approach,
                            shortening=b.shortening(i.approach) if own_arms else 0.0, **settings) for i in scene.impacts]
