# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""calculix.py [NAME ...]: writes the input of CalculiX for the references of this scene, runs ccx (Debian's
calculix-ccx) on it, and writes the deflection of the loaded section against time. Everything is in calculix/, and the
scene only reads the results: it takes CalculiX, and about 40 minutes, to make them anew.

NAME is MODEL-PULSE, MODEL one of
  2d          plane stress, 250 quadratic elements (CPS8), finite displacements
  2d-linear   the same, small displacements
  2d-layer    as 2d, clamped in the last clamped layer of particles (potdem/struck_beam.py)
  3d          225 quadratic bricks (C3D20R), finite displacements
"""

import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

from potdem import calculix, struck_beam

FOLDER = struck_beam.CALCULIX
STEP = 2e-5     # s; the period of the second bending mode is 1.66 ms
MODELS = {"2d": {}, "2d-linear": {"finite": False}, "2d-layer": {"clamp": "layer"}, "3d": {"cells": (25, 3, 3)}}


def make(name):
    model, pulse = name.rsplit("-", 1)
    settings = {"cells": (50, 5), "clamp": "half", "finite": True, **MODELS[model]}
    mesh = calculix.Mesh(*struck_beam.CLAMPS[settings["clamp"]], settings["cells"])
    mesh_file = f"mesh-{model.replace('-linear', '')}.inp"
    FOLDER.mkdir(exist_ok=True)
    (FOLDER / mesh_file).write_text(mesh.text(), encoding="utf-8")
    (FOLDER / f"{name}.inp").write_text(calculix.deck(mesh, mesh_file, pulse, settings["finite"], STEP), encoding="utf-8")
    with tempfile.TemporaryDirectory() as folder:
        for file in (mesh_file, f"{name}.inp"):
            shutil.copy(FOLDER / file, folder)
        done = subprocess.run(["ccx", "-i", name], cwd=folder, check=True, text=True, stdout=subprocess.PIPE)
        if "Job finished" not in done.stdout:
            sys.exit(f"{name}: CalculiX did not finish\n{done.stdout[-2000:]}")
        rows = calculix.history((Path(folder) / f"{name}.dat").read_text(encoding="utf-8"), mesh.shares())
    np.savetxt(FOLDER / f"{name}.csv", rows, fmt=["%.5e", "%.7e"], delimiter=",", header="time [s],deflection [m]",
               comments="")
    print(f"{name}: {len(rows)} rows, largest deflection {np.abs(rows[:, 1]).max():.6g} m", flush=True)


if __name__ == "__main__":
    for wanted in sys.argv[1:] or [f"{model}-{pulse}" for model in MODELS for pulse in struck_beam.PULSES]:
        make(wanted)
