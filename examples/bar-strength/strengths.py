# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Strength of the bars over f_t: measured, and of the bonds' directions.

  strengths.py [LOG ...]             prints the tables of the README (reference logs if none are named)
  strengths.py --draw PICTURE.png    stress against strain of all
"""

import sys
from pathlib import Path

import numpy as np

from potdem import lattices, logs

HERE = Path(__file__).resolve().parent

NU = 0.25        # of area body
DIRECTIONS = {"100": (1, 0, 0), "110": (1, 1, 0), "111": (1, 1, 1), "a": (1, 0, 0), "b": (0, 1, 0), "c": (0, 0, 1)}


def bond_directions(packing, reach):
    """(bonds, 3) of one particle in the lattice"""
    return lattices.shells(packing, reach)[1]


def strength(bonds, along):
    """stress over f_t at which the first bonds of a uniform isotropic bar fail: a bond at an angle has the strain
    eps (cos^2 - nu sin^2)"""
    cosine = bonds @ np.asarray(along, dtype=float) / np.linalg.norm(along)
    return 1 / (cosine**2 - NU * (1 - cosine**2)).max()


def spread(bonds, count=20000):
    """least, mean and largest strength of all directions"""
    k = np.arange(count) + 0.5
    z, turn = 1 - 2 * k / count, np.pi * (1 + np.sqrt(5)) * k
    over = np.column_stack([np.sqrt(1 - z * z) * np.cos(turn), np.sqrt(1 - z * z) * np.sin(turn), z])
    values = np.array([strength(bonds, n) for n in over])
    return values.min(), values.mean(), values.max()


def measured(log):
    """parameters; stress over f_t at the first break, largest stress, strain (times E) over f_t there, and the curve"""
    given = logs.parameters(logs.read(log))
    table = logs.read_thermo(log)
    stress, strain = table["v_stress"], table["v_ratio"]
    first, peak = np.argmax(table["f_crack"] > 0), np.argmax(stress)
    return given, stress[first], stress[peak], strain[peak], (strain[: peak + 1], stress[: peak + 1])


def formula(given):
    if given["packing"] not in lattices.CELLS:
        return None
    return strength(bond_directions(given["packing"], float(given["reach"])), DIRECTIONS[given["along"]])


def variant(log):
    return Path(log).name.split(".bar-strength.")[1].rsplit(".g++.", 1)[0]


def report(paths):
    print("| variant | bonds' directions | first bond | strength |\n|---|---|---|---|")
    for log in paths:
        given, first, peak, _, _ = measured(log)
        expected = formula(given)
        print(f"| `{variant(log)}` | {'' if expected is None else f'{expected:.3f}'} | {first:.3f} | {peak:.3f} |")
    print("\n| lattice, $r_{\\mathrm{infl}}/d$ | least | mean | largest |\n|---|---|---|---|")
    for packing, name in (("sc", "simple cubic"), ("fcc", "fcc"), ("bcc", "bcc"), ("hcp", "hcp")):
        for reach in (1.42, 2.0, 2.5):
            low, mean, high = spread(bond_directions(packing, reach))
            print(f"| {name}, {reach} | {low:.2f} | {mean:.2f} | {high:.2f} |")


def words(name):
    """what a variant is"""
    _, _, rest = name.rpartition("wide-")
    packing, _, along = rest.partition("-")
    what = {"sc": "cubic", "random": "random packing"}.get(packing, packing)
    direction = {"": "", "a": ", in a layer, along", "b": ", in a layer, across", "c": ", normal to the layers"}.get(along, f" [{along}]")
    return what + direction + (", 10 d wide" if name.startswith("wide") else "")


def draw(paths, path):
    from potdem import picture

    groups = {"along an axis": ("sc-100", "fcc-100", "bcc-100", "hcp-a", "hcp-b", "hcp-c"),
              "along a diagonal, and random": ("sc-110", "sc-111", "fcc-110", "fcc-111", "bcc-110", "bcc-111", "random"),
              "along [111], 6 d and 10 d wide": ("sc-111", "wide-sc-111", "fcc-111", "wide-fcc-111")}
    curves = {variant(log): measured(log)[4] for log in paths}
    figure, (axes,) = picture.curves(1, 3, 5.0, sharey=True)
    for axis, (title, names) in zip(axes, groups.items()):
        axis.axhspan(0.98, 1.02, color="#e4eadf", zorder=0)
        axis.axhline(1, color="black", lw=0.8)
        for name, colour in zip(names, picture.CURVES):
            strain, stress = curves[name]
            axis.plot(strain, stress, color=colour, label=f"{words(name)}: {stress[-1]:.3f}")
            axis.plot(strain[-1], stress[-1], "o", color=colour, ms=5)
        axis.set(title=title, xlabel=r"strain $\times\,E/f_t$", xlim=(0.6, 1.02), ylim=(0.55, 1.05))
        axis.legend(loc="upper center", bbox_to_anchor=(0.5, -0.16), title="largest stress over $f_t$", title_fontsize=picture.FONT - 2)
    axes[0].set_ylabel("stress of the middle third over $f_t$")
    axes[0].text(0.61, 1.022, r"$f_t\pm2\,\%$", va="bottom", fontsize=picture.FONT - 2)
    picture.save(figure, path)


if __name__ == "__main__":
    LOGS = sorted(HERE.glob("log.*.g++.1"))
    if sys.argv[1:2] == ["--draw"]:
        draw(LOGS, sys.argv[2])
    else:
        report(sys.argv[1:] or LOGS)
