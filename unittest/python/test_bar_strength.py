# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Bars that are pulled until they part (examples/bar-strength): strength along the axes of the lattices, and what the
directions of the bonds say."""

import numpy as np
import pytest

from potdem.paths import EXAMPLES
from potdem.scenes.scene import load
from potdem.text import replaced

SCENE = EXAMPLES / "bar-strength"
strengths = load(SCENE / "strengths.py")


@pytest.mark.parametrize("packing, along", [("sc", "100"), ("hcp", "c")])
def test_a_bar_parts_at_the_strength(run_lammps, tmp_path, packing, along):
    """at twice the rate of the scene. 2 %: area body leaves the strain uneven by so much"""
    script = (SCENE / "in.bar-strength").read_text()
    settings = {"packing": packing, "along": along, "rate": "2e-3", "end": "1.2"}
    text = "".join(f"variable {name} index {value}\n" for name, value in settings.items()) + script
    run = run_lammps(text)
    stress = run.thermo["v_stress"]
    assert stress.max() == pytest.approx(1.0, abs=0.02)
    assert run.thermo["f_crack"][-1] > 100 and stress[-1] < 0.2
    # elastic until then: E = 1
    before = run.thermo["f_crack"] == 0
    assert stress[before] == pytest.approx(run.thermo["v_ratio"][before], rel=0.02)


@pytest.mark.parametrize("variant", ["sc-100", "fcc-100", "bcc-100", "hcp-a", "hcp-b", "hcp-c"])
def test_reference_logs_along_the_axes(variant):
    (log,) = SCENE.glob(f"log.*.bar-strength.{variant}.g++.1")
    given, _, peak, _, _ = strengths.measured(log)
    assert peak == pytest.approx(1.0, abs=0.02)
    assert strengths.formula(given) == pytest.approx(1.0, abs=1e-12)


def test_strength_by_direction():
    """[111] of fcc within 2 d: the nearest bonds are along [112], cos^2 = 8/9; of simple cubic within sqrt 2 d: [110],
    cos^2 = 2/3"""
    assert strengths.strength(strengths.bond_directions("fcc", 2.0), (1, 1, 1)) == pytest.approx(1 / (8 / 9 - 1 / 36))
    assert strengths.strength(strengths.bond_directions("sc", 1.42), (1, 1, 1)) == pytest.approx(1 / (2 / 3 - 1 / 12))
    low, mean, high = strengths.spread(strengths.bond_directions("bcc", 2.0), 2000)
    assert 1.0 <= low < mean < high < 2.0
    turned = np.roll(strengths.bond_directions("hcp", 2.0), 1, axis=1)    # c along x
    assert strengths.strength(turned, (1, 0, 0)) == pytest.approx(1.0)
