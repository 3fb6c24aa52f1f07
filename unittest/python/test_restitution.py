# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""restitution e: what is measured in an impact is e, at any speed, for every law that only repels, among particles and at walls."""

import numpy as np
import pytest

from potdem import scripts

SPEEDS = [1e-2, 1e-1, 1.0, 10.0]
PAIRS = {"hertz": ("potdem/hertz", "7e10 0.25"), "truss": ("potdem/truss", "1e9 0.4")}
WALLS = {"hertz": "7e10 0.25 particle 7e10 0.25 layer none", "layer": "7e10 0.25 particle 7e10 0.25 layer 0.05 2",
         "truss": "law truss 1e9 0.4"}
# a duration of impact, about, of a radius of 0.1 m at 1 m/s; Hertz: it goes with speed^(-1/5)
DURATION = {"hertz": 4e-4, "truss": 4e-3, "layer": 4e-4}


def rebound(speed, law, e, partner, kind):
    """velocities along z after the impact of a sphere on a heavier one, or on a wall"""
    duration = DURATION[kind] * (1.0 if kind == "truss" else speed**-0.2) * (1.0 if kind != "layer" else 3.0)
    gap = 1e-3 * speed * duration
    rows = [(0, 0, 0.1 + gap, 0.2)] + ([(0, 0, -0.15, 0.3)] if partner else [])
    if kind == "layer":
        rows = [(0, 0, 0.105 + gap, 0.2)]
    script = scripts.box(4, newton="off") + scripts.particles(rows, density=2650.0)
    script += f"comm_modify vel yes\nset atom 1 vz {-speed:.17g}\n"
    if partner:
        script += f"pair_style {law[0]}\npair_coeff * * {law[1]} restitution {e}\n"
    else:
        script += "pair_style zero 0.3\npair_coeff * *\nregion floor plane 0 0 0 0 0 1\n"
        script += f"fix floor all potdem/wall/region floor {law} restitution {e}\n"
    script += f"compute ledger all potdem/energy\nfix move all nve\ntimestep {duration / 4000:.17g}\nthermo 8000\n"
    script += "thermo_style custom step c_ledger c_ledger[1] c_ledger[8]\nrun 16000\n"
    return script + scripts.result("vz[1]", "vz[2]" if partner else "vz[1]", "c_ledger", "c_ledger[8]", "c_ledger[1]")


@pytest.mark.parametrize("kind", PAIRS)
@pytest.mark.parametrize("e", [0.3, 0.8, 1.0])
def test_two_particles_rebound_with_it_over_three_decades_of_speed(run_lammps, kind, e):
    script = "clear\n".join(rebound(speed, PAIRS[kind], e, True, kind) for speed in SPEEDS)
    for speed, (first, second, total, lost, kinetic) in zip(SPEEDS, scripts.results(run_lammps(script).stdout)):
        assert first - second == pytest.approx(e * speed, rel=5e-3)
        # of the kinetic energy of the relative motion, which 1 - e^2 of is lost, and booked
        masses = 2650.0 * np.pi / 6 * np.array([0.2, 0.3]) ** 3
        relative = 0.5 * masses.prod() / masses.sum() * speed**2
        assert lost == pytest.approx((1 - e * e) * relative, rel=5e-3, abs=1e-4 * relative)
        assert total == pytest.approx(kinetic + lost, abs=1e-9 * relative)
        assert total == pytest.approx(0.5 * masses[0] * speed**2, rel=1e-3)


@pytest.mark.parametrize("kind", WALLS)
@pytest.mark.parametrize("e", [0.3, 0.8])
def test_so_does_a_particle_at_a_wall(run_lammps, kind, e):
    script = "clear\n".join(rebound(speed, WALLS[kind], e, False, kind) for speed in SPEEDS)
    for speed, (away, *_) in zip(SPEEDS, scripts.results(run_lammps(script).stdout)):
        assert away == pytest.approx(e * speed, rel=5e-3)


