# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""The number of ranks and the newton setting are no physics: same trajectories, same broken bonds."""

import numpy as np
import pytest

from potdem import dumps, formulas, scripts

# Sums in another order: rounding 1e-16 of the forces, growing over 300 steps of vibration
RANKS_AGREE = 1e-9


def body(newton=None, boundary="f f f", options=""):
    """a vibrating block of 4 x 5 x 6 particles; in a periodic box it reaches across the boundaries"""
    size = (4, 5, 6) if "p" in boundary else 24
    return scripts.box(size, boundary, newton=newton) + "region body block -2 2 -2.5 2.5 -3 3\n" + scripts.crystal(
        region="body") + scripts.elastic(E=100.0, area="lattice", bond=options, contact=0.3)


def vibrate(steps=300, amplitude=0.3, more=""):
    return scripts.velocities_by_formula(amplitude) + f"""
fix 1 all nve
timestep 0.02
thermo 50
thermo_style custom step pe ke pxx pyz
thermo_modify format float {scripts.ALL_DIGITS}
{scripts.write_dump("start.dump", "x y z")}
{more}
run {steps}
""" + scripts.write_dump("end.dump", "xu yu zu vx vy vz")


def order(tmp_path):
    """places of the particles at the start"""
    return scripts.places(dumps.read(tmp_path / "start.dump")[0])


def end_state(run_lammps, tmp_path, script, nprocs):
    run = run_lammps(script, nprocs=nprocs)
    columns = dumps.read(tmp_path / "end.dump")[0]
    return scripts.vectors(columns, "xu", "yu", "zu", "vx", "vy", "vz")[order(tmp_path)], run


@pytest.mark.parametrize("boundary, options", [("f f f", "damping 0.02"), ("p p p", ""), ("p f p", "penetration 2")])
def test_same_trajectory_on_any_number_of_ranks(run_lammps, tmp_path, boundary, options):
    script = body(boundary=boundary, options=options) + "potdem_bonds all 1 1.42\n" + vibrate()
    one, run = end_state(run_lammps, tmp_path, script, 1)
    assert np.abs(one).max() > 1    # positions of order 1: absolute is relative
    for nprocs in (2, 4):
        state, other = end_state(run_lammps, tmp_path, script, nprocs)
        assert np.abs(state - one).max() < RANKS_AGREE
        for column in ("PotEng", "KinEng", "Pxx", "Pyz"):
            scale = np.abs(run.thermo[column]).max()
            assert np.abs(other.thermo[column] - run.thermo[column]).max() < RANKS_AGREE * scale


def test_tiled_domains_that_move(run_lammps, tmp_path):
    """comm_style tiled and load balancing shift particles between ranks while they vibrate"""
    script = body("on off", "p p p") + "potdem_bonds all 1 1.42\n"
    one, _ = end_state(run_lammps, tmp_path, script + vibrate(), 1)
    tiled = vibrate(more="comm_style tiled\nfix balance all balance 20 1.0 rcb\n")
    state, _ = end_state(run_lammps, tmp_path, script + tiled, 4)
    assert np.abs(state - one).max() < RANKS_AGREE


@pytest.mark.parametrize("nprocs", [1, 4])
@pytest.mark.parametrize("newton", ["on off", "off off"])
def test_newton_makes_no_difference(run_lammps, tmp_path, newton, nprocs):
    """against the setting that potdem_bonds makes by itself, with contacts between two bodies"""
    def script(setting):
        text = body(setting)
        text += "region low block INF INF INF INF INF 0\ngroup low region low\ngroup high subtract all low\n"
        text += "potdem_bonds low 1 1.42\npotdem_bonds high 1 1.42\n"
        return text + vibrate(more="velocity high set 0 0 -1 sum yes")

    reference, run = end_state(run_lammps, tmp_path, script(None), 1)
    state, other = end_state(run_lammps, tmp_path, script(newton), nprocs)
    assert np.abs(state - reference).max() < RANKS_AGREE
    assert other.thermo["PotEng"] == pytest.approx(run.thermo["PotEng"], rel=RANKS_AGREE, abs=RANKS_AGREE)


# --- breaking --------------------------------------------------------------------------------------------

