# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""tools/plot: curves of the thermo output, with units."""

import re

import numpy as np
import pytest
from PIL import Image

from potdem import commands, logs, plot
from potdem.paths import DOCS

LOG = """LAMMPS (4 Feb 2025 - Update 1)
units {units}
compute ledger all potdem/energy
fix cracks all potdem/failure 1 tension 2e5
fix floor all potdem/wall/region floor 3e10 0.2 particle 3e6 0.2
   Step          Time         f_cracks     f_floor[3]   c_ledger     c_ledger[1]  c_ledger[2]    v_strain     v_stress
         0   0              0              0              5              5              0              0              0
        10   0.5            3             -2              5              4              0              0.1            7
        20   1.0            4             -3              5              3              0              0.2            9
Loop time of 1 on 1 procs for 20 steps with 2 atoms
"""


@pytest.fixture
def log(tmp_path):
    path = tmp_path / "log.lammps"
    path.write_text(LOG.format(units="si"))
    return path


def drawn(log, x, *ys):
    """axes of the figure"""
    run, table = commands.of_log(log), logs.read_thermo(log)
    ys = [plot.named(text) for text in ys]
    return plot.draw(table, run, plot.named(x), plot.groups(run, ys)).axes


def test_axes_have_the_units_of_the_script(log):
    failed, force = drawn(log, "Time", "f_cracks", "f_floor[3]")
    assert (failed.get_xlabel(), failed.get_ylabel(), force.get_ylabel()) == ("Time, s", "failed bonds", "force on the wall, z, N")
    log.write_text(LOG.format(units="metal"))
    assert drawn(log, "Time", "f_floor[3]")[0].get_ylabel() == "force on the wall, z, eV/Å"
    log.write_text(LOG.format(units="lj"))
    assert drawn(log, "Time", "f_floor[3]")[0].get_ylabel() == "force on the wall, z"


def test_columns_are_drawn_over_each_other(log):
    (axis,) = drawn(log, "v_strain=strain", "v_stress=stress, Pa")
    (line,) = axis.lines
    assert np.array_equal(line.get_xdata(), [0, 0.1, 0.2]) and np.array_equal(line.get_ydata(), [0, 7, 9])
    assert (axis.get_xlabel(), axis.get_ylabel()) == ("strain", "stress, Pa")


def test_the_ledger_shares_a_panel(log):
    failed, ledger = drawn(log, "Time", "f_cracks", "c_ledger", "c_ledger[1]", "c_ledger[2]")
    assert ledger.get_ylabel() == "energy, J"
    assert [text.get_text() for text in ledger.get_legend().get_texts()] == ["sum of all energies", "kinetic", "gravity"]


def test_without_names_every_column_is_drawn_but_those_that_are_zero(log, capsys):
    plot.main([str(log)])
    out = capsys.readouterr().out
    assert "zero, and not drawn: c_ledger[2]" in out and "log.lammps.png" in out
    image = np.asarray(Image.open(log.with_name("log.lammps.png")).convert("L"))
    assert 0.005 < np.mean(image < 200) < 0.2


def test_of_runs_that_differ_in_their_columns_the_last_are_drawn(log):
    log.write_text("   Step PotEng\n 0 1\nLoop time of 1 on 1 procs for 0 steps with 2 atoms\n" + LOG.format(units="si"))
    with pytest.raises(logs.LogError, match="differ in their columns"):
        logs.read_thermo(log)
    assert logs.read_thermo(log, last=True)["Step"].tolist() == [0, 10, 20]


def test_the_words_of_the_ledger_are_those_of_its_page():
    """the table of compute_potdem_energy.md, in its order"""
    rows = re.findall(r"^\| (\d+) \| (.*?) \|", (DOCS / "compute_potdem_energy.md").read_text(encoding="utf-8"), re.MULTILINE)
    words = commands.OUTPUTS["potdem/energy"]
    assert [int(number) for number, _ in rows] == list(range(1, len(words)))
    keys = {"bonds": "elastic energy of bonds", "contacts": "elastic energy of contacts", "walls": "elastic energy of walls",
            "damping": "numerical damping", "work of walls": "work of moving walls", "springs of friction": "elastic energy of the springs of friction"}
    for number, text in rows:
        name = words[int(number)][0]
        assert text.startswith(keys.get(name, name)), (number, name, text)


@pytest.mark.parametrize("arguments, message", [
    (["Time", "v_none"], "has no column v_none; it has: Step, Time, f_cracks"), (["Tiem"], "has no column Tiem")])
def test_a_column_that_is_not_there_is_named(log, arguments, message):
    with pytest.raises(plot.PlotError, match=message):
        plot.main([str(log), *arguments])


@pytest.mark.parametrize("text, message", [(None, "no log"), ("nothing\n", "no thermo output")])
def test_what_is_no_log_is_refused(tmp_path, text, message):
    path = tmp_path / "log.x"
    if text:
        path.write_text(text)
    with pytest.raises((plot.PlotError, logs.LogError), match=message):
        plot.main([str(path)])
