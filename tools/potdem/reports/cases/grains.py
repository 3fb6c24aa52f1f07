# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Grains: discharge of the hopper, a bed that comes to rest."""

import numpy as np

from potdem.paths import EXAMPLES
from potdem.reports.cases.bulk import against_reference, seeded
from potdem.reports.cases.case import HERE, Case, lammps

SEEDS_TEXT = "A round is a draw of the diameters."


# --- hopper -----------------------------------------------------------------------------------------------

HOPPER_TEXT = """Scene [hopper](../../examples/hopper/README.md), `rough`: friction 0.3 on walls and between grains, first {time} s. Reference:
{{reference}}. *Curve*: root mean square, over time, of the difference in the share of the grains that have left both ledges, draw by
draw. η: viscosity of the friction between grains; `auto` is the stiffest that the step allows, so that it grows stiffer as the
step shrinks. *No layer*: walls without the soft layer that the scene, as the thesis, has; another model, whose difference counts as error."""


def of_hopper(run):
    thermo = run.thermo
    left = 1 - (thermo["v_above"] + thermo["v_ledge"]) / (thermo["v_above"] + thermo["v_ledge"])[0]
    return {"time": thermo["Time"], "left": left, "upper": thermo["v_above"][-1], "lower": thermo["v_ledge"][-1]}


def curve_error(found, known):
    return float(np.sqrt(np.mean((np.interp(known["time"], found["time"], found["left"]) - known["left"]) ** 2)))


def hopper(short, _):
    time = 0.2 if short else 0.4
    steps = [1e-4, 5e-5, 1.25e-5] if short else [1e-4, 5e-5, 2.5e-5, 1.25e-5, 6.25e-6]
    chosen = [("η auto, soft layer", step, {}) for step in steps]
    chosen[-1:-1] = [("η = 1 kg/s, soft layer", 5e-5, {"eta": 1})] + ([] if short else [
        ("η = 1 kg/s, soft layer", 2.5e-5, {"eta": 1}), ("η = 7.6 kg/s, soft layer", 5e-5, {"eta": 7.6}),
        ("η = 7.6 kg/s, soft layer", 2.5e-5, {"eta": 7.6}), ("η auto, no layer", 1e-4, {"layer": "layer none"}),
        ("η auto, no layer", 5e-5, {"layer": "layer none"})])
    settings = [lammps(series, f"{1e6 * step:g} µs", EXAMPLES / "hopper" / "in.hopper",
                       seeded({"mu_wall": 0.3, "mu_grain": 0.3, "weight": "yes", "time": time, "picture": "no", "dt": step, **more}),
                       of_hopper, loop=True)
                for series, step, more in chosen]
    settings[-1].reference = True
    return Case("hopper", "Discharge of a hopper", HOPPER_TEXT.format(time=time) + " " + SEEDS_TEXT, "friction and walls", "step",
                {"curve": "the discharge curve", "upper": "the grains above the upper ledge", "lower": "the grains on the lower ledge"}, settings,
                against_reference(("upper", "lower"), {"curve": curve_error}))


# --- column -----------------------------------------------------------------------------------------------

COLUMN_TEXT = """Scene [column-drop](../../examples/column-drop/README.md), friction {mu_grain} between the grains, λ = {damping}, {settling} s in the box and {spreading} s without
the left wall. Reference: {{reference}}. *Run-out*: of the centre of mass, from the right wall; *height*: of the same; η as above."""


def of_column(run):
    return {name: float(run.thermo[f"v_{name}"][-1]) for name in ("x", "z")}


def column(short, _):
    script = EXAMPLES / "column-drop" / "in.column-drop"
    common = {"settling": 0.3, "spreading": 0.3} if short else {"settling": 0.5, "spreading": 0.5}
    # more friction than the scene has, so that η tells, and a heap that comes to rest
    common |= {"mu_grain": 0.3, "damping": 0.2, "weight": "yes", "solid": 0.584}
    chosen = [("η auto", 1e-4, {}), ("η auto", 5e-5, {}), ("η = 1 kg/s", 5e-5, {"eta": 1}), ("η auto", 2.5e-5, {})]
    chosen += [] if short else [("η = 1 kg/s", 1e-4, {"eta": 1}), ("η auto", 1.25e-5, {})]
    settings = [lammps(series, f"{1e6 * step:g} µs", script, seeded({**common, "picture": "no", "dt": step, **more}), of_column, loop=True)
                for series, step, more in chosen]
    settings[-1].reference = True
    return Case("column", "Run-out of a column", COLUMN_TEXT.format(**common) + " " + SEEDS_TEXT, "friction", "step",
                {"x": "the run-out", "z": "the height"}, settings, against_reference(("x", "z"), {}))


