# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""potdem/dmt, a cohesive Hertz contact: among particles and at a wall, beside LAMMPS's own, with dashpots and friction."""

import numpy as np
import pytest

from potdem import scripts

E, NU, GAMMA = 1e7, 0.3, 5.0
MODULUS = E / (2 * (1 - NU**2))


def touching(pair, gap, boundary="f f f"):
    """two spheres of radii 0.1 and 0.15 m"""
    script = scripts.box(4, newton="off", boundary=boundary)
    return script + scripts.particles([(0, 0, 0, 0.2), (0, 0, 0.25 + gap, 0.3)], density=2000.0) + f"comm_modify vel yes\n{pair}"


def test_force_and_energy_are_those_of_the_formula_and_of_lammps(run_lammps):
    """K = 4/3 E* sqrt(R), P = 4 pi gamma R, R = 0.06 m"""
    R, w = 0.06, 1e-3
    end = "run 0\n" + scripts.result("fz[2]", "pe", "ke")
    ours = touching(f"pair_style potdem/dmt\npair_coeff * * {E} {NU} {GAMMA}\n", -w) + end
    theirs = touching(f"pair_style granular\npair_coeff * * dmt {E} 0 {NU} {GAMMA} tangential linear_nohistory 0 0 damping velocity\n", -w) + end
    (force, energy, _), (expected, *_) = (scripts.results(run_lammps(script).stdout)[0] for script in (ours, theirs))
    K, P = 4 / 3 * MODULUS * np.sqrt(R), 4 * np.pi * GAMMA * R
    assert force == pytest.approx(K * w**1.5 - P, rel=1e-12)
    assert energy == pytest.approx(0.4 * K * w**2.5 - P * w, rel=1e-12)
    assert force == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize("wall", [False, True])
def test_what_meets_slowly_stays_and_what_meets_fast_leaves(run_lammps, wall):
    """the energy books close; with e = 0.5 a quarter of the energy is left, which must exceed what the pull takes, P w of all w it had"""
    law = f"{E} {NU} {GAMMA} restitution 0.5"
    pair = f"pair_style potdem/dmt\npair_coeff * * {law}\n"
    if wall:
        pair = f"pair_style zero 0.4\npair_coeff * *\nregion far block -2 2 -2 2 -0.1 2\nfix floor all potdem/wall/region far law dmt {law}\n"
    for speed, stays in ((0.01, True), (1.0, False)):
        script = touching(pair, 1e-5 if not wall else 0.5) + ("set atom 1 z 0.00001\n" if wall else "")
        script += f"set atom {1 if wall else 2} vz {-speed}\nset atom 2 vz {0.0 if wall else -speed}\nfix move all nve\ntimestep 1e-6\n"
        script += "compute ledger all potdem/energy\nthermo_style custom step c_ledger c_ledger[8]\nrun 50000\n"
        run = run_lammps(script + scripts.result("z[1]", "z[2]", "c_ledger", "c_ledger[8]"))
        (z1, z2, total, lost) = scripts.results(run.stdout)[0]
        distance = z1 + 0.1 - 0.1 if wall else z2 - z1 - 0.25
        assert (distance < 0.0) == stays
        assert total == pytest.approx(run.thermo["c_ledger"][0], rel=1e-2) and lost > 0.0


def test_friction_holds_where_the_contact_is_pulled(run_lammps):
    """its limit is mu (F + P): two that overlap by less than at rest pull each other, and still resist"""
    R, w, mu = 0.06, 1e-5, 0.4
    pair = f"pair_style potdem/dmt\npair_coeff * * {E} {NU} {GAMMA} friction {mu} mindlin\n"
    script = touching(pair, -w) + "group two id 2\nfix pull two move linear 0.01 0 0\ntimestep 1e-5\n"
    script += "compute f all pair/local force p4 p8\ncompute s all reduce sum c_f[1] c_f[2] c_f[3] inputs local\n"
    script += "thermo_style custom step c_s[1] c_s[2] c_s[3]\nrun 1000\nrun 0\n" + scripts.result("c_s[1]", "c_s[2]", "c_s[3]")
    (normal, friction, slides) = scripts.results(run_lammps(script).stdout)[0]
    assert normal < 0.0 and slides == 1.0
    assert friction == pytest.approx(mu * (normal + 4 * np.pi * GAMMA * R), rel=1e-9)
