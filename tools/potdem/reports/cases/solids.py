# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Elastic solids: the struck cantilever beside finite elements, a pulse in a bar beside d'Alembert's solution."""

import shutil

import numpy as np
from scipy.interpolate import CubicSpline

from potdem import beams, calculix, dumps, networks, running, struck_beam
from potdem.paths import EXAMPLES
from potdem.reports import writing
from potdem.reports.cases.case import FAILED, HERE, Case, Setting, critical_step, exact_errors, integration_and_model, lammps, relative
from potdem.reports.work_precision import Point

AREAS = {"body": "body density 2400", "lattice": "lattice", "factor 0.4": "factor 0.4"}
FINE = (0.9, 0.7, 0.5, 0.3, 0.2, 0.1)


# --- beam-impulse -----------------------------------------------------------------------------------------

SCENE = EXAMPLES / "beam-impulse" / "in.beam-impulse"
TIME = 0.02    # s, two periods
CALCULIX_TIMES = HERE / "calculix.csv"
# elements along and across, step: what runs while the report does; what is bundled, because it takes minutes
MESHES = [((8, 1), 2e-4), ((8, 1), 1e-4), ((16, 2), 1e-4)]
FLOOR_MESHES = ("25 × 3, 40 µs", "50 × 5, 40 µs")
FINE_MESHES = [((25, 3), 4e-5), ((50, 5), 4e-5)]


def peak_and_period(time, deflection):
    """of a history with any spacing, as the scene measures them"""
    even = np.arange(0, min(time[-1], TIME), 2e-5)
    history = struck_beam.History("", even, CubicSpline(time, deflection)(even))
    return history.peak, history.period


def reference():
    known = struck_beam.calculix("2d-layer", "f1")
    return peak_and_period(known.time, known.deflection)


def modal(depth):
    """peak and period of the Timoshenko beam that the particles stand for: clamped in the last clamped layer, loaded in the last
    one, with half a layer behind the load"""
    d = struck_beam.DEPTH / depth
    loaded = round(0.24 / d) * d
    solid = struck_beam.beam(loaded + d / 2)
    time = np.arange(0, TIME, 2e-5)
    return peak_and_period(time, beams.deflection(solid, loaded, struck_beam.FORCE, struck_beam.PULSES["f1"], time))


def beam_reference(depth, known, modes):
    """finite elements of 5 particles' beam; others differ by the piece behind the load, which the modes know"""
    return [value * own / five for value, own, five in zip(known, modes[depth], modes[5])]


def models(short):
    """(area, r_infl over d, particles through the depth) -> fractions of the critical step"""
    steps = (0.9, 0.5, 0.3) if short else FINE
    found = {("body", 2.0, 5): steps, ("factor 0.4", 2.0, 5): (0.9, 0.5) if short else (0.9, 0.5, 0.1)}
    if short:
        return {**found, ("lattice", 2.0, 5): (0.9,), ("body", 1.42, 5): (0.9, 0.5)}
    for area in AREAS:
        for reach in (1.42, 1.75, 2.0, 2.5):
            found.setdefault((area, reach, 5), (0.9, 0.4) if area == "body" else (0.9,))
    return {**found, ("body", 1.42, 7): (0.9, 0.4), ("body", 2.0, 7): (0.9, 0.4), ("body", 2.0, 10): (0.9,)}


def beam_settings(short, folder):
    for (area, reach, depth), fractions in models(short).items():
        variables = {"area": AREAS[area], "reach": reach, "depth": depth, "time": TIME}
        critical = critical_step(SCENE, variables, folder / "critical")

        def quantities(run, depth=depth):
            return of_history(depth, run.thermo["Time"], run.thermo["v_deflection"])

        for fraction in fractions:
            yield lammps(f"area {area}, {reach:g} d, {depth} through the depth", f"{fraction:g} Δt_c", SCENE,
                         {**variables, "dt": fraction * critical}, quantities)


def of_history(depth, time, deflection):
    return {"depth": depth, **dict(zip(("peak", "period"), peak_and_period(time, deflection)))}


