# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Runs for every combination of some variables."""

import pytest

from potdem.scenes import scanning

SCRIPT = """
variable a index 0
variable b index 0
print "${a} ${b}" file ${out}/said
"""


@pytest.fixture
def scene(tmp_path, lmp, monkeypatch):
    """a scene whose script repeats its variables"""
    monkeypatch.setattr(scanning.running, "LMP", lmp)
    (tmp_path / "said").mkdir()
    (tmp_path / "said" / "in.said").write_text(SCRIPT)
    return tmp_path / "said"


def read(folder):
    return (folder / "said").read_text().strip()


def test_every_combination_is_run(scene, capsys):
    scanning.main(scene, read, ["a=1,2", "b=3,x"])
    lines = [line.split() for line in capsys.readouterr().out.splitlines()]
    assert lines == [[f"a={a}", f"b={b}", a, b] for a in "12" for b in "3x"]


def test_folders_are_measured(scene, capsys):
    scanning.run(scene, {"a": 7}, scene)
    scanning.main(scene, read, [str(scene)])
    assert capsys.readouterr().out.split() == ["said", "7", "0"]
