# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""pair_style hybrid and hybrid/overlay: the same forces as alone."""

import numpy as np
import pytest

from potdem import dumps, formulas, scripts
from potdem.text import replaced

E, A = 500.0, 0.6
CLUSTER = [(0, 0, 0, 1.0, 1), (0.9, 0.1, 0, 1.2, 2), (0.2, 0.95, 0.1, 1.0, 1),
           (0.5, 0.3, 0.6, 0.9, 2), (-0.9, 0.2, 0.1, 1.1, 1)]
COEFFS = [("1 1", f"{E} {A}"), ("1 2", f"{2 * E} {A} penetration 2"), ("2 2", f"{E} {A} friction 0.3 1.5")]


def scene(pair_style, prefix, more="", bonds=False):
    """five particles of two types that overlap, some of them bonded"""
    script = scripts.box(20, types=2) + scripts.particles(CLUSTER)
    script += f"bond_style potdem/truss\nbond_coeff * {E} area factor {A}\n" if bonds else "bond_style none\n"
    script += f"pair_style {pair_style}\n"
    script += "".join(f"pair_coeff {types} {prefix}{values}\n" for types, values in COEFFS) + more
    if bonds:
        script += "group left id 1 3 5\npotdem_bonds left 1 1.05\n"
    return script + scripts.velocities_by_formula(1.0) + """
fix move all nve
timestep 0.0005
thermo_style custom step pe ke pxx pxy
thermo_modify format float %.17g
run 100
""" + scripts.write_dump("end.dump", "x y z vx vy vz fx fy fz")


def end(run_lammps, tmp_path, script, nprocs=1):
    run = run_lammps(script, nprocs=nprocs)
    table = dumps.read(tmp_path / "end.dump")[0]
    return scripts.vectors(table, "x", "y", "z", "vx", "vy", "vz", "fx", "fy", "fz"), run


@pytest.mark.parametrize("bonds", [False, True])
@pytest.mark.parametrize("style, more", [("hybrid potdem/truss", ""),
                                         ("hybrid/overlay potdem/truss zero 2.0", "pair_coeff * * zero\n")])
def test_same_as_alone(run_lammps, tmp_path, style, more, bonds):
    """rounding of sums in another order: 1e-16, over 100 steps"""
    alone, run = end(run_lammps, tmp_path, scene("potdem/truss", "", bonds=bonds))
    together, other = end(run_lammps, tmp_path, scene(style, "potdem/truss ", more, bonds))
    assert np.abs(alone[:, 6:]).max() > 1.0    # there are forces
    assert np.abs(together - alone).max() < 1e-12 * np.abs(alone).max()
    for column in ("PotEng", "Pxx", "Pxy"):
        assert other.thermo[column] == pytest.approx(run.thermo[column], rel=1e-11)


def test_a_pair_of_types_left_to_another_style(run_lammps, tmp_path):
    """hybrid with `zero` for 2-2: what is missing is the force between particles 2 and 4"""
    script = replaced(scene("hybrid potdem/truss zero 2.0", "potdem/truss "), "run 100", "run 0")
    script = replaced(script, f"pair_coeff 2 2 potdem/truss {COEFFS[2][1]}", "pair_coeff 2 2 zero")
    assert "pair_coeff 2 2 zero" in script
    without, _ = end(run_lammps, tmp_path, script)
    full, _ = end(run_lammps, tmp_path, replaced(scene("potdem/truss", ""), "run 100", "run 0"))
    difference = full[:, 6:] - without[:, 6:]
    x2, x4 = (np.array(CLUSTER[k][:3]) for k in (1, 3))
    r = np.linalg.norm(x4 - x2)
    mean = 0.5 * (CLUSTER[1][3] + CLUSTER[3][3])
    assert r < mean
    push = -formulas.truss_tension(r / mean, E * formulas.section(mean, A))
    # friction acts across the line of centres; along it there is the truss alone
    assert difference[3] @ (x4 - x2) / r == pytest.approx(push, rel=1e-10)
    # rounding of sums that are taken in another order
    assert np.all(np.abs(difference[[0, 2, 4]]) < 1e-13 * np.abs(full[:, 6:]).max())


def test_single_in_hybrid(run_lammps, tmp_path):
    """LAMMPS's own pair_style hybrid up to 2025 crashes on columns of a sub-style: it is not offered them"""
    sums = "compute c all pair/local {}\ncompute s all reduce sum c_c inputs local\nthermo_style custom step c_s\n"
    sums += "thermo_modify format float %.17g\nrun 0\n"
    energies = [run_lammps(replaced(scene(style, prefix), "run 100", sums.format("eng"))).thermo["c_s"][-1]
                for style, prefix in (("potdem/truss", ""), ("hybrid potdem/truss", "potdem/truss "))]
    assert energies[1] == pytest.approx(energies[0], rel=1e-12) and energies[0] > 0.0
    run_lammps(replaced(scene("hybrid/overlay potdem/truss", "potdem/truss "), "run 100", sums.format("p1")))


