# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""The walk-through of docs/developer.md: a new law is one header and one row. Each patch of unittest/walk-through is applied to a
copy of the sources, which is built as a plugin and checked with two particles."""

import conftest
import numpy as np
import pytest
import walk_through

from potdem import formulas, scripts
from potdem.text import replaced

pytestmark = pytest.mark.built_in


# half the time to compile, about 100 s instead of 200: one law is compiled for all registers, which says enough of the others
PLAIN_AND_QUICK = ("-O1", "-DPOTDEM_PLAIN_CODE")


def plugin_of(law, *options):
    """a fixture: the plugin with this patch"""

    @pytest.fixture(scope="module", name=law)
    def plugin(root, build, tmp_path_factory):
        patch = root / "unittest" / "walk-through" / f"{law}.patch"
        return walk_through.build_plugin(root, build, patch, tmp_path_factory.mktemp(law), *options)

    return plugin


bond_law = plugin_of("bond_law", *PLAIN_AND_QUICK)


@pytest.fixture
def lmp():
    """a LAMMPS without our styles: all come from the plugin"""
    return conftest.PLAIN


# --- a bond law: a truss that yields (unittest/walk-through/bond_law.patch) ----------------------------------------------------

E, YIELD, SECTION = 1000.0, 20.0, formulas.section(1.0, 0.5)


class Yielding:
    """the law, as a formula of one bond of length 1"""

    def __init__(self):
        self.plastic = 0.0

    def stretched(self, x):
        """(tension, energy) at length x"""
        strain = 0.5 * (x * x - 1.0)
        elastic = np.clip(strain - self.plastic, -YIELD / E, YIELD / E)
        self.plastic = strain - elastic
        rest = np.sqrt(1.0 + 2.0 * self.plastic)    # without load
        return SECTION * E * elastic, SECTION * E * (x - rest)**2 * (x + 2.0 * rest) / 6.0


PATH = (1.01, 1.05, 1.04, 0.97, 0.99, 1.06, 1.06)
PAIR = [(-0.5, 0.1, 0.1, 1.0), (0.5, 0.1, 0.1, 1.0)]
FORCES = "fix hold all nve/noforce\ntimestep 1e-6\n"
CONTACTS = f"pair_style potdem/truss\npair_coeff * * {E} 0.4\n"
BONDS = f"bond_style potdem/plastic\nbond_coeff * {E} {YIELD} area factor 0.5\n"
STATE = scripts.result("fx[1]", "ebond", "c_f", "c_e")
LOCAL = "compute b all bond/local force engpot\ncompute f all reduce sum c_b[1] inputs local\n"
LOCAL += "compute e all reduce sum c_b[2] inputs local\nthermo_style custom step ebond c_f c_e\nthermo_modify format float %.17g\n"


def start(plugin):
    """each half of the box is a rank, if there are two"""
    return f"plugin load {plugin}\nprocessors * 1 1\n"


def bonded(plugin, bonds=BONDS):
    return start(plugin) + scripts.box(20) + scripts.particles(PAIR) + CONTACTS + bonds + "potdem_bonds all 1 1.1\n" + \
        FORCES + LOCAL


def moved_to(x, run):
    """the second particle that far from the first"""
    return f"set atom 2 x {x - 0.5:.17g}\n{run}\n"


@pytest.mark.parametrize("nprocs", [1, 2])
@pytest.mark.parametrize("run", ["run 0", "neigh_modify every 1 delay 0 check no\nrun 3", "run 1 post no\nrun 1 pre no\nrun 1"])
def test_force_and_energy_remember_the_plastic_strain(bond_law, run_lammps, run, nprocs):
    """through set-up, rebuilds of lists and runs in pieces; the two particles are on two ranks if there are two"""
    script = bonded(bond_law) + "".join(moved_to(x, run) + STATE for x in PATH)
    law = Yielding()
    for x, found in zip(PATH, scripts.results(run_lammps(script, nprocs=nprocs).stdout)):
        tension, energy = law.stretched(x)
        assert found == pytest.approx([tension, energy, -tension, energy], rel=1e-9, abs=1e-12), x


@pytest.mark.parametrize("nprocs", [1, 2])
def test_it_yields_and_rebounds_within_a_run(bond_law, run_lammps, nprocs):
    """out and back, half a period in one run, with new lists on the way: what was learnt at the far end stays"""
    amplitude, steps = 0.05, 1000
    script = bonded(bond_law) + f"""unfix hold
