# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Figures of the report on impacts: lines are answers, symbols are what was measured."""

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

from potdem import chung_ooi, impacts  # noqa: E402

FIGURES = {"impacts-normal.png": "Tests 1 to 3: force over overlap and time, and the coefficient of restitution",
           "impacts-plane.png": "Tests 4 and 5: oblique impacts with a plane",
           "impacts-spin.png": "Tests 6 to 8: impacts of spheres that spin"}
COLOURS = ("#2a6f97", "#c1502e", "#5b8e3e", "#7a5195")
POTDEM, GRANULAR = {"marker": "o", "markersize": 4.5}, {"marker": "x", "markersize": 7}
STYLES = {"POTDEM": POTDEM, "GRANULAR": GRANULAR}
LIMITED, TSUJI = "GRANULAR, coeff_restitution limit_damping", "GRANULAR, tsuji"
MIXED = "GRANULAR, mixed"


def chosen(scenes, found, *tests):
    """(scene, {code: Measured}) of tests"""
    return [(scene, runs) for scene, runs in zip(scenes, found) if scene.test in tests]


def finish(axes, title, xlabel, ylabel, **limits):
    axes.set(title=title, xlabel=xlabel, ylabel=ylabel, **limits)
    axes.grid(True, color="0.92", linewidth=0.6)
    axes.set_axisbelow(True)
    axes.legend(fontsize=8, frameon=False)


def symbols(axes, x, y, colour, label=None, **style):
    """what was measured"""
    axes.plot(x, y, color=colour, label=label, linestyle="", markeredgewidth=1, **style)


def line(axes, x, y, colour="0.4", label=None, style="-"):
    """an answer"""
    axes.plot(x, y, color=colour, label=label, linestyle=style, linewidth=1)


def both_codes(axes, x, of, runs, colour, label):
    """of: of a rebound"""
    for name, style in STYLES.items():
        symbols(axes, x, [of(rebound) for rebound in runs[name].rebounds], colour, f"{label}, {name}", **style)


def panels(path, draws):
    figure, row = plt.subplots(1, len(draws), figsize=(5.2 * len(draws), 4.6), constrained_layout=True)
    for axes, draw_one in zip(row, draws):
        draw_one(axes)
    figure.savefig(path, dpi=110)
    plt.close(figure)


# --- tests 1 to 3 ---------------------------------------------------------------------------------------------------------------

def samples(runs):
    """(style, time, force, overlap) of both codes, few and not at the same instants"""
    for first, (name, style) in zip((0, 75), STYLES.items()):
        time, force, overlap = (column[first::150] for column in runs[name].history)
        inside = overlap > 0
        yield style, time[inside], force[inside], overlap[inside]


def force_over_overlap(axes, scenes, found):
    for colour, (scene, runs) in zip(COLOURS, chosen(scenes, found, "1", "2")):
        b = scene.bodies
        w = np.linspace(0, b.overlap(scene.impacts[0].approach), 100)
        line(axes, 1e6 * w, 1e-3 * b.hertz * w**1.5, colour, f"test {scene.test}, {scene.material.name}")
        for style, _, force, overlap in samples(runs):
            symbols(axes, 1e6 * overlap, 1e-3 * force, colour, **style)
    for name, style in STYLES.items():
        symbols(axes, [], [], "0.4", name, **style)
    finish(axes, "Tests 1 and 2", "overlap, µm", "normal force, kN")


def force_over_time(axes, scenes, found):
    line(axes, *hertz_in_time(), label="Hertz")
    for colour, (scene, runs) in zip(COLOURS, chosen(scenes, found, "1", "2")):
        b, speed = scene.bodies, scene.impacts[0].approach
        for style, time, force, _ in samples(runs):
            since = (time - chung_ooi.FLIGHT * scene.step) / b.duration(speed)
            symbols(axes, since, force / b.largest_force(speed), colour, **style)
    for name, style in STYLES.items():
        symbols(axes, [], [], "0.4", name, **style)
    finish(axes, "Tests 1 and 2", "time over the duration after Hertz", "force over the largest after Hertz")


def hertz_in_time():
    """time over the duration, force over the largest: the way in by the quadrature of dx/sqrt(1 - x^(5/2)), and back"""
    x = np.sin(np.linspace(0, np.pi / 2, 2001)) ** 2
    middle = 0.5 * (x[1:] + x[:-1])
    time = np.concatenate([[0], np.cumsum(np.diff(x) / np.sqrt(1 - middle**2.5))])
    time *= 0.5 / time[-1]
    return np.concatenate([time, 1 - time[::-1]]), np.concatenate([x, x[::-1]]) ** 1.5


def restitution(axes, scenes, found):
    rows = [(scene, runs) for scene, runs in chosen(scenes, found, "3") if scene.material == chung_ooi.OXIDE]
    looks = {"POTDEM": (COLOURS[0], POTDEM), "GRANULAR": (COLOURS[0], GRANULAR),
             LIMITED: (COLOURS[1], {**GRANULAR, "marker": "+"}), TSUJI: (COLOURS[2], {**GRANULAR, "marker": "2"})}
    for name, (colour, style) in looks.items():
        symbols(axes, [scene.e for scene, _ in rows], [runs[name].rebounds[0].e for _, runs in rows], colour, name, **style)
    line(axes, [0, 1], [0, 1], label="as asked for")
    finish(axes, "Test 3, aluminium oxide", "coefficient of restitution asked for", "rebound speed over speed of approach")


