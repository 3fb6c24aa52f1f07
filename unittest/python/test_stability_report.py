# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""tools/report stability: how runs are judged, on made-up logs, and that its page is made of what was judged."""

from pathlib import Path

import numpy as np
import pytest

from potdem import formulas
from potdem.reports import stability, stability_cases, stability_page
from potdem.running import Run
from potdem.text import replaced

OURS = "WARNING: The contact of atoms 1 and 2 on step 30 is so stiff that ... (src/lammps/output/fix_potdem_monitor.cpp:188)\n"
LAMMPS_OWN = "WARNING: No fixes with time integration, atoms won't move (src/verlet.cpp:60)\n"
HEADER = "Step Time Dt c_ledger " + " ".join(f"c_ledger[{k}]" for k in range(1, 11)) + " v_stray"


def log(ledger, stray=None, before="", after="", kinetic=2.0):
    """a run with these sums of the ledger, one row for every tenth step"""
    stray = stray or [0] * len(ledger)
    rows = "".join(f"{10 * k} {0.1 * k} 0.01 {sum_:g} {kinetic} " + "0 " * 9 + f"{lost}\n" for k, (sum_, lost) in enumerate(zip(ledger, stray)))
    return f"LAMMPS\n{stability.MARK}\n{before}{HEADER}\n{rows}Loop time of 1\n{after}"


def judged(output, status=0, scale=2.0):
    case = stability_cases.Case("made up", "case", "")
    return stability.judge(case, "0.9", 0.9, 0.01, Run(Path(), status, output), scale)


SOUND = [1.0, 1.1, 0.9]
WRONG = [1.0, 1.1, 2.0]


@pytest.mark.parametrize("output, status, verdict", [
    (log(SOUND), 0, "right"),
    (log(SOUND, before=LAMMPS_OWN), 0, "right"),
    (log(SOUND, before=OURS), 0, "right, warns"),
    (log(WRONG, before=OURS), 0, "warns"),
    (log(WRONG), 0, "SILENT NONSENSE"),
    (log(WRONG, before=LAMMPS_OWN), 0, "SILENT NONSENSE"),    # LAMMPS's own words are not about this
    (log([1.0, float("nan"), 1.0]), 0, "SILENT NONSENSE"),
    (log([1.0, float("inf"), 1.0], before=OURS), 0, "warns"),
    (log(SOUND, stray=[0, 1, 0]), 0, "SILENT NONSENSE"),
    (log(SOUND, stray=[0, 1, 0], before=OURS), 0, "warns"),
    (log(SOUND, after="ERROR: Lost atoms: original 2 current 0 (src/thermo.cpp:512)\n"), 1, "stops"),
    ("LAMMPS\nERROR: no such luck (src/x.cpp:1)\n", 1, "stops"),
    ("LAMMPS\n", -9, "stops"),
    ("LAMMPS\n", 0, "SILENT NONSENSE"),    # ended well, and nothing is known about it
])
def test_verdicts(output, status, verdict):
    assert judged(output, status).verdict == verdict


def test_the_bound_is_a_share_of_the_energy_exchanged():
    ledger = [5.0, 5.0 + 0.99 * stability.LEDGER_BOUND, 5.0]
    assert judged(log(ledger), scale=1.0).verdict == "right"
    assert judged(log(ledger), scale=0.9).verdict == "SILENT NONSENSE"
    assert judged(log(ledger), scale=1.0).error == pytest.approx(0.99 * stability.LEDGER_BOUND)


def test_energy_exchanged():
    """half of what all terms have changed, or the largest kinetic energy, or the least that is given"""
    thermo = {f"c_ledger[{k}]": np.zeros(3) for k in range(1, 11)}
    thermo["c_ledger[1]"] = np.array([1.0, 4.0, 2.0])
    assert stability.exchanged(thermo) == 4.0
    thermo["c_ledger[3]"] = np.array([100.0, 93.0, 99.0])
    assert stability.exchanged(thermo) == 5.0
    assert stability.exchanged(thermo, 70.0) == 70.0