# --- bed --------------------------------------------------------------------------------------------------

BED_E, BED_NU, BED_H = 3e6, 0.3, 2e-4               # as in.bed has them
BED_K = 4 / 3 * BED_E / (2 * (1 - BED_NU**2))       # F = sqrt(R w) (k w + gamma m w')
BED_MASS = np.pi / 6 * 2000 * 0.01**3 / 2
BED_SOFT = 2 / 7                                    # stiffness of the springs of friction, over sqrt(R w) K: 1.5 times it over dF/dw
BED_SERIES = {
    "potdem/hertz, η auto": {},
    "potdem/hertz, η = 2 kg/s": {"eta": 2},
    "potdem/hertz, η = 0.5 kg/s": {"eta": 0.5},
    "potdem/hertz, η auto, soft layer": {"layer": "layer 0.1 2"},
    "potdem/hertz, η auto, with the ledger": {"book": "yes"},
    "potdem/hertz, mindlin": {"eta": "mindlin damping 0.1"},
    "potdem/hertz, spring": {"eta": f"spring {BED_SOFT / 1.5:.9g} damping 0.3"},
    "gran/hertz/history": {"style": "history"},
    "granular, mindlin": {"style": "granular"},
}

BED_TEXT = """768 grains of 10 mm, friction 0.3, fall into a box and come to rest ([in.bed](../../tools/potdem/reports/cases/in.bed)), 0.4 s. All
styles have the same Hertz contact with the same viscosity, rolling, and this package's walls. Reference: {reference}. Its friction
is a spring that remembers the sliding, so it holds grains at rest, as do *mindlin* and *spring* of `potdem/hertz`; with a viscosity η, its
other friction, it creeps: part of that error is of the model. *spring* is as stiff as the springs of LAMMPS's styles here, *mindlin* 4.3 times as stiff, as
the elasticity of the grains says, and needs shorter steps for it. Walls are bare, but for *soft layer*."""


def of_bed(run):
    thermo = run.thermo
    late = thermo["Time"] > 0.75 * thermo["Time"][-1]
    return {"height": thermo["v_height"][-1], "contacts": np.mean(thermo["c_contacts"][late]),
            "ledger": abs(thermo["v_ledger"][-1] - thermo["v_ledger"][0]) / thermo["v_lost"][-1],
            "sinks": -np.polyfit(thermo["Time"][late], thermo["v_height"][late], 1)[0]}


def bed_remarks(points):
    lines = [f"{p.label}: energy is lost from the ledger, or found, by {100 * p.values['ledger']:.2g} % of what friction and viscosity "
             "took." for p in points if "ledger" in p.series]
    finest = {p.series: p for p in points if "ledger" not in p.series}
    creep = [f"{p.label}: {1e3 * p.values['sinks']:.2g} mm/s" for p in finest.values()]
    return [*lines, "The heap's centre still sinks, over the last quarter of the time, at: " + "; ".join(creep) + "."]


def bed(short, _):
    steps = (2e-4, 1e-4) if short else (4e-4, 2e-4, 1e-4, 5e-5)
    finest = 2.5e-5 if short else 1.25e-5
    settings = [bed_setting(series, step) for series in BED_SERIES for step in (steps if "layer" not in series else steps[-2:])]
    settings.append(bed_setting("granular, mindlin", finest))
    settings[-1].reference = True
    return Case("bed", "A bed that comes to rest", BED_TEXT + " " + SEEDS_TEXT, "style", "step",
                {"height": "the height of the centre", "contacts": "the number of contacts"}, settings,
                against_reference(("height", "contacts"), {}), remarks=bed_remarks)


def bed_setting(series, step):
    variables = {**BED_SERIES[series], "dt": step, "time": 0.4, "k": BED_K, "kt": BED_SOFT * BED_K, "gamma": BED_K * BED_H / BED_MASS}
    return lammps(series, f"{1e6 * step:g} µs", HERE / "in.bed", seeded(variables), of_bed, loop=True, peer="potdem" not in series)
