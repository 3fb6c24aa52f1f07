# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""A bond that has failed is gone for good, from every list of LAMMPS, and what its contact remembers belongs to the contact."""

import pytest

from potdem import dumps, formulas, scripts
from potdem.text import replaced

E, A = 1000.0, 0.5
PAIR_LINES = scripts.elastic(E, f"factor {A}", "", A)


def spheres(*places, diameter=1.0):
    rows = [(*place, diameter) for place in places]
    return scripts.box(20, room=4) + scripts.particles(rows) + "set group all mass 1\n" + PAIR_LINES


# two spheres bonded at 0.9 of their diameter; pressed to 0.85 the bond fails in compression: eps = -0.054
CLOSE = spheres((0, 0, 0), (0.9, 0, 0)) + "potdem_bonds all 1 0.95\n"
SETTINGS = "fix fail all potdem/failure 1 compression 50\nfix hold all nve/noforce\ntimestep 1e-6\n"
FAILED = CLOSE + SETTINGS + "set atom 2 x 0.85\nrun 3\n"
STATE = scripts.result("bonds", "f_fail", "ebond", "evdwl", "fx[1]")


def contact_energy(r, begins, diameter=1.0):
    """of the truss of contact, which begins at a distance (by quadrature, formulas.truss_energy)"""
    return formulas.truss_energy(r / begins, begins, E * formulas.section(diameter, A)) if r < begins else 0.0


def contact_push(r, begins, diameter=1.0):
    return -formulas.truss_tension(r / begins, E * formulas.section(diameter, A)) if r < begins else 0.0


# --- data files -------------------------------------------------------------------------------------------------------

@pytest.mark.parametrize("others", [0, 1])
def test_a_data_file_does_not_heal(run_lammps, others):
    """one bond fails while its ends touch, another one is left or not: read back, the dead one does not pull"""
    third = [(0, 0.9, 0)] if others else []
    script = spheres((0, 0, 0), (0.9, 0, 0), *third) + "potdem_bonds all 1 0.95\n" + SETTINGS
    script += "set atom 2 x 0.85\nrun 3\n" + STATE + "write_data half.data\nclear\n"
    script += "units si\nnewton on off\natom_style bpm/sphere\natom_modify map array\nboundary f f f\nspecial_bonds lj 0 1 1 coul 0 1 1\n"
    script += "neighbor 0.3 bin\nbond_style potdem/truss\npair_style potdem/truss\nread_data half.data\n"
    script += "compute failed all pair/local force\nvariable f_fail equal 0\n"
    script += "".join(f"set atom 2 x {x}\nrun 0\n" + scripts.result("bonds", "fx[1]") for x in (0.98, 1.05))
    found = scripts.results_by_length(run_lammps(script).stdout)
    before = found[5][0]
    assert before[:2].tolist() == [others, 1]
    near, apart = found[2]
    # the contact is one like any other: it begins at the diameter
    assert near == pytest.approx([others, -contact_push(0.98, 1.0)], rel=1e-9)
    assert apart.tolist() == [others, 0.0]


def test_a_crack_stays_a_crack(run_lammps):
    """through a data file: no bond across it"""
    script = scripts.box(12, newton="on off") + "region body block -2 2 -1.5 1.5 -1.5 1.5\n" + scripts.crystal(region="body")
    script += PAIR_LINES + "region slit block -0.1 0.1 INF INF INF INF units box\npotdem_bonds all 1 1.1 crack slit\n"
    script += "run 0\n" + scripts.result("bonds") + "write_data body.data\nclear\n"
    script += "units si\nnewton on off\natom_style bpm/sphere\nboundary f f f\nspecial_bonds lj 0 1 1 coul 0 1 1\nneighbor 0.3 bin\n"
    script += "bond_style potdem/truss\npair_style potdem/truss\nread_data body.data\nrun 0\n"
    script += "change_box all x scale 1.1 y scale 1.0 remap\nrun 0\n" + scripts.result("bonds")
    whole, again = scripts.results(run_lammps(script).stdout)[:, 0]
    # 4 x 3 x 3 particles: 3 + 2 + 2 rows of bonds without those between the middle layers
    assert whole == again == 2 * 9 + 4 * 6 + 4 * 6


# --- bonding anew -----------------------------------------------------------------------------------------------------

