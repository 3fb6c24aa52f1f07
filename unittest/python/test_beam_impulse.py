# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""The references of the scene beam-impulse against each other, and its claim: deflection and period agree with finite
elements. Reads the results that are committed; test_run_scene.py and examples/run are what runs scenes."""

import numpy as np
import pytest
from scipy.integrate import quad

from potdem import beams, struck_beam
from potdem.paths import EXAMPLES

SCENE = EXAMPLES / "beam-impulse"


def beam(length=0.24, depth=0.025):
    return struck_beam.beam(length, depth)


def test_slender_beam_has_the_frequencies_of_euler_and_bernoulli():
    """(beta L)^2 (E I / rho A)^(1/2) / L^2, with cos(beta L) cosh(beta L) = -1"""
    slender = beam(depth=0.24 / 200)
    scale = np.sqrt(slender.modulus * slender.inertia / (slender.density * slender.area)) / slender.length**2
    betas = np.array([1.875104068711961, 4.694091132974175, 7.854757438237613])
    found = [mode.omega for mode in beams.modes(slender)[:3]]
    # shear and rotary inertia lower them by about 0.2 (beta h / L)^2 or, in the third mode, 3e-4
    assert found == pytest.approx(betas**2 * scale, rel=1e-3)


def test_modes_are_orthogonal_in_the_mass():
    """shapes that are not those of the same problem, or not at its frequencies, are not"""
    modes = beams.modes(beam())
    nodes, weights = np.polynomial.legendre.leggauss(300)
    x = 0.12 * (nodes + 1)
    w, theta = (np.array([mode.amplitudes @ mode.waves.at(x)[part] for mode in modes]) for part in (0, 1))
    b = beam()
    mass = 0.12 * b.density * ((b.area * w * weights) @ w.T + (b.inertia * theta * weights) @ theta.T)
    norms = np.sqrt(np.diag(mass))
    assert np.abs(mass / np.outer(norms, norms) - np.eye(len(modes))).max() < 1e-8


@pytest.mark.parametrize("x", [0.1, 0.2375])
def test_static_deflections_of_the_modes_add_up(x):
    """to x^3 / 3 E I + x / kappa G A, but for the modes that are left out, above the cut-off"""
    assert sum(mode.flexibility(x) for mode in beams.modes(beam())) == pytest.approx(beam().static(x), rel=2e-3)


@pytest.mark.parametrize("pulse, force", [("f1", lambda t: float(t < 1e-3)),
                                          ("f2", lambda t: max(0.0, 1 - abs(t - 1e-3) / 1e-3))])
@pytest.mark.parametrize("omega", [631.0, 9993.0])
def test_response_to_the_pulses(pulse, force, omega):
    """against Duhamel's integral"""
    times = np.array([4e-4, 1.6e-3, 5e-3])
    expected = [omega * quad(lambda s, t=t: force(s) * np.sin(omega * (t - s)), 0, min(t, 2e-3), points=[1e-3], limit=200)[0]
                for t in times]
    assert beams.amplification(omega, struck_beam.PULSES[pulse], times) == pytest.approx(expected, abs=1e-8)


@pytest.mark.parametrize("pulse", struck_beam.PULSES)
def test_finite_elements_agree_with_the_modal_sum(pulse):
    """two-dimensional elasticity against the beam theory: they differ in the shear near the clamp"""
    elements, modes = struck_beam.calculix("2d-linear", pulse), struck_beam.modal("half", pulse)
    assert elements.period == pytest.approx(modes.period, rel=0.002)
    difference = elements.deflection - np.interp(elements.time, modes.time, modes.deflection)
    # what 0.2 % in the period are of the phase after three periods
    assert np.abs(difference).max() < 0.04 * modes.peak


@pytest.mark.parametrize("reach", ["1.42", "1.75", "2.00", "2.50"])
@pytest.mark.parametrize("pulse", struck_beam.PULSES)
def test_claim_deflection_and_period_agree_with_finite_elements(pulse, reach):
    """area body, 5 particles through the depth: within 5 %, wherever the clamp is taken to act"""
    (log,) = SCENE.glob(f"log.4Feb2025.beam-impulse.{pulse}-body-{reach}.g++.1")
    _, found = struck_beam.lammps(log)
    for model in ("2d", "3d", "2d-layer"):
        expected = struck_beam.calculix(model, pulse)
        assert (found.peak, found.period) == pytest.approx((expected.peak, expected.period), rel=0.05)
