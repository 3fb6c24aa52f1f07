# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""A run continued from a restart file is the run that was not interrupted."""

import numpy as np
import pytest

from potdem import dumps, formulas, scripts
from potdem.text import replaced

# Both runs start from the same positions to the last bit, the atoms are sorted differently: rounding of sums
# 1e-16, growing over some hundred steps of vibration and contact
SAME = 1e-10

SETUP = scripts.box(24) + "region body block -2 2 -1.5 1.5 -4 4\n" + scripts.crystal(region="body") + scripts.elastic(
    100.0, area="lattice", bond="penetration 2 damping 0.01", contact=0.4, pair_options="friction 0.3 2.0")


def commands(failure=""):
    """what a restart file does not hold: fixes and output"""
    return f"""
{f"fix failure all potdem/failure 1 {failure}" if failure else "variable nothing equal 0"}
fix move all nve
timestep 0.01
thermo 50
thermo_style custom step pe ke etotal {"f_failure f_failure[1] f_failure[2] f_failure[3]" if failure else ""} bonds pxx
thermo_modify format float {scripts.ALL_DIGITS}
"""


def state(folder):
    columns = dumps.read(folder / "end.dump")[0]
    return scripts.vectors(columns, "x", "y", "z", "vx", "vy", "vz", "fx", "fy", "fz")


END = "{}\n" + scripts.write_dump("end.dump", "x y z vx vy vz fx fy fz")


def compare(run_lammps, tmp_path, setup, settings, before, after, again_on=(1, 4), nprocs=1):
    """thermo of the uninterrupted run; asserts that the continued ones are the same"""
    whole = setup + settings + f"run {before}\nwrite_restart half.restart\n" + END.format(f"run {after}")
    run = run_lammps(whole, nprocs=nprocs)
    expected = state(tmp_path)
    scale = np.abs(expected).max()
    for ranks in again_on:
        (tmp_path / "end.dump").unlink()
        again = run_lammps("read_restart half.restart\n" + settings + END.format(f"run {after}"), nprocs=ranks)
        assert np.abs(state(tmp_path) - expected).max() < SAME * scale
        last = {name: values[-1] for name, values in run.thermo.items()}
        assert again.thermo["Step"][0] == before
        for name, value in last.items():
            assert again.thermo[name][-1] == pytest.approx(value, rel=1e-9, abs=SAME), name
    return run


def test_elastic_body(run_lammps, tmp_path):
    """reference lengths and sections of the bonds, coefficients, newton and special settings come back"""
    setup = SETUP + "potdem_bonds all 1 1.42\n" + scripts.velocities_by_formula(0.3)
    run = compare(run_lammps, tmp_path, setup, commands(), 150, 150)
    assert np.ptp(run.thermo["PotEng"]) > 0.1    # it moved


def test_elastic_body_periodic_and_parallel(run_lammps, tmp_path):
    setup = scripts.box((5, 6, 7), "p p p") + scripts.crystal() + scripts.elastic(100.0, area="lattice")
    setup += "potdem_bonds all 1 2.0\n" + scripts.velocities_by_formula(0.3)
    compare(run_lammps, tmp_path, setup, commands(), 100, 100, again_on=(2,), nprocs=4)


@pytest.mark.every_style
@pytest.mark.parametrize("nprocs", [1, 2])
def test_in_the_middle_of_breaking(run_lammps, tmp_path, nprocs):
    """some bonds are gone, some will go: counts, energy and the special lists continue"""
    setup = SETUP + "potdem_bonds all 1 1.42\nvelocity all ramp vz -1.2 1.2 z -4 4\n"
    setup += "velocity all ramp vx -0.1 0.12 y -1.5 1.5 sum yes\n"
    settings = commands("tension 3.0 compression 5.0")
    run = compare(run_lammps, tmp_path, setup, settings, 45, 60, again_on=(1, 2), nprocs=nprocs)
    step, broken = run.thermo["Step"], run.thermo["f_failure"]
    assert 0 < broken[step == 45][0] < broken[-1]