group right id 2
neigh_modify every 7 delay 0 check no
timestep {0.5 / steps}
fix sway right move wiggle {amplitude} 0 0 1.0
run {steps}
""" + STATE
    law = Yielding()
    law.stretched(1.0 + amplitude)
    tension, energy = law.stretched(1.0)
    assert tension == pytest.approx(-SECTION * YIELD)
    (found,) = scripts.results(run_lammps(script, nprocs=nprocs).stdout)
    assert found == pytest.approx([tension, energy, -tension, energy], rel=1e-9)


def test_both_ends_remember(bond_law, run_lammps):
    """stretched on one rank, then across the border of two, each of which computes the bond for its own end"""
    script = bonded(bond_law) + f"set atom 1 x 2.5\nset atom 2 x {2.5 + 1.05}\nrun 0\n"
    script += f"set atom 1 x -0.5\nset atom 2 x {1.04 - 0.5}\nrun 0\n" + scripts.result("fx[1]", "fx[2]")
    law = Yielding()
    law.stretched(1.05)
    tension, _ = law.stretched(1.04)
    for nprocs in (1, 2):
        (found,) = scripts.results(run_lammps(script, nprocs=nprocs).stdout)
        assert found == pytest.approx([tension, -tension], rel=1e-9), nprocs


@pytest.mark.parametrize("when", ["write_restart half.restart\n", "restart 2 half.restart half.restart\nrun 2\n"])
@pytest.mark.parametrize("nprocs", [1, 2])
def test_restart_keeps_the_plastic_strain(bond_law, run_lammps, when, nprocs):
    script = bonded(bond_law) + moved_to(1.05, "run 0") + when + "clear\n" + start(bond_law) + "read_restart half.restart\n"
    script += FORCES + LOCAL + "run 0\n" + STATE + moved_to(1.04, "run 0") + STATE
    law = Yielding()
    law.stretched(1.05)
    for x, found in zip((1.05, 1.04), scripts.results(run_lammps(script, nprocs=nprocs).stdout)):
        tension, energy = law.stretched(x)
        assert found == pytest.approx([tension, energy, -tension, energy], rel=1e-9), x


def test_coefficients_are_checked_adapted_and_written(bond_law, run_lammps):
    run_lammps(bonded(bond_law, replaced(BONDS, f"{E}", "-1.0")), expect_error="E = -1 is out of range")
    run_lammps(bonded(bond_law, replaced(BONDS, f"{YIELD}", "0.0")), expect_error="yield = 0 is out of range")
    run_lammps(bonded(bond_law, BONDS.strip() + " penetration 2\n"), expect_error="damping")
    script = bonded(bond_law) + moved_to(1.05, "run 0") + STATE + "variable softer equal 10.0\n"
    script += "fix soften all adapt 1 bond potdem/plastic yield * v_softer\nrun 0\n" + STATE
    before, after = scripts.results(run_lammps(script).stdout)
    assert before[0] == pytest.approx(SECTION * YIELD, rel=1e-9)
    assert after[0] == pytest.approx(SECTION * 10.0, rel=1e-9)


@pytest.mark.parametrize("nprocs", [1, 2])
def test_it_fails_at_its_strength(bond_law, run_lammps, nprocs):
    """below the stress at which it yields; above it never"""
    for strength, fails in ((0.9 * YIELD, 1), (1.1 * YIELD, 0)):
        script = bonded(bond_law) + f"fix fail all potdem/failure 1 tension {strength}\n" + moved_to(1.1, "run 3")
        script += scripts.result("bonds", "f_fail", "f_fail[1]")
        left, failed, energy = scripts.results(run_lammps(script, nprocs=nprocs).stdout)[0]
        assert (left, failed) == (1 - fails, fails)
        assert energy == pytest.approx(fails * Yielding().stretched(1.1)[1], rel=1e-9)


HYBRID = scripts.box(20, bond_types=2) + scripts.particles(PAIR + [(-0.5, 5.1, 0.1, 1.0), (0.5, 5.1, 0.1, 1.0)]) + CONTACTS + f"""
bond_style hybrid potdem/truss potdem/plastic
bond_coeff 1 potdem/truss {E} area factor 0.5
bond_coeff 2 potdem/plastic {E} {YIELD} area factor 0.5
group below id 1 2
group above id 3 4
potdem_bonds below 1 1.1
potdem_bonds above 2 1.1
""" + FORCES + "thermo_style custom step ebond\nthermo_modify format float %.17g\n"


def both_moved_to(x, run):
    return f"set atom 2 x {x - 0.5:.17g}\nset atom 4 x {x - 0.5:.17g}\n{run}\n"


@pytest.mark.parametrize("nprocs", [1, 2])
@pytest.mark.parametrize("run", ["run 0", "neigh_modify every 1 delay 0 check no\nrun 3"])
def test_beside_a_truss_in_hybrid(bond_law, run_lammps, run, nprocs):
    script = start(bond_law) + HYBRID
    script += "".join(both_moved_to(x, run) + scripts.result("fx[1]", "fx[3]", "ebond") for x in PATH)
    law = Yielding()
    for x, found in zip(PATH, scripts.results(run_lammps(script, nprocs=nprocs).stdout)):
        tension, energy = law.stretched(x)
        truss = formulas.truss_tension(x, SECTION * E)
        assert found == pytest.approx([truss, tension, energy + formulas.truss_energy(x, 1.0, SECTION * E)], rel=1e-9), x


@pytest.mark.parametrize("nprocs", [1, 2])
def test_each_law_of_a_hybrid_fails_by_its_own_fix(bond_law, run_lammps, nprocs):
    """at 1.01 none, at 1.03 the truss, in compression at 0.985 the other"""
    fixes = f"fix one all potdem/failure 1 tension {0.02 * E}\nfix two all potdem/failure 2 compression {0.014 * E}\n"
    script = start(bond_law) + HYBRID + fixes
    for x in (1.01, 1.03, 0.985, 1.01):
        script += both_moved_to(x, "run 3") + scripts.result("bonds", "f_one", "f_two", "fx[1]", "fx[3]")
    found = scripts.results(run_lammps(script, nprocs=nprocs).stdout)
    assert found[:, 0].tolist() == [2, 1, 0, 0]
    assert found[:, 1].tolist() == [0, 1, 1, 1]
    assert found[:, 2].tolist() == [0, 0, 1, 1]
    assert found[0, 3] > 0.0 and found[1, 3] == 0.0
    assert found[1, 4] == pytest.approx(SECTION * YIELD, rel=1e-9)
    assert found[3, 3] == 0.0 and found[3, 4] == 0.0


def test_types_that_change_their_law(bond_law, run_lammps):
    """bond_coeff given again to the other style of hybrid; the lists are new in the step in which a bond goes"""
    script = start(bond_law) + HYBRID + f"bond_coeff 1 potdem/plastic {E} {YIELD} area factor 0.5\n"
    script += f"bond_coeff 2 potdem/truss {E} area factor 0.5\nfix fail all potdem/failure 1 compression {0.014 * E}\n"
    script += "neigh_modify every 1 delay 0 check no\n"
    for x in (1.05, 0.985):
        script += both_moved_to(x, "run 1") + scripts.result("bonds", "fx[1]", "fx[3]")
    found = scripts.results(run_lammps(script).stdout)
    truss = [formulas.truss_tension(x, SECTION * E) for x in (1.05, 0.985)]
    assert found[0] == pytest.approx([2, SECTION * YIELD, truss[0]], rel=1e-9)
    assert found[1] == pytest.approx([1, 0.0, truss[1]], rel=1e-9)


# --- a normal law: a linear spring (unittest/walk-through/contact_law.patch) ---------------------------------------------------

contact_law = plugin_of("contact_law")
K, MASS = 400.0, 2.0
TOUCHING = [(0.1, -0.45, 0.1, 1.0), (0.1, 0.45, 0.1, 1.0, 2)]


def two_particles(plugin, pair, newton="off", types=2):
    """one above the other, 0.9 apart, each half of the box a rank if there are two"""
    script = f"plugin load {plugin}\nprocessors 1 * 1\n" + scripts.box(20, types=types, newton=newton)
    script += scripts.particles(TOUCHING) + f"set group all mass {MASS}\n" + pair
    return script + "thermo_style custom step pe\nthermo_modify format float %.17g\ntimestep 1e-5\n"


@pytest.mark.parametrize("nprocs", [1, 2])
def test_normal_law_pushes_is_mixed_restarted_and_adapted(contact_law, run_lammps, nprocs):
    """in series two springs k and 3 k are 1.5 k"""
    script = two_particles(contact_law, f"pair_style potdem/linear\npair_coeff 1 1 {K}\npair_coeff 2 2 {3 * K}\n")
    script += "fix move all nve\ncompute step all potdem/timestep\nthermo_style custom step pe c_step\nrun 0\n"
    script += scripts.result("fy[1]", "pe", "c_step") + "write_restart half.restart\nclear\n"
    script += f"plugin load {contact_law}\nprocessors 1 * 1\nread_restart half.restart\nfix move all nve\n"
    script += "compute step all potdem/timestep\nthermo_style custom step pe c_step\nrun 0\n" + scripts.result("fy[1]", "pe", "c_step")
    script += f"variable k equal {3 * K}\nfix stiffer all adapt 1 pair potdem/linear k 1 1 v_k\nrun 0\n"
    script += scripts.result("fy[1]", "pe", "c_step")
    mixed = np.array([1.5, 1.5, 3.0]) * K
    expected = np.column_stack([-mixed * 0.1, 0.5 * mixed * 0.01, 2.0 / np.sqrt(2.0 * mixed / MASS)])
    assert scripts.results(run_lammps(script, nprocs=nprocs).stdout) == pytest.approx(expected, rel=1e-12)


def test_normal_law_is_a_wall_and_checks_its_coefficient(contact_law, run_lammps):
    pair = f"pair_style potdem/linear\npair_coeff * * {K}\n"
    script = two_particles(contact_law, pair) + "region floor plane 0 -0.9 0 0 1 0\n"
    wall = f"fix floor all potdem/wall/region floor law linear {K}\nrun 0\n"
    (found,) = scripts.results(run_lammps(script + wall + scripts.result("fy[1]", "f_floor")).stdout)
    assert found == pytest.approx([-K * 0.1 + K * 0.05, 0.5 * K * 0.05**2], rel=1e-11)
    run_lammps(replaced(script + wall, f"linear {K}", "linear 0"), expect_error="k = 0 is out of range, it must be > 0")


# --- a tangential law with state: a spring that slips (unittest/walk-through/tangential_law.patch) -----------------------------

tangential_law = plugin_of("tangential_law", *PLAIN_AND_QUICK)
MU, SPRING, SPEED, DT = 0.5, 200.0, 1e-3, 1e-5
ROUGH = f"pair_style potdem/truss\npair_coeff * * {K} 0.5 friction {MU} elastic {SPRING}\n"


NORMAL = K * SECTION * 0.5 * (1.0 - 0.9**2)


def pulled(piece, there, back):
    """force along x on what is pulled there and then back by pieces: of a spring that slips at the limit, and of the normal
    force, which tilts"""
    out, spring, place, limit = [], 0.0, 0.0, MU * NORMAL / SPRING
    for count, sign in ((there, 1.0), (back, -1.0)):
        for _ in range(count):
            place += sign * piece
            spring = np.clip(spring + sign * piece, -limit, limit)
            out.append(-SPRING * spring + NORMAL * place / 0.9)
    return out


def pull(pieces, steps, sign):
    move = f"fix pull upper move linear {sign * SPEED} 0 0\n"
    return move + f"run {steps}\n{scripts.result('fx[2]', 'fx[1]')}" * pieces + "unfix pull\n"


@pytest.mark.parametrize("nprocs", [1, 2])
@pytest.mark.parametrize("newton", ["off", "on"])
@pytest.mark.parametrize("lists", ["", "neigh_modify every 1 delay 0 check no\n"])
def test_friction_remembers_slips_and_turns_back(tangential_law, run_lammps, lists, newton, nprocs):
    steps, there, back = 100, 8, 6
    piece = 1.3 * MU * NORMAL / SPRING / there    # so that it slips in the last pieces
    script = two_particles(tangential_law, ROUGH, newton) + lists + "group upper id 2\nfix hold all nve/noforce\n"
    script += f"timestep {piece / SPEED / steps:.17g}\n" + pull(there, steps, 1.0) + pull(back, steps, -1.0)
    found = scripts.results(run_lammps(script, nprocs=nprocs).stdout)
    # the arm is longer, the force less by the square of the tilt
    tilt = 1.3 * MU * NORMAL / SPRING / 0.9
    assert found[:, 0] == pytest.approx(np.array(pulled(piece, there, back)), abs=3.0 * NORMAL * tilt**2)
    assert tilt < 0.06
    assert found[:, 1] == pytest.approx(-found[:, 0], rel=1e-12)


@pytest.mark.parametrize("nprocs", [1, 2])
@pytest.mark.parametrize("newton", ["off", "on"])
def test_friction_is_in_a_restart_file(tangential_law, run_lammps, newton, nprocs):
    """without a step, and the next steps go on from there"""
    script = two_particles(tangential_law, ROUGH, newton) + "group upper id 2\nfix hold all nve/noforce\n"
    script += pull(1, 500, 1.0) + "write_restart half.restart\n" + pull(1, 500, 1.0) + "clear\n"
    script += f"plugin load {tangential_law}\nprocessors 1 * 1\nread_restart half.restart\n"
    script += "fix hold all nve/noforce\nthermo_modify format float %.17g\nrun 0\n" + scripts.result("fx[2]", "fx[1]")
    script += pull(1, 500, 1.0)
    first, second, read, again = scripts.results(run_lammps(script, nprocs=nprocs).stdout)
    assert first == pytest.approx(np.array([1.0, -1.0]) * pulled(SPEED * 500 * DT, 1, 0), rel=1e-9)
    assert read == pytest.approx(first, rel=1e-12)
    assert again == pytest.approx(second, rel=1e-9)


@pytest.mark.parametrize("nprocs", [1, 2])
def test_friction_at_a_wall_remembers_too(tangential_law, run_lammps, nprocs):
    """also in a restart file; and what leaves the wall forgets"""
    script = two_particles(tangential_law, f"pair_style potdem/truss\npair_coeff * * {K} 0.5\n")
    wall = f"fix floor all potdem/wall/region floor law truss {K} 0.5 friction {MU} elastic {SPRING}\n"
    script += "region floor plane 0 -0.9 0 0 1 0\n" + wall + "fix pull all move linear 1e-3 0 0\n"
    script += "run 300\n" + scripts.result("fx[1]") + "write_restart half.restart\nrun 200\n" + scripts.result("fx[1]")
    script += "unfix pull\ndisplace_atoms all move 0 1 0\nrun 0\ndisplace_atoms all move 0 -1 0\n"
    script += "fix pull all move linear 1e-3 0 0\nrun 10\n" + scripts.result("fx[1]") + "clear\n"
    script += f"plugin load {tangential_law}\nprocessors 1 * 1\nread_restart half.restart\nregion floor plane 0 -0.9 0 0 1 0\n"
    script += wall + "fix pull all move linear 1e-3 0 0\nthermo_modify format float %.17g\nrun 0\n" + scripts.result("fx[1]")
    found = scripts.results(run_lammps(script, nprocs=nprocs).stdout)[:, 0]
    assert found == pytest.approx(-SPRING * SPEED * DT * np.array([300, 500, 10, 300]), rel=1e-9)


def test_friction_is_known_by_its_keyword_and_range(tangential_law, run_lammps):
    run_lammps(two_particles(tangential_law, replaced(ROUGH, f"elastic {SPRING}", "elastic -1")),
               expect_error="k = -1 is out of range, it must be > 0")
    other = ROUGH + f"pair_coeff 2 2 {K} 0.5 friction {MU} auto\n"
    run_lammps(two_particles(tangential_law, other) + "run 0\n", expect_error="different laws of friction")


# --- a rate law: a linear dashpot (unittest/walk-through/rate_law.patch) --------------------------------------------------------

rate_law = plugin_of("rate_law", *PLAIN_AND_QUICK)
DASHPOT, APPROACH = 30.0, 0.2
SHOW_RATE = "compute p all pair/local p3\ncompute viscous all reduce sum c_p inputs local\ncompute step all potdem/timestep\n" \
            "thermo_style custom step c_viscous c_step\nthermo_modify format float %.17g\nrun 0\n" + \
            scripts.result("fy[1]", "c_viscous", "c_step")


@pytest.mark.parametrize("nprocs", [1, 2])
def test_rate_law_pushes_is_mixed_restarted_and_adapted(rate_law, run_lammps, nprocs):
    """beside the truss law, c 1 and 3 times DASHPOT: the mean is 2. The critical step is that of two equal masses on a spring and a
    dashpot"""
    pair = "pair_style potdem/truss\n" + "".join(f"pair_coeff {k} {k} {K} 0.5 dashpot {c * DASHPOT}\n" for k, c in ((1, 1), (2, 3)))
    script = two_particles(rate_law, pair) + f"comm_modify vel yes\nset atom 1 vy {APPROACH}\nfix move all nve\n" + SHOW_RATE
    script += f"write_restart half.restart\nclear\nplugin load {rate_law}\nprocessors 1 * 1\nread_restart half.restart\n"
    script += "comm_modify vel yes\nfix move all nve\n" + SHOW_RATE
    script += f"variable c equal {3 * DASHPOT}\nfix thicker all adapt 1 pair potdem/truss dashpot 1 1 v_c\nrun 0\n"
    script += scripts.result("fy[1]", "c_viscous", "c_step")
    c = np.array([2.0, 2.0, 3.0]) * DASHPOT
    stiffness = K * SECTION * 0.9
    frequency = np.sqrt(2.0 * stiffness / MASS)
    damped = c / MASS / frequency
    expected = np.column_stack([-NORMAL - c * APPROACH, c * APPROACH, 2.0 / frequency * (np.sqrt(1.0 + damped**2) - damped)])
    assert scripts.results(run_lammps(script, nprocs=nprocs).stdout) == pytest.approx(expected, rel=1e-11)


def test_rate_law_is_a_walls_too_and_checks_its_coefficient(rate_law, run_lammps):
    """and it is for the laws it serves"""
    script = two_particles(rate_law, "pair_style zero 1.2\npair_coeff * *\n") + f"region floor plane 0 -0.9 0 0 1 0\nset atom 1 vy {-APPROACH}\n"
    wall = f"fix floor all potdem/wall/region floor law truss {K} 0.5 dashpot {DASHPOT}\n"
    (found,) = scripts.results(run_lammps(script + wall + "run 0\n" + scripts.result("fy[1]")).stdout)
    push = K * 0.5 * np.pi / 4 * 0.5**2 * 0.5 * (1.0 - 0.9**2)
    assert found == pytest.approx([push + DASHPOT * APPROACH], rel=1e-11)
    run_lammps(script + replaced(wall, f"dashpot {DASHPOT}", "dashpot -1"), expect_error="dashpot c = -1 is out of range")
    run_lammps(script + replaced(wall, f"truss {K} 0.5", "granular 100 4 0.3"), expect_error="unknown keyword 'dashpot'")
