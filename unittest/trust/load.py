# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Size and time: four million particles that break on two ranks; a million steps of bodies that tumble through the boundaries of ranks
and of the periodic box while they break. Nothing is lost, and memory stays."""

import re

import project

from potdem import scripts
from potdem.reports.writing import table

TITLE = "Large and long"
EDGE = 159             # 4 019 679 particles
STEPS, PIECES = 1_000_000, 10

LARGE = f"""
units si
atom_style bpm/sphere
boundary f f f
processors 2 1 1
region box block -40 {EDGE + 40} -40 {EDGE + 40} -5 {EDGE + 5} units box
create_box 1 box bond/types 1
neighbor 0.1 bin
lattice sc 1.0 origin 0.25 0.25 0.25
region body block 0 {EDGE} 0 {EDGE} 0 {EDGE} units box
create_atoms 1 region body
set group all diameter 1.0
set group all density 1.0
pair_style potdem/truss
pair_coeff * * 100 0.4
bond_style potdem/truss
bond_coeff * 100 area factor 0.4 damping 0.02
potdem_bonds all 1 1.1
variable vx atom 4*sin(0.04*y)*cos(0.05*z)
variable vy atom 4*sin(0.05*z)*cos(0.04*x)
velocity all set v_vx v_vy NULL
fix fails all potdem/failure 1 tension 4 scatter weibull 5 3
fix move all nve
compute books all potdem/energy
variable px equal vcm(all,x)*mass(all)
timestep 0.02
thermo 40
thermo_style custom step atoms bonds f_fails c_books ke v_px
thermo_modify format float {scripts.ALL_DIGITS}
run 200
"""

# six blocks in a periodic box, which hit each other and turn; the pieces go on
LONG = f"""
units si
atom_style bpm/sphere
boundary p p p
region box block 0 12 0 12 0 12 units box
create_box 1 box bond/types 1
neighbor 0.4 bin
lattice sc 1.0 origin 0.25 0.25 0.25
region left block 0 4 0 4 0 4 units box
region right block 6 9 6 10 5 9 units box
region top block 1 4 6 9 8 11 units box
create_atoms 1 region left
create_atoms 1 region right
create_atoms 1 region top
set group all diameter 1.0
set group all density 1.0
pair_style potdem/truss
pair_coeff * * 100 0.4 friction 0.3 spring 0.7 damping 0.1
bond_style potdem/truss
bond_coeff * 100 area factor 0.4
group left region left
group right region right
group top region top
potdem_bonds left 1 1.42
potdem_bonds right 1 1.42
potdem_bonds top 1 1.42
velocity left set 1.1 0.3 0.7
velocity right set -1.3 0.5 -0.8
velocity top set 0.2 -1.2 0.4
velocity all zero linear
velocity left ramp vx -0.5 0.5 y 0 4 sum yes units box
velocity right ramp vy -0.5 0.5 z 5 9 sum yes units box
fix fails all potdem/failure 1 tension 4 compression 9 scatter weibull 5 3
fix move all nve
compute books all potdem/energy
compute pieces all potdem/piece/atom
compute most all reduce max c_pieces
variable px equal vcm(all,x)*mass(all)
timestep 0.005
thermo {STEPS // PIECES}
thermo_style custom step atoms bonds f_fails c_books ke v_px c_most
thermo_modify format float {scripts.ALL_DIGITS}
run 0
info memory
""" + f"run {STEPS // PIECES}\ninfo memory\n" * PIECES


def measure(build, work):
    rows, wrong = [], 0
    for name, script in (("4 019 679 particles, 200 steps, 2 ranks", LARGE), ("250 particles, 10^6 steps, 2 ranks", LONG)):
        print(f"  {name}", flush=True)
        done = project.run(script, work / "load", "load", nprocs=2, log="log.load", lmp=build / "lmp")
        thermo = done.thermo
        made, alive, failed = thermo["Bonds"][0], thermo["Bonds"][-1], thermo["f_fails"][-1]
        resident = [float(value) for value in re.findall(r"^Maximum resident set size: (\S+) Mbyte", done.stdout, re.MULTILINE)]
        growth = f"{resident[-1] - resident[1]:+.1f} MB after the first tenth" if len(resident) > 2 else f"{done.peak / 2**30:.1f} GiB at most"
        lost = made - alive - failed + thermo["Atoms"][0] - thermo["Atoms"][-1]
        drift = abs(thermo["c_books"][-1] - thermo["c_books"][0]) / thermo["KinEng"][0]
        wrong += lost != 0 or (len(resident) > 2 and resident[-1] - resident[1] > 1.0)
        rows.append((name, int(failed), int(lost), drift, growth, f"{done.cpu:.0f} s"))
    return table(["run", "failed bonds", "lost bonds and particles", "energy of the ledger, change over kinetic", "memory of the first rank",
                  "processor time"], rows), wrong
