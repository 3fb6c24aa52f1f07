# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Cracks that cost an energy: where they begin, how bonds soften, what a crack through a body costs.

What is expected comes from Hooke's law and from the area below the curve of force over opening, worked out here."""

import shutil

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from test_area_body import HEAD, write_particles

from potdem import dumps, networks, scripts
from potdem.paths import EXAMPLES

E = 1000.0
PERIOD = 4    # steps from one look at the stress to the next


# ---- one bond

FT, GF = 1.0, 0.02
PAIR = scripts.box(20) + scripts.particles([(0, 0, 0, 1.0), (1, 0, 0, 1.0)]) + scripts.elastic(E, "factor 1", "") + f"""
potdem_bonds all 1 1.1
group two id 2
timestep 1
variable r equal x[2]-x[1]
variable f equal fx[1]
"""
FAILURE = f"fix failure all potdem/failure 1 tension {FT} energy {GF}\n"
COLUMNS = f"""thermo 1
thermo_style custom step v_r v_f ebond f_failure f_failure[1] f_failure[4]
thermo_modify format float {scripts.ALL_DIGITS}
"""


def moved(to, start, steps):
    return f"fix move two move linear {(to - start) / steps:.17g} 0 0\nrun {steps}\nunfix move\n"


def stress_of_path(r, onset_at):
    """by the law of the thesis's truss and a straight line from the onset to the opening below which the area is GF; onset_at: the step
    it begins on"""
    strain = 0.5 * (r**2 - 1)
    onset, damage, stress = strain[onset_at], 0.0, E * strain
    end = 0.5 * ((1 + 2 * GF / (E * onset))**2 - 1)
    for k in range(onset_at + 1, len(r)):
        if strain[k] > onset:
            damage = max(damage, 1 - onset * (end - min(strain[k], end)) / ((end - onset) * strain[k]))
        if strain[k] > 0:
            stress[k] *= 1 - damage
    return stress


def test_a_bond_softens(run_lammps):
    """opened, closed into compression, opened to its end. A chain: the bond's own stress decides. Forces to rounding; what is lost and
    stored is the work, by the trapezoidal rule over 1/300 of the opening"""
    turn, last = 1 + 1.3 * GF / FT, 1 + 2.1 * GF / FT
    run = run_lammps(PAIR + FAILURE + COLUMNS + moved(turn, 1, 300) + moved(0.995, turn, 200) + moved(last, 0.995, 400))
    table = run.thermo
    r, force, area = table["v_r"], table["v_f"], 0.25 * np.pi
    onset = next(k for k in range(0, len(r), PERIOD) if 0.5 * E * (r[k]**2 - 1) >= FT)
    there = table["f_failure"] == 0
    stress = stress_of_path(r, onset)
    assert force[there] == pytest.approx(area * stress[there], abs=1e-11)
    assert r[there][-1] - 1 == pytest.approx(2 * GF / stress[onset], rel=0.01)    # it goes at its end
    assert (force[~there] == 0).all() and (table["f_failure[1]"][:onset + 1] == 0).all()
    work = np.concatenate([[0], np.cumsum(0.5 * (force[1:] + force[:-1]) * np.diff(r))])
    whole = area * GF
    assert table["f_failure[1]"] + table["E_bond"] == pytest.approx(work, abs=1e-3 * whole)
    assert table["f_failure[1]"][-1] == pytest.approx(whole, rel=0.01)    # strains of 4 %
    assert table["f_failure[4]"][onset + 1] == 1 and table["f_failure[4]"][-1] == 0
    assert (np.diff(table["f_failure[1]"]) >= 0).all()


def test_damage_of_a_bond_can_be_read(run_lammps):
    """compute bond/local b5 and the others of the damaged bond"""
    turn = 1 + GF / FT
    run = run_lammps(PAIR + FAILURE + "compute bond all bond/local force engpot b1 b2 b5\n" + COLUMNS + moved(turn, 1, 200) + """
compute of_bond all reduce sum c_bond[*] inputs local
run 0
""" + scripts.result("c_of_bond[1]", "c_of_bond[2]", "c_of_bond[3]", "c_of_bond[4]", "c_of_bond[5]", "ebond", "v_f"))
    pull, energy, strain, stress, damage, ebond, force = scripts.results(run.stdout)[0]
    assert strain == pytest.approx(0.5 * (turn**2 - 1)) and 0.9 < damage < 1
    assert stress == pytest.approx((1 - damage) * E * strain)
    assert -pull == pytest.approx(0.25 * np.pi * stress) and -pull == pytest.approx(force)
    assert energy == pytest.approx(ebond, rel=1e-12)