@pytest.mark.parametrize("output, status, sign", [
    (log(SOUND), 0, None),
    (log(WRONG), 0, (20, "energy ledger")),
    (log(WRONG, before=OURS), 0, (20, "energy ledger")),
    (log(WRONG, before=replaced(OURS, "step 30", "step 20")), 0, (20, "warning")),
    (log(SOUND, stray=[0, 1, 0], before=OURS), 0, (10, "particle astray")),
    (log(SOUND, after="ERROR: Bond between atoms 1 and 2 is long on step 7 (src/x.cpp:1)\n"), 1, (7, "error")),
    (log(SOUND, after="ERROR: Bond atoms 1 2 missing on proc 0 at step 13 (src/x.cpp:1)\n"), 1, (13, "error")),
    (log(SOUND, after="ERROR: Lost atoms: original 2 current 0 (src/thermo.cpp:512)\n"), 1, (20, "error")),    # after the last row
])
def test_first_sign(output, status, sign):
    assert judged(output, status).sign == sign


def test_scripts():
    case = stability_cases.Case("g", "c", "SCRIPT\n", time=2.0, longest=0.1, short=0.5)
    assert "timestep 0.25\n" in stability.fixed_script(case, 0.25, 1.0)
    assert stability.fixed_script(case, 0.01, 1.0).endswith("run 200\n")
    assert stability.fixed_script(case, 0.01, 0.5).endswith("run 100\n")
    counted = stability_cases.Case("g", "c", "SCRIPT\n", steps=5000)
    assert stability.fixed_script(counted, 0.25, 1.0).endswith("run 5000\n")


def test_names_are_unique():
    names = [case.name for case in stability_cases.cases()]
    assert len(names) == len(set(names))


@pytest.mark.parametrize("name", ["bond stretched by 20 %", "granular, packing overlaps by 30 %", "hertz, collision"])
def test_a_case_as_the_report_runs_it(lmp, tmp_path, name):
    """adaptive and half the critical step are right, twice the critical step is not silent; a law that cannot hold stops"""
    case, = [case for case in stability_cases.cases() if case.name == name]
    runs = {outcome.label: outcome for outcome in stability.run_case(case, tmp_path, True)}
    assert list(runs) == ["adaptive", "0.5", "0.9", "1.1", "2"]
    assert runs["2"].verdict in ("warns", "stops")
    if "granular" in name:
        assert {run.verdict for run in runs.values()} == {"stops"}
        assert "not beyond the smallest distance" in runs["2"].message
    else:
        assert runs["adaptive"].verdict == "right"
    if "bond" in name:    # two masses of 1 and a spring 1.2 times as stiff as at rest: 2 / omega
        stiffness = 1.2 * 1000.0 * formulas.section(1.0, 0.5)
        assert runs["2"].step == pytest.approx(2 * 2 / (2 * stiffness) ** 0.5, rel=1e-3)


def test_page_parts():
    def outcome(label, fraction, output, status=0):
        case = shared
        return stability.judge(case, label, fraction, fraction, Run(Path(), status, output), 2.0)

    shared = stability_cases.Case("made up", "the case", "")
    outcomes = [outcome("adaptive", 0.1, log(SOUND)), outcome("0.5", 0.5, log(SOUND)), outcome("0.9", 0.9, log(SOUND, before=OURS)),
                outcome("1.1", 1.1, log(WRONG, before=OURS)), outcome("2", 2.0, log(WRONG))]
    cases = stability_page.by_case(outcomes)
    assert len(cases) == 1
    table = stability_page.matrix(cases)
    assert "| the case | 1 | right 5 % | right 5 % | right, warns 5 % | warns 50 % | **SILENT NONSENSE** 50 % |" in table
    assert "| the case | 0.9 | step 30: warning: *The contact of atoms 1 and 2" in stability_page.signs(cases)
    counts = stability_page.counts(outcomes)
    assert "| right | the ledger closes, all particles are where they can be, nothing is said | 2 |" in counts
    assert "| SILENT NONSENSE | wrong without a word | 1 |" in counts
