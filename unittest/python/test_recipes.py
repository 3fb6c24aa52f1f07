# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""examples/recipes: each script runs; bodies have the porosity and tests the modulus that closed forms give."""

import shutil
from pathlib import Path

import numpy as np
import pytest

from potdem import dumps

RECIPES = Path(__file__).resolve().parent.parent.parent / "examples" / "recipes"
E, D = 3e10, 0.005


@pytest.fixture
def recipe(run_lammps, tmp_path):
    for file in [*RECIPES.glob("*.lmp"), *RECIPES.glob("*.stl")]:
        shutil.copy(file, tmp_path)

    def run(name, nprocs=1, **variables):
        return run_lammps((RECIPES / f"in.{name}").read_text(), nprocs=nprocs, vars=variables)

    return run


def slope(x, y):
    return np.polyfit(x, y, 1)[0]


@pytest.mark.parametrize("rate, strain", [(0.1, 5e-5), (-0.1, -5e-5)])
def test_modulus_between_clamps(recipe, rate, strain):
    """stiffer than E by what the clamps hold sideways: a sixth of the length, where up to E/(1 - nu^2) = 1.067 E counts, for nu = 1/4;
    and the area body's own 1 %. The rows are of a body that swings a little about its mean"""
    thermo = recipe("pull", rate=rate, strain=strain).thermo
    modulus = slope(thermo["v_strain_now"], thermo["v_stress"])
    assert 0.99 * E < modulus < (1 + 0.067 / 6 + 0.02) * E
    assert thermo["Bonds"][-1] == thermo["Bonds"][0]


def test_strength_between_clamps(recipe):
    """breaks between 0.85 and 1 of f_t: docs of bar-strength have 0.85 to 0.89 for lattices that are drawn along an axis, where one
    bond in the middle of a section carries more than the mean"""
    thermo = recipe("pull").thermo
    assert 0.85 * 3e6 < thermo["v_stress"].max() < 3.0e6
    assert thermo["Bonds"][-1] < thermo["Bonds"][0]


@pytest.mark.parametrize("nprocs", [1, 2])
def test_modulus_between_platens(recipe, nprocs):
    """with friction 0.1 the ends can hardly slide: up to 1/(1 - nu^2) of E, and half a spacing of contact at each end is as stiff as
    the body"""
    thermo = recipe("press", nprocs=nprocs, strain=2e-4).thermo
    assert E < slope(thermo["v_shortening"], thermo["v_stress"]) < 1.067 * E
    assert thermo["Bonds"][-1] == thermo["Bonds"][0]


def test_triaxial(recipe):
    """10 MPa from all sides, held on four while the cube is pressed on; eight particles read 8 % stiff between platens (see the page)"""
    thermo = recipe("triaxial", strain=2e-4, tension=3e9).thermo
    shear = thermo["v_shortening"] > 0
    start = np.flatnonzero(shear)[0] - 1
    assert thermo["v_stress"][start] == pytest.approx(1e7, rel=0.01)
    assert thermo["v_lateral"][start:] == pytest.approx(1e7, rel=0.02)
    assert E < slope(thermo["v_shortening"][shear], thermo["v_stress"][shear]) < 1.09 * E


def test_bending(recipe):
    """F L^3/(48 E I) (1 + 2.85 (h/L)^2 - 0.84 (h/L)^3): a beam under a single load, with shear and what the load does below it (J. Wilson
    and G. Stokes 1891, in S. Timoshenko and J. Goodier, Theory of Elasticity, for nu = 0.3); the beam swings"""
    thermo = recipe("bend", deflection=1.6e-5).thermo
    size, span = 6 * D, 36 * D
    ratio = size / span
    stiffness = 48 * E * size**4 / 12 / span**3 / (1 + 2.85 * ratio**2 - 0.84 * ratio**3)
    swings_in = len(thermo["v_load"]) // 4
    assert slope(thermo["v_deflection_now"][swings_in:], thermo["v_load"][swings_in:]) == pytest.approx(stiffness, rel=0.06)


def test_interface_breaks_first(recipe):
    thermo = recipe("interface").thermo
    assert thermo["v_stress"].max() < 1e6
    assert 0 < thermo["Bonds"][0] - thermo["Bonds"][-1] <= 219


def test_a_crack_runs_across_the_plate(recipe):
    """a body in two pieces carries no load, but for its swinging"""
    thermo = recipe("crack", strain=6e-5).thermo
    assert thermo["v_stress"].max() < 1e6    # a third of f_t: the notch
    assert np.abs(np.mean(thermo["v_stress"][-60:])) < 0.1 * thermo["v_stress"].max()


@pytest.mark.parametrize("porosity, nprocs", [(0.42, 1), (0.5, 2)])
def test_packing(recipe, tmp_path, porosity, nprocs):
    run = recipe("packing", porosity=porosity, nprocs=nprocs)
    (frame,) = dumps.read(tmp_path / "packing.dump")
    r = frame["radius"]
    assert 0.0015 <= r.min() < 0.00152 and 0.00248 < r.max() <= 0.0025
    # one draw of some 3000 volumes with a coefficient of variation of 0.43
    assert 1 - np.sum(4 / 3 * np.pi * r**3) / (np.pi * 0.025**2 * 0.1) == pytest.approx(porosity, abs=3 * 0.43 * (1 - porosity) / 3000**0.5)
    inside = 0.02 * r    # they overlap by this much with the wall, and twice as much with each other
    assert (np.hypot(frame["x"], frame["y"]) + r < 0.025 + inside).all()
    assert (frame["z"] > r - inside).all() and (frame["z"] < 0.1 - r + inside).all()
    places = np.column_stack([frame[k] for k in "xyz"])
    gap = np.linalg.norm(places[:, None] - places[None], axis=2) - r[:, None] - r[None]
    np.fill_diagonal(gap, 0.0)
    assert gap.min() > -0.04 * r.mean()
    assert "bonds of type 1" in run.stdout


def test_stone_breaks(recipe):
    thermo = recipe("stone").thermo
    assert thermo["c_piece"][0] == 1 and thermo["c_piece"][-1] > 100
    assert thermo["Bonds"][-1] + thermo["f_cracks"][-1] == thermo["Bonds"][0]


def test_every_recipe_is_tested_and_on_the_page(request):
    text, page = Path(__file__).read_text(), (RECIPES / "README.md").read_text()
    for file in RECIPES.glob("in.*"):
        assert f'recipe("{file.suffix[1:]}"' in text
        assert f"[{file.name}]" in page
    for file in RECIPES.glob("*.lmp"):
        assert f"[{file.name}]" in page
