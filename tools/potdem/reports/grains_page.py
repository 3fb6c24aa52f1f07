# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Writes the report of grains: Markdown, CSV and figures, all from what was measured."""

from dataclasses import dataclass

import numpy as np

from potdem import dumps, heaps, picture
from potdem.picture import plt
from potdem.reports import grains_runs, writing

NAMES = {"potdem": "`potdem/hertz`", "granular": "LAMMPS's `granular`"}
COLOURS = {"potdem": "#1f5f9f", "granular": "#c2702a"}
SAND, FIXED = (0.85, 0.72, 0.48, 1.0), (0.45, 0.45, 0.45, 1.0)
GRAVITY = 9.81
PUBLISHED = (1.03, 1.4)    # C and k of a slot
# what is compared: text, digits
COMPARED = {"later": ("angle, degrees", 1), "by_volume": ("angle by volume, degrees", 1), "stay": ("grains in the heap", 0)}
NUMBERS = {2: "Two", 3: "Three", 5: "Five"}

INTRODUCTION = """# Grains: heaps and discharge, beside LAMMPS's granular

Made by `tools/report grains`; the numbers and the verdicts are measured, the words around them are written by hand. `tools/report grains --short` takes fewer
draws and writes to build/report/. How to set up such runs: [How to: grains](../howto_grains.md).

{machine}

{short}

## The laws

Grains of 10 mm (±10 %), 2500 kg/m³, $E$ = 5 MPa, ν = 0.3, restitution 0.5, friction 0.5, step 50 µs. Both styles have the same laws; what has other numbers in
LAMMPS is converted:

| | `potdem/hertz` | LAMMPS's `granular` |
|---|---|---|
| normal force | Hertz | `hertz/material` |
| losses | `restitution 0.5` | `damping coeff_restitution` with {e_gran:.4f}, `limit_damping`: the same dashpot. LAMMPS's number is the restitution of a contact that may pull |
| friction | `friction 0.5 mindlin damping 0.3` | `tangential mindlin_rescale/force` with the same stiffness, dashpot {xt:.4f} of that along the normal: the same. Where it slips, its spring keeps what the dashpot leaves of μF, POTDEM's keeps μF; and its arm is the radius, POTDEM's reaches to the point of contact |
| rolling | `rolling 0.2 0.5 0.3`: a spring of half the stiffness $K$ that the contact has at the moment | `rolling sds` with a constant spring, {k_roll:.0f} N/m: half of the mean $K$, {stiffness:.0f} N/m, of the contacts of a heap that stands (mean overlap {overlap:.4f} d); dashpot {g_roll:.3f} kg/s |
| walls | `fix potdem/wall/region` | `fix wall/gran` |

"""

HEAPS = """## A heap on a rough base

{start} grains settle in a box, 18 × 6 grains wide, periodic in *y*, on a base of fixed grains ([in.heap](../../tools/potdem/reports/cases/in.heap)). Then one wall, the gate, is
gone; what runs over the edge of the base is lost, and what stays is a slope between the edge and a wall without friction. It is measured {flow:g} s after the gate is
gone, and again {rest:g} s later.

**The angle** is that of the surface: the highest point of the grains in each square cell of 1.1 mean diameters, the median of the six cells that lie side by side, and through these
heights, three diameters from both ends left out, the line whose slope is the median of the slopes between all pairs (Theil and Sen), which single grains
on the slope do not move. *By volume* is the same line through the volume of the grains over each strip of the base, with the solid fraction that they had in the box: an
angle that knows nothing of the surface.

Mean ± standard deviation of the draws of the grains:

{table}

{differences}

Between the two measurements:

{ways}

Processor time of a run, median, POTDEM and `granular`, with rolling resistance {seconds}.

![The heaps of the first draw at the end, with their lines](grains-heaps.png)

Each run: [grains-heaps.csv](grains-heaps.csv).

"""

CHANGED = """### What else changes the angle

The same heaps of POTDEM without rolling resistance, one thing changed at a time (steps of 100 µs for 0.5 MPa and of 20 µs for 50 MPa):

{table}

"""

DISCHARGE = """## Discharge through a slot

A bin with a flat bottom of fixed grains, periodic across and along the slot, so that there are no walls
([in.slot](../../tools/potdem/reports/cases/in.slot)): every 16 grains of bottom a slot of 5, 7 or 9 grains, from surface to surface. The grains settle, the slot opens. The
rate is that of a line through the mass in the bin while it falls from {first:g} to {last:g} of what was there; the mass strays from that line by {bends:.1g} of the whole at
most. {draws} draws, mean ± standard deviation:

{table}

{verdicts}

![Mass in the bin, and the rates with the law](grains-slot.png)

Each run: [grains-slot.csv](grains-slot.csv).
"""


