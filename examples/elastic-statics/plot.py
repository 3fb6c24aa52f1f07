# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""plot.py FOLDER PICTURE.png: a run (build/examples/elastic-statics/<variant>.np<ranks>) over the exact answer:
displacements of the layers of particles, or, for the plate with a hole, the stress. Ends with an error where an answer
that should be exact is not."""

import sys
from pathlib import Path

import numpy as np

from potdem import dumps, logs, picture
from potdem.picture import INK, POINT
from potdem.scenes.scene import beside

solutions = beside(__file__, "solutions")

EXACT = 1e-5      # uniform shear: loads of 1e-6 on a law that is linear to first order
KIRSCH = 0.05     # of the stress, from two spacings off the hole on
HELD = 3          # layers at the rim of the plate


def at_rest(coordinates):
    """the places in the lattice, from which the particles have moved by far less than a spacing"""
    return np.round(coordinates - 0.5) + 0.5


def layers(frame, coordinate, *values):
    """means over the particles of a layer of the lattice"""
    places, which = np.unique(at_rest(frame[coordinate]), return_inverse=True)
    return places, *(np.bincount(which, value) / np.bincount(which) for value in values)


def displacements(axis, solution, frame):
    moved = frame[solution.moved] - at_rest(frame[solution.moved])
    places, moved = layers(frame, solution.across, moved)
    expected = solution.exact(places)
    axis.plot(places, 1e6 * expected, color=INK, label="exact")
    axis.plot(places, 1e6 * moved, "o", ms=4, mfc="none", mec=POINT, label="LAMMPS, mean of the layer")
    axis.set_xlabel(f"${solution.across}\\,/\\,d$")
    axis.set_ylabel(f"displacement along ${solution.moved}$, $10^{{-6}}\\,d$")
    return np.abs(moved - expected).max() / np.abs(expected).max()


def radius_of_same_area(frame, hole_radius):
    """of the round hole that is as large as the particles left out; the plate is six radii wide and six layers thick"""
    return float(np.sqrt(((6 * hole_radius) ** 2 - frame["x"].size / 6) / np.pi))


def hole(figure, frame, hole_radius, small):
    """the field of the stress, and its course along the section through the hole"""
    radius = radius_of_same_area(frame, hole_radius)
    field, course = figure.subplots(1, 2, width_ratios=[1.2, 1])
    stress = frame["c_stress[1]"] / small
    free = 3 * hole_radius - HELD
    layer = (np.abs(frame["z"] - 0.5) < 0.1) & (np.maximum(np.abs(frame["x"]), np.abs(frame["y"])) < free)
    shown = field.scatter(frame["x"][layer], frame["y"][layer], c=stress[layer], s=14, cmap=picture.MAPS["stress"], vmin=-3, vmax=3,
                          linewidths=0)
    field.set_aspect("equal")
    field.set_xlabel("$x\\,/\\,d$")
    field.set_ylabel("$y\\,/\\,d$")
    bar = figure.colorbar(shown, ax=field, label=r"$\sigma_{xx}$ over the tension", shrink=0.8)
    bar.ax.set_ylim(-1, 3)

    section = (np.abs(frame["x"]) < 0.7) & (frame["y"] > 0) & (frame["y"] < free)
    y, found = layers({"y": frame["y"][section]}, "y", stress[section])
    fine = np.linspace(1, y.max() / radius, 400)
    course.plot(fine, solutions.kirsch(fine, np.pi / 2), color=INK, label="Kirsch")
    course.plot(y / radius, found, "o", ms=4, mfc="none", mec=POINT, label="LAMMPS, compute stress/atom")
    course.set_xlabel("$y$ over the radius of the hole, at $x=0$")
    course.set_ylabel(r"$\sigma_{xx}$ over the tension")
    off = y > radius + 2
    return np.abs(found[off] / solutions.kirsch(y[off] / radius, np.pi / 2) - 1).max(), course


def main(folder, path):
    folder = Path(folder)
    log = next(folder.glob("log*"))
    given = logs.parameters(log.read_text(encoding="utf-8"))
    body = given.pop("body")
    values = {name: float(value) for name, value in given.items()}
    frame = dumps.read(folder / "dump.elastic-statics")[-1]
    figure = picture.plt.figure(figsize=(picture.WIDTH if body == "hole" else 6, 3.8), layout="constrained")
    if body == "hole":
        worst, axis = hole(figure, frame, values["hole"], values["small"])
        limit = KIRSCH
    else:
        solution = solutions.SOLUTIONS[body](values)
        axis = figure.subplots()
        worst = displacements(axis, solution, frame)
        worst = max(worst, abs(logs.read_thermo(log)["v_ratio"][-1] - 1))
        axis.set_title(solution.title)
        limit = EXACT if body == "shear" else np.inf
    axis.legend()
    picture.save(figure, path)
    print(f"{body}: largest relative deviation from the exact answer {worst:.1e}")
    if not worst < limit:
        sys.exit(f"{body}: LAMMPS and the exact answer differ by more than {limit:g}")


if __name__ == "__main__":
    main(*sys.argv[1:])