def test_nothing_softens_in_a_minimisation(run_lammps):
    run = run_lammps(PAIR + FAILURE + COLUMNS + moved(1 + GF / FT, 1, 200) + "displace_atoms two move 0.01 0 0 units box\nminimize 0 1e-6 50 50\n")
    damaged = run.thermo["f_failure[1]"]
    assert damaged[200] > 0 and damaged[-1] == damaged[200]


def test_damage_stays_when_bonds_need_more_room(run_lammps):
    """LAMMPS's arrays of bonds grow when a particle gets more bonds than any had"""
    run = run_lammps(PAIR + FAILURE + COLUMNS + moved(1 + GF / FT, 1, 200) + scripts.result("f_failure[1]", "f_failure[4]") + """
region far block 3 6 3 6 3 6 units box
lattice sc 1
create_atoms 1 region far
group far region far
set group far diameter 1 density 1
potdem_bonds far 1 1.8
run 0
""" + scripts.result("f_failure[1]", "f_failure[4]"))
    before, after = scripts.results(run.stdout)
    assert before[0] > 0 and before[1] == 1
    assert (after == before).all()


# ---- where a crack begins

def displaced(strain):
    """displacements of this strain from where the particles are"""
    rows = ["+".join(f"({strain[a][b]:.17g})*f_start[{b + 1}]" for b in range(3)) for a in range(3)]
    lines = [f"variable u{a} atom {row}" for a, row in enumerate(rows)]
    return "\n".join(["fix start all store/state 0 x y z", *lines, "displace_atoms all move v_u0 v_u1 v_u2 units box", "run 0\nunfix start\n"])


def stretched(strain, energy=1.0):
    """particles.data under this strain; is anything softening? (number of bonds)"""
    return f"fix failure all potdem/failure 1 tension {FT} energy {energy}\n" + displaced(strain) + scripts.result("f_failure[4]")


def solid(area="body density 1", stiffness=100 * E):
    """particles.data; strains at the strength of 1e-5: linear"""
    return (HEAD + f"pair_style zero 1.0\npair_coeff * *\nbond_style potdem/truss\nbond_coeff * {stiffness} area {area}\n"
            "potdem_bonds all 1 2 diameters\n")


BODIES = {"cubic": networks.beam("sc", 4, 6), "fcc": networks.beam("fcc", 4, 6), "random": networks.packing(4, 6, spread=0.2)}
STATES = {"tension": (1, 0, 0), "biaxial": (1, 0.9, 0), "shear": (1, 0, -1), "all sides": (1, 1, 1), "pressed": (1, -2, -3)}


@pytest.mark.parametrize("state", STATES)
@pytest.mark.parametrize("name", BODIES)
def test_a_uniform_stress_reaches_the_strength(run_lammps, tmp_path, name, state):
    """its largest principal value FT, turned anyhow: nothing at 0.999 of it, many bonds at 1.001"""
    body = BODIES[name]
    write_particles(tmp_path, body.x - 0.5 * body.size, body.d, body.v)
    turn = Rotation.from_euler("xyz", [0.3, -0.7, 1.1]).as_matrix()
    principal = FT * np.array(STATES[state], dtype=float)
    stress = turn @ np.diag(principal) @ turn.T
    strain = ((1 + 0.25) * stress - 0.25 * np.trace(stress) * np.eye(3)) / (100 * E)
    found = [scripts.results(run_lammps(solid() + stretched(part * strain)).stdout)[0][0] for part in (0.999, 1.001)]
    assert found[0] == 0 and found[1] > len(body.x)


