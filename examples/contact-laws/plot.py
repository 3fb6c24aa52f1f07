# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""plot.py FOLDER PICTURE.png: energy, force and stiffness of a run (build/examples/contact-laws/<law>.np1) over the
formula. Ends with an error where LAMMPS and the formula differ by more than the tolerance."""

import sys
from pathlib import Path

import numpy as np

from potdem import formulas, logs, picture
from potdem.picture import GUIDE, INK, POINT

TOLERANCE = 1e-10
# first derivative, central, of eighth order
STENCIL = np.array([1 / 280, -4 / 105, 1 / 5, -4 / 5, 0, 4 / 5, -1 / 5, 4 / 105, -1 / 280])
SHOWN = 40                      # points in a panel
QUANTITIES = ((r"energy $\Phi$", "mJ", 1e3), ("force $F$, > 0 repels", "N", 1.0), ("stiffness $K$", "kN/m", 1e-3))


def parameters(text):
    """name of the law, and its coefficients"""
    words = logs.parameters(text)
    return words.pop("law"), {name: float(value) for name, value in words.items()}


def differences(r, force, ends):
    """-dF/dr from the forces of LAMMPS; not a number next to the ends of the law's branches, where a difference
    formula is out of place"""
    step = (r[-1] - r[0]) / (r.size - 1)
    stiffness = np.full(r.shape, np.nan)
    stiffness[4:-4] = -np.correlate(force, STENCIL, "valid") / step
    for end in ends:
        stiffness[np.abs(r - end) < 20 * abs(step)] = np.nan
    return stiffness


def deviation(found, expected):
    """the largest relative one; where the formula is zero, LAMMPS must be zero as well"""
    valid = np.isfinite(found)
    found, expected = found[valid], expected[valid]
    zero = expected == 0
    if np.any(found[zero] != 0):
        return np.inf
    return float(np.max(np.abs(found[~zero] / expected[~zero] - 1)))


def draw(axis, law, which, r, found):
    label, unit, scale = QUANTITIES[which]
    function = (law.phi, law.force, law.stiffness)[which]
    guide = law.guide[1 + which] if law.guide else None
    fine = np.linspace(r.min(), r.max(), 2000)
    x = law.abscissa(fine)
    if guide:
        axis.plot(x, scale * guide(fine), color=GUIDE, lw=1.2, ls=(0, (4, 3)), label=law.guide[0])
    expected = scale * function(fine)
    for place in law.ends:      # a jump is no slope
        expected[np.searchsorted(fine, place)] = np.nan
    axis.plot(x, expected, color=INK, lw=1.6, label="formula")
    every = slice(0, None, max(1, r.size // SHOWN))
    axis.plot(law.abscissa(r[every]), scale * found[every], "o", ms=4, mfc="none", mec=POINT, mew=1.1, label="LAMMPS")
    axis.axhline(0, color="black", lw=0.6)
    values = scale * np.append(found[np.isfinite(found)], 0)
    top = scale * law.tops[which] if law.tops[which] else values.max()
    margin = 0.07 * (top - values.min())
    axis.set_ylim(values.min() - margin, top + margin)
    axis.set_xlabel(law.axis)
    axis.set_ylabel(f"{label}, {unit}")


def main(folder, path):
    log = next(Path(folder).glob("log*"))
    name, values = parameters(log.read_text(encoding="utf-8"))
    law = formulas.LAWS[name](values)
    table = logs.read_thermo(log)
    r = table["v_r"]
    found = (table["PotEng"], table["v_force"], differences(r, table["v_force"], law.ends))
    functions = (law.phi, law.force, law.stiffness)
    worst = [deviation(*pair) for pair in zip(found, [function(r) for function in functions])]

    figure, (axes,) = picture.curves(1, 3, 3.4)
    for which, axis in enumerate(axes):
        draw(axis, law, which, r, found[which])
        axis.set_title(f"relative deviation at most {worst[which]:.1e}", fontsize=picture.FONT - 1, color=picture.STEEL)
    axes[0].legend()
    figure.suptitle(law.title)
    picture.save(figure, path)

    print(f"\n{name}: largest relative deviation from the formula over {r.size} distances: energy {worst[0]:.1e}, "
          f"force {worst[1]:.1e}, stiffness (differences of forces) {worst[2]:.1e}")
    if not max(worst) < TOLERANCE:
        sys.exit(f"{name}: LAMMPS and the formula differ by more than {TOLERANCE:g}")


if __name__ == "__main__":
    main(*sys.argv[1:])
