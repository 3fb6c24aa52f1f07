# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""The programs of the race: each runs the same packing with the same laws and tells a curve and its seconds."""

import json
import os
import re
import shutil
import subprocess
import sys
from dataclasses import asdict, dataclass, field
from pathlib import Path

import numpy as np
from scipy.optimize import brentq

from potdem import running

INPUTS = Path(__file__).resolve().parent / "race_inputs"
POISSON = 0.2                                # of grains and steel
SHEAR = 2 * (1 - POISSON) / (2 - POISSON)    # tangential over normal stiffness
YADE_PACKAGE = "yade"


@dataclass(frozen=True)
class Material:
    """of grains: modulus in Pa, density in kg/m^3, restitution and friction of grains, restitution of a grain and steel"""

    modulus: float
    density: float
    e: float
    mu: float
    e_steel: float

    def variables(self):
        """of in.laws, in.silo and in.ball"""
        return {"modulus": self.modulus, "density": self.density, "e": self.e, "mu": self.mu, "e_steel": self.e_steel}


MATERIALS = {"M1": Material(1e9, 2500, 0.5, 0.3, 0.4), "M2": Material(0.5e9, 2000, 0.4, 0.4, 0.4)}


@dataclass
class Outcome:
    """time: s, values: what is followed; clock, processor: seconds of the steps alone; load: processes that wanted a core as it ended"""

    time: np.ndarray
    values: np.ndarray
    clock: float
    processor: float
    load: float = field(default_factory=lambda: os.getloadavg()[0])

    def as_json(self):
        return json.dumps({**asdict(self), "time": self.time.tolist(), "values": self.values.tolist()})

    @classmethod
    def from_json(cls, text):
        found = json.loads(text)
        return cls(np.array(found["time"]), np.array(found["values"]), found["clock"], found["processor"], found["load"])


# --- laws -----------------------------------------------------------------------------------------------------

def damping_of(restitution):
    """zeta of the dashpot 2 zeta F sqrt(m/(2 Phi)), sqrt(5) zeta sqrt(m K) w^(1/4) with Hertz's F = K w^1.5, that gives this
    restitution where the force may not attract: ln e = -2 zeta acos(zeta)/sqrt(1 - zeta^2)"""
    return brentq(lambda zeta: 2 * zeta * np.arccos(zeta) / np.sqrt(1 - zeta * zeta) + np.log(restitution), 1e-9, 1 - 1e-9)


def with_attraction(zeta):
    """the restitution that belongs to the same dashpot where the force may attract"""
    return float(np.exp(-np.pi * zeta / np.sqrt(1 - zeta * zeta)))


def law_variables(material):
    """of in.laws. The tangential dashpot is 2 beta sqrt(m k_t) with the beta of the normal one, 2 beta sqrt(m k_n), as in YADE:
    beta = zeta sqrt(5/6). POTDEM's xi counts the mass at the surface, 2/7 m; LAMMPS's xt multiplies the normal dashpot"""
    grains, steel = damping_of(material.e), damping_of(material.e_steel)
    surface = np.sqrt(5 / 6 * 7 / 2)
    return {"laws": INPUTS / "in.laws", **material.variables(), "xi": grains * surface, "xi_steel": steel * surface,
            "fitted": with_attraction(grains), "fitted_steel": with_attraction(steel), "xt": np.sqrt(SHEAR)}


# --- programs -------------------------------------------------------------------------------------------------

def lammps(style):
    """a program that is LAMMPS with one of the styles of in.laws"""
    def run(case, packing, cores, folder):
        variables = {**law_variables(case.material), **case.variables, "stage": "run", "style": style, "packing": packing}
        done = running.must_run(INPUTS / case.script, variables, folder, nprocs=cores, log="log.race")
        clock = sum(map(float, re.findall(r"^Loop time of (\S+)", done.stdout, re.MULTILINE)))
        return Outcome(done.thermo["Time"], done.thermo[case.column], clock, done.loop_cpu)

    return run


def yade(case, packing, cores, folder):
    folder.mkdir(parents=True, exist_ok=True)
    curve, values = folder / "curve.csv", case.variables
    arguments = ["yade", "-n", "-x", f"-j{cores}", INPUTS / "yade_race.py", case.bulk, packing, values["softer"], values["dt"],
                 values["time"], case.every, *case.material.variables().values(), curve]
    done = subprocess.run([str(word) for word in arguments], cwd=folder, capture_output=True, text=True, check=False,
                          stdin=subprocess.DEVNULL)
    told = re.search(r"^SECONDS (\S+) (\S+)", done.stdout, re.MULTILINE)
    if not told:
        sys.exit(f"YADE failed (exit status {done.returncode}):\n{(done.stdout + done.stderr)[-2000:]}")
    time, found = np.loadtxt(curve, delimiter=",", unpack=True)
    return Outcome(time, found, float(told[1]), float(told[2]))


def missing_yade():
    """why YADE does not take part, or nothing"""
    return "" if shutil.which("yade") else f"YADE is not installed (`apt-get install {YADE_PACKAGE}`): its rows are empty."


PROGRAMS = {"POTDEM": lammps("potdem"), "LAMMPS granular": lammps("granular"), "YADE": yade}


def settle(case, packing):
    """makes the packing, with POTDEM"""
    for number, stage in enumerate(case.settling):
        variables = {**law_variables(case.material), **case.variables, "style": "potdem", "packing": packing, **stage}
        running.must_run(INPUTS / case.script, variables, packing.parent, log=f"log.settle-{number}")
