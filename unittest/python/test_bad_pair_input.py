# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Errors of the pair styles potdem/lj, potdem/granular and potdem/hertz, as in test_bad_input.py."""

import pytest

from potdem import scripts
from potdem.text import replaced

BOX = scripts.box(20, types=2) + "bond_style none\n"
ATOMS = scripts.particles([(0, 0, 0, 1.0, 1), (1.0, 0, 0, 1.0, 2)])
GOOD = {"lj": "100 0.2 3 0.2", "granular": "100 3 0.2", "hertz": "100 0.3"}


def style(name, settings=""):
    return BOX + ATOMS + f"pair_style potdem/{name} {settings}\n"


def coeff(name, values, types="* *"):
    return style(name) + f"pair_coeff {types} {values}"


def two_materials(name, first, second):
    return style(name) + f"pair_coeff 1 1 {first}\npair_coeff 2 2 {second}\nrun 0"


CASES = {
    # settings
    "lj setting": (style("lj", "shift yes"), ["pair_style potdem/lj", "'shift'", "rotation"]),
    "granular setting": (style("granular", "attract yes"), ["pair_style potdem/granular", "'attract'", "rotation"]),
    "hertz setting": (style("hertz", "rotate yes"), ["pair_style potdem/hertz", "'rotate'", "rotation", "attract"]),
    "truss setting": (style("truss", "attract yes"), ["pair_style potdem/truss", "'attract'", "rotation"]),
    "hertz attract maybe": (style("hertz", "attract maybe"), ["attract must be yes or no", "'maybe'"]),
    "lj rotation on": (style("lj", "rotation on"), ["rotation must be yes or no", "'on'"]),
    "truss rotation missing": (style("truss", "rotation"), ["pair_style potdem/truss", "missing"]),
    # potdem/lj
    "lj K0 zero": (coeff("lj", "0 0.2 3 0.2"), ["pair_coeff potdem/lj", "K0 = 0", "> 0"]),
    "lj K0 negative": (coeff("lj", "-5 0.2 3 0.2"), ["K0 = -5", "> 0"]),
    "lj K0 nan": (coeff("lj", "nan 0.2 3 0.2"), ["K0", "nan"]),
    "lj K0 a word": (coeff("lj", "stiff 0.2 3 0.2"), ["K0 must be a number", "'stiff'"]),
    "lj R zero": (coeff("lj", "100 0 3 0.2"), ["R = 0", "> 0"]),
    "lj R infinite": (coeff("lj", "100 inf 3 0.2"), ["R", "inf"]),
    "lj n zero": (coeff("lj", "100 0.2 0 0.2"), ["n = 0", "> 0"]),
    "lj n negative": (coeff("lj", "100 0.2 -3 0.2"), ["n = -3", "> 0"]),
    "lj alpha one": (coeff("lj", "100 0.2 3 1"), ["alpha = 1", ">= 0 and < 1"]),
    "lj alpha negative": (coeff("lj", "100 0.2 3 -0.1"), ["alpha = -0.1", ">= 0 and < 1"]),
    "lj alpha missing": (coeff("lj", "100 0.2 3"), ["pair_coeff potdem/lj", "missing"]),
    "lj cut zero": (coeff("lj", "100 0.2 3 0.2 cut 0"), ["cut s_c = 0", "> 0"]),
    "lj cut missing": (coeff("lj", "100 0.2 3 0.2 cut"), ["pair_coeff potdem/lj", "missing"]),
    "lj linear zero": (coeff("lj", "100 0.2 3 0.2 linear 0"), ["linear s_min = 0", "> 0 and < 0.2"]),
    "lj linear beyond R": (coeff("lj", "100 0.2 3 0.2 linear 0.2"), ["linear s_min = 0.2", "> 0 and < 0.2"]),
    "lj linear missing": (coeff("lj", "100 0.2 3 0.2 linear"), ["pair_coeff potdem/lj", "missing"]),
    "lj keyword": (coeff("lj", "100 0.2 3 0.2 viscous 1"), ["'viscous'", "cut, linear, friction, rolling or twisting"]),
    "lj friction negative": (coeff("lj", "100 0.2 3 0.2 friction -1 auto"), ["friction mu = -1", ">= 0"]),
    "lj different n": (two_materials("lj", "100 0.2 3 0.2", "100 0.2 4 0.2"),
                       ["pair_style potdem/lj", "types 1 and 2", "different n", "pair_coeff 1 2"]),
    # potdem/granular
    "granular K0 negative": (coeff("granular", "-5 3 0.2"), ["pair_coeff potdem/granular", "K0 = -5", "> 0"]),
    "granular n two": (coeff("granular", "100 2 0.2"), ["n = 2", "> 2"]),
    "granular n one": (coeff("granular", "100 1 0.2"), ["n = 1", "> 2"]),
    "granular alpha zero": (coeff("granular", "100 3 0"), ["alpha = 0", "> 0 and < 1"]),
    "granular alpha one": (coeff("granular", "100 3 1"), ["alpha = 1", "< 1"]),
    "granular alpha missing": (coeff("granular", "100 3"), ["pair_coeff potdem/granular", "missing"]),
    "granular cut one": (coeff("granular", "100 3 0.2 cut 1"), ["cut x = 1", "> 1"]),
    "granular cut a word": (coeff("granular", "100 3 0.2 cut far"), ["cut x", "'far'"]),
    "granular linear one": (coeff("granular", "100 3 0.2 linear 1"), ["linear x_min = 1", "> 0 and < 1"]),
    "granular linear a word": (coeff("granular", "100 3 0.2 linear soft"), ["linear x_min", "'soft'"]),
    "granular keyword": (coeff("granular", "100 3 0.2 penetration 2"), ["'penetration'", "cut, linear, friction, rolling or twisting"]),
    "granular different n": (two_materials("granular", "100 3 0.2", "100 3.5 0.2"),
                             ["pair_style potdem/granular", "types 1 and 2", "different n", "pair_coeff 1 2"]),
    # potdem/hertz
    "hertz E zero": (coeff("hertz", "0 0.3"), ["pair_coeff potdem/hertz", "E = 0", "> 0"]),
    "hertz E overflows": (coeff("hertz", "1e999 0.3"), ["1e999", "out of range"]),
    "hertz nu too large": (coeff("hertz", "100 0.51"), ["nu = 0.51", "> -1 and <= 0.5"]),
    "hertz nu minus one": (coeff("hertz", "100 -1"), ["nu = -1", "> -1 and <= 0.5"]),
    "hertz nu missing": (coeff("hertz", "100"), ["pair_coeff potdem/hertz", "missing"]),
    "hertz viscous negative": (coeff("hertz", "100 0.3 viscous -1"), ["viscous H = -1", ">= 0"]),
    "hertz viscous missing": (coeff("hertz", "100 0.3 viscous"), ["pair_coeff potdem/hertz", "missing"]),
    "hertz keyword": (coeff("hertz", "100 0.3 damping 1"), ["'damping'", "viscous, restitution, friction, rolling or twisting"]),
    "hertz friction missing": (coeff("hertz", "100 0.3 friction 0.5"), ["pair_coeff potdem/hertz", "missing"]),
    "hertz viscosity a word": (coeff("hertz", "100 0.3 friction 0.5 much"), ["friction eta", "'much'"]),
}
for _name, _good in GOOD.items():
    CASES.update({
        f"{_name} unset": (coeff(_name, _good, "1 1") + "\nrun 0", ["pair coeffs are not set"]),
        f"{_name} types reversed": (coeff(_name, _good, "2* *1"), [f"pair_coeff potdem/{_name}", "I <= J"]),
        f"{_name} type out of range": (coeff(_name, _good, "3 3"), ["3"]),
        f"{_name} points": (coeff(_name, _good) + "\nset atom 2 diameter 0\nrun 0", ["atom 2", "diameter 0", "> 0"]),
        f"{_name} without diameters": (
            scripts.box(5, atom_style="bond") + "create_atoms 1 single 1 1 1\nmass 1 1.0\n"
            f"pair_style potdem/{_name}\npair_coeff * * {_good}\nrun 0",
            [f"pair_style potdem/{_name}", "particle diameters", "bpm/sphere"]),
        f"{_name} respa": (coeff(_name, _good) + "\nrun_style respa 2 2\nrun 0",
                           [f"potdem/{_name}", "verlet", "respa"]),
    })


