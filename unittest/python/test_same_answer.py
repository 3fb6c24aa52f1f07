# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""However a scene is computed, the result is the same: to rounding, before bonds fail; what is conserved, after."""

import pytest
from conftest import PLAIN, THROUGH_PLUGIN

from potdem import same_answer


@pytest.fixture(scope="module")
def base(lmp, tmp_path_factory):
    answer = same_answer.compute(same_answer.Way("as it comes"), tmp_path_factory.mktemp("base"), lmp)
    assert answer.last["f_fails"] > 200 and answer.last["c_most"] > 30    # it breaks, into many pieces
    return answer


def ways(build):
    through_plugin = same_answer.Way("the plugin", environment={"LAMMPS_PLUGIN_PATH": str(build)}, lmp=PLAIN, same_bits=True)
    return [*same_answer.WAYS, through_plugin]


NAMES = [way.name for way in ways("")]


@pytest.mark.parametrize("name", NAMES)
def test_the_same_answer(lmp, build, base, tmp_path, name):
    way = ways(build)[NAMES.index(name)]
    if way.lmp and (THROUGH_PLUGIN or not way.lmp.exists()):
        pytest.skip("this is the pass through the plugin" if THROUGH_PLUGIN else f"{way.lmp.name} without styles was not built")
    answer = same_answer.compute(way, tmp_path, lmp)
    assert answer.failed_before == 0
    assert same_answer.deviation(answer, base) <= (0.0 if way.same_bits else same_answer.ROUNDING)
    drifts = same_answer.drifts(answer)
    assert drifts["bonds"] == 0
    assert drifts["momentum"] < same_answer.ROUNDING
    assert drifts["energy"] < same_answer.ENERGY