def pulled_bar(boundary="f f f"):
    """a bar of 3 x 3 x 12 pulled at both ends, weakened by a notch so that it breaks at one place"""
    return scripts.box((9, 9, 30), boundary, bond_types=1) + f"""
region body block -1.5 1.5 -1.5 1.5 -6 6
{scripts.crystal(region="body")}
region notch block -1.5 -0.5 INF INF -0.5 0.5
{scripts.elastic(E=100.0)}
potdem_bonds all 1 1.42 crack notch
region top block INF INF INF INF 5 INF
region bottom block INF INF INF INF INF -5
group top region top
group bottom region bottom
fix failure all potdem/failure 1 tension 3.0
fix 1 all nve
velocity all ramp vz -0.8 0.8 z -6 6
velocity top set 0.05 0.02 0.8
velocity bottom set 0 0 -0.8
fix top top setforce 0 0 0
fix bottom bottom setforce 0 0 0
timestep 0.01
thermo 20
thermo_style custom step pe ke f_failure f_failure[1] f_failure[2] bonds
thermo_modify format float {scripts.ALL_DIGITS}
{scripts.write_dump("start.dump", "x y z")}
dump events all local 10 events.dump index f_failure[*]
dump_modify events format float {scripts.ALL_DIGITS}
"""


def events(tmp_path):
    """rows of broken bonds, the particles numbered by their place, sorted by pair"""
    table = dumps.read(tmp_path / "events.dump")[-1]
    rows = scripts.vectors(table, *(f"f_failure[{k}]" for k in range(1, 11)))
    number = np.argsort(order(tmp_path))
    rows[:, 2:4] = np.sort(number[rows[:, 2:4].astype(int) - 1], axis=1)
    return rows[np.lexsort((rows[:, 3], rows[:, 2]))]


def pairs(rows):
    return [(int(a), int(b)) for a, b in rows[:, 2:4]]


def test_same_bonds_break_on_any_number_of_ranks(run_lammps, tmp_path):
    """the bar breaks through within a few hundred steps, before rounding can grow to matter"""
    script = pulled_bar() + "run 60\n"
    run = run_lammps(script)
    one = events(tmp_path)
    assert len(one) >= 20
    assert len(set(pairs(one))) == len(one)    # each once
    assert run.thermo["f_failure"][-1] == len(one)
    for nprocs in (2, 4):
        other_run = run_lammps(script, nprocs=nprocs)
        other = events(tmp_path)
        assert pairs(other) == pairs(one)
        assert np.array_equal(other[:, 0], one[:, 0])    # on the same step
        assert np.abs(other[:, 1:] - one[:, 1:]).max() < RANKS_AGREE
        for column in ("f_failure", "f_failure[1]", "f_failure[2]", "Bonds", "PotEng"):
            assert other_run.thermo[column] == pytest.approx(run.thermo[column], rel=RANKS_AGREE, abs=RANKS_AGREE)


@pytest.mark.parametrize("nprocs", [1, 2])
def test_a_run_in_pieces(run_lammps, tmp_path, nprocs):
    """a bond that is due at the end of one run goes at the start of the next: ten runs break what one does"""
    run = run_lammps(pulled_bar() + "run 60\n", nprocs=nprocs)
    whole = events(tmp_path)
    parts_run = run_lammps(pulled_bar() + 20 * "run 3\n", nprocs=nprocs)
    parts = events(tmp_path)
    assert pairs(parts) == pairs(whole)
    assert np.abs(parts - whole).max() < RANKS_AGREE
    assert parts_run.thermo["PotEng"][-1] == pytest.approx(run.thermo["PotEng"][-1], rel=RANKS_AGREE)


@pytest.mark.parametrize("nprocs", [1, 4])
def test_contact_distance_travels_with_the_pair(run_lammps, tmp_path, nprocs):
    """a pair fails while it overlaps and then drifts through a periodic box and its ranks, held together by
    nothing: no force between the distance of failure and the mean diameter, the same on any number of ranks"""
    script = scripts.box((12, 6, 6), "p p p") + scripts.particles([(0, 0, 0, 1.0), (0.8, 0, 0, 1.0)])
    script += scripts.elastic()
    script += """potdem_bonds all 1 0.9
fix failure all potdem/failure 1 compression 60
fix move all nve
velocity all set 3.0 1.7 0.9
group two id 2
group one id 1
velocity two set 0 1.7 0.9
timestep 0.0005
thermo 200
thermo_style custom step etotal f_failure f_failure[1] evdwl
thermo_modify format float %.17g
run 400
velocity all set 3.0 1.7 0.9
run 10000
"""
    # at the same speed they stay where they parted; at the end they are pushed together again
    script += scripts.result("f_failure") + "set atom 1 x 0 y 0 z 0\nset atom 2 x 0.79 y 0 z 0\nrun 0\n"
    script += scripts.result("f_failure", "fx[2]", "evdwl") + "set atom 2 x 0.5\nrun 0\n"
    script += scripts.result("fx[2]", "evdwl", "f_failure")
    kinds = scripts.results_by_length(run_lammps(script, nprocs=nprocs).stdout)
    assert kinds[1][0][0] == 1
    between, inside = kinds[3]
    assert tuple(between) == (1, 0, 0)
    reference = 0.8 * np.sqrt(1 - 2 * 60 / 1000)    # the distance of the strength; passed by one step's way, 1.5e-3
    modulus = 1000.0 * formulas.section(1.0, 0.5)
    assert inside[0] == pytest.approx(-formulas.truss_tension(0.5 / reference, modulus), rel=0.01)