@pytest.mark.parametrize("nprocs", [1, 2])
@pytest.mark.parametrize("how", ["potdem_bonds all 1 0.99", "create_bonds single/bond 1 1 2"])
def test_a_pair_that_failed_in_touch_is_bonded_anew(run_lammps, how, nprocs):
    """no force and no energy at the new length, and its failure is that of any bond"""
    script = FAILED + STATE + f"set atom 2 x 0.97\n{how}\ncompute b all bond/local b4\ncompute re all reduce sum c_b inputs local\n"
    script += "thermo_style custom step c_re bonds f_fail ebond evdwl\nrun 0\n" + STATE + scripts.result("c_re")
    script += "set atom 2 x 1.01\nrun 0\n" + STATE + "set atom 2 x 0.9\nrun 3\n" + STATE
    found = scripts.results_by_length(run_lammps(script, nprocs=nprocs).stdout)
    failed, anew, stretched, again = found[5]
    assert failed[:2].tolist() == [0, 1]
    assert anew.tolist() == [1, 1, 0, 0, 0] and found[1][0][0] == pytest.approx(0.97, rel=1e-15)
    energy = formulas.truss_energy(1.01 / 0.97, 0.97, E * formulas.section(1.0, A))
    assert stretched[:4] == pytest.approx([1, 1, energy, 0], rel=1e-12)
    # eps = ((0.9/0.97)^2 - 1)/2 = -0.07: beyond the strength
    assert again[:2].tolist() == [0, 2]
    assert again[3] == pytest.approx(0.0, abs=1e-15)    # the contact begins where the bond ended


def test_a_pair_bonded_twice_is_refused(run_lammps):
    message = run_lammps(CLOSE + "create_bonds single/bond 1 1 2\nrun 0\n", expect_error="").error
    assert "1 and 2" in message.replace("2 and 1", "1 and 2") and "bonded twice" in message


# --- what others see --------------------------------------------------------------------------------------------------

@pytest.mark.parametrize("nprocs", [1, 2])
def test_lists_and_counts_see_live_bonds_only(run_lammps, tmp_path, nprocs):
    """a body with much overlap is torn and crushed: thermo, compute nbond/atom, property/local, strain/atom agree"""
    script = scripts.box(24) + "region body block -2 2 -1.5 1.5 -4 4\n" + scripts.crystal(region="body", diameter=1.1)
    script += scripts.elastic(100.0, "lattice", "", 0.4) + "potdem_bonds all 1 1.42\nvelocity all ramp vz 1.2 -1.2 z -4 4\n"
    script += """
velocity all ramp vx -0.6 0.6 x -2 2 sum yes
fix move all nve
fix fail all potdem/failure 1 tension 3 compression 4
timestep 0.01
compute t all property/local btype batom1 batom2
compute n all nbond/atom
compute sn all reduce sum c_n
compute strain all potdem/strain/atom
compute ss all reduce sum c_strain[7]
thermo_style custom step bonds f_fail c_sn c_ss pe
thermo 30
run 120
write_dump all local t.dump index c_t[*]
"""
    thermo = run_lammps(script, nprocs=nprocs).thermo
    live = thermo["Bonds"]
    assert thermo["f_fail"][-1] > 50 and live[-1] > 50
    assert (live + thermo["f_fail"] == live[0]).all()
    assert (thermo["c_sn"] == 2 * live).all() and (thermo["c_ss"] == 2 * live).all()
    types = dumps.read(tmp_path / "t.dump")[0]["c_t[1]"]
    assert len(types) == live[-1] and (types == 1).all()


# --- what a contact remembers -----------------------------------------------------------------------------------------

def path(*places):
    """the second sphere is put to these places, one after the other"""
    return "".join(f"set atom 2 x {x}\nrun 0\n" + scripts.result("evdwl", "fx[2]") for x in places)


@pytest.mark.parametrize("nprocs, newton", [(1, "on"), (2, "on"), (2, "off")])
def test_the_contact_begins_where_the_bond_ended(run_lammps, nprocs, newton):
    """also after the two have been out of each other's neighbour lists for some runs and rebuilds"""
    places = (0.8, 0.9, 0.99, 0.8, 1.01, 5.0, 8.0, 5.0, 0.9, 0.8)
    script = replaced(FAILED, "atom_style", f"newton {newton} off\natom_style", 1) + path(*places)
    found = scripts.results(run_lammps(script, nprocs=nprocs).stdout)
    for (energy, push), r in zip(found, places):
        # the pair fails in the step after the one that found it: at 0.85 to the last digit, since it is held
        assert energy == pytest.approx(contact_energy(r, 0.85), rel=1e-9, abs=1e-15), r
        assert push == pytest.approx(contact_push(r, 0.85), rel=1e-9, abs=1e-13), r