def test_a_plane_body(run_lammps):
    """a triangular network: nu = 1/3"""
    plane = f"""units si
newton on off
atom_style bpm/sphere
dimension 2
boundary f f p
region box block -10 10 -10 10 -0.5 0.5
create_box 1 box bond/types 1
lattice hex 1.0
region body block -4 4 -4 4 -0.5 0.5 units box
create_atoms 1 region body
set group all diameter 1 mass 1
bond_style potdem/truss
bond_coeff * {100 * E} area factor 0.5
pair_style zero 1.0
pair_coeff * *
potdem_bonds all 1 1.1
"""
    turn = Rotation.from_euler("z", 0.4).as_matrix()
    stress = turn @ np.diag([FT, 0.2 * FT, 0]) @ turn.T
    strain = ((1 + 1 / 3) * stress - np.trace(stress) / 3 * np.diag([1, 1, 0])) / (100 * E)
    strain[2] = strain[:, 2] = 0
    found = [scripts.results(run_lammps(plane + stretched(part * strain)).stdout)[0][0] for part in (0.999, 1.001)]
    assert found[0] == 0 and found[1] > 50


def test_turned_body_softens_alike(run_lammps, tmp_path):
    """a body past its strength, and the same turned: bonds, energies and forces (area body finds sections by rays, which do not turn)"""
    body = BODIES["random"]
    turn = Rotation.from_euler("xyz", [1.0, 0.4, -2.1]).as_matrix()
    found = []
    for q in (np.eye(3), turn):
        write_particles(tmp_path, (body.x - 0.5 * body.size) @ q.T, body.d, body.v)
        strain = q @ np.diag([1.3, 0.4, -0.3]) @ q.T * FT / E
        run = run_lammps(solid("factor 0.4", E) + stretched(strain, 0.01) + displaced(strain) +
                         scripts.result("f_failure[1]", "ebond", "f_failure[4]") + scripts.write_dump("end.dump", "fx fy fz"))
        found.append((scripts.results_by_length(run.stdout)[3][0], scripts.vectors(dumps.read(tmp_path / "end.dump")[-1], "fx", "fy", "fz") @ q))
    (before, forces), (after, turned) = found
    assert before[2] > 100 and before[0] > 0
    assert after == pytest.approx(before, rel=1e-9)
    assert np.abs(turned - forces).max() < 1e-8 * np.abs(forces).max()


# ---- what a crack costs

BAR = (EXAMPLES / "bar-strength" / "in.bar-strength").read_text()
# distance of the planes of the lattice across the bar, spacing 1
PLANES = {"sc 100": 1, "sc 111": 1 / np.sqrt(3), "fcc 100": 1 / np.sqrt(2), "hcp c": np.sqrt(2 / 3)}


def bar(packing, along, failure, **settings):
    """the scene's bar, shorter, between grips that do not move sideways; the last results: fracture energy, mass, length"""
    given = {"packing": packing, "along": along, "free": 8, "failure": f'"{failure}"', "rate": "2e-3", **settings}
    text = BAR.replace("setforce 0 NULL NULL", "setforce 0 0 0")
    return "".join(f"variable {name} index {value}\n" for name, value in given.items()) + text + scripts.result(
        "f_crack[1]", "mass(all)", "bound(all,xmax)-bound(all,xmin)")


@pytest.mark.parametrize("name", PLANES)
def test_energy_of_a_crack(run_lammps, name):
    """through a bar of 6 d, whatever the lattice and its direction, over Gf times its section"""
    ft, gf = 1e-3, 1.5e-5
    packing, along = name.split()
    end = 1.15 * (1 + 2 * gf / ft / (ft * 8))
    run = run_lammps(bar(packing, along, f"energy {gf}", end=end))
    energy, mass, length = scripts.results(run.stdout)[0]
    section = mass / (length - 8 * ft * (end - 0.6) + PLANES[name])
    stress = run.thermo["v_stress"]
    assert stress[-1] < 0.05
    assert stress.max() == pytest.approx(1, abs=0.05)
    assert energy / section == pytest.approx(gf, rel=0.05)


