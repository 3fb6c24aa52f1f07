# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Texts are changed, or the change fails."""

import pytest

from potdem.text import replaced


def test_every_place_or_the_first_ones():
    assert replaced("run 1\nrun 2\n", "run", "rerun") == "rerun 1\nrerun 2\n"
    assert replaced("run 1\nrun 2\n", "run", "rerun", 1) == "rerun 1\nrun 2\n"
    assert replaced(b"E 500", b"500", b"1e400") == b"E 1e400"


@pytest.mark.parametrize("count", [None, 1])
def test_what_is_not_there_is_an_error(count):
    with pytest.raises(ValueError, match="'walk' stands 0 times"):
        replaced("run 1\n", "walk", "fly", count)


def test_fewer_places_than_wanted_are_an_error():
    with pytest.raises(ValueError, match="stands 1 times, not 2"):
        replaced("run 1\n", "run", "fly", 2)