@pytest.mark.parametrize("nprocs", [1, 2])
@pytest.mark.parametrize("newton", ["on", "off"])
@pytest.mark.parametrize("first, second, side", [(9.6, lambda r: r - 10.4, 1), (-9.5, lambda r: 10.5 - r, -1)])
def test_the_contact_across_a_periodic_border(run_lammps, first, second, side, newton, nprocs):
    """whichever of the two has the pair in its row of the list, before and after the list is built anew"""
    script = scripts.box(20, boundary="p p p", newton=f"{newton} off") + scripts.particles(
        [(first, 0, 0, 1.0), (second(0.9), 0, 0, 1.0)]) + "set group all mass 1\n" + PAIR_LINES
    script += "potdem_bonds all 1 0.95\n" + SETTINGS + f"set atom 2 x {second(0.85)}\nrun 3\n"
    places = (0.8, 0.9, 0.8)
    found = scripts.results(run_lammps(script + path(*map(second, places)), nprocs=nprocs).stdout)
    for (energy, push), r in zip(found, places):
        assert energy == pytest.approx(contact_energy(r, 0.85), rel=1e-9, abs=1e-15), r
        assert side * push == pytest.approx(contact_push(r, 0.85), rel=1e-9, abs=1e-13), r


@pytest.mark.parametrize("nprocs", [1, 2])
def test_a_pair_that_is_bonded_and_fails_again_begins_anew(run_lammps, nprocs):
    """first at 0.85, then at 0.9, then out of touch: the contact begins where the last bond ended, or at the diameter"""
    strong = replaced(SETTINGS, "compression 50", "tension 60 compression 50")
    script = CLOSE + strong + "set atom 2 x 0.85\nrun 3\n" + path(0.84)
    script += "set atom 2 x 0.97\npotdem_bonds all 1 0.99\nrun 0\nset atom 2 x 0.9\nrun 3\n" + path(0.84)
    script += "set atom 2 x 0.97\npotdem_bonds all 1 0.99\nrun 0\nset atom 2 x 1.06\nrun 3\n" + path(0.84)
    found = scripts.results_by_length(run_lammps(script + scripts.result("f_fail"), nprocs=nprocs).stdout)
    assert found[1][0][0] == 3
    for (energy, push), start in zip(found[2], (0.85, 0.9, 1.0)):
        assert energy == pytest.approx(contact_energy(0.84, start), rel=1e-9), start
        assert push == pytest.approx(contact_push(0.84, start), rel=1e-9), start


KEPT = {
    "restart": "write_restart half.restart\nclear\nread_restart half.restart\n" + SETTINGS,
    "pair_style again": "pair_style potdem/truss\npair_coeff * * 1000 0.5\n",
    "bond_style again": "bond_style potdem/truss\nbond_coeff * 1000 area factor 0.5\n",
    "friction that remembers": "pair_coeff * * 1000 0.5 friction 0.3 spring 0.5\n",
    "friction that remembers, and then none": "pair_coeff * * 1000 0.5 friction 0.3 spring 0.5\nrun 0\npair_coeff * * 1000 0.5\n",
    "other pages": "neigh_modify one 1000 page 20000\n",
    "a minimisation": "min_modify dmax 1e-9\nmin_style cg\nminimize 0 0 2 2\nset atom 1 x 0\n",
    "a run in pieces": "run 3 pre no\nrun 2 post no\n",
    "bonds elsewhere": "create_atoms 1 single 5 5 5 units box\ncreate_atoms 1 single 6 5 5 units box\nset atom 3*4 diameter 1\n"
                       "set atom 3*4 mass 1\ngroup far id 3 4\npotdem_bonds far 1 1.05\n",
}


@pytest.mark.parametrize("nprocs", [1, 2])
@pytest.mark.parametrize("event", KEPT)
def test_the_memory_is_kept_through(run_lammps, event, nprocs):
    script = FAILED + KEPT[event] + path(0.8, 0.9)
    inside, outside = scripts.results(run_lammps(script, nprocs=nprocs).stdout)
    assert inside == pytest.approx([contact_energy(0.8, 0.85), contact_push(0.8, 0.85)], rel=1e-9)
    assert outside.tolist() == [0.0, 0.0]


@pytest.mark.parametrize("steps", [0, 1, 2, 3])
def test_a_restart_around_the_step_of_failure(run_lammps, steps):
    """the bond is found overstretched at step 0, and in step 1 it is gone and the pair in the neighbour list"""
    script = CLOSE + SETTINGS + f"set atom 2 x 0.85\nrun {steps}\nwrite_restart half.restart\n"
    script += "clear\nread_restart half.restart\n" + SETTINGS + "run 3\n" + scripts.result("bonds", "f_fail", "ebond") + path(0.8)
    found = scripts.results_by_length(run_lammps(script).stdout)
    assert found[3][0].tolist() == [0, 1, 0]
    assert found[2][0] == pytest.approx([contact_energy(0.8, 0.85), contact_push(0.8, 0.85)], rel=1e-9)


