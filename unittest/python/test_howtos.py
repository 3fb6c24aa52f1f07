# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""The how-to pages but that of grains: every script runs as it stands there, and shows what its page says."""

import re

import numpy as np
import pytest

from potdem import dumps, logs
from potdem.paths import DOCS
from potdem.scenes import resume
from potdem.text import replaced

BLOCK = re.compile(r"^`(\w+\.lmp)`\n\n```LAMMPS\n(.*?)^```$", re.MULTILINE | re.DOTALL)
NAMES = {"body": ["bar"], "walls": ["piston", "shaker", "drum"], "parallel": ["balance"], "restart": ["tower"],
         "translate": ["bpm", "truss", "granular", "hertz"], "mixed": ["mixed"]}


def scripts(page):
    return dict(BLOCK.findall((DOCS / f"howto_{page}.md").read_text(encoding="utf-8")))


SCRIPTS = {name: text for page in NAMES for name, text in scripts(page).items()}


@pytest.fixture
def run(run_lammps):
    return lambda name, **more: run_lammps(SCRIPTS[f"{name}.lmp"], **more)


def of_last_run(done):
    return logs.thermo(done.log or done.stdout, last=True)


@pytest.mark.parametrize("page", NAMES)
def test_every_block_is_a_script_with_a_name(page):
    assert (DOCS / f"howto_{page}.md").read_text(encoding="utf-8").count("```LAMMPS\n") == len(scripts(page))
    assert [f"{name}.lmp" for name in NAMES[page]] == list(scripts(page))


@pytest.mark.parametrize("words, row", [({}, (0.79, 1.013, 0.96)), ({"area": "lattice"}, (0.94, 0.909, 0.90)),
                                        ({"reach": 1.42}, (0.61, 1.026, 1.02))])
def test_bar_has_the_numbers_of_the_table(run_lammps, words, row):
    """rounded as printed; the strength is that of the first bonds of a brittle bar. The modulus: the solid's, within what area body and
    its beams of five particles are worth; area lattice: 0.908 of area.md"""
    done = run_lammps(replaced(SCRIPTS["bar.lmp"], "thermo          80", "thermo          10"), vars=words)
    thermo = of_last_run(done)
    critical = float(re.search(r"^The critical step is above (\S+)", done.stdout, re.MULTILINE).group(1))
    half = thermo["v_strain"].searchsorted(0.5 * thermo["v_strain"][-1])
    assert critical == pytest.approx(row[0], abs=0.006)
    assert thermo["v_modulus"][half] == pytest.approx(row[1], abs=0.002)
    assert thermo["v_modulus"][half] == pytest.approx(0.908 if "area" in words else 1.0, abs=0.03)
    assert thermo["v_strength"].max() == pytest.approx(row[2], abs=0.01)
    assert thermo["f_cracks"][-1] > 100


def test_piston(run):
    """force in equilibrium, near E A times the shortening over 10 spacings; work: half of force times way, and more by what bounces"""
    thermo = run("piston").thermo
    force, work = thermo["f_piston[3]"][-1], thermo["c_ledger[10]"][-1]
    assert force == pytest.approx(-thermo["f_floor[3]"][-1], rel=0.005)
    assert 1.0 < force / (3e7 * 0.025**2 * 1e-4 / 0.05) < 1.1
    assert force == pytest.approx(40.6, abs=0.1)
    assert work == pytest.approx(0.5 * force * 1e-4, rel=0.005)
    assert np.ptp(thermo["c_ledger"]) < 0.001 * work


@pytest.mark.parametrize("amplitude, jumps", [(0.0005, False), (0.001, True)])
def test_shaker(run, amplitude, jumps):
    """a grain leaves a table whose acceleration is beyond that of gravity; the first cycle has the transient of the start"""
    assert (amplitude * (2 * np.pi * 20)**2 > 9.81) == jumps
    gap = run("shaker", vars={"amplitude": amplitude}).thermo["v_gap"]
    assert 0.5 < gap.max() < 1.5 if jumps else gap[1:].max() < 0