@pytest.mark.parametrize("nprocs", [1, 2, 4])
def test_a_bond_across_the_boundary_breaks_once(run_lammps, tmp_path, nprocs):
    """two particles on either side of a periodic boundary, which is a boundary between ranks too"""
    script = scripts.box((10, 6, 6), "p p p") + scripts.particles([(4.6, 0, 0, 1.0), (-4.4, 0, 0, 1.0)])
    script += scripts.elastic()
    script += "potdem_bonds all 1 1.5\nfix failure all potdem/failure 1 tension 50.0\nfix 1 all nve\n"
    script += "velocity all set 0 0 0\ngroup two id 2\nvelocity two set 4 0 0\ntimestep 0.0005\nthermo 10\n"
    script += "thermo_style custom step f_failure bonds pe\nthermo_modify format float %.17g\n"
    script += scripts.write_dump("start.dump", "x y z")
    script += "dump events all local 10 events.dump index f_failure[*]\nrun 200\n"
    run = run_lammps(script, nprocs=nprocs)
    rows = events(tmp_path)
    assert pairs(rows) == [(0, 1)]
    assert run.thermo["f_failure"][-1] == 1 and run.thermo["Bonds"][-1] == 0
    assert run.thermo["PotEng"][-1] == 0.0
    assert abs(rows[0, 4]) == pytest.approx(5.0, abs=0.2)    # the middle of the bond, not of the box


# --- threads ---------------------------------------------------------------------------------------------

def threaded(script, threads=2):
    return f"package omp {threads}\nsuffix omp\n" + script


@pytest.mark.parametrize("nprocs", [1, 2])
@pytest.mark.parametrize("options", ["damping 0.02", "penetration 2"])
def test_same_trajectory_on_threads(run_lammps, tmp_path, options, nprocs):
    """bonds, and contacts of two bodies: forces, energy, virial, per-atom stress"""
    script = body(options=options)
    script += "region low block INF INF INF INF INF 0\ngroup low region low\ngroup high subtract all low\n"
    script += "potdem_bonds low 1 1.42\npotdem_bonds high 1 1.42\ncompute s all stress/atom NULL\n"
    script += "compute square all reduce sumsq c_s[1] c_s[5]\n"
    script += vibrate(more="thermo_style custom step pe ke pxx pyz c_square[1] c_square[2] evdwl\n"
                           "thermo_modify format float %.17g\nvelocity high set 0 0 -1 sum yes\nthermo 5")
    one, run = end_state(run_lammps, tmp_path, script, 1)
    state, other = end_state(run_lammps, tmp_path, threaded(script), nprocs)
    assert "potdem/truss/omp" in other.stdout
    assert np.abs(state - one).max() < RANKS_AGREE
    assert run.thermo["E_vdwl"].max() > 0
    for column in ("PotEng", "KinEng", "Pxx", "Pyz", "c_square[1]", "c_square[2]", "E_vdwl"):
        scale = np.abs(run.thermo[column]).max()
        assert np.abs(other.thermo[column] - run.thermo[column]).max() < RANKS_AGREE * scale


@pytest.mark.every_style
def test_same_bonds_break_on_threads(run_lammps, tmp_path):
    script = pulled_bar() + "run 60\n"
    run_lammps(script)
    one = events(tmp_path)
    run_lammps(threaded(script, 3))
    other = events(tmp_path)
    assert pairs(other) == pairs(one)
    assert np.abs(other - one).max() < RANKS_AGREE


GRAINS = {
    "potdem/hertz rotation yes": "1000 0.3 viscous 1e-3 friction 0.3 auto",
    "potdem/truss": "1000 0.5 friction 0.3 5",
    "potdem/lj": "300 0.2 3 0.2",
    "potdem/granular rotation yes": "300 3 0.2 friction 0.3 5",
    "potdem/dmt rotation yes": "1000 0.3 0.1 restitution 0.5 friction 0.3 mindlin damping 0.1 rolling 0.1 0.2 0.1 twisting 0.1 0.2 0.1",
}


