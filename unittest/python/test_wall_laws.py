# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""fix potdem/wall/region with any of the laws, and at edges, seams and corners of regions."""

import math

import numpy as np
import pytest

RADIUS = 0.5


def start(region, places, moving=""):
    rows = "\n".join(f"create_atoms 1 single {x:.17g} {y:.17g} {z:.17g} units box" for x, y, z in places)
    return f"""
units si
atom_style sphere
atom_modify map yes
boundary f f f
region box block -20 20 -20 20 -20 20
create_box 1 box
{rows}
set type 1 diameter {2 * RADIUS}
set type 1 density 1.0
pair_style zero 3.0
pair_coeff * *
{region}
{moving}
"""


# law, its distance from the surface (in radii), energy and force: formulas of the thesis with d -> ri (docs)
def lj(z, K0=50.0, R=0.1, n=2.0, alpha=0.2):
    s = z - (1 - alpha) * RADIUS
    depth, p = K0 * R**2 / (2 * n**2), (R / s) ** n
    return depth * (p * p - 2 * p), 2 * n * depth / s * (p * p - p)


def granular(z, K0=50.0, n=4.0, alpha=0.3):
    s, first = z - (1 - alpha) * RADIUS, alpha * RADIUS
    c = K0 * first ** (n + 1) / n
    return c / ((n - 1) * s ** (n - 1)), c / s**n


def truss(z, E=100.0, a=0.8):
    modulus, x = E * a * math.pi / 4 * RADIUS**2, z / RADIUS
    return modulus * RADIUS * (x**3 / 6 - x / 2 + 1 / 3), -modulus * (x**2 - 1) / 2


LAWS = [("lj 50 0.1 2 0.2", lj, (0.82, 0.95, 1.0, 1.04)), ("granular 50 4 0.3", granular, (0.72, 0.9, 1.0, 1.3)),
        ("truss 100 0.8", truss, (0.3, 0.8, 0.999))]


@pytest.mark.every_style
@pytest.mark.parametrize("words, law, heights", LAWS)
def test_energy_and_force(run_lammps, words, law, heights):
    for height in heights:
        z = height * RADIUS
        run = run_lammps(start("region floor plane 0 0 0 0 0 1", [(0.3, 0.2, z)]) + f"""
fix floor all potdem/wall/region floor law {words}
thermo_style custom step f_floor f_floor[1] f_floor[3]
thermo_modify format float %.17g
run 0
""")
        energy, force = law(z)
        # rounding, magnified where s is a small difference
        assert run.thermo["f_floor"][0] == pytest.approx(energy, rel=1e-11)
        assert run.thermo["f_floor[3]"][0] == pytest.approx(-force, rel=1e-11)
        assert run.thermo["f_floor[1]"][0] == 0


def test_core_of_a_law_is_an_error(run_lammps):
    script = start("region floor plane 0 0 0 0 0 1", [(0, 0, 0.79 * RADIUS)])
    script += "fix floor all potdem/wall/region floor law lj 50 0.1 2 0.2\nrun 0\n"
    message = run_lammps(script, expect_error="").error
    for words in ("potdem/wall/region floor", "atom 1", "step 0", "smaller timestep"):
        assert words in message, message


# a table of two blocks is what both leave out. (LAMMPS's "union ... side out" of the blocks loses their faces.)
SEAM = """
region left block -10 0 -5 5 -3 0 side out units box
region right block 0 10 -5 5 -3 0 side out units box
region table intersect 2 left right
"""


def slide(run_lammps, table, law, x0, steps, speed=1.0, z0=0.47):
    """heights of a particle that slides without friction, from equilibrium under its weight"""
    run = run_lammps(start(table, [(x0, 0, z0)]) + f"""
fix move all nve
fix weight all gravity 9.81 vector 0 0 -1
fix table all potdem/wall/region table {law}
timestep 0.0002
fix calm all viscous 3.0
variable x equal x[1]
variable z equal z[1]
variable vx equal vx[1]
thermo {max(1, steps // 200)}
thermo_style custom step v_x v_z v_vx
thermo_modify format float %.17g
run 40000
unfix calm
velocity all set {speed} 0 0
run {steps}
""")
    rows = run.thermo["Step"] > 40000
    return {name: run.thermo[name][rows] for name in ("v_x", "v_z", "v_vx")}


@pytest.mark.parametrize("law", ["3e3 0.2 particle 3e3 0.2", "law granular 500 4 0.3", "law truss 1000 0.8"])
def test_no_kick_at_the_seam_of_two_blocks(run_lammps, law):
    """a particle slides over the seam of a table made of two blocks: same height, same speed"""
    path = slide(run_lammps, SEAM, law, -1.0, 10000)
    assert path["v_x"][0] < -0.9 < 0.9 < path["v_x"][-1]
    # what the damping left of the settling
    assert np.ptp(path["v_z"]) < 1e-6
    assert np.abs(path["v_vx"] - 1.0).max() < 1e-9


@pytest.mark.parametrize("law", ["3e3 0.2 particle 3e3 0.2", "law truss 1000 0.8"])
def test_energy_is_kept_over_an_open_edge(run_lammps, law):
    """a particle leaves a table over its edge: pushed by the edge, but the energy is that of the start"""
    run = run_lammps(start("region table block -10 0 -5 5 -3 0 side out units box", [(-0.5, 0.1, 0.499)]) + f"""
fix move all nve
fix weight all gravity 9.81 vector 0 0 -1
fix table all potdem/wall/region table {law}
velocity all set 1 0 0
compute ledger all potdem/energy
variable x equal x[1]
timestep 0.0001
thermo 100
thermo_style custom step v_x c_ledger c_ledger[1]
thermo_modify format float %.17g
run 10000
""")
    assert run.thermo["v_x"][-1] > 0.3
    # second order in the step, over the kink of the contact's beginning
    assert np.ptp(run.thermo["c_ledger"]) < 2e-5 * run.thermo["c_ledger[1]"].max()