def test_drum(run):
    """work: angular velocity times the sum of the mean torques over 0.1 s"""
    thermo = run("drum").thermo
    assert thermo["c_ledger[10]"][-1] == pytest.approx(-np.pi * 0.1 * thermo["f_torque"][1:].sum(), rel=0.002)
    assert thermo["c_ledger[10]"][-1] == pytest.approx(0.186, abs=0.01)
    assert thermo["v_side"].min() < -25
    assert np.ptp(thermo["c_ledger"][1:]) < 0.002 * thermo["c_ledger[10]"][-1]


def test_balance(run, run_lammps):
    """rounding grows with the contacts: at 0.05 s it is still small. In a corner of the box all are on half of the ranks, or fewer"""
    alone, shared = (of_last_run(run("balance", nprocs=n)) for n in (1, 2))
    assert shared["f_share"][-1] < 1.1
    assert shared["KinEng"][1] == pytest.approx(alone["KinEng"][1], rel=1e-6)
    script = re.sub(r"fix +share.*\n|comm_style.*\n| f_share", "", SCRIPTS["balance.lmp"])
    mean, most = map(float, re.search(r"^Nlocal: +(\S+) ave +(\S+) max", run_lammps(script, nprocs=4).stdout, re.MULTILINE).groups())
    assert most / mean == pytest.approx(2.67, abs=0.05)


def test_bar_of_bpm_and_of_trusses(run):
    """before the first failure; 0.5 e of the truss's strain is a thousandth"""
    theirs, ours = (run(name).thermo for name in ("bpm", "truss"))
    before = slice(1, 3)
    assert ours["c_pulled"][before] == pytest.approx(theirs["c_pulled"][before], rel=1e-3)
    assert ours["Bonds"][0] == theirs["Bonds"][0] and ours["Bonds"][2] == ours["Bonds"][0]
    assert ours["Bonds"][-1] < 0.8 * ours["Bonds"][0]


def test_grain_of_granular_and_of_hertz(run):
    theirs, ours = (run(name).thermo for name in ("granular", "hertz"))
    assert ours["c_mean[2]"][6] == pytest.approx(theirs["c_mean[2]"][6], rel=1e-4)
    assert ours["c_mean[2]"][6] == pytest.approx(0.239, abs=0.0005)
    assert ours["c_mean[3]"][-1] == pytest.approx(43.8, abs=0.1)
    assert theirs["c_mean[3]"][-1] == pytest.approx(41.5, abs=0.1)
    # half of the speed of a fall by 15 mm, less gravity since it left. Contact: an elastic one after Hertz, up to half as long again
    fall, mass, radius, modulus = np.sqrt(2 * 9.81 * 0.015), 2500 * np.pi / 6 * 0.01**3, 0.005, 5e6 / (2 * (1 - 0.3**2))
    contact = 2.87 * (mass**2 / (radius * modulus**2 * fall))**0.2
    earliest, latest = (0.5 * fall - 9.81 * (0.06 - fall / 9.81 - factor * contact) for factor in (0.7, 1.5))
    assert earliest < ours["c_mean[2]"][6] < latest


@pytest.mark.parametrize("nprocs", [1, 2])
def test_bonded_body_with_granular(run, run_lammps, nprocs):
    """what the ledger misses is what POTDEM's law of the same impacts dissipates, within 2 % (the springs that slip differ)"""
    mixed = run("mixed", nprocs=nprocs)
    assert "beyond" not in mixed.stdout and "shorter than a bond length" not in mixed.stdout
    own = re.sub(r"pair_style .*\n(pair_coeff.*\n)+", "pair_style potdem/hertz rotation yes\n"
                 "pair_coeff * * 3e6 0.3 restitution 0.5 friction 0.3 mindlin damping 0.3\n", SCRIPTS["mixed.lmp"])
    ours = run_lammps(own, nprocs=nprocs).thermo
    assert np.ptp(ours["c_ledger"]) < 1e-5 * ours["c_ledger"][0]
    lost = mixed.thermo["c_ledger"][0] - mixed.thermo["c_ledger"][-1]
    assert lost == pytest.approx(ours["c_ledger[7]"][-1] + ours["c_ledger[8]"][-1], rel=0.02)
    assert np.all(mixed.thermo["c_ledger[7]"] == 0) and np.all(mixed.thermo["c_ledger[8]"] == 0)
    # component 4 is small: no contact of the beam with itself
    assert mixed.thermo["c_ledger[4]"].max() < 1e-9