def test_hybrid_in_parallel(run_lammps, tmp_path):
    script = scene("hybrid/overlay potdem/truss zero 2.0", "potdem/truss ", "pair_coeff * * zero\n", bonds=True)
    one, _ = end(run_lammps, tmp_path, script)
    four, _ = end(run_lammps, tmp_path, script, nprocs=4)
    assert np.abs(four - one).max() < 1e-11 * np.abs(one).max()


def test_hybrid_restart(run_lammps, tmp_path):
    """LAMMPS's hybrid styles want their pair_coeff again after a restart; the bonds and the rest come back"""
    script = scene("hybrid/overlay potdem/truss zero 2.0", "potdem/truss ", "pair_coeff * * zero\n", bonds=True)
    coeffs = "".join(line + "\n" for line in script.splitlines() if line.startswith("pair_coeff"))
    whole, _ = end(run_lammps, tmp_path, replaced(script, "run 100", "run 50\nwrite_restart half.restart\nrun 50"))
    settings = "fix move all nve\ntimestep 0.0005\nrun 50\n"
    again, _ = end(run_lammps, tmp_path, "read_restart half.restart\n" + coeffs + settings +
                   scripts.write_dump("end.dump", "x y z vx vy vz fx fy fz"))
    assert np.abs(again - whole).max() < 1e-12 * np.abs(whole).max()


# --- bonds ------------------------------------------------------------------------------------------------------------

SPRING, STRETCH = 200.0, 0.2


@pytest.mark.parametrize("nprocs", [1, 2])
def test_trusses_that_fail_beside_springs_of_bpm(run_lammps, nprocs):
    """A-B and C-D are trusses, B-C is a spring of BPM, all held: when the trusses fail, the spring's own memory (its length)
    stays with it, at once, after a rebuild of lists and in the next run"""
    places = [0.0, 1.0, 4.0, 5.0]
    script = scripts.box(20, newton="on off", room=4, bond_types=2) + scripts.particles([(x - 2.5, 0.1, 0.1, 1.0) for x in places])
    script += f"""set group all mass 1
comm_modify vel yes cutoff 8
potdem_bonds all 1 1.1
bond_style hybrid potdem/truss bpm/spring break no smooth no
bond_coeff 1 potdem/truss 1000 area factor 0.5
bond_coeff 2 bpm/spring {SPRING} 5.0 0.0
pair_style potdem/truss
pair_coeff * * 1000 0.4
create_bonds single/bond 2 2 3
fix fail all potdem/failure 1 tension 100
fix hold all nve/noforce
timestep 1e-6
thermo_style custom step bonds f_fail
run 2
set atom 3 x {1.5 + STRETCH}
set atom 4 x {2.5 + STRETCH}
run 0
""" + scripts.result("f_fail", "fx[1]", "fx[3]") + f"""
set atom 1 x -3.0
set atom 4 x {3.1 + STRETCH}
run 3
""" + scripts.result("f_fail", "fx[1]", "fx[3]")
    for run in ("run 0\n", "neigh_modify every 1 delay 0 check no\nrun 5\n"):
        script += run + scripts.result("f_fail", "fx[1]", "fx[3]")
    found = scripts.results(run_lammps(script, nprocs=nprocs).stdout)
    assert found[:, 0].tolist() == [0, 2, 2, 2]
    assert found[1:, 1].tolist() == [0, 0, 0]
    assert found[:, 2] == pytest.approx(4 * [-SPRING * STRETCH], rel=1e-9)


def test_failure_of_bonds_of_another_style_is_refused(run_lammps):
    script = scripts.box(20, newton="on off", room=4, bond_types=2) + scripts.particles([(x, 0, 0, 1.0) for x in (-1, 0, 1)])
    script += """set group all mass 1
comm_modify vel yes cutoff 8
create_bonds single/bond 1 1 2
create_bonds single/bond 2 2 3
bond_style hybrid potdem/truss bpm/spring break no smooth no
bond_coeff 1 potdem/truss 1000 area factor 0.5
bond_coeff 2 bpm/spring 200 5.0 0.0
special_bonds lj 0 1 1 coul 0 1 1
fix fail all potdem/failure 2 tension 100
fix move all nve
run 0
"""
    run_lammps(script, expect_error="Fix potdem/failure fail: bonds of type 2 are of another bond style")