def test_units_do_not_matter(run_lammps):
    """in `real` units force over acceleration is not mass"""
    script = scripts.box(40, units="real", newton="off") + scripts.particles([(0, 0, 0.501, 1), (0, 0, -0.501, 1)])
    script += "comm_modify vel yes\nset atom 1 vz -0.01\npair_style potdem/truss\npair_coeff * * 1e5 0.5 restitution 0.6\n"
    script += "fix move all nve\ntimestep 2e-4\nrun 10000\n" + scripts.result("vz[1]", "vz[2]")
    (velocity,) = scripts.results(run_lammps(script).stdout)
    assert velocity[0] - velocity[1] == pytest.approx(0.6 * 0.01, rel=5e-3)


def bounce(coeffs, more=""):
    script = scripts.box(4, newton="off", types=2)
    script += scripts.particles([(0, 0, 0.10001, 0.2, 1), (0, 0, -0.10001, 0.2, 2)], density=2650.0)
    script += f"comm_modify vel yes\nset atom 1 vz -1\npair_style potdem/hertz\n{coeffs}{more}"
    return script + "fix move all nve\ntimestep 1e-7\nrun 10000\n" + scripts.result("vz[1]", "vz[2]")


def restitution_of(run_lammps, script):
    ((first, second),) = scripts.results(run_lammps(script).stdout)
    return first - second


@pytest.mark.parametrize("coeffs, expected", [
    ("pair_coeff 1 1 7e10 0.25 restitution 0.9\npair_coeff 2 2 7e10 0.25 restitution 0.4\n", 0.6),
    ("pair_coeff 1 1 7e10 0.25 restitution 0.36\npair_coeff 2 2 7e10 0.25\n", 0.6),
    ("pair_coeff 1 1 7e10 0.25 restitution 0.9\npair_coeff 2 2 2e10 0.4 restitution 0.4\npair_coeff 1 2 mixed restitution 0.7\n", 0.7)])
def test_of_two_materials(run_lammps, coeffs, expected):
    """the geometric mean, or what is given for the two"""
    assert restitution_of(run_lammps, bounce(coeffs)) == pytest.approx(expected, rel=5e-3)


def test_restart_and_data_files_keep_it(run_lammps):
    coeffs = "pair_coeff 1 1 7e10 0.25 restitution 0.9 friction 0.3 mindlin\npair_coeff 2 2 2e10 0.4 viscous 0 restitution 0.4\n"
    coeffs += "pair_coeff 1 2 mixed restitution 0.7 friction 0.2 mindlin\n"
    saved = "write_restart pair.restart\nclear\nread_restart pair.restart\ncomm_modify vel yes\n"
    assert restitution_of(run_lammps, bounce(coeffs, saved)) == pytest.approx(0.7, rel=5e-3)


def test_mixed_is_the_law_that_mixing_makes(run_lammps):
    types = "pair_coeff 1 1 7e10 0.25\npair_coeff 2 2 2e10 0.4\n"
    force = "thermo_style custom step pe\nthermo_modify format float %.17g\nset atom 1 z 0.099\nrun 0\n" + scripts.result("fz[1]", "pe")
    runs = [scripts.results(run_lammps(bounce(types + given).replace("run 10000\n", force)).stdout)[0]
            for given in ("", "pair_coeff 1 2 mixed\n")]
    assert runs[0] == pytest.approx(runs[1], rel=1e-14) and runs[0][0] > 0.0


def test_it_is_adapted(run_lammps):
    script = bounce("pair_coeff * * 7e10 0.25 restitution 0.9\n",
                    "variable e equal 0.5\nfix lossy all adapt 1 pair potdem/hertz restitution * * v_e\n")
    assert restitution_of(run_lammps, script) == pytest.approx(0.5, rel=5e-3)


def test_laws_of_dissipation_do_not_mix(run_lammps):
    coeffs = "pair_coeff 1 1 7e10 0.25 restitution 0.9\npair_coeff 2 2 7e10 0.25 viscous 1e-5\n"
    run_lammps(bounce(coeffs), expect_error="lose energy by different laws")
    run_lammps(bounce(coeffs + "pair_coeff 1 2 7e10 0.25\n"), expect_error="lose energy by different laws")