def test_bonds_fail_beside_granular(run_lammps):
    thermo = run_lammps(replaced(SCRIPTS["mixed.lmp"], "run             6000", "run             4500"), vars={"strength": 3e4}).thermo
    assert thermo["Bonds"][-1] < thermo["Bonds"][0] - 200


# --- stop and go on --------------------------------------------------------------------------------------------------------------

END = "\nwrite_dump all custom end.dump id x y z vx vy vz modify sort id format float %.17g\n"
LAST_RUN = "run             10000 upto"


@pytest.fixture
def tower(run_lammps, tmp_path):
    """in a folder, from a restart file if one is given; (thermo output, all digits of the last state)"""
    def start(folder, runs="run 5000 upto", file=None, **more):
        (tmp_path / folder).mkdir(exist_ok=True)
        variables = ({} if file is None else {"resume": file}) | more.pop("vars", {})
        done = run_lammps(replaced(SCRIPTS["tower.lmp"], LAST_RUN, runs) + END, cwd=tmp_path / folder, vars=variables, **more)
        return done.thermo, (tmp_path / folder / "end.dump").read_text(encoding="utf-8")
    return start


@pytest.mark.parametrize("nprocs", [1, 2])
def test_tower_goes_on_to_the_last_bit(tower, tmp_path, nprocs):
    """from both files, without a dump that repeats a frame where it was cut; bodies break before and after"""
    thermo, end = tower("whole", nprocs=nprocs)
    assert 0 < thermo["f_cracks"][1] < thermo["f_cracks"][-1] and thermo["Step"][-1] == 5000
    for name, step in (("a.restart", 2000), ("b.restart", 4000)):
        again, end_again = tower("rest", file=tmp_path / "whole" / name, nprocs=nprocs)
        assert again["Step"][0] == step and end_again == end
        assert all((again[column] == thermo[column][step // 1000:]).all() for column in thermo)


def test_tower_goes_on_with_the_second_of_two_runs(tower, tmp_path):
    _, end = tower("whole", "run 3000 upto\nwrite_restart between.restart\nrun 5000 upto")
    assert tower("rest", file=tmp_path / "whole" / "between.restart")[1] == end


def test_tower_goes_on_on_other_ranks_up_to_rounding(tower, tmp_path):
    """over 100 steps in which bonds fail: 1e-15 of each step's sums grows by what contacts and failures add"""
    tower("whole", "run 1500 upto", vars={"restart": 500})
    step = tmp_path / "whole" / "b.restart"
    one, other = (tower(f"on-{nprocs}", "run 1100 upto", file=step, nprocs=nprocs)[0] for nprocs in (1, 2))
    assert one["Step"][0] == 1000 and one["f_cracks"][-1] == other["f_cracks"][-1] > one["f_cracks"][0]
    assert other["KinEng"][-1] == pytest.approx(one["KinEng"][-1], rel=1e-6)


def test_tower_ends_in_time_and_goes_on(tower, tmp_path):
    """a job that would take an hour has a second; the next one comes to the same state"""
    _, end = tower("first", "run 20000000 upto", vars={"limit": "0:00:01", "restart": 100})
    stopped = dumps.read(tmp_path / "first" / "end.dump")[0].step
    file, step = resume.newest([tmp_path / "first" / name for name in ("a.restart", "b.restart")])
    assert 0 < step <= stopped < 20000000
    assert tower("next", f"run {stopped} upto", file=file, vars={"restart": 100})[1] == end


def test_files_that_were_damaged_are_refused_and_named_as_the_page_does(tower, run_lammps, tmp_path):
    tower("whole", "run 100 upto", vars={"restart": 50})
    file = tmp_path / "whole" / "b.restart"
    data = file.read_bytes()
    page = " ".join((DOCS / "howto_restart.md").read_text(encoding="utf-8").split())
    file.write_bytes(data[:len(data) // 2])
    error = run_lammps(SCRIPTS["tower.lmp"], vars={"resume": file}, expect_error="").error
    assert f"*{error}*" in page
    # of a coefficient's text
    place = data.index(b"PTDM") + 20
    file.write_bytes(data[:place] + bytes([data[place] ^ 1]) + data[place + 1:])
    assert "damaged" in run_lammps(SCRIPTS["tower.lmp"], vars={"resume": file}, expect_error="").error
