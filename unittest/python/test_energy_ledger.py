# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""compute potdem/energy: the sum of all terms is constant, whatever is dissipated, broken or pushed by walls."""

import numpy as np
import pytest

from potdem import scripts
from potdem.text import replaced

TERMS = ["kinetic", "gravity", "bonds", "contacts", "walls", "fracture", "friction", "viscous", "damping", "wall work"]
LEDGER = """
compute ledger all potdem/energy
thermo_style custom step c_ledger c_ledger[*]
thermo_modify format float %.17g
"""


def balance(run):
    """sum of the ledger, and its terms by name"""
    terms = {name: run.thermo[f"c_ledger[{k}]"] for k, name in enumerate(TERMS, start=1)}
    return run.thermo["c_ledger"], terms


def grains(step, time=0.4, pair="potdem/hertz rotation yes", coeff="3e6 0.2 viscous 1e-4 friction 0.3 auto"):
    """grains poured into a box: contacts, walls, friction, viscosity, damping and spin at once"""
    steps = round(time / step)
    return f"""
units si
atom_style sphere
boundary f f f
region box block -1 1 -1 1 -1 1
create_box 1 box
lattice sc 0.0105
region fill block -0.02 0.02 -0.02 0.02 0.01 0.06 units box
create_atoms 1 region fill
set type 1 diameter 0.01
set type 1 density 2000
displace_atoms all random 0.001 0.001 0.001 1234
pair_style {pair}
pair_coeff 1 1 {coeff}
neighbor 0.002 bin
region walls block -0.03 0.03 -0.03 0.03 0 0.5 units box
fix move all nve/sphere
fix weight all gravity 9.81 vector 0 0 -1
fix walls all potdem/wall/region walls 3e8 0.2 particle 3e6 0.2 friction 0.3 auto viscous 1e-4
fix damp all potdem/damping 0.1
{LEDGER}
timestep {step}
thermo {steps // 20}
run {steps}
"""


@pytest.mark.parametrize("nprocs, time", [(1, 0.4), (4, 0.2)])
def test_grains_come_to_rest(run_lammps, nprocs, time):
    """or nearly, on more ranks than there are cores, where steps take long"""
    total, terms = balance(run_lammps(grains(2e-5, time), nprocs=nprocs))
    exchanged = terms["friction"][-1] + terms["viscous"][-1] + terms["damping"][-1]
    assert min(terms[name][-1] for name in ("friction", "viscous", "damping")) > 0.05 * exchanged
    # the bound; measured 1e-4
    assert np.abs(total - total[0]).max() < 1e-3 * exchanged


def test_the_error_is_of_second_order(run_lammps):
    """before the trajectories part: half the step, a quarter of the error"""
    errors = [np.abs(np.diff(balance(run_lammps(grains(step, time=0.08)))[0][[0, -1]]))[0] for step in (2e-5, 1e-5)]
    # the contacts' kinks (sqrt(w)) leave some scatter around 4
    assert 3.0 < errors[0] / errors[1] < 5.5


def body(step, steps, more="", rows=500):
    """a free bonded block, trembling"""
    text = scripts.box(24, "f f f") + "region body block -1.5 1.5 -1.5 1.5 -1.5 1.5\n"
    text += scripts.crystal(region="body") + scripts.elastic(E=100.0, area="lattice", contact=0.3)
    text += "potdem_bonds all 1 1.42\n" + scripts.velocities_by_formula(0.3)
    text += "velocity all zero linear\nvelocity all zero angular\n"
    return text + f"fix move all nve\n{more}\n{LEDGER}\ntimestep {step}\nthermo {max(1, steps // rows)}\nrun {steps}\n"


def test_no_drift_in_a_conservative_run(run_lammps):
    """100 000 steps: the mean of the last tenth is that of the first tenth, to 1e-6 of the energy (the fluctuation
    itself is 5e-6 at this step and averages out)"""
    total, terms = balance(run_lammps(body(0.001, 100000, "", 5000)))
    assert terms["kinetic"].max() > 0.1 * total[0] > 0    # it does move
    tenth = len(total) // 10
    assert abs(total[-tenth:].mean() - total[:tenth].mean()) < 1e-6 * total[0]


def test_the_fluctuation_is_of_second_order(run_lammps):
    spread = [np.ptp(balance(run_lammps(body(step, round(5 / step))))[0]) for step in (0.01, 0.005)]
    # sampled at the same times; 4 up to higher orders
    assert spread[0] / spread[1] == pytest.approx(4.0, rel=0.1)


def test_broken_bonds_keep_the_balance(run_lammps):
    """the block is torn: fracture energy takes what the bonds lose"""
    pull = "variable vx atom 1.5*x\nvelocity all set v_vx 0 0 sum yes\nfix fail all potdem/failure 1 tension 8"
    total, terms = balance(run_lammps(body(0.002, 2000, pull)))
    assert terms["fracture"][-1] > 0.01 * total[0]
    # second order in the step: (omega dt)^2 / 8 of about 1e-4
    assert np.abs(total - total[0]).max() < 1e-3 * terms["fracture"][-1]


def test_viscous_bonds(run_lammps):
    text = replaced(body(0.005, 1000), "area lattice", "area lattice damping 0.05")
    total, terms = balance(run_lammps(text))
    assert terms["viscous"][-1] > 0.3 * total[0]
    assert np.abs(total - total[0]).max() < 1e-3 * terms["viscous"][-1]


