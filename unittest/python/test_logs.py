# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Reading thermo output and error messages."""

import numpy as np
import pytest

from potdem import logs
from potdem.text import replaced

TWO_RUNS = """LAMMPS (4 Feb 2025 - Update 1)
Per MPI rank memory allocation (min/avg/max) = 1 | 1 | 1 Mbytes
   Step          Temp     v_broken
         0   1.5            0
        10   1.25           0
Loop time of 1 on 1 procs for 10 steps with 2 atoms

Total # of neighbors = 3
   Step          Temp     v_broken
        10   1.25           0
WARNING: something happened at step 12
        20   nan            3
Loop time of 1 on 1 procs for 10 steps with 2 atoms
"""

YAML_RUN = """---
keywords: ['Step', 'Temp', 'c_x[1]', ]
data:
  - [0, 1.5, 2, ]
  - [10, -1e-3, 3, ]
...
Loop time of 1
"""


def test_runs_are_joined_without_the_shared_step():
    table = logs.thermo(TWO_RUNS)
    assert table["Step"].tolist() == [0, 10, 20]
    assert table["v_broken"].tolist() == [0, 0, 3]


def test_rows_with_numbers_that_are_not_finite_are_kept():
    """LAMMPS's own reader takes them for text"""
    table = logs.thermo(replaced(TWO_RUNS, "1.25 ", "-inf "))
    assert table["Temp"][:2].tolist() == [1.5, -np.inf] and np.isnan(table["Temp"][2])


def test_a_run_that_did_not_end_is_read_up_to_its_last_whole_line():
    """LAMMPS's own reader leaves it out"""
    begun = "   Step          Temp     v_broken\n        20   1.0            3\n        30   2.0"
    assert logs.thermo(TWO_RUNS + begun + "            4\n        40   1")["Step"].tolist() == [0, 10, 20, 30]
    assert logs.thermo(TWO_RUNS + begun)["Step"].tolist() == [0, 10, 20]
    assert logs.thermo(begun + "            4\nERROR: Lost atoms (thermo.cpp:1)\n")["v_broken"].tolist() == [3, 4]
    told = "ERROR on proc 0: Bond atoms 1 2 missing (a.cpp:1)\n" + "-" * 74 + "\nMPI_ABORT was invoked on rank 0\n" + "-" * 74 + "\n"
    assert logs.thermo(begun + "            4\n" + told)["v_broken"].tolist() == [3, 4]


def test_lines_of_numbers_between_the_rows_are_refused():
    with pytest.raises(logs.LogError, match="shorter than its header"):
        logs.thermo(replaced(TWO_RUNS, "        20   nan", "5 7\n        20   nan"))


def test_yaml_output():
    table = logs.thermo(YAML_RUN)
    assert list(table) == ["Step", "Temp", "c_x[1]"]
    assert table["Temp"].tolist() == [1.5, -1e-3]


def test_runs_with_other_columns_are_refused():
    with pytest.raises(logs.LogError, match="differ in their columns"):
        logs.thermo(TWO_RUNS + "   Step   Temp\n   20 1\n")


def test_a_log_without_thermo_output_is_refused():
    with pytest.raises(logs.LogError, match="no thermo output"):
        logs.thermo("LAMMPS (4 Feb 2025)\n")


def test_version():
    assert logs.version(TWO_RUNS) == "4Feb2025"


def test_error_message_is_one_line():
    text = "ERROR: Unknown keyword\n  frction in pair_coeff (src/pair.cpp:12)\nLast input line: pair_coeff * *\n"
    assert logs.error_message(text) == "Unknown keyword frction in pair_coeff"
    assert logs.error_message("ERROR on proc 3: Bond too long (a.cpp:1)\n") == "Bond too long"
    assert logs.error_message("all is well\n") is None


def test_error_message_of_lammps(run_lammps):
    run = run_lammps("units si\npair_style no/such/style\n", expect_error="no/such/style")
    assert run.error.startswith("Unrecognized pair style")


def test_parameters_are_those_printed_not_those_of_the_script():
    echo = 'print "PARAMETERS law=${law} d=$d"\n'
    assert logs.parameters(echo + "PARAMETERS law=lj d=0.005\n") == {"law": "lj", "d": "0.005"}


def test_log_without_parameters():
    with pytest.raises(logs.LogError, match="PARAMETERS"):
        logs.parameters("run 0\n")