@pytest.mark.parametrize("name", CASES)
def test_message(run_lammps, name):
    script, words = CASES[name]
    message = run_lammps(script + "\n", expect_error="").error
    missing = [word for word in words if word not in message]
    assert not missing, message


@pytest.mark.parametrize("name", GOOD)
def test_the_line_that_the_cases_spoil_is_good(run_lammps, name):
    """and stays good with both keywords, and when it is given twice"""
    keyword = {"lj": "cut 0.5", "granular": "cut 3", "hertz": "viscous 0.1"}[name]
    script = coeff(name, GOOD[name]) + f"\npair_coeff * * {GOOD[name]} {keyword} friction 0.3 auto\n"
    script += f"pair_coeff 1 2 {GOOD[name]} friction 0.3 2 {keyword}\nrun 0\n"
    run_lammps(script)


@pytest.mark.parametrize("nprocs", [1, 2])
@pytest.mark.parametrize("name", GOOD)
def test_a_pair_that_passes_its_smallest_distance(run_lammps, name, nprocs):
    """thrown through each other by a step that is much too long: IDs, step, distance and remedy"""
    values = {"lj": "100 0.2 3 0.2", "granular": "100 3 0.2", "hertz": "100 0.3"}[name]
    # two steps bring them from beyond all cuts to next to each other's centres
    script = scripts.box((20, 8, 8), types=2) + "bond_style none\n"
    script += scripts.particles([(-2.0, 0, 0, 1.0), (2.0, 0, 0, 1.0, 2)])
    script += f"pair_style potdem/{name}\npair_coeff * * {values}\ngroup two id 2\nvelocity all set 1 0 0\n"
    script += "velocity two set -1 0 0\nfix move all nve\ntimestep 1.0\nneigh_modify every 1 delay 0 check no\nrun 2\n"
    # Hertz has no core: two centres at one place are the only pair that has no direction
    message = run_lammps(script, nprocs=nprocs, expect_error="").error
    words = [f"pair_style potdem/{name}", "step 2", "smaller timestep"]
    assert not [word for word in words if word not in message], message
    assert "atoms 1 and 2" in message or "atoms 2 and 1" in message
    if name != "hertz":
        assert "smallest distance 0.8" in message


@pytest.mark.parametrize("name", GOOD)
def test_positions_that_are_not_finite(run_lammps, name):
    """an error, not a NaN that spreads"""
    script = coeff(name, GOOD[name]) + "\nvariable bad equal 0/1\nfix move all nve\n"
    script = replaced(script, "lost error", "lost ignore")
    script += "variable huge atom 1e308*10*(id==2)\nvelocity all set 0 0 0\nfix kick all addforce v_huge 0 0\nrun 3\n"
    message = run_lammps(script, expect_error="").error
    assert "Non-numeric atom coords" in message or "not finite" in message


def test_many_pairs_given_one_by_one(run_lammps):
    """a coefficient of a pair of types does not need those of the types themselves to agree"""
    script = style("lj") + "pair_coeff 1 1 100 0.2 3 0.2\npair_coeff 2 2 100 0.2 4 0.2\n"
    run_lammps(script + "pair_coeff 1 2 100 0.2 3.5 0.2\nrun 0\n")