@dataclass
class Found:
    """heaps; contact: (stiffness, overlap) of the first; others: heaps in which something is changed; slots: discharges; times: of
    the heaps"""

    heaps: list
    contact: tuple
    others: list
    slots: list
    times: dict


# --- numbers ----------------------------------------------------------------------------------------------------------

def spread(values):
    return float(np.mean(values)), float(np.std(values, ddof=1))


def plus_minus(values, digits):
    mean, deviation = spread(values)
    return f"{mean:.{digits}f} ± {deviation:.{digits}f}"


def short(value):
    """text of a number of which the size matters"""
    return f"{value:.0f}" if value >= 1 else f"{value:.1g}"


def compared(ours, theirs):
    """(difference of the means, its standard error)"""
    error = np.sqrt(np.var(ours, ddof=1) / len(ours) + np.var(theirs, ddof=1) / len(theirs))
    return float(np.mean(ours) - np.mean(theirs)), float(error)


def chosen(runs, **what):
    return [run for run in runs if all(getattr(run, name) == value for name, value in what.items())]


def values(runs, name):
    return [getattr(run, name) for run in runs]


# --- heaps ------------------------------------------------------------------------------------------------------------

def heap_table(found):
    header = ["rolling resistance", "", "draws", "angle, degrees", "later", "by volume", "grains in the heap"]
    rows = []
    for rolling in grains_runs.ROLLING:
        for style in grains_runs.STYLES:
            runs = chosen(found, style=style, rolling=rolling)
            angles = [plus_minus(values(runs, name), 1) for name in ("angle", "later", "by_volume")]
            rows.append([f"{rolling:g}", NAMES[style], len(runs), *angles, plus_minus(values(runs, "stay"), 0)])
    return writing.table(header, rows)


def ways_table(found):
    """what moved between the two measurements"""
    rows = []
    for rolling in grains_runs.ROLLING:
        for style in grains_runs.STYLES:
            runs = chosen(found, style=style, rolling=rolling)
            rows.append([f"{rolling:g}", NAMES[style], f"{max(abs(run.later - run.angle) for run in runs):.2f}",
                         ", ".join(str(run.grains - run.stay) for run in runs),
                         ", ".join(short(run.moved / grains_runs.D) for run in runs)])
    header = ["rolling resistance", "", "largest change of the angle", "grains lost, draw by draw", "farthest way of a grain, d"]
    return writing.table(header, rows)


def difference_table(found):
    """POTDEM less LAMMPS's granular"""
    rows = []
    for rolling in grains_runs.ROLLING:
        for name, (what, digits) in COMPARED.items():
            ours, theirs = (values(chosen(found, style=style, rolling=rolling), name) for style in grains_runs.STYLES)
            difference, error = compared(ours, theirs)
            inside = min(theirs) <= np.mean(ours) <= max(theirs)
            rows.append([f"{rolling:g}", what, f"{difference:+.{digits}f} ± {error:.{digits}f}", f"{np.mean(ours):.{digits}f}",
                         f"{min(theirs):.{digits}f} to {max(theirs):.{digits}f}", "within" if inside else "**outside**"])
    header = ["rolling resistance", "", "POTDEM less `granular`, ± standard error", "mean of POTDEM", "draws of `granular`", "POTDEM's mean is"]
    return writing.table(header, rows)


def seconds_of(found):
    """text"""
    def median(style, rolling):
        return f"{np.median(values(chosen(found, style=style, rolling=rolling), 'cpu')):.0f} s"

    return "; ".join(f"{rolling:g}: " + " and ".join(median(style, rolling) for style in grains_runs.STYLES) for rolling in grains_runs.ROLLING)


def changed_table(found):
    """of POTDEM's heaps without rolling resistance"""
    rows = []
    for changed in ["", *grains_runs.CHANGED]:
        runs = chosen(found, style="potdem", rolling=0.0, changed=changed)
        overlaps = [grains_runs.stiffness_of(run.folder)[1] / grains_runs.D for run in runs]
        rows.append([changed or "as above", plus_minus(values(runs, "later"), 1), plus_minus(values(runs, "stay"), 0),
                     f"{np.mean(overlaps):.2g}", len(runs), f"{np.median(values(runs, 'cpu')):.0f}"])
    return writing.table(["", "angle, degrees", "grains in the heap", "mean overlap, d", "draws", "seconds"], rows)


