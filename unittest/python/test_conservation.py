# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Without dissipation nothing may be lost: momentum, angular momentum, energy."""

import numpy as np
import pytest

from potdem import dumps, formulas, scripts

MASS = formulas.sphere_mass(1.0)
STEP = 0.02    # about a fiftieth of the shortest period of the scenes below


def free_body(step, steps, every, bond=""):
    """a 3 x 4 x 7 block in an open box, every particle with a velocity of its own"""
    script = scripts.box(20) + "region body block -1.5 1.5 -2 2 -3.5 3.5\n" + scripts.crystal(region="body")
    script += scripts.elastic(E=100.0, bond=bond) + "potdem_bonds all 1 1.75\n"
    script += scripts.velocities_by_formula(0.2) + f"""
fix 1 all nve
timestep {step:.17g}
thermo {every}
thermo_style custom step pe ke etotal pxx
thermo_modify format float {scripts.ALL_DIGITS}
dump d all custom {every} x.dump id x y z vx vy vz
dump_modify d sort id format float {scripts.ALL_DIGITS}
run {steps}
"""
    return script


def test_momentum_and_angular_momentum(run_lammps, tmp_path):
    """equal and opposite forces along the line of centres: both conserved to rounding, 1e-16 of the sum of
    the magnitudes times the root of the number of additions (5e5)"""
    run_lammps(free_body(STEP, 1000, 1000, bond="penetration 2"))
    start, end = dumps.read(tmp_path / "x.dump")
    momenta, turning, size = [], [], 0.0
    for columns in (start, end):
        x, v = scripts.vectors(columns, "x", "y", "z"), scripts.vectors(columns, "vx", "vy", "vz")
        momenta.append(MASS * v.sum(axis=0))
        turning.append(MASS * np.cross(x, v).sum(axis=0))
        size = MASS * np.abs(v).sum()
    assert np.linalg.norm(start["vx"] - end["vx"]) > 0.1    # it does vibrate
    assert np.abs(momenta[1] - momenta[0]).max() < 1e-13 * size
    assert np.abs(turning[1] - turning[0]).max() < 1e-12 * size


def fluctuation(run, at_most):
    """largest deviation of the total energy over its share in motion"""
    energy, kinetic = run.thermo["TotEng"], run.thermo["KinEng"]
    assert np.ptp(kinetic) > 0.2 * kinetic.max()    # energy does go to and fro
    deviation = np.abs(energy - energy[0]).max() / energy[0]
    assert deviation < at_most
    return deviation


@pytest.mark.parametrize("bond", ["", "penetration 3 normalized"])
def test_energy_error_is_second_order_in_the_step(run_lammps, bond):
    """velocity Verlet: halving the step divides the fluctuation by four (3.5 to 4.5: terms of fourth order,
    and the extremes are not sampled at exactly the same times)"""
    errors = [fluctuation(run_lammps(free_body(STEP / n, 400 * n, 2 * n, bond)), 0.05 / n**2) for n in (1, 2, 4)]
    assert errors[0] / errors[1] == pytest.approx(4, abs=0.5)
    assert errors[1] / errors[2] == pytest.approx(4, abs=0.5)


def test_no_drift(run_lammps):
    """over 20000 steps: the mean of the last 50 outputs is that of the first 50 within the fluctuation"""
    energy = run_lammps(free_body(STEP, 20000, 20)).thermo["TotEng"]
    first, last = energy[:50], energy[-50:]
    assert abs(last.mean() - first.mean()) < np.ptp(energy[:200])


def test_energy_through_a_collision(run_lammps):
    """two blocks collide and part: contact gives back what it took, and the error is of second order in the
    step. Contacts start between two steps, which scatters it: a ratio of 2.5 to 6 is asked for"""
    def energies(step):
        script = scripts.box(20, bond_types=2)
        script += "region low block -1 1 -1 1 -3 0\nregion high block -1 1 -1 1 0.2 3.2\n"
        script += scripts.crystal(region="low") + "lattice sc 1.0 origin 0.25 0.25 0.45\ncreate_atoms 1 region high\n"
        script += "set group all diameter 1\nset group all density 1\n"
        script += "group low region low\ngroup high region high\n" + scripts.elastic(E=100.0, contact=0.5)
        script += "potdem_bonds low 1 1.42\npotdem_bonds high 2 1.42\n"
        script += f"""
velocity low set 0 0 0.5
velocity high set 0.05 0 -0.5
fix 1 all nve
timestep {step:.17g}
thermo 20
thermo_style custom step etotal ke evdwl
run {int(round(6 / step))}
"""
        run = run_lammps(script)
        assert run.thermo["E_vdwl"].max() > 0.05 * run.thermo["KinEng"][0]
        assert run.thermo["E_vdwl"][-1] == 0.0    # parted again
        assert run.thermo["KinEng"].min() < 0.8 * run.thermo["KinEng"][0]
        energy = run.thermo["TotEng"]
        return np.abs(energy - energy[0]).max() / energy[0]

    coarse, fine = energies(STEP / 2), energies(STEP / 4)
    assert coarse < 1e-3
    assert 2.5 < coarse / fine < 6


def test_momentum_of_a_collision_with_friction(run_lammps, tmp_path):
    """friction takes energy, never momentum; without rotation it may change the angular momentum"""
    script = scripts.box(20)
    script += scripts.particles([(0, 0, 0, 1.0), (0.95, 0.3, 0, 1.2), (0.2, 0.9, 0.5, 0.8)], density=2.0)
    script += "bond_style none\npair_style potdem/truss\npair_coeff * * 100 0.5 friction 0.4 auto\n"
    script += scripts.velocities_by_formula(1.0) + "fix 1 all nve\ntimestep 0.001\nthermo_style custom step etotal\n"
    script += f"thermo_modify format float {scripts.ALL_DIGITS}\nrun 0\n"
    script += scripts.write_dump("a.dump", "mass vx vy vz")
    script += "run 500\n" + scripts.write_dump("b.dump", "mass vx vy vz")
    run = run_lammps(script)
    a, b = dumps.read(tmp_path / "a.dump")[0], dumps.read(tmp_path / "b.dump")[0]
    for k in ("vx", "vy", "vz"):
        assert abs(np.sum(a["mass"] * (b[k] - a[k]))) < 1e-13 * np.sum(a["mass"] * np.abs(a[k]) + 1)
    assert run.thermo["TotEng"][-1] < 0.999 * run.thermo["TotEng"][0]
