# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Every error names what is wrong and what to do. One case is one wrong line in a script that works."""

import pytest

from potdem import scripts
from potdem.text import replaced

BOX = scripts.box(20, types=2, bond_types=2)
ATOMS = scripts.particles([(0, 0, 0, 1.0, 1), (1.0, 0, 0, 1.0, 2)])
BODY = BOX + ATOMS + scripts.elastic() + "potdem_bonds all 1 1.2\n"
WALL = BOX + ATOMS + "pair_style none\nbond_style none\nregion floor plane 0 0 -5 0 0 1\n"
PAIR = BOX + ATOMS + "bond_style none\npair_style potdem/truss\n"
BOND = BOX + ATOMS + "pair_style zero 2.0\npair_coeff * *\nbond_style potdem/truss\n"


def wall(options):
    return WALL + f"fix w all potdem/wall/region {options}"


def pair(options):
    return PAIR + f"pair_coeff {options}"


def bond(options):
    return BOND + f"bond_coeff {options}"


def failure(options):
    return BODY + f"fix f all potdem/failure {options}"


def pace(options):
    return BODY + f"fix p all potdem/timestep {options}"


# name: script up to and including the wrong line, words that the message must contain
CASES = {
    # pair style
    "pair style keyword": (BOX + "pair_style potdem/truss rotate", ["pair_style potdem/truss", "'rotate'"]),
    "pair E negative": (pair("* * -5 0.5"), ["pair_coeff potdem/truss", "E = -5", "> 0"]),
    "pair E not a number": (pair("* * stiff 0.5"), ["E must be a number", "'stiff'"]),
    "pair E nan": (pair("* * nan 0.5"), ["E", "nan"]),
    "pair E infinite": (pair("* * inf 0.5"), ["E", "inf"]),
    "pair E overflows": (pair("* * 1e999 0.5"), ["1e999", "out of range"]),
    "pair a zero": (pair("* * 5 0"), ["a = 0", "> 0"]),
    "pair a missing": (pair("* * 5"), ["pair_coeff potdem/truss", "missing"]),
    "pair keyword": (pair("* * 5 0.5 fricton 0.3 1"), ["'fricton'", "penetration, restitution, friction, rolling or twisting"]),
    "pair exponent zero": (pair("* * 5 0.5 penetration 0"), ["penetration m = 0", "1 to 64"]),
    "pair exponent fractional": (pair("* * 5 0.5 penetration 2.5"), ["penetration m = 2.5", "whole number"]),
    "pair exponent missing": (pair("* * 5 0.5 penetration"), ["pair_coeff potdem/truss", "missing"]),
    "pair friction negative": (pair("* * 5 0.5 friction -0.1 auto"), ["friction mu = -0.1", ">= 0"]),
    "pair viscosity negative": (pair("* * 5 0.5 friction 0.1 -3"), ["friction eta = -3", ">= 0"]),
    "pair viscosity a word": (pair("* * 5 0.5 friction 0.1 much"), ["friction eta", "'much'"]),
    "pair friction missing": (pair("* * 5 0.5 friction 0.1"), ["pair_coeff potdem/truss", "missing"]),
    "pair types reversed": (pair("2* *1 5 0.5"), ["pair_coeff potdem/truss", "I <= J"]),
    "pair type out of range": (pair("3 3 5 0.5"), ["3"]),
    "pair coefficients unset": (pair("1 1 5 0.5\nrun 0"), ["pair coeffs are not set"]),
    "pair mixing": (pair("1 1 5 0.5 penetration 2\npair_coeff 2 2 5 0.5\nrun 0"),
                    ["types 1 and 2", "penetration", "pair_coeff 1 2"]),
    # bond style
    "bond style keyword": (BOX + "bond_style potdem/truss lattice", ["bond_style potdem/truss", "'lattice'"]),
    "bond E zero": (bond("* 0 area factor 0.5"), ["bond_coeff potdem/truss", "E = 0", "> 0"]),
    "bond E not a number": (bond("* area factor 0.5"), ["E must be a number", "'area'"]),
    "bond area missing": (bond("* 5 factor 0.5"), ["'factor'", "expected area"]),
    "bond area nothing": (bond("* 5"), ["bond_coeff potdem/truss", "missing"]),
    "bond area mode": (bond("* 5 area all"), ["'all'", "area factor, area lattice or area body"]),
    "bond area density": (bond("* 5 area body density 0"), ["density of area body = 0", "> 0"]),
    "bond factor negative": (bond("* 5 area factor -1"), ["area factor a = -1", "> 0"]),
    "bond factor missing": (bond("* 5 area factor"), ["bond_coeff potdem/truss", "missing"]),
    "bond keyword": (bond("* 5 area lattice dampng 0.1"), ["'dampng'", "penetration or damping"]),
    "bond damping negative": (bond("* 5 area lattice damping -0.1"), ["damping xi = -0.1", ">= 0"]),
    "bond exponent too large": (bond("* 5 area lattice penetration 65"), ["penetration m = 65", "1 to 64"]),
    "bond type out of range": (bond("7 5 area lattice"), ["7"]),
    "bond coefficients unset": (bond("1 5 area factor 0.5\nrun 0"), ["bond coeffs are not set"]),
    "bond area lattice without a lattice": (bond("* 5 area lattice\npotdem_bonds all 1 1.2\nrun 0"),
                                            ["area lattice for bond type 1", "cubic", "use area body or area factor"]),
    "bonds made with newton on": (
        replaced(BOND, "bond/types 2", "bond/types 2 extra/bond/per/atom 1 extra/special/per/atom 9") + "bond_coeff * 5 area factor 0.5\n"
        "special_bonds lj 0 1 1 coul 0 1 1\ncreate_bonds single/bond 1 1 2\nrun 0",
        ["newton off for bonds", "potdem_bonds", "newton on off"]),
    # potdem_bonds
    "bonds without a box": ("units si\natom_style bpm/sphere\npotdem_bonds all 1 1.2", ["potdem_bonds", "create_box"]),
    "bonds group": (BOX + ATOMS + "potdem_bonds body 1 1.2", ["potdem_bonds", "group 'body'"]),
    "bonds group empty": (BOX + ATOMS + "group none empty\npotdem_bonds none 1 1.2", ["group 'none' is empty"]),
    "bonds type": (BOX + ATOMS + "potdem_bonds all 3 1.2", ["bond type = 3", "1 to 2"]),
    "bonds type fractional": (BOX + ATOMS + "potdem_bonds all 1.5 1.2", ["bond type = 1.5", "whole number"]),
    "bonds no types": (scripts.box(20, bond_types=0) + scripts.particles([(0, 0, 0, 1.0)]) + "potdem_bonds all 1 1.2",
                       ["no bond types", "bond/types"]),
    "bonds reach": (BOX + ATOMS + "potdem_bonds all 1 -1.2", ["r_infl = -1.2", "> 0"]),
    "bonds reach missing": (BOX + ATOMS + "potdem_bonds all 1", ["potdem_bonds", "missing"]),
    "bonds reach too short": (BOX + ATOMS + "potdem_bonds all 1 0.9",
                              ["group 'all'", "r_infl = 0.9", "the shortest distance between two of them is 1"]),
    "bonds reach much too short": (BOX + ATOMS + "potdem_bonds all 1 0.01 diameters",
                                   ["r_infl = 0.01 diameters", "no two of them near each other"]),
    "bonds reach too short in a group": (
        BOX + ATOMS + "create_atoms 1 single 1.5 0 0 units box\nset atom 3 diameter 1\ngroup ends id 1 3\n"
        "potdem_bonds ends 1 1.2", ["group 'ends'", "is 1.5"]),
    "bonds all made already": (BODY + "potdem_bonds all 1 1.2", ["that are not bonded already", "near each other"]),
    "bonds all cut by a crack": (
        BOX + ATOMS + "region slit block 0.4 0.6 INF INF INF INF units box\npotdem_bonds all 1 1.2 crack slit",
        ["the crack, region slit", "cuts every pair of group 'all'", "thinner"]),
    "bonds reach too short for a crack": (
        BOX + ATOMS + "region slit block 0.4 0.6 INF INF INF INF units box\npotdem_bonds all 1 0.9 crack slit",
        ["the shortest distance between two of them is 1"]),
    "bonds keyword": (BOX + ATOMS + "potdem_bonds all 1 1.2 diameter", ["'diameter'", "diameters or crack"]),
    "bonds crack region": (BOX + ATOMS + "potdem_bonds all 1 1.2 crack slit", ["no region 'slit'"]),
    "bonds in a small periodic box": (
        scripts.box(3, "p p p") + scripts.particles([(0, 0, 0, 1.0), (1, 0, 0, 1.0)]) + "potdem_bonds all 1 1.6",
        ["r_infl 1.6", "half the periodic box length 3", "larger"]),
    "bonds at one place": (
        BOX + scripts.particles([(0, 0, 0, 1.0), (0, 0, 0, 1.0)]) + "potdem_bonds all 1 1.2",
        ["atoms", "1", "2", "same place"]),
    "bonds in atom style sphere": (
        "units si\natom_style sphere\nboundary f f f\nregion box block 0 5 0 5 0 5\ncreate_box 1 box\n"
        "create_atoms 1 single 1 1 1\npotdem_bonds all 1 1.2", ["atom style with bonds", "bpm/sphere"]),
    "bonds in atom style bond": (
        scripts.box(5, atom_style="bond") + "create_atoms 1 single 1 1 1\nmass 1 1.0\npotdem_bonds all 1 1.2",
        ["particle diameters", "bpm/sphere"]),
    "bonds of points": (BOX + ATOMS + "set atom 2 diameter 0\npotdem_bonds all 1 1.2",
                        ["atom 2", "diameter 0", "> 0", "set"]),
    # atoms that the styles cannot do without
    "contact of points": (PAIR + "pair_coeff * * 5 0.5\nset atom 2 diameter 0\nrun 0", ["atom 2", "diameter 0", "> 0"]),
    "negative diameter": (BOX + ATOMS + "set atom 2 diameter -1", ["diameter"]),
    "contact without diameters": (
        scripts.box(5, atom_style="bond") + "create_atoms 1 single 1 1 1\nmass 1 1.0\npair_style potdem/truss\n"
        "pair_coeff * * 5 0.5\nrun 0", ["pair_style potdem/truss", "particle diameters", "bpm/sphere"]),
    "wall without diameters": (
        scripts.box(5, atom_style="bond") + "create_atoms 1 single 1 1 1\nmass 1 1.0\n"
        "pair_style none\nbond_style none\n"
        "region floor plane 0 0 -2 0 0 1\nfix w all potdem/wall/region floor 5 0.3 particle 5 0.3\nrun 0",
        ["potdem/wall/region w", "particle diameters"]),
    # failure
    "failure without strength": (failure("1"), ["fix potdem/failure", "tension ft", "compression fc"]),
    "failure strength zero": (failure("1 tension 0"), ["tension strength = 0", "> 0"]),
    "failure strength missing": (failure("1 tension"), ["fix potdem/failure", "missing"]),
    "failure strength a word": (failure("1 tension high"), ["tension strength", "'high'"]),
    "failure keyword": (failure("1 tensile 5"), ["'tensile'", "tension, compression or scatter"]),
    "failure scatter": (failure("1 tension 5 scatter gauss 1 2"), ["'gauss'", "weibull or normal"]),
    "failure scatter modulus": (failure("1 tension 5 scatter weibull 0 2"), ["scatter weibull k = 0", "> 0"]),
    "failure scatter spread": (failure("1 tension 5 scatter normal 0.5 2"), ["cov = 0.5", "scatter weibull"]),
    "failure scatter seed": (failure("1 tension 5 scatter weibull 3 0"), ["scatter seed = 0", "whole number"]),
    "failure bond type": (failure("3 tension 5"), ["bond type = 3", "1 to 2"]),
    "failure nothing": (failure(""), ["fix potdem/failure", "missing"]),
    "failure twice": (failure("1 tension 5\nfix g all potdem/failure 1 compression 5\nrun 0"),
                      ["f", "g", "bond type 1", "one fix"]),
    "failure of other bonds": (
        BOX + ATOMS + "pair_style none\nbond_style zero\nbond_coeff *\nfix f all potdem/failure 1 tension 5\nrun 0",
        ["potdem/failure f", "bond_style potdem/truss"]),
    "failure special bonds": (failure("1 tension 5\nspecial_bonds lj 1 1 1\nrun 0"),
                              ["bond_style potdem/truss", "special_bonds lj 0 1 1"]),
    # wall
    "wall region": (wall("ceiling 5 0.3 particle 5 0.3"), ["fix potdem/wall/region", "no region 'ceiling'"]),
    "wall region gone": (wall("floor 5 0.3 particle 5 0.3\nregion floor delete\nrun 0"), ["floor", "does not exist"]),
    "wall E": (wall("floor -5 0.3 particle 5 0.3"), ["E of the wall = -5", "> 0"]),
    "wall nu": (wall("floor 5 0.7 particle 5 0.3"), ["nu of the wall = 0.7", "<= 0.5"]),
    "wall particle": (wall("floor 5 0.3"), ["particle E nu"]),
    "wall particle E": (wall("floor 5 0.3 particle 0 0.3"), ["E of the particle = 0", "> 0"]),
    "wall particle nu": (wall("floor 5 0.3 particle 5 -1"), ["nu of the particle = -1", "> -1"]),
    "wall particle missing": (wall("floor 5 0.3 particle 5"), ["fix potdem/wall/region", "missing"]),
    "wall keyword": (wall("floor 5 0.3 particle 5 0.3 rough"), ["'rough'", "layer, viscous, restitution, friction, rolling, twisting or rotation"]),
    "wall layer": (wall("floor 5 0.3 particle 5 0.3 layer 0 2"), ["layer gamma_over_r = 0", "> 0"]),
    "wall layer exponent": (wall("floor 5 0.3 particle 5 0.3 layer 0.1 0.5"), ["layer m = 0.5", ">= 1"]),
    "wall layer missing": (wall("floor 5 0.3 particle 5 0.3 layer 0.1"), ["fix potdem/wall/region", "missing"]),
    "wall viscous": (wall("floor 5 0.3 particle 5 0.3 viscous -1"), ["viscous H = -1", ">= 0"]),
    "wall friction": (wall("floor 5 0.3 particle 5 0.3 friction 0.3"), ["fix potdem/wall/region", "missing"]),
    "wall passed": (wall("floor 5 0.3 particle 5 0.3\nset atom 2 z -6\nrun 0"),
                    ["potdem/wall/region w", "atom 2", "-6", "step 0", "smaller timestep"]),
    # damping
    "damping negative": (WALL + "fix d all potdem/damping -0.1", ["fix potdem/damping", "lambda = -0.1", ">= 0"]),
    "damping one": (WALL + "fix d all potdem/damping 1", ["lambda = 1", "< 1"]),
    "damping form": (WALL + "fix d all potdem/damping 0.1 form diagonal", ["'diagonal'", "vector or component"]),
    "damping keyword": (WALL + "fix d all potdem/damping 0.1 component", ["'component'", "expected form or weight"]),
    "damping weight": (WALL + "fix d all potdem/damping 0.1 weight none", ["weight must be yes or no", "'none'"]),
    "damping missing": (WALL + "fix d all potdem/damping", ["fix potdem/damping", "missing"]),
    # strain
    "strain before bonds": (WALL + "compute s all potdem/strain/atom", ["potdem/strain/atom s", "after potdem_bonds"]),
    "strain keyword": (BODY + "compute s all potdem/strain/atom green", ["potdem/strain/atom", "'green'"]),
    # pieces
    "piece before bonds": (WALL + "compute p all potdem/piece/atom",
                           ["potdem/piece/atom p", "no memory of bonds", "after bond_style potdem/truss or potdem_bonds"]),
    "piece keyword": (BODY + "compute p all potdem/piece/atom 0.1", ["potdem/piece/atom", "'0.1'", "none"]),
    "piece without memory": (BODY + "compute p all potdem/piece/atom\nunfix POTDEM_BONDS\nrun 0", ["POTDEM_BONDS", "unfix"]),
    # critical step
    "timestep keyword": (BODY + "compute t all potdem/timestep before 1", ["compute potdem/timestep", "'before'", "ahead"]),
    "timestep ahead": (BODY + "compute t all potdem/timestep ahead -1", ["ahead = -1", ">= 0"]),
    "timestep ahead missing": (BODY + "compute t all potdem/timestep ahead", ["compute potdem/timestep", "missing"]),
    "timestep without masses": (
        scripts.box(5, atom_style="bond") + "create_atoms 1 single 1 1 1\nmass 1 1.0\npair_style zero 1\npair_coeff * *\n"
        "bond_style none\ncompute t all potdem/timestep\nrun 0", ["potdem/timestep t", "mass per particle", "sphere"]),
    "pace N": (pace("0 0.5 max 1"), ["fix potdem/timestep", "N = 0", "whole number"]),
    "pace fraction": (pace("1 0 max 1"), ["fraction = 0", "> 0"]),
    "pace beyond critical": (pace("1 1.5 max 1"), ["fraction = 1.5", "<= 1"]),
    "pace without max": (pace("1 0.5"), ["fix potdem/timestep", "missing"]),
    "pace keyword": (pace("1 0.5 min 1"), ["'min'", "expected max"]),
    "pace max": (pace("1 0.5 max 0"), ["max dt = 0", "> 0"]),
    "pace more": (pace("1 0.5 max 1 2"), ["'2'", "after max dt"]),
    "pace twice": (pace("1 0.5 max 1\nfix q all potdem/timestep 1 0.5 max 1\nrun 0"), ["p", "q", "keep one"]),
    "pace and dt/reset": (pace("1 0.5 max 1\nfix q all dt/reset 1 NULL NULL 0.1\nrun 0"), ["p", "q", "keep one"]),
    "pace with respa": (pace("1 0.5 max 1\nrun_style respa 2 2\nrun 0"), ["verlet", "respa"]),
    "pace without its compute": (pace("1 0.5 max 1\nuncompute p_CRITICAL\nrun 0"), ["potdem/timestep p", "p_CRITICAL"]),
    "pace and fix move": (pace("1 0.5 max 1\nfix m all move linear 1 0 0\nrun 2"), ["fix move"]),
    # bonds longer than LAMMPS communicates
    "communication cutoff": (BODY + "comm_modify cutoff 0.8\nrun 0",
                             ["longest bond (1", "communication cutoff 0.8", "comm_modify cutoff"]),
    # run styles that these styles do not know
    "respa with bonds": (BODY + "run_style respa 2 2\nrun 0", ["potdem/truss", "verlet", "respa"]),
}


