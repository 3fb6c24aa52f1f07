# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""What the impacts of chung_ooi.py are compared with: answers that know nothing of LAMMPS, tolerances and their reasons."""

from dataclasses import dataclass

from potdem import impacts
from potdem.chung_ooi import RIGID, STEPS, expected

# name -> (what it is, why the tolerance is what it is)
ANSWERS = {
    "Hertz": (
        "closed form of the elastic impact",
        "1e-6: the error of a step is of second order, and 3000 are taken to a contact"),
    "published": (
        "largest force of the paper's figure, as Kratos keeps it (limestone 7108 N, magnesium alloy 7233 N)",
        "0.001: read to 4 digits, and Kratos's plane is stiffer by that"),
    "given e": (
        "the coefficient of restitution that was asked for",
        "a step of the contact's 3000, as the dashpot sees a velocity half a step old; of two spheres 2 w0/(r1 + r2) more, by "
        "which their normal turns"),
    "symmetry": (
        "equal surface velocities: nothing rubs, nothing changes",
        "1e-9: rounding"),
    "rigid sliding": (
        "tangential impulse μ (1 + e) m* v_n, closed form, of the impacts that slide throughout",
        "a step, as friction sees a velocity half a step old. With e < 1 the dashpot's force is there before the spring of "
        "friction is strained, which may take up to 0.64 c² μ v_n/(κ u (1 + e)) of the impulse, c: of the dashpot, κ: tangential "
        "stiffness over normal one"),
    "no slip": (
        "Hertz, Mindlin's stiffness, Coulomb's limit: equation of motion solved to 1e-10, overlaps small",
        "a step, and 2 w0/(r1 + r2), at a plane 2 w0/r, for the arms, which the overlap shortens or not, and for the normal of "
        "two spheres that turns"),
    "no slip, own arms": (
        "the same with arms from the centres to the contact point, as POTDEM has them",
        "a step; of two spheres 2 w0/(r1 + r2) more"),
    "no slip, pulling dashpot": (
        "the same with the dashpot that GRANULAR has: it may pull before the spheres part",
        "as *no slip*"),
    "ring of slip": (
        "friction that slips in a ring and sticks inside (Maw, Barber and Fawcett)",
        "0.1, a tenth of what friction can do: the theories differ by that, not the codes"),
}
PUBLISHED = {"1 limestone": 7108.0, "2 magnesium alloy": 7233.0}
A_STEP = 1 / STEPS


@dataclass(frozen=True)
class Compared:
    """error: the largest of the scene's impacts; relative, of velocities and spins over the largest change that friction makes"""

    test: str
    scene: str
    quantity: str
    answer: str
    error: float
    tolerance: float

    @property
    def good(self):
        return self.error <= self.tolerance


def compare(scene, measured, potdem=True):
    """a list of Compared; potdem: with the answers that are meant for POTDEM, else with those for GRANULAR"""
    def row(quantity, answer, error, tolerance):
        found.append(Compared(scene.test, scene.name, quantity, answer, float(error), tolerance))

    found = []
    if scene.test in "12":
        normal(scene, measured, row)
        return found
    row("restitution", "given e", max(abs(r.e - scene.e) for r in measured.rebounds), A_STEP + turn(scene))
    if scene.test == "7":
        row("tangential velocity", "symmetry", max(abs(r.velocity) for r in measured.rebounds), 1e-9)
        turned = [r.spins[0] - i.spins[0] / i.approach for r, i in zip(measured.rebounds, scene.impacts)]
        row("spin", "symmetry", max(map(abs, turned)), 1e-9)
    elif scene.mu:
        friction(scene, measured, row, potdem)
    return found


def overlaps(scene):
    """how much an overlap may matter"""
    return 2 * max(scene.bodies.shortening(i.approach) for i in scene.impacts)


def turn(scene):
    """of the normal of two spheres"""
    return overlaps(scene) if scene.partner else 0.0


def normal(scene, measured, row):
    b, speed = scene.bodies, scene.impacts[0].approach
    row("largest force", "Hertz", abs(measured.force / b.largest_force(speed) - 1), 1e-6)
    if scene.name in PUBLISHED:
        row("largest force", "published", abs(measured.force / PUBLISHED[scene.name] - 1), 1 / RIGID)
    row("largest overlap", "Hertz", abs(measured.overlap / b.overlap(speed) - 1), 1e-6)
    row("duration", "Hertz", abs(measured.rebounds[0].duration - 1), 1e-6)
    row("rebound speed", "Hertz", abs(measured.rebounds[0].e - 1), 1e-6)


def friction(scene, measured, row, potdem):
    b = scene.bodies
    scales = impacts.rigid_sliding(b.e, b.mu)
    small = expected(scene)

    def against(outcomes, answer, tolerance):
        for quantity, of, scale in (("tangential velocity", "velocity", scales[0]), ("spin", "spin", scales[1])):
            apart = max(abs(getattr(r, of) - getattr(o, of)) for r, o in zip(measured.rebounds, outcomes))
            row(quantity, answer, apart / abs(scale), tolerance)

    sliding(scene, measured, small, row)
    against(small, "no slip", A_STEP + overlaps(scene))
    if potdem:
        against(expected(scene, own_arms=True), "no slip, own arms", A_STEP + turn(scene))
    elif b.e < 1:
        against(expected(scene, pulls=True), "no slip, pulling dashpot", A_STEP + overlaps(scene))
    if scene.test == "5":
        against(impacts.partial_slip(b.kappa, b.mu, [i.velocity / i.approach for i in scene.impacts]), "ring of slip", 0.1)


def sliding(scene, measured, outcomes, row):
    """the impacts that slide throughout, by the impulse"""
    b = scene.bodies
    impulse = impacts.rigid_sliding(b.e, b.mu)[0]
    those = [(r, i) for r, o, i in zip(measured.rebounds, outcomes, scene.impacts) if o.slides]
    slowest = min((i.velocity + sum(i.spins)) / i.approach for _, i in those)
    before_strained = 0.64 * impacts.damping_for(b.e) ** 2 * b.mu / (b.kappa * slowest * (1 + b.e))
    apart = [(r.velocity - i.velocity / i.approach) / impulse - 1 for r, i in those]
    row("tangential velocity", "rigid sliding", max(map(abs, apart)), A_STEP + before_strained)
