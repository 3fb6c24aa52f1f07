# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""tools/report grains: what it measures, on made-up heaps and bins; that both styles get the same laws; that its page is made of what was
measured."""

import numpy as np
import pytest

from potdem import dumps, heaps, scripts
from potdem.reports import grains_page, grains_runs

RNG = np.random.default_rng(5)
D, ACROSS, LONG = grains_runs.D, grains_runs.ACROSS, grains_runs.LONG


def wedge(degrees, count=4000):
    """grains at random below a slope that ends at x = LONG 2 d above the base"""
    x, y = RNG.uniform(0, LONG, count), RNG.uniform(-ACROSS, 2 * ACROSS, count)
    top = np.tan(np.radians(degrees)) * (LONG - x) + 2 * D
    return dumps.Frame(0, {"x": x, "y": y, "z": RNG.uniform(0, 1, count) ** 0.1 * top, "radius": np.full(count, 0.5 * D)})


@pytest.mark.parametrize("degrees", [10.0, 25.0, 40.0])
def test_the_angle_of_a_wedge(degrees):
    assert grains_runs.slope(wedge(degrees))[0] == pytest.approx(degrees, abs=1.0)


def test_stray_grains_do_not_turn_the_surface():
    frame = wedge(25.0)
    before = grains_runs.slope(frame)[0]
    frame["z"][:20] += 0.1
    assert grains_runs.slope(frame)[0] == pytest.approx(before, abs=1.0)


def test_the_angle_by_volume():
    """columns of grains whose number falls along x"""
    place = (np.arange(18) + 0.5) * grains_runs.CELL
    x = np.repeat(place, np.arange(190, 10, -10))
    frame = dumps.Frame(0, {"x": x, "radius": np.full(x.size, 0.5 * D)})
    step = 10 * np.pi / 6 * D**3 / (grains_runs.CELL * ACROSS * 0.6)
    expected = np.degrees(np.arctan(step / grains_runs.CELL))
    assert heaps.slope(*heaps.filled(frame, ACROSS, grains_runs.CELL, LONG, 0.6), D)[0] == pytest.approx(expected, rel=1e-9)


def test_the_rate_of_a_bin():
    time = np.linspace(0, 1, 101)
    mass = 4.0 - np.where(time < 0.1, 0, 3.0 * (time - 0.1))
    rate, bends = heaps.rate(time, mass, 0.9, 0.5)
    assert rate == pytest.approx(3.0, rel=1e-9) and bends < 1e-9


def test_the_law_of_beverloo_is_found_again():
    widths = np.array([0.05, 0.07, 0.09])
    factor, shift, deviation = heaps.beverloo(widths, 190.0 * (widths - 0.013) ** 1.5, 1.5)
    assert (factor, shift) == pytest.approx((190.0, 0.013), rel=1e-9) and deviation < 1e-9


def impact(style, speed, xi):
    """two grains of the report meet obliquely; velocity and spin afterwards"""
    terms = grains_runs.in_lammps_terms(1.0)
    pair = {
        "potdem": f"potdem/hertz rotation yes\npair_coeff * * 5e6 0.3 restitution 0.5 friction 0.5 mindlin damping {xi}",
        "granular": f"granular\npair_coeff * * hertz/material 5e6 {terms['e_gran']} 0.3 tangential mindlin_rescale/force NULL "
                    f"{terms['xt'] * xi / grains_runs.XI} 0.5 damping coeff_restitution limit_damping",
    }[style]
    script = scripts.box(0.1, skin=0.002, atom_style="sphere") + scripts.particles([(0, 0, 0, D), (1.001 * D, 0, 0, D)], grains_runs.DENSITY)
    script += f"comm_modify vel yes\npair_style {pair}\ngroup one id 1\nfix move all nve/sphere\n"
    script += f"velocity one set {speed[0]} {speed[1]} 0\ntimestep 1e-6\ncompute w one property/atom omegaz\ncompute spin one reduce sum c_w\n"
    script += "thermo_style custom step c_spin\nrun 15000\n"
    return script + scripts.result("vcm(one,x)", "vcm(one,y)", "c_spin")


@pytest.mark.parametrize("across, xi, same", [
    (0.0, 0.3, 1e-9),    # head-on: the same dashpot
    (0.2, 0.0, 1e-3), (0.8, 0.0, 1e-3),    # it sticks, it slips; the arms differ by the overlap, half a thousandth of d
    (0.2, 0.3, 5e-3), (0.8, 0.3, 0.02),    # when it slips, the two keep different springs beside a dashpot
])
def test_both_styles_have_the_same_law(run_lammps, across, xi, same):
    speed = 0.005
    found = [scripts.results(run_lammps(impact(style, (speed, across / 0.5 * speed), xi)).stdout)[0] for style in grains_runs.STYLES]
    assert found[0] == pytest.approx(found[1], rel=same, abs=1e-12)
    if across == 0.0:
        assert found[0][0] == pytest.approx(0.25 * speed, rel=1e-3)    # restitution 0.5 of two equal grains


def made_up():
    """heaps and discharges with round numbers"""
    runs = [grains_runs.Heap(style, rolling, seed, "", 25.0 + seed + 10 * rolling, 25.0 + seed + 10 * rolling, 24.0, 2484, 1000, 1000, 1e-4, 20.0, None)
            for style in grains_runs.STYLES for rolling in grains_runs.ROLLING for seed in (1, 2, 3)]
    time, mass = np.linspace(0, 1, 11), np.linspace(4, 2, 11)
    slots = [grains_runs.Discharge(style, width, seed, 190.0 * (width * D - 0.013) ** 1.5, 0.001, 1500.0, 10.0, time, mass)
             for style in grains_runs.STYLES for width in grains_runs.WIDTHS for seed in (1, 2, 3)]
    return runs, slots


def test_the_page_says_what_was_measured():
    runs, slots = made_up()
    table = grains_page.heap_table(runs)
    assert "| 27.0 ± 1.0 |" in table and "| 29.0 ± 1.0 |" in table
    assert grains_page.difference_table(runs).count("| within |") == 6
    for run in runs:
        run.later += 5.0 if run.style == "potdem" else 0.0
    differences = grains_page.difference_table(runs)
    assert differences.count("| **outside** |") == 2 and differences.count("| +5.0 ± 0.8 |") == 2
    assert "with $C$ = 0.67 and $k$ = 1.30" in grains_page.slot_verdicts(slots)