def draw_heap(axis, run):
    frame = dumps.read(run.folder / "later.dump")[-1]
    order = np.argsort(-frame["y"])
    points = np.column_stack([frame["x"], frame["y"], frame["z"]])[order]
    colours = np.where((frame["type"] == 1)[order, None], SAND, FIXED)
    picture.spheres(axis, points, frame["radius"][order], colours, turn=0.0, tilt=0.0)
    degrees, start, falls = grains_runs.slope(frame)
    ends = np.array([heaps.LEFT_OUT * grains_runs.D, grains_runs.LONG - heaps.LEFT_OUT * grains_runs.D])
    axis.plot(ends, start + falls * ends, color="#b5332e", linewidth=2)
    axis.plot([0, 0], [-0.5 * grains_runs.D, 19 * grains_runs.D], color="#888888", linewidth=2)
    name = "POTDEM" if run.style == "potdem" else "granular"
    axis.text(0.98, 0.95, f"{name}, rolling {run.rolling:g}\n{degrees:.1f}°", transform=axis.transAxes, ha="right", va="top", fontsize=13)
    axis.set_xlim(-0.01, grains_runs.LONG + 0.02)
    axis.set_ylim(-0.01, 0.195)


def draw_heaps(path, found):
    figure, axes = picture.panels(len(grains_runs.ROLLING), len(grains_runs.STYLES), 5.0, 4.2)
    for line, rolling in zip(axes, grains_runs.ROLLING):
        for axis, style in zip(line, grains_runs.STYLES):
            draw_heap(axis, chosen(found, style=style, rolling=rolling)[0])
    figure.savefig(path, dpi=90)
    plt.close(figure)


# --- discharge --------------------------------------------------------------------------------------------------------

def law(slots):
    """(C, k in grains, largest relative deviation, factor, density) of W = C rho sqrt(g) L (D - k d)^(3/2), of POTDEM's runs"""
    widths = np.array(grains_runs.WIDTHS) * grains_runs.D
    rates = [np.mean(values(chosen(slots, style="potdem", width=width), "rate")) for width in grains_runs.WIDTHS]
    factor, shift, deviation = heaps.beverloo(widths, rates, 1.5)
    density = float(np.mean(values(chosen(slots, style="potdem"), "density")))
    return factor / (density * np.sqrt(GRAVITY) * grains_runs.SLOT_DEEP), shift / grains_runs.D, deviation, factor, density


def published(width, density):
    C, k = PUBLISHED
    return C * density * np.sqrt(GRAVITY) * grains_runs.SLOT_DEEP * ((width - k) * grains_runs.D) ** 1.5


def slot_table(slots):
    C, k, _, factor, density = law(slots)
    rows = []
    for style in grains_runs.STYLES:
        for width in grains_runs.WIDTHS:
            runs = chosen(slots, style=style, width=width)
            if runs:
                laws = [factor * ((width - k) * grains_runs.D) ** 1.5, published(width, density)]
                rows.append([f"{width}", NAMES[style], plus_minus(values(runs, "rate"), 3), *laws, plus_minus(values(runs, "density"), 0)])
    header = ["width, grains", "", "rate, kg/s", f"C = {C:.2f}, k = {k:.2f}", "C = {:g}, k = {:g}".format(*PUBLISHED), "density in the bin, kg/m³"]
    return writing.table(header, rows)


def slot_verdicts(slots):
    C, k, deviation, *_ = law(slots)
    ours, theirs = (values(chosen(slots, style=style, width=grains_runs.WIDTH_OF_BOTH), "rate") for style in grains_runs.STYLES)
    difference, error = compared(ours, theirs)
    return "\n".join([
        "* Beverloo's law of a slot, $W=C\\,\\rho\\,\\sqrt g\\,L\\,(D-k\\,d)^{3/2}$ with the density in the bin, meets the three rates "
        f"within {100 * deviation:.1g} %, with $C$ = {C:.2f} and "
        f"$k$ = {k:.2f}. Published for slots: {PUBLISHED[0]:g} and, for spheres, about {PUBLISHED[1]:g} (Nedderman, 1992).",
        f"* At a width of {grains_runs.WIDTH_OF_BOTH} grains POTDEM's rate is {100 * difference / np.mean(theirs):+.1f} % ± "
        f"{100 * error / np.mean(theirs):.1f} % (standard error) from that of `granular`."])