@pytest.mark.parametrize("packing, along", [("sc", "100"), ("sc", "110"), ("sc", "111"), ("fcc", "111"), ("bcc", "100"), ("random", "x")])
def test_strength_of_a_bar(run_lammps, tmp_path, packing, along):
    """the stress that it carries at most, whatever the lattice and its direction. Its strain is uneven by some percent; where a bond's own
    stress decides, it is 1 to 1.37 of the strength, and 0.85 for the packing"""
    shutil.copy(EXAMPLES / "bar-strength" / "random.data", tmp_path)
    run = run_lammps(bar(packing, along, "energy 1.5e-5", free=24 if packing == "random" else 12, end=1.3))
    assert run.thermo["v_stress"].max() == pytest.approx(1, abs=0.05)


# ---- a body that breaks

FREE = HEAD + f"""pair_style potdem/truss
pair_coeff * * {E} 0.5
bond_style potdem/truss
bond_coeff * {E} area body density 1
potdem_bonds all 1 2 diameters
compute ledger all potdem/energy
velocity all ramp vx -0.2 0.2 x -4 4 units box
fix failure all potdem/failure 1 tension {FT} energy {GF} compression 20
fix move all nve
"""
BREAKING = networks.beam("fcc", 5, 8)


def flying_apart(step=0.002, before="", time=0.8, more=""):
    steps = round(time / step)
    return before + FREE + f"""timestep {step}
thermo {max(1, steps // 40)}
thermo_style custom step c_ledger f_failure f_failure[*] ebond bonds {more}
thermo_modify format float {scripts.ALL_DIGITS}
run {steps}
"""


@pytest.fixture
def breaking(tmp_path):
    write_particles(tmp_path, BREAKING.x - 0.5 * BREAKING.size, BREAKING.d, BREAKING.v)


def test_energy_is_kept(run_lammps, breaking):
    """of what cracks cost: bonds that a crack enters or leaves do it at one step, an error of second order in the step"""
    drift = []
    for step in (0.004, 0.002):
        table = run_lammps(flying_apart(step)).thermo
        assert table["f_failure"][-1] > 300 and table["f_failure[1]"][-1] > 0.5
        drift.append(np.ptp(table["c_ledger"]) / table["f_failure[1]"][-1])
    assert drift[1] < 2e-3 and drift[1] < 0.6 * drift[0]


@pytest.mark.parametrize("nprocs", [2, 3])
def test_ranks(run_lammps, breaking, nprocs):
    """to rounding before many bonds have gone, all in all after"""
    one, more = run_lammps(flying_apart()).thermo, run_lammps(flying_apart(), nprocs=nprocs).thermo
    begun = one["f_failure[4]"] > 0
    early = begun & (one["f_failure"] == 0)
    assert early.sum() > 1
    for name in ("f_failure[1]", "E_bond", "f_failure[4]"):
        assert more[name][early] == pytest.approx(one[name][early], rel=1e-9)
    assert more["f_failure"][-1] == pytest.approx(one["f_failure"][-1], rel=0.2)
    assert np.ptp(more["c_ledger"]) < 2e-3 * more["f_failure[1]"][-1]


def test_threads(run_lammps, breaking):
    one = run_lammps(flying_apart(time=0.08)).thermo
    two = run_lammps(flying_apart(before="package omp 2\nsuffix omp\n", time=0.08))
    assert "potdem/truss/omp" in two.stdout and one["f_failure[1]"][-1] > 0
    for name in ("f_failure[1]", "E_bond", "f_failure[4]"):
        assert two.thermo[name] == pytest.approx(one[name], rel=1e-9)


END = scripts.write_dump("end.dump", "x y z vx vy vz")