@pytest.mark.every_style
@pytest.mark.parametrize("friction", ["", "friction 0.3 auto", "friction 0.3 0.02 viscous 0.01"])
def test_work_of_a_moving_wall(run_lammps, friction):
    """a plate comes from below, sideways too, and throws a grain up: its work is in the ledger"""
    text = f"""
units si
atom_style sphere
boundary f f f
region box block -10 10 -10 10 -10 10
create_box 1 box
create_atoms 1 single 0 0 1.2 units box
set type 1 diameter 1.0
set type 1 density 1.0
pair_style zero 2.0
pair_coeff * *
variable shift equal ramp(0,1)
variable aside equal ramp(0,0.7)
region plate plane 0 0 0 0 0 1 move v_aside NULL v_shift units box
fix move all nve
fix plate all potdem/wall/region plate 1e4 0.2 particle 1e4 0.2 {friction}
{LEDGER}
timestep 0.0001
thermo 200
run 10000
"""
    total, terms = balance(run_lammps(text))
    assert terms["wall work"][-1] > 0.8    # thrown at up to twice the speed of the plate: 2 m v^2 = 1.05
    assert terms["kinetic"][-1] > 0.5
    # the plate's velocity is that of the last step, not of this instant: first order, dt/duration of the contact
    assert np.abs(total - total[0]).max() < 2e-3 * terms["wall work"][-1]


FIXES = ["fix floor all potdem/wall/region floor law hertz 1e4 0.3 friction 0.4 10", "fix drag all potdem/damping 0.2"]


@pytest.mark.parametrize("nprocs, newton", [(1, "on"), (2, "on"), (2, "off")])
def test_the_heat_of_the_first_step_whatever_is_defined_first(run_lammps, nprocs, newton):
    """grains that slide on each other and on a floor, damped: half of the first step has the forces at the start, of all fixes"""
    script = scripts.box(10, newton=newton, atom_style="sphere") + scripts.particles(
        [(0.48 * k, 0, 0.49, 1.0) for k in (-3, -1, 1, 3)]) + "set group all density 1.0\npair_style potdem/hertz\n"
    script += "pair_coeff * * 1e4 0.3 viscous 1e-3 friction 0.3 5\nregion floor plane 0 0 0 0 0 1 units box\nfix move all nve\ntimestep 1e-4\n"
    script += "variable vy atom 0.5+0.3*x\nvelocity all set 0.4 v_vy 0\n"
    ledger = "compute ledger all potdem/energy\n"
    out = "thermo 1\nthermo_style custom step c_ledger c_ledger[7] c_ledger[8] c_ledger[9]\nthermo_modify format float %.17g\nrun 1\n"
    orders = [ledger + "\n".join(FIXES), f"{FIXES[0]}\n{ledger}{FIXES[1]}", "\n".join(FIXES) + "\n" + ledger]
    runs = [run_lammps(script + order + "\n" + out, nprocs=nprocs).thermo for order in orders]
    for term in ("c_ledger[7]", "c_ledger[8]", "c_ledger[9]"):
        heat = [run[term][1] for run in runs]
        assert heat[0] == pytest.approx(heat[2], rel=1e-12) and heat[1] == pytest.approx(heat[2], rel=1e-12)
        assert heat[2] != 0.0 or term == "c_ledger[8]"
    # a step of a second-order rule errs with the third power of the step; half a step's heat missing, with the first
    heat = runs[0]["c_ledger[7]"][1] + runs[0]["c_ledger[9]"][1]
    assert abs(runs[0]["c_ledger"][1] - runs[0]["c_ledger"][0]) < 1e-3 * heat


# second order in the step, but for the forces that jump at their cut by design: F v dt / 2 on each passage
@pytest.mark.parametrize("style, coeff, allowed", [("potdem/granular", "50 4 0.3", 5e-3),
                                                   ("potdem/lj", "50 0.3 2 0.2", 2e-2),
                                                   ("potdem/hertz", "50 0.2", 1e-3), ("potdem/truss", "50 0.5", 1e-3)])
def test_a_failing_bond_creates_no_contact_energy(run_lammps, style, coeff, allowed):
    """a bond fails within reach of the contact law, the two fly apart and come back from mirrors"""
    text = scripts.box(24) + scripts.particles([(0, 0, 0, 1.0), (0.9, 0, 0, 1.0)])
    text += f"pair_style {style}\npair_coeff * * {coeff}\npair_modify shift yes\n"
    text += "bond_style potdem/truss\nbond_coeff 1 200 area factor 0.5\npotdem_bonds all 1 1.2\n"
    text += f"""
set atom 1 vx -1.2
set atom 2 vx 1.2
fix move all nve
fix mirrors all wall/reflect xlo -1.5 xhi 2.4 units box
fix fail all potdem/failure 1 tension 10
{LEDGER}
timestep 0.0005
thermo 20
run 12000
"""
    total, terms = balance(run_lammps(text))
    assert terms["fracture"][-1] > 0.05
    assert np.abs(terms["contacts"]).max() > 0.01 * terms["kinetic"].max()    # they do come back
    # without the rule the granular law adds several times the fracture energy
    assert np.abs(total - total[0]).max() < allowed * terms["fracture"][-1]
