# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""One scene, computed in every way that is no physics: ranks, grids of processors, newton, order of particles, skin, threads, balance,
the plugin, the width of the machine's vectors. How far apart the results are before the first bond fails, and what holds after."""

from dataclasses import dataclass, field

import numpy as np

from potdem import dumps, running, scripts

WHOLE, BROKEN = 120, 900    # steps: before the first failure, and at the end
# sums in another order: 1e-16 of the largest value, growing over 120 steps of vibration and contact
ROUNDING = 1e-12
# velocity Verlet errs with the square of the step, bonds that fail in it besides: 1.1e-5 of the kinetic energy here, the same on every way
ENERGY = 3e-5

# Two blocks in free space, of which one flies into the other and turns: both break. Friction with springs, dashpots in the bonds. The
# IDs go by place, so that the strengths, which are scattered by them, are those of the same bonds however the particles were made
SCRIPT = f"""
variable skin index 0.3
variable newton index "on on"
variable sort index "1000 0"
variable grid index "* * *"
units si
newton ${{newton}}
processors ${{grid}}
atom_style bpm/sphere
atom_modify sort ${{sort}}
boundary f f f
region box block -14 14 -14 14 -14 14 units box
create_box 1 box bond/types 1
neighbor ${{skin}} bin
neigh_modify delay 0 every 1 check yes
lattice sc 1.0 origin 0.25 0.25 0.25
region left block -6 -1 -3 2 -2 2
region right block 0 4 -2 2 -3 3
create_atoms 1 region left
create_atoms 1 region right
set group all diameter 1.0
set group all density 1.0
reset_atoms id sort yes
group left region left
pair_style potdem/truss
pair_coeff * * 100 0.4 friction 0.3 spring 0.7 damping 0.1
bond_style potdem/truss
bond_coeff * 100 area lattice damping 0.02
potdem_bonds left 1 1.42
group right subtract all left
potdem_bonds right 1 1.42
velocity left set 2.5 0.1 -0.1 units box
variable turn atom 0.15*y
velocity right set 0 NULL v_turn units box
fix fails all potdem/failure 1 tension 5.0 compression 9.0 scatter weibull 10 7
fix move all nve
${{more}}
timestep 0.004
compute books all potdem/energy
compute pieces all potdem/piece/atom
compute most all reduce max c_pieces
variable px equal vcm(all,x)*mass(all)
variable py equal vcm(all,y)*mass(all)
variable pz equal vcm(all,z)*mass(all)
thermo {WHOLE}
thermo_style custom step atoms bonds f_fails c_books v_px v_py v_pz ke c_most
thermo_modify format float {scripts.ALL_DIGITS}
run {WHOLE}
{scripts.write_dump("whole.dump", "x y z vx vy vz")}
run {BROKEN - WHOLE}
"""


@dataclass
class Way:
    """of computing the scene"""
    name: str
    nprocs: int = 1
    variables: dict = field(default_factory=dict)
    threads: int = 1
    environment: dict = field(default_factory=dict)
    lmp: object = None          # another program
    same_bits: bool = False     # the same numbers, not only to rounding


TILED = "comm_style tiled"
RCB = "fix share all balance 50 1.0 rcb"
SHIFT = "fix share all balance 50 1.0 shift xyz 10 1.0"

WAYS = [
    Way("once more", same_bits=True),
    Way("2 ranks", 2),
    Way("3 ranks", 3),
    Way("4 ranks", 4),
    Way("6 ranks", 6),
    Way("6 ranks in a row, some of them empty", 6, {"grid": "1 1 6"}),
    Way("4 ranks, 1 x 2 x 2", 4, {"grid": "1 2 2"}),
    Way("4 ranks, 4 x 1 x 1", 4, {"grid": "4 1 1"}),
    Way("newton off", 1, {"newton": "off off"}),
    Way("newton off, 4 ranks", 4, {"newton": "off off"}),
    Way("newton off for pairs, 2 ranks", 2, {"newton": "off on"}),
    Way("particles never sorted", 1, {"sort": "0 0"}),
    Way("particles sorted on every rebuild, 2 ranks", 2, {"sort": "1 0.7"}),
    Way("skin 0.05", 1, {"skin": "0.05"}),
    Way("skin 1, 2 ranks", 2, {"skin": "1.0"}),
    Way("2 threads", 1, threads=2),
    Way("2 ranks with 2 threads", 2, threads=2),
    Way("balance by shifts, 4 ranks", 4, {"more": SHIFT}),
    Way("balance by shifts, 3 ranks in a row", 3, {"more": SHIFT, "grid": "3 1 1"}),
    Way("tiled communication, balance rcb, 4 ranks", 4, {"newton": "off off", "more": f"{TILED}\n{RCB}"}),
    Way("tiled communication, balance rcb, 3 ranks", 3, {"newton": "off off", "more": f"{TILED}\n{RCB}"}),
    Way("plain loops instead of the widest", environment={"POTDEM_WIDTH": "plain"}, same_bits=True),
]


@dataclass
class Answer:
    """positions and velocities before the first failure, and how many bonds had failed; thermo output at the start and at the end"""
    whole: np.ndarray
    failed_before: float
    first: dict
    last: dict


def script(more=""):
    """of the scene; more: lines before its runs"""
    return SCRIPT.replace("${more}", more)


def compute(way, folder, lmp):
    """the scene in a folder"""
    variables = {name: value for name, value in way.variables.items() if name != "more"}
    done = running.run(script(way.variables.get("more", "")), variables, folder, way.nprocs, name="same", log="log.same", limit=300, lmp=way.lmp or lmp,
                       threads=way.threads, more=way.environment)
    if not done.ended_well:
        raise RuntimeError(f"{way.name}: {done.error or done.stdout[-1000:]}")
    columns, thermo = dumps.read(folder / "whole.dump")[0], done.thermo
    return Answer(scripts.vectors(columns, "x", "y", "z", "vx", "vy", "vz"), thermo["f_fails"][1],
                  *({name: values[row] for name, values in thermo.items()} for row in (0, -1)))


def deviation(answer, base):
    """largest, over the largest value: of places and of velocities"""
    parts = [(slice(0, 3)), (slice(3, 6))]
    return max(np.abs(answer.whole[:, part] - base.whole[:, part]).max() / np.abs(base.whole[:, part]).max() for part in parts)


def drifts(answer):
    """what must not change, over its size: bonds that are there and failed over bonds made; momentum; energy of the ledger"""
    first, last = answer.first, answer.last
    momentum = max(abs(last[f"v_p{k}"] - first[f"v_p{k}"]) for k in "xyz") / abs(first["v_px"])
    return {"bonds": abs(last["Bonds"] + last["f_fails"] - first["Bonds"]), "momentum": momentum,
            "energy": abs(last["c_books"] - first["c_books"]) / first["KinEng"]}