@pytest.mark.every_style
@pytest.mark.parametrize("nprocs, newton", [(1, None), (2, "off off")])
@pytest.mark.parametrize("style", GRAINS)
def test_same_grains_on_threads(run_lammps, tmp_path, style, nprocs, newton):
    """a shaken heap with friction, spin and the ledger"""
    script = "bond_style none\nregion heap block -2 2 -2 2 -2 2\n" + scripts.crystal(
        region="heap", diameter=1.03) + f"""
pair_style {style}
pair_coeff * * {GRAINS[style]}
{scripts.velocities_by_formula(0.5)}
fix move all nve/sphere
compute books all potdem/energy
timestep 0.002
thermo 50
thermo_style custom step pe ke c_books[*] pxy
thermo_modify format float %.17g
{scripts.write_dump("start.dump", "x y z")}
run 200
""" + scripts.write_dump("end.dump", "xu yu zu vx vy vz")
    one, run = end_state(run_lammps, tmp_path, scripts.box(7) + script, 1)
    state, other = end_state(run_lammps, tmp_path, threaded(scripts.box(7, newton=newton) + script), nprocs)
    assert f"{style.split()[0]}/omp" in other.stdout
    assert np.abs(state - one).max() < RANKS_AGREE
    for column in run.thermo:
        if column != "Step":
            scale = max(1.0, np.abs(run.thermo[column]).max())
            assert np.abs(other.thermo[column] - run.thermo[column]).max() < RANKS_AGREE * scale


def test_collapse_on_threads_is_one_error(run_lammps):
    script = scripts.box(20) + "bond_style none\n" + scripts.particles([(0, 0, 0, 1.0), (0.5, 0, 0, 1.0)])
    script += "pair_style potdem/lj\npair_coeff * * 300 0.2 3 0.2\nrun 0\n"
    run_lammps(threaded(script), expect_error="atoms 1 and 2 are 0.5 apart")


WALLS = {
    "flat": "region wall block -1 1 -1 1 -1 1 units box",
    "round": "region wall cylinder z 0 0 1 -1 1 units box",
    "moving": "variable z equal -0.2*time\nregion wall block -1 1 -1 1 -1.2 1 move NULL NULL v_z units box",
}


@pytest.mark.every_style
@pytest.mark.parametrize("options", ["restitution 0.9 friction 0.3 mindlin damping 0.2", "friction 0.3 auto"])
@pytest.mark.parametrize("name", WALLS)
def test_the_same_bits_at_walls_on_threads(run_lammps, tmp_path, name, options):
    """grains that fly about, each for itself, and are damped: particle by particle the same operations; sums over them in another order"""
    rng = np.random.default_rng(1)
    places = np.column_stack([rng.uniform(-0.3, 0.3, (30, 2)), rng.uniform(0, 0.7, 30), 0.04 + 0.002 * np.arange(30)])
    script = scripts.box(4, newton="off", atom_style="sphere", skin=0.05) + scripts.particles(places, density=1000)
    for number, velocity in enumerate(rng.normal(0, 3, (30, 3)), start=1):
        script += "set atom {} vx {} vy {} vz {}\n".format(number, *velocity)
    script += f"""comm_modify vel yes
{WALLS[name]}
pair_style zero 0.2
pair_coeff * *
fix weight all gravity 9.81 vector 0 0 -1
fix wall all potdem/wall/region wall 1e7 0.3 particle 1e7 0.3 layer none {options} rotation yes
fix damp all potdem/damping 0.02
fix move all nve/sphere
compute books all potdem/energy
timestep 2e-5
thermo 500
thermo_style custom step ke c_books[*] f_wall[*] pxx
thermo_modify format float {scripts.ALL_DIGITS} lost ignore
run 10000
info fixes
""" + scripts.write_dump("end.dump", "x y z vx vy vz omegax omegay omegaz")
    run = run_lammps(script)
    one = (tmp_path / "end.dump").read_text()
    assert np.abs(run.thermo["f_wall[3]"]).max() > 0
    for threads in (2, 3):
        other = run_lammps(threaded(script, threads))
        assert "potdem/wall/region/omp" in other.stdout and "potdem/damping/omp" in other.stdout
        assert (tmp_path / "end.dump").read_text() == one
        for column in run.thermo:
            scale = max(1.0, np.abs(run.thermo[column]).max())
            assert np.abs(other.thermo[column] - run.thermo[column]).max() < RANKS_AGREE * scale, column


def test_a_passed_wall_on_threads_is_one_error(run_lammps):
    script = scripts.box(20) + "bond_style none\n" + scripts.particles([(0, 0, 0, 1.0), (0, 0, 9.0, 1.0)])
    script += "pair_style zero 1.0\npair_coeff * *\nregion wall block -4 4 -4 4 -4 4\n"
    script += "fix wall all potdem/wall/region wall 1e7 0.3 particle 1e7 0.3\nrun 0\n"
    run_lammps(threaded(script), expect_error="centre of atom 2 has passed the wall")
