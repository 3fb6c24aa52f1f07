# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""fix potdem/timestep: the step that it sets, that all of LAMMPS follows it, and the order of the error."""

import numpy as np
import pytest
import test_energy_ledger as ledger

from potdem import collisions, dumps, scripts
from potdem.text import replaced

GROWTH = 1.05    # at most, from one evaluation to the next
ROUNDING = 1e-12


# --- a collision: the step falls and rises ----------------------------------------------------------------

@pytest.mark.every_style
@pytest.mark.parametrize("every", [1, 4])
def test_the_step_that_is_set(run_lammps, every):
    fraction, longest = 0.1, 2.0
    thermo = run_lammps(collisions.adaptive(fraction, every, longest)).thermo
    step, largest = thermo["Dt"], fraction * longest * collisions.DURATION
    wanted = np.minimum(largest, fraction * thermo["f_pace"])
    assert step[0] == wanted[0] == largest
    for k in range(1, len(step)):
        now = min(GROWTH * step[k - 1], wanted[k]) if k % every == 0 else step[k - 1]
        assert step[k] == pytest.approx(now, rel=ROUNDING)
    # it fell far, at once and before the contact, and came back slowly
    first = np.argmax(thermo["v_f"] > 0)
    assert step[first] == pytest.approx(step.min(), rel=0.05)
    assert step.min() < 0.3 * largest
    assert step[-1] > GROWTH**(10 / every) * step.min()
    assert thermo["Time"] == pytest.approx(np.concatenate([[0], np.cumsum(step[:-1])]), rel=ROUNDING)


def test_the_integrator_follows(run_lammps):
    """velocity Verlet with the steps that thermo output shows"""
    thermo = run_lammps(collisions.adaptive(0.1, longest=2.0)).thermo
    h, r, u, f = thermo["Dt"][:-1], thermo["v_r"], thermo["v_u"], thermo["v_f"] / collisions.REDUCED
    assert np.ptp(h) > 0
    assert r[1:] == pytest.approx(r[:-1] - h * u[:-1] + 0.5 * h**2 * f[:-1], rel=ROUNDING)
    assert u[1:] == pytest.approx(u[:-1] - 0.5 * h * (f[:-1] + f[1:]), abs=1e-9 * collisions.SPEED)


def collision_errors(run_lammps, fraction):
    """of the duration and of the energy during contact"""
    thermo = run_lammps(collisions.adaptive(fraction)).thermo
    r, u, energy = thermo["v_r"], thermo["v_u"], thermo["c_books"]
    ends = thermo["Time"][-1] - (r[-1] - collisions.CONTACT) / -u[-1]
    assert thermo["Dt"].min() < 0.8 * thermo["Dt"].max()
    return abs(ends - collisions.FLIGHT - collisions.DURATION) / collisions.DURATION, np.ptp(energy) / energy[0]


def test_second_order_in_a_collision(run_lammps):
    errors = np.array([collision_errors(run_lammps, fraction) for fraction in (0.2, 0.1, 0.05, 0.025)])
    ratios = errors[:-1] / errors[1:]
    # 4 up to the next order and the place within a step where the contact begins
    assert np.all((3.4 < ratios) & (ratios < 4.6)), ratios
    assert np.all(errors[-1] < 5e-4)


# --- a body that breaks ------------------------------------------------------------------------------------

def breaking_beam(fraction, every):
    """a block breaks a cantilever; the ledger counts fracture"""
    return f"""
units si
atom_style bpm/sphere
boundary f f f
lattice sc 0.005
region box block -10 30 -20 25 -15 30
create_box 1 box bond/types 1
region beam block 0 12 0 2 0 2
region block block 9 12 0 2 4 7
create_atoms 1 region beam
create_atoms 1 region block
set group all diameter 0.005 mass $(2400*0.005^3)
set region block vz -4
potdem_bonds all 1 2.0 diameters
bond_style potdem/truss
bond_coeff 1 3e6 area lattice
pair_style potdem/truss
pair_coeff 1 1 3e6 0.4
region free block 1 INF INF INF INF INF
group free region free
fix move free nve
fix weight free gravity 9.81 vector 0 0 -1
fix cracks all potdem/failure 1 tension 2e5
fix pace free potdem/timestep {every} {fraction} max 1
compute books all potdem/energy
""" + collisions.until(0.006, "f_cracks c_books c_books[1] bonds")


@pytest.mark.parametrize("every", [1, 10])
def test_second_order_while_a_beam_breaks(run_lammps, every):
    """the sum of the ledger, over the kinetic energy at the start"""
    errors = []
    for fraction in (0.8, 0.4, 0.2, 0.1):
        thermo = run_lammps(breaking_beam(fraction, every)).thermo
        total = thermo["c_books"]
        assert thermo["f_cracks"][-1] > 30
        assert thermo["Dt"].max() > 1.02 * thermo["Dt"].min()
        errors.append(np.abs(total - total[0]).max() / thermo["c_books[1]"].max())
    ratios = np.array(errors[:-1]) / errors[1:]
    # measured 3.9 to 4.3: which bonds break first differs
    assert np.all((3.3 < ratios) & (ratios < 4.8)), ratios
    assert errors[-1] < 3e-4