def test_restart(run_lammps, tmp_path, breaking):
    """written inside a run, bit for bit; the sums over ranks and bonds have another order"""
    run = run_lammps(flying_apart(time=0.6).replace("run ", "restart 101 half.*\nrun ") + END)
    end = dumps.read(tmp_path / "end.dump")[-1]
    again = run_lammps(f"""read_restart half.101
neighbor 0.3 bin
compute ledger all potdem/energy
fix failure all potdem/failure 1 tension {FT} energy {GF} compression 20
fix move all nve
timestep 0.002
restart 101 more.*
thermo_style custom step c_ledger f_failure f_failure[*] ebond bonds
thermo_modify format float {scripts.ALL_DIGITS}
run 199
""" + END)
    there = dumps.read(tmp_path / "end.dump")[-1]
    assert all((end[name] == there[name]).all() for name in end)
    for name in ("f_failure", "f_failure[1]", "f_failure[4]", "c_ledger"):
        assert again.thermo[name][-1] == pytest.approx(run.thermo[name][-1], rel=1e-12)
    assert run.thermo["f_failure[4]"][-1] > 0
    run_lammps("read_restart half.101\nneighbor 0.3 bin\nfix move all nve\nrun 1\n", expect_error="Bonds of the restart file have softened")


def test_what_is_damaged_stays_so(run_lammps, breaking):
    """without the fix nothing softens further, and nothing is whole again"""
    run = run_lammps(flying_apart(time=0.1) + scripts.result("f_failure[1]", "ebond") + """
thermo_style custom step ebond
unfix failure
run 0
""" + scripts.result("ebond") +
                     f"fix failure all potdem/failure 1 tension {FT} energy {GF}\nrun 0\n" + scripts.result("f_failure[1]", "ebond"))
    before, after = scripts.results_by_length(run.stdout)[2]
    (alone,), = scripts.results_by_length(run.stdout)[1]
    assert before[0] > 0
    assert after == pytest.approx(before, rel=1e-12) and alone == pytest.approx(before[1], rel=1e-12)


# ---- a notch

def notched_plate(across, failure):
    """1 wide, 2 high, four layers thick, cut across half its width; pulled by clamped ends over 3e-3 in 200 times that a wave needs to cross
    it. E = density = 1, strength 1e-3"""
    d = 1 / across
    return f"""units si
atom_style bpm/sphere
boundary f f f
region box block -0.8 0.8 -1.5 1.5 -0.6 0.6 units box
create_box 1 box bond/types 1
lattice sc {d} origin 0.5 0.5 0.5
region plate block -0.5 0.5 -1 1 0 {4 * d} units box
create_atoms 1 region plate
set group all diameter {d} mass {d**3}
neighbor {0.3 * d} bin
region slit block -0.6 0 {-1e-3 * d} {1e-3 * d} INF INF units box
pair_style zero {d}
pair_coeff * *
bond_style potdem/truss
bond_coeff 1 1.0 area body density 1
potdem_bonds all 1 2 diameters crack slit
region top block INF INF {1 - 2.05 * d} INF INF INF units box
region bottom block INF INF INF {-1 + 2.05 * d} INF INF units box
group top region top
group bottom region bottom
group ends union top bottom
group free subtract all ends
fix crack free potdem/failure 1 tension 1e-3 {failure}
velocity all ramp vy -7.5e-6 7.5e-6 y -1 1 units box
velocity top set 0 7.5e-6 0 units box
velocity bottom set 0 -7.5e-6 0 units box
fix move all nve
fix drag free viscous {0.3 * d**3}
fix top top setforce 0 0 0
fix bottom bottom setforce 0 0 0
timestep {0.25 * d}
variable stress equal (f_bottom[2]-f_top[2])/2/{4 * d}/1e-3
thermo {2 * across}
thermo_style custom step v_stress f_crack f_crack[1]
run {800 * across}
"""


def test_a_notched_plate_depends_less_on_its_particles(run_lammps):
    """without an energy the load falls with the square root of the particle size, by 2^-1/2 = 0.71 (the rest is that a coarse notch is
    blunt); with E Gf/ft^2 half of the width, ten particles, by 0.6 of that at most"""
    peak = {}
    for failure in ("criterion bond", "energy 5e-7"):
        for across in (10, 20):
            table = run_lammps(notched_plate(across, failure)).thermo
            peak[failure, across] = table["v_stress"].max()
            assert table["v_stress"][-1] < 0.1 < peak[failure, across]
    fall = {failure: 1 - peak[failure, 20] / peak[failure, 10] for failure in ("criterion bond", "energy 5e-7")}
    assert 0.2 < fall["criterion bond"] < 0.3
    assert 0 < fall["energy 5e-7"] < 0.6 * fall["criterion bond"]