def calculix_setting(cells, step):
    def measure(folder, _):
        folder.mkdir(parents=True, exist_ok=True)
        mesh = calculix.Mesh(*struck_beam.CLAMPS["layer"], cells)
        (folder / "mesh.inp").write_text(mesh.text(), encoding="utf-8")
        (folder / "job.inp").write_text(calculix.deck(mesh, "mesh.inp", "f1", True, step, TIME, 1), encoding="utf-8")
        status, seconds, _ = running.processor_seconds(["ccx", "-i", "job"], folder, folder / "screen")
        if status:
            return seconds, FAILED
        return seconds, of_history(5, *calculix.history((folder / "job.dat").read_text(encoding="utf-8"), mesh.shares()).T)

    return Setting("CalculiX", f"{cells[0]} × {cells[1]}, {1e6 * step:g} µs", measure, peer=True)


def keep_calculix(folder):
    """measures all meshes of CalculiX once, for machines that do not have it"""
    rows = []
    for setting in (calculix_setting(*mesh) for mesh in MESHES + FINE_MESHES):
        seconds, found = setting.measure(folder, 0)
        rows.append([setting.knob, seconds, found["peak"], found["period"], writing.machine()[0][1]])
    writing.write_csv(CALCULIX_TIMES, ["mesh", "seconds", "peak", "period", "machine"], rows)


def bundled_calculix(error_of, installed, floors=None):
    """points of the meshes that are not run now"""
    points = []
    for row in writing.read_csv(CALCULIX_TIMES)[len(MESHES) if installed else 0:]:
        found = {"depth": 5, "peak": float(row["peak"]), "period": float(row["period"])}
        points.append(Point("CalculiX, earlier run", row["mesh"], [float(row["seconds"])], error_of(found), True, floors or {}, found))
    return points


BEAM_TEXT = r"""Scene [beam-impulse](../../examples/beam-impulse/README.md), pulse $f_1$, 20 ms. Reference: CalculiX, plane stress, 50 × 5 quadratic
elements, 20 µs, clamped in the last clamped layer of particles, where the scene's page finds that the clamp acts. For other numbers of
particles through the depth the reference is corrected, by the modes of a Timoshenko beam, for the half layer behind the load. {calculix}

*Model*: area of the bonds, $r_{{\mathrm{{infl}}}}$, particles through the depth.

*Dotted* and ±: uncertainty of the reference, the larger of what 20 µs instead of 40 µs and 50 × 5 instead of 25 × 3 elements change in
it."""


def beam_impulse(short, folder):
    known, modes = reference(), {depth: modal(depth) for depth in (5, 7, 10)}
    installed = shutil.which("ccx") is not None
    settings = list(beam_settings(short, folder))
    settings += [calculix_setting(*mesh) for mesh in MESHES] if installed else []

    def error_of(found):
        wanted = beam_reference(found["depth"], known, modes)
        return {name: relative(found[name], value) for name, value in zip(("peak", "period"), wanted)}

    earlier = bundled_calculix(error_of, False)
    said = (f"CalculiX is installed: its coarse meshes ran beside the others. The finer ones take minutes and were measured once, on "
            f"{writing.read_csv(CALCULIX_TIMES)[0]['machine']}." if installed else
            f"CalculiX (`ccx`) is not installed here: its times are bundled, measured on {writing.read_csv(CALCULIX_TIMES)[0]['machine']}.")
    floors = {name: max(p.errors[name] for p in earlier if p.knob in FLOOR_MESHES) for name in ("peak", "period")}
    return Case("beam-impulse", "Struck cantilever (beam-impulse)", BEAM_TEXT.format(calculix=said), "model", "step",
                {"peak": "the first peak", "period": "the period"}, settings, exact_errors(("peak", "period"), error_of, floors), floors=floors,
                remarks=lambda points: integration_and_model(points, ("peak", "period")),
                bundled=lambda: bundled_calculix(error_of, installed, floors))


# --- bar --------------------------------------------------------------------------------------------------

BAR = HERE / "in.bar"
BAR_TIME, BAR_WIDTH = 40.0, 4.0    # as in.bar has them


def tuned(reach, depth, stiffness):
    """by what to multiply the stiffness of the bonds, so that a bar six times as long as deep has the modulus 1; d = 1. stiffness: of
    the bonds' lengths"""
    grid = np.meshgrid(np.arange(6.0 * depth), np.arange(float(depth)), np.arange(float(depth)), indexing="ij")
    points = np.stack(grid, axis=-1).reshape(-1, 3)
    pairs = networks.bonds(points, reach)
    lengths = np.linalg.norm(points[pairs[:, 1]] - points[pairs[:, 0]], axis=1)
    return depth**2 / networks.axial_stiffness(points, networks.stiffness(points, pairs, lengths * stiffness(lengths)))