CUT = spheres((0, 0, 0), (0.9, 0, 0), (0, 0.9, 0)) + "region slit block 0.4 0.5 INF INF INF INF units box\n"
CUT += "potdem_bonds all 1 0.95 crack slit\n"


@pytest.mark.parametrize("through", ["", "write_restart half.restart\nclear\nread_restart half.restart\n"])
@pytest.mark.parametrize("nprocs", [1, 2])
def test_a_crack_begins_free_of_force(run_lammps, through, nprocs):
    """the two that it cuts overlap by a tenth"""
    places = (0.9, 0.8, 0.95, 1.01, 4.0, 0.95)
    found = scripts.results(run_lammps(CUT + through + path(*places), nprocs=nprocs).stdout)
    for (energy, push), r in zip(found, places):
        assert energy == pytest.approx(contact_energy(r, 0.9), rel=1e-9, abs=1e-15), r
        assert push == pytest.approx(contact_push(r, 0.9), rel=1e-9, abs=1e-13), r


@pytest.mark.parametrize("nprocs", [1, 2])
def test_a_crack_through_a_pair_that_failed_begins_anew(run_lammps, nprocs):
    """first at 0.85, and then where the crack is made"""
    script = replaced(FAILED, "\nset group all mass", "\ncreate_atoms 1 single 0 5 0 units box\ncreate_atoms 1 single 0 5.9 0 units box\n"
                      "set atom 3*4 diameter 1\nset group all mass", 1)
    script += path(0.84) + "set atom 2 x 0.9\nregion slit block 0.4 0.5 -1 1 INF INF units box\n"
    script += "delete_bonds all bond 1 any remove special\npotdem_bonds all 1 1.05 crack slit\n" + path(0.84)
    found = scripts.results(run_lammps(script, nprocs=nprocs).stdout)
    for (_, push), start in zip(found, (0.85, 0.9)):
        assert push == pytest.approx(contact_push(0.84, start), rel=1e-9), start


@pytest.mark.parametrize("law, coeff", [("potdem/hertz", "1000 0.3"), ("potdem/lj", "300 0.5 3 0.2")])
def test_each_style_of_a_hybrid_remembers_its_own(run_lammps, law, coeff):
    """types 1 and 2: a pair of each fails in touch; the laws begin where the bonds ended, lj with the pull of its cut"""
    rows = [(0, 0, 0, 1.0, 1), (0.9, 0, 0, 1.0, 1), (0, 5, 0, 1.0, 2), (0.9, 5, 0, 1.0, 2)]
    script = scripts.box(20, types=2) + scripts.particles(rows) + "set group all mass 1\n"
    script += f"pair_style hybrid potdem/truss {law}\npair_coeff 1 1 potdem/truss 1000 0.5\npair_coeff 2 2 {law} {coeff}\n"
    script += "pair_coeff 1 2 potdem/truss 1000 0.5\nbond_style potdem/truss\nbond_coeff * 1000 area factor 0.5\n"
    script += "potdem_bonds all 1 0.95\n" + SETTINGS + "set atom 2 x 0.85\nset atom 4 x 0.85\n"
    state = scripts.result("f_fail", "evdwl", "fx[1]", "fx[3]")
    script += "run 3\n" + state + "set atom 2 x 0.84\nset atom 4 x 0.84\nrun 0\n" + state
    script += "set atom 2 x 0.86\nset atom 4 x 0.86\nrun 0\n" + state
    at, inside, outside = scripts.results(run_lammps(script).stdout)
    assert at[0] == 2
    assert inside[2] < 0 and (inside[3] > 0 if law == "potdem/lj" else inside[3] < 0)
    assert outside[2] == 0.0 and outside[3] == 0.0
    if law == "potdem/hertz":
        assert at[1:] == pytest.approx([0, 0, 0], abs=1e-12) and inside[1] > 0


def test_a_memory_that_is_removed_is_missed(run_lammps):
    message = run_lammps(FAILED + "unfix POTDEM_CONTACTS_1\nrun 0\n", expect_error="").error
    assert "POTDEM_CONTACTS_1" in message and "pair_style potdem/truss" in message and "unfix" in message


def test_no_memory_where_no_bond_can_fail(run_lammps):
    grains = scripts.box(8) + scripts.particles([(0, 0, 0, 1.0), (0.9, 0, 0, 1.0)])
    grains += "bond_style none\npair_style potdem/truss\npair_coeff * * 1000 0.5\n"
    assert "POTDEM_CONTACTS" not in replaced(run_lammps(grains + "run 0\ninfo fixes\n").stdout, "POTDEM_CONTACTS_1_PLACE", "")