# --- grains come to rest -----------------------------------------------------------------------------------

def grains(pace):
    script = ledger.grains(2e-5, pair="potdem/truss", coeff="3e6 0.4 friction 0.3 auto")
    return script.rsplit("timestep", 1)[0] + pace + collisions.until(0.4, "c_ledger c_ledger[*]")


def test_no_chatter(run_lammps):
    """a pour: the ledger closes as with a fixed step of the same length, and once the grains rest, so does the step"""
    def closure(thermo):
        total = thermo["c_ledger"]
        return np.abs(total - total[0]).max() / sum(thermo[f"c_ledger[{k}]"][-1] for k in (7, 8, 9))

    paced = run_lammps(grains("fix pace all potdem/timestep 10 0.1 max 2e-4\n")).thermo
    step = paced["Dt"]
    fixed = run_lammps(grains(f"timestep {np.mean(step)}\n")).thermo
    assert step.max() > 2 * step.min()
    # both scatter by a factor of 2, as trajectories differ; measured 0.0018 and 0.0012. Contacts that are not foreseen
    # make it 0.0096
    assert closure(paced) < 3 * closure(fixed)
    assert closure(paced) < 0.005
    last = step[-len(step) // 4:]
    assert np.ptp(last) < 1e-6 * last[0]


# --- a step that does not change, pieces, restart, ranks ---------------------------------------------------

def lattice(settings, steps=60):
    """a trembling crystal, for which the longest step is what the fix sets"""
    return scripts.box((5, 6, 7), "p p p") + scripts.crystal() + scripts.elastic(100.0, area="lattice") + f"""
potdem_bonds all 1 1.5
{scripts.velocities_by_formula(0.3)}
fix move all nve
{settings}
run {steps}
""" + scripts.write_dump("end.dump", "x y z vx vy vz")


def end(tmp_path):
    columns = dumps.read(tmp_path / "end.dump")[-1]
    return scripts.vectors(columns, "x", "y", "z", "vx", "vy", "vz")


def test_a_constant_step_is_the_usual_run(run_lammps, tmp_path):
    run_lammps(lattice("timestep 0.02"))
    usual = end(tmp_path)
    run_lammps(lattice("fix pace all potdem/timestep 1 0.9 max 0.02"))
    assert np.array_equal(end(tmp_path), usual)


COLUMNS = f"""thermo 1
thermo_style custom step time dt f_pace pe ke
thermo_modify format float {scripts.ALL_DIGITS}
"""


def shaken(fraction=0.5, every=2):
    return f"fix pace all potdem/timestep {every} {fraction} max 1\n" + COLUMNS


@pytest.mark.parametrize("pieces", ["run 30\nrun 30", "run 24 every 12 NULL\nrun 36 pre no"])
def test_a_run_in_pieces(run_lammps, tmp_path, pieces):
    whole = run_lammps(lattice(shaken())).thermo
    state = end(tmp_path)
    parts = run_lammps(replaced(lattice(shaken()), "run 60", pieces)).thermo
    assert np.ptp(whole["Dt"]) > 1e-3 * whole["Dt"][0]
    for column in whole:
        assert parts[column] == pytest.approx(whole[column], rel=1e-9), column
    assert end(tmp_path) == pytest.approx(state, abs=1e-9)


@pytest.mark.parametrize("nprocs", [1, 4])
def test_restart(run_lammps, nprocs):
    """the continued run takes the step that the interrupted one had, whatever its script sets before"""
    whole = run_lammps(lattice(shaken() + "run 20\nwrite_restart half.restart\n", steps=40), nprocs=nprocs).thermo
    again = run_lammps(f"read_restart half.restart\nfix move all nve\ntimestep 1e-9\n{shaken()}run 40\n",
                       nprocs=nprocs).thermo
    assert again["Step"][0] == 20
    for column in whole:
        assert again[column] == pytest.approx(whole[column][20:], rel=1e-9), column


def test_same_steps_on_any_number_of_ranks(run_lammps):
    one = run_lammps(lattice(shaken())).thermo
    assert one["f_pace"] == pytest.approx(one["Dt"] / 0.5, rel=0.2)
    for nprocs in (2, 4):
        other = run_lammps(lattice(shaken()), nprocs=nprocs).thermo
        for column in one:
            assert other[column] == pytest.approx(one[column], rel=1e-9), column


def test_a_minimization_keeps_the_step(run_lammps):
    script = lattice("timestep 0.01\nfix pace all potdem/timestep 1 0.5 max 1\nminimize 0 1e-9 10 10\n"
                     + scripts.result("dt"), steps=0)
    kept, = scripts.results(run_lammps(script).stdout)
    assert kept == 0.01
