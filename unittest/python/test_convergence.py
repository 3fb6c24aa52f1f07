# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""tools/convergence.py: cantilevers with more and more particles through the depth."""


import convergence
import numpy as np
import pytest
from scipy.sparse import identity


from potdem import networks


@pytest.mark.parametrize("n", [4, 5])
def test_a_quarter_stands_for_the_whole(n):
    """equal sections: the network is symmetric, so the displacements are the same up to rounding; even and odd n"""
    body = networks.beam("sc", n, 20)
    pairs = body.pairs(2.0)
    x = body.x - [2, 0.5 * body.size[1], 0.5 * body.size[2]]
    force = np.zeros_like(x)
    force[x[:, 0] > 17, 2] = 1.0
    whole, quarter = (networks.Network(x, pairs, np.ones(len(pairs)), x[:, 0] < 0, fields)
                      for fields in (identity(3 * len(x), format="csc"), networks.quarter_fields(x)))
    assert quarter.fields.shape[1] < 0.3 * whole.fields.shape[1]
    u = whole.displacement(force)
    assert quarter.displacement(force) == pytest.approx(u, abs=1e-9 * np.abs(u).max())
    assert quarter.first_frequency(body.v, 2) == pytest.approx(whole.first_frequency(body.v, 2), rel=1e-9)


def test_errors_fall(lmp):
    """body, 5 and 10 through the depth, from the last held layer: within 1 %, where the beam theory ends; lattice, 3 and 6: first order"""
    few, more = (convergence.errors(lmp, n, "body") for n in (5, 10))
    for what in ("tip", "frequency"):
        assert abs(few[what, "plane"]) < 0.05 and abs(more[what, "plane"]) < 0.6 * abs(few[what, "plane"])
        assert abs(few[what, "layer"]) < 0.01 and abs(more[what, "layer"]) < 0.01
    few, more = (convergence.errors(lmp, n, "lattice")["tip", "plane"] for n in (3, 6))
    assert 0.9 < np.log2(few / more) < 1.5