def profile(run):
    """mean velocity of each layer at the end, and its error"""
    (frame,) = dumps.read(run.folder / "end.dump")
    places, layer = np.unique(np.round(frame["x"], 3), return_inverse=True)
    return places, np.bincount(layer, frame["vx"]) / np.bincount(layer)


def blow(x):
    return 1e-5 * np.exp(-0.5 * (x / BAR_WIDTH) ** 2)


def of_profile(run):
    """difference from the two pulses, in the norm, over the pulses; how far the momentum on the right has come"""
    x, v = profile(run)
    exact = (blow(x - BAR_TIME) + blow(x + BAR_TIME)) / 2
    right = x > 0
    return {"profile": float(np.linalg.norm(v - exact) / np.linalg.norm(exact)),
            "speed": float(v[right] @ x[right] / v[right].sum() / BAR_TIME)}


def bar_models(short):
    """(area or bpm, r_infl over d, particles through the depth) -> fractions of the critical step"""
    steps = (0.9, 0.5, 0.2)
    few = steps[:1] if short else steps
    found = {("body", 2.0, 5): few, ("lattice", 2.0, 5): steps[:2], ("factor 0.4", 2.0, 5): steps[:1],
             ("factor, tuned", 2.0, 5): steps, ("bpm", 2.0, 5): steps[:2], ("body", 1.42, 5): few, ("lattice", 2.0, 3): steps[:1]}
    if short:
        return found
    for reach in (1.75, 2.5):
        found["body", reach, 5] = (0.9, 0.5)
    for model in (("bpm", 1.42, 5), ("factor, tuned", 1.42, 5), ("lattice", 2.0, 7), ("bpm", 2.0, 7), ("factor, tuned", 2.0, 7)):
        found[model] = (0.9, 0.5)
    return {**found, ("bpm", 2.0, 5): steps, ("body", 1.42, 7): (0.9,), ("body", 2.0, 7): (0.9,)}


def bar_area(area, reach, depth):
    """as bond_coeff has it"""
    if area == "factor, tuned":
        return f"factor {tuned(reach, depth, lambda lengths: np.pi / 4 / lengths):.6g}"
    return "body density 1" if area == "body" else area


def bar_settings(short, folder):
    critical = {}
    for (area, reach, depth), fractions in bar_models(short).items():
        variables = {"n": depth, "reach": reach}
        if area == "bpm":
            variables |= {"style": "bpm", "k": tuned(reach, depth, np.ones_like) / depth}
            name = f"bond_style bpm/spring, {reach:g} d, {depth} through the depth"
        else:
            variables["area"] = bar_area(area, reach, depth)
            name = f"area {area}, {reach:g} d, {depth} through the depth"
            critical[reach, depth] = critical_step(BAR, variables, folder / "critical")
        for fraction in fractions:
            # the springs of bpm/spring have no critical step of ours: they get the steps of the trusses
            yield lammps(name, f"{fraction:g} Δt_c", BAR, {**variables, "dt": fraction * critical[reach, depth]}, of_profile,
                         peer=area == "bpm")


BAR_TEXT = r"""A free bar, 1 × 1 × 120 ([in.bar](../../tools/potdem/reports/cases/in.bar)), is struck over a width of 4 in its middle; after 40
units of time the two pulses have run 40 times the bar's width. Reference: d'Alembert, $v=\frac12[V(x-ct)+V(x+ct)]$ with $c=\sqrt{E/\rho}$. *Profile*: norm of the
difference in velocity over that of the pulses. *Speed*: of the momentum that runs to the right. A real bar does not quite follow
d'Alembert either: its lateral inertia slows waves by about $\nu^2 k^2a^2/12$, here %.1g for $\nu$ = 0.25. *Model* as above.

Peer: LAMMPS's `bond_style bpm/spring` on the same network, all springs alike, without damping, at the steps of the trusses. Its stiffness,
and the section of *factor, tuned*, are such that a bar six times as long as deep has the modulus $E$. That needs sparse linear algebra beforehand,
which is not in the seconds; `area body` does its own in the seconds that are counted."""


def bar(short, folder):
    names = ("profile", "speed")
    return Case("bar", "Wave in a bar", BAR_TEXT % ((0.25 / BAR_WIDTH) ** 2 / 12), "model", "step",
                {"profile": "the profile", "speed": "the speed"}, list(bar_settings(short, folder)),
                exact_errors(names, lambda found: {"profile": found["profile"], "speed": relative(found["speed"], 1.0)}),
                remarks=lambda points: integration_and_model(points, ("speed",)))