@pytest.mark.parametrize("name", CASES)
def test_message(run_lammps, name):
    script, words = CASES[name]
    message = run_lammps(script + "\n", expect_error="").error
    missing = [word for word in words if word not in message]
    assert not missing, message


def test_a_bond_stretched_beyond_the_ghosts(run_lammps):
    """on two ranks, a body torn apart without fix potdem/failure: IDs, lengths and the two remedies"""
    script = scripts.box((40, 8, 8)) + scripts.particles([(-0.5, 0, 0, 1.0), (0.5, 0, 0, 1.0)]) + scripts.elastic(1.0)
    script += "potdem_bonds all 1 1.2\nvelocity all set 0 0 0\ngroup two id 2\nvelocity two set 10 0 0\nfix 1 all nve\n"
    script += "timestep 0.001\nrun 5000\n"
    message = run_lammps(script, nprocs=2, expect_error="").error
    for word in ("atoms 1 and 2", "reference 1", "communication cutoff", "comm_modify cutoff", "fix potdem/failure"):
        assert word in message or word.replace("1 and 2", "2 and 1") in message, message


@pytest.mark.parametrize("styles", ["bond", "contact"])
def test_two_centres_at_one_place(run_lammps, styles):
    """no direction, no force: an error with the IDs, not a NaN that spreads"""
    body = "potdem_bonds all 1 1.2\n" if styles == "bond" else "bond_style none\n"
    script = BOX + ATOMS + scripts.elastic() + body + "set atom 2 x 0\nrun 0\n" + scripts.result("fx[1]")
    message = run_lammps(script, expect_error="").error
    assert "1" in message and "2" in message and "timestep" in message


@pytest.mark.parametrize("nprocs", [2])
def test_an_error_of_one_rank_ends_the_run(run_lammps, nprocs):
    """a wall passed on one rank only: the run ends and says so"""
    script = wall("floor 5 0.3 particle 5 0.3\nset atom 2 x 8 z -6\nrun 10\n")
    assert "atom 2" in run_lammps(script, nprocs=nprocs, expect_error="", timeout=60).error