# --- tests 4 and 5 --------------------------------------------------------------------------------------------------------------

def by_angle(axes, scenes, found, of, **labels):
    """of: of a rebound or outcome, tangential and normal speed before, radius"""
    fine = np.radians(np.linspace(2, 88, 120))
    for colour, (scene, runs) in zip(COLOURS, chosen(scenes, found, "4")):
        b, speed = scene.bodies, np.hypot(scene.impacts[0].velocity, scene.impacts[0].approach)
        outcomes = [impacts.no_slip(b.kappa, b.mu, b.e, np.tan(a), 0.0) for a in fine]
        values = [of(o, speed * np.sin(a), speed * np.cos(a), scene.radius) for o, a in zip(outcomes, fine)]
        line(axes, np.degrees(fine), values, colour)
        for name, style in STYLES.items():
            values = [of(r, i.velocity, i.approach, scene.radius) for r, i in zip(runs[name].rebounds, scene.impacts)]
            symbols(axes, chung_ooi.FIVE_TO_85, values, colour, f"{scene.material.name}, {name}", **style)
    line(axes, [], [], label="no slip, equation")
    finish(axes, "Test 4", "angle of incidence, degrees", **labels)


def centre_by_angle(axes, scenes, found):
    by_angle(axes, scenes, found, lambda after, along, towards, _: after.velocity * towards / along,
             ylabel="tangential velocity of the centre, after over before")


def spin_by_angle(axes, scenes, found):
    by_angle(axes, scenes, found, lambda after, _, towards, radius: -after.spin * towards / radius,
             ylabel="angular velocity after, rad/s")


def recoil(axes, scenes, found):
    fine = np.linspace(0.05, 13, 100)
    for colour, (scene, runs) in zip(COLOURS, chosen(scenes, found, "5")):
        b, name = scene.bodies, scene.material.name
        spring = [impacts.no_slip(b.kappa, b.mu, 1.0, x * b.mu, 0.0) for x in fine]
        ring = impacts.partial_slip(b.kappa, b.mu, fine * b.mu)
        line(axes, fine, [o.surface / b.mu for o in spring], colour, f"{name}, no slip, equation")
        line(axes, fine, [o.surface / b.mu for o in ring], colour, f"{name}, ring of slip", "--")
        before = [i.velocity / i.approach / b.mu for i in scene.impacts]
        both_codes(axes, before, lambda r, mu=b.mu: r.surface / mu / r.e, runs, colour, name)
    line(axes, fine, fine - 7, "0.6", "rigid sliding", ":")
    finish(axes, "Test 5", r"surface velocity before, $u\,/\,\mu v_n$", r"surface velocity after, $u'/\,\mu v_n'$",
           xlim=(0, 13), ylim=(-3, 6.5))


# --- tests 6 to 8 ---------------------------------------------------------------------------------------------------------------

def spinning(test):
    """draws test 6 or 8"""
    def draw_it(axes, scenes, found):
        fine = np.linspace(0.03, 3, 80)
        for colour, (scene, runs) in zip(COLOURS, chosen(scenes, found, test)):
            b = scene.bodies
            for pulls, style in ((False, "-"), (True, "--")):
                outcomes = [impacts.no_slip(b.kappa, b.mu, b.e, 0.0, x, pulls=pulls) for x in fine]
                line(axes, fine, [o.surface / b.e for o in outcomes], colour, style=style)
            before = [sum(i.spins) / i.approach for i in scene.impacts]
            both_codes(axes, before, lambda r: r.surface / r.e, runs, colour, scene.material.name)
            if MIXED in runs:
                after = [r.surface / r.e for r in runs[MIXED].rebounds]
                symbols(axes, before, after, colour, f"{scene.material.name}, {MIXED} types", marker="+", markersize=8)
        line(axes, [], [], label="no slip, equation")
        line(axes, [], [], label="no slip, pulling dashpot", style="--")
        finish(axes, f"Test {test}", r"surface velocity before, $u\,/\,v_n$", r"surface velocity after, $u'/\,v_n'$",
               xlim=(0, 3), ylim=(-1.5, 2.5))

    return draw_it


def two_that_spin(axes, scenes, found):
    """of the alloy; both materials lie on each other"""
    rows = [(scene, runs) for scene, runs in chosen(scenes, found, "7", "7*") if scene.material == chung_ooi.ALLOY]
    for colour, (scene, runs) in zip(COLOURS, rows):
        to_spin = scene.impacts[0].approach / scene.radius
        before = [i.spins[0] / scene.radius for i in scene.impacts]
        like = scene.test == "7*"
        what = "like spins" if like else "opposite spins"
        after = [o.spin / 2 * to_spin for o in chung_ooi.expected(scene)] if like else before
        line(axes, before, after, colour, f"{what}, no slip, equation" if like else f"{what}, nothing changes")
        both_codes(axes, before, lambda r, k=to_spin: r.spins[0] * k, runs, colour, what)
    finish(axes, "Tests 7 and 7*, aluminium alloy", "angular velocity before, rad/s", "angular velocity after, rad/s",
           xlim=(0, 12), ylim=(-1, 12))


PANELS = ((force_over_overlap, force_over_time, restitution), (centre_by_angle, spin_by_angle, recoil),
          (spinning("6"), two_that_spin, spinning("8b")))


def draw(folder, scenes, found):
    for file, draws in zip(FIGURES, PANELS):
        panels(folder / file, [lambda axes, one=one: one(axes, scenes, found) for one in draws])