def overlapped_pair():
    """two particles bonded at 0.8 diameters and thrown at each other: the bond fails in compression"""
    script = scripts.box(20) + scripts.particles([(0, 0, 0, 1.0), (0.8, 0, 0, 1.0)])
    return script + scripts.elastic(1000.0, "factor 0.5") + """
potdem_bonds all 1 1.0
group two id 2
velocity all set 1.5 0.1 0
velocity two set -1.5 0 0
"""


@pytest.mark.parametrize("nprocs", [1, 2])
def test_contact_distance_survives(run_lammps, tmp_path, nprocs):
    """a pair that failed while it overlapped touches again at the distance of failure, not at its diameter,
    after the restart as before"""
    settings = replaced(replaced(commands("compression 60"), "timestep 0.01", "timestep 1e-4"), "thermo 50", "thermo 5")
    settings += "variable r equal x[2]-x[1]\nvariable f equal fx[2]\n"
    settings = replaced(settings, "bonds pxx", "bonds evdwl")
    run = compare(run_lammps, tmp_path, overlapped_pair(), settings, 420, 800, again_on=(nprocs,))
    step, broken, contact = run.thermo["Step"], run.thermo["f_failure"], run.thermo["E_vdwl"]
    assert broken[step == 420][0] == 1
    assert contact[step == 420][0] > 0 and contact[-1] == 0    # in touch at the restart, parted at the end


def test_failed_overlapping_pair_is_force_free_after_a_restart(run_lammps, tmp_path):
    """between the distance of failure and the mean diameter there is no force: without the memory there would be"""
    settings = replaced(commands("compression 60"), "timestep 0.01", "timestep 1e-4")
    script = overlapped_pair() + settings + "run 500\nwrite_restart half.restart\n"
    script += scripts.result("x[2]-x[1]", "fx[2]", "f_failure")
    distance, force, broken = scripts.results(run_lammps(script).stdout)[0]
    for r in (0.795, 0.3):
        again = "read_restart half.restart\n" + settings + f"set atom 1 x 0 y 0 z 0\nset atom 2 x {r} y 0 z 0\nrun 0\n"
        text = run_lammps(again + scripts.result("fx[2]", "f_failure", "evdwl")).stdout
        force, count, energy = scripts.results(text)[0]
        assert count == 1
        if r > 0.79:
            assert force == 0.0 and energy == 0.0
    assert broken == 1 and distance < 1.0
    # at 0.3 the contact of reference length dref pushes: dref from the strength, eps = -60/1000
    dref = 0.8 * np.sqrt(1 - 2 * 60 / 1000)
    modulus = 1000.0 * formulas.section(1.0, 0.5)
    # the pair fails within one step of the strength: 3e-4 in distance, and the force moves with it
    assert force == pytest.approx(-formulas.truss_tension(0.3 / dref, modulus), rel=2e-3)


def test_data_file_keeps_the_body(run_lammps, tmp_path):
    """write_data, read_data: the bonds are there again, coefficients too; lengths are those at the time of
    writing, so a body at rest stays at rest"""
    setup = SETUP + "potdem_bonds all 1 1.42\n" + commands() + "run 0\nwrite_data body.data\n" + scripts.result("bonds")
    bonds = scripts.results(run_lammps(setup).stdout)[0][0]
    again = "units si\nnewton on off\natom_style bpm/sphere\nboundary f f f\nneighbor 0.3 bin\n"
    again += "bond_style potdem/truss\n"
    again += "pair_style potdem/truss\nspecial_bonds lj 0 1 1 coul 0 1 1\nread_data body.data\npair_coeff * * 100 0.4\n"
    again += commands() + "run 0\n" + scripts.result("bonds", "pe")
    again += "change_box all x scale 1.01 remap units box\nrun 0\n"
    again += scripts.result("bonds", "pe")
    (count, energy), (_, strained) = scripts.results(run_lammps(again).stdout)
    assert count == bonds
    assert energy == pytest.approx(0.0, abs=1e-12)
    assert strained > 1e-3