def draw_masses(panel, slots):
    """of the first draw"""
    for run in chosen(slots, seed=slots[0].seed):
        panel.plot(run.time, run.mass / run.mass[0], color=COLOURS[run.style], linestyle="-" if run.style == "potdem" else "--")
        if run.style == "potdem":
            panel.annotate(f"{run.width}", (run.time[-1], run.mass[-1] / run.mass[0]), textcoords="offset points", xytext=(0, -12), ha="center")
    for share in grains_runs.EMPTIES:
        panel.axhline(share, color="#bbbbbb", linewidth=0.8)
    panel.set(xlabel="time since the slot is open, s", ylabel="mass in the bin, share", ylim=(0.3, 1.02),
              title="by the width of the slot in grains; dashed: granular")


def draw_rates(panel, slots):
    C, k, _, factor, density = law(slots)
    widths = np.linspace(2, 10, 100)
    fitted = factor * (np.maximum(widths - k, 0) * grains_runs.D) ** 1.5
    panel.plot(widths, fitted, color="#555555", label=f"fit: C = {C:.2f}, k = {k:.2f}")
    known = published(np.maximum(widths, PUBLISHED[1]), density)
    panel.plot(widths, known, color="#555555", linestyle=":", label="C = {:g}, k = {:g}".format(*PUBLISHED))
    for style, marker in zip(grains_runs.STYLES, "ox"):
        runs = chosen(slots, style=style)
        panel.plot(values(runs, "width"), values(runs, "rate"), marker, color=COLOURS[style], markersize=8,
                   label=NAMES[style].replace("`", ""))
    panel.set(xlabel="width of the slot, grains", ylabel="rate, kg/s", xlim=(2, 10), ylim=(0, None))
    panel.legend()


def draw_slot(path, slots):
    figure, panels = plt.subplots(1, 2, figsize=(11, 4.5), constrained_layout=True)
    draw_masses(panels[0], slots)
    draw_rates(panels[1], slots)
    figure.savefig(path, dpi=100)
    plt.close(figure)


# --- the page ---------------------------------------------------------------------------------------------------------

def in_short(found):
    """the lines on top"""
    def angle(style, rolling):
        return f"{NAMES[style]} {plus_minus(values(chosen(found.heaps, style=style, rolling=rolling), 'later'), 1)}°"

    texts = [f"rolling resistance {rolling:g}: " + ", ".join(angle(style, rolling) for style in grains_runs.STYLES)
             for rolling in grains_runs.ROLLING]
    C, k, deviation, *_ = law(found.slots)
    return ("**In short.** Angles of repose: " + "; ".join(texts) + ". Discharge of `potdem/hertz`: Beverloo's law within "
            f"{100 * deviation:.1g} %, with $C$ = {C:.2f} and $k$ = {k:.2f}.")


def write_data(out, found):
    header = ["style", "rolling", "seed", "changed", "angle", "angle later", "by volume", "grains", "later", "farthest way, m", "seconds"]
    names = ["style", "rolling", "seed", "changed", "angle", "later", "by_volume", "grains", "stay", "moved", "cpu"]
    writing.write_csv(out / "grains-heaps.csv", header, [[getattr(run, name) for name in names] for run in found.heaps + found.others])
    header = ["style", "width", "seed", "rate, kg/s", "density, kg/m^3", "deviation from a line", "seconds"]
    writing.write_csv(out / "grains-slot.csv", header,
                      [[run.style, run.width, run.seed, run.rate, run.density, run.bends, run.cpu] for run in found.slots])


def page(found, machine):
    stiffness, overlap = found.contact
    return (INTRODUCTION.format(machine=writing.table(("machine", ""), machine), short=in_short(found), stiffness=stiffness,
                                overlap=overlap / grains_runs.D, **grains_runs.in_lammps_terms(stiffness))
            + HEAPS.format(start=found.heaps[0].start, table=heap_table(found.heaps), ways=ways_table(found.heaps),
                           differences=difference_table(found.heaps), seconds=seconds_of(found.heaps), **found.times)
            + CHANGED.format(table=changed_table(found.heaps + found.others))
            + DISCHARGE.format(first=grains_runs.EMPTIES[0], last=grains_runs.EMPTIES[1], bends=max(values(found.slots, "bends")),
                               draws=NUMBERS[max(values(found.slots, "seed"))], table=slot_table(found.slots),
                               verdicts=slot_verdicts(found.slots)))


def write(out, found, machine):
    (out / "grains.md").write_text(page(found, machine), encoding="utf-8")
    write_data(out, found)
    draw_heaps(out / "grains-heaps.png", found.heaps)
    draw_slot(out / "grains-slot.png", found.slots)
    print(f"written: {out / 'grains.md'}")
