# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""What examples/run runs, on a small scene of its own."""

import re
import shutil
import subprocess
import sys

import pytest
import vtk_files
import yaml
from PIL import Image

from potdem.scenes.claim import of_draws
from potdem.text import replaced

SCRIPT = """
variable speed index 1.0
print "POTDEM total steps 40"
region box block 0 4 0 4 0 4
lattice sc 1.0
create_box 1 box
create_atoms 1 box
mass 1 1.0
pair_style zero 1.5
pair_coeff * *
comm_modify cutoff 2.0
velocity all set ${speed} 0 0
fix move all nve
variable broken equal step>25
thermo_style custom step ke v_broken
thermo 10
run 20
run 20
print "done" file ${out}/done.txt
"""

SETTINGS = """
title: Atoms that fly on
variants:
  slow: {description: at unit speed}
  fast: {vars: {speed: 2.0}, description: at twice that}
default_variants: [slow]
readings:
  2: slow and fast
reference:
  break_column: v_broken
  columns:
    Step: {all: true, abs: 0}
    KinEng: [{before: first_break, rel: 1.0e-6}, {final: true, rel: 0.1}]
    v_broken: {final: true, rel: 0.1}
"""

PLOT = """
import sys
from pathlib import Path
if __name__ == "__main__":
    assert (Path(sys.argv[1]) / "done.txt").exists()
    Path(sys.argv[2]).write_text("a picture")
"""


CLAIMS = """
from potdem.scenes.claim import Claim
def claims(folder_of):
    return [Claim("2", "atoms fly", "42 m", (folder_of("slow") / "done.txt").read_text().strip(), "no"),
            Claim("1", "atoms are there", "yes", "yes", "yes")]
"""

PAGE = """# Claims
before
<!-- made by examples/run all --update-reference -->
| an | old | table |
<!-- end of the table -->
after
"""

FILM = PLOT + """
from potdem import picture

def draw(axis, frame):
    axis.plot(frame["x"], frame["y"], "o")

FILM = picture.Film("dump.flight", draw, picture.Scale("way", 0, 1, "nothing, m"), (0, 4, 0, 4), (1, (0, 0, 0)))
"""


@pytest.fixture
def examples(project, tmp_path):
    """a tree with a copy of the package and one scene; runs it with the arguments given"""
    scene = tmp_path / "examples" / "flight"
    scene.mkdir(parents=True)
    (scene / "in.flight").write_text(SCRIPT)
    (scene / "scene.yaml").write_text(SETTINGS)
    (scene / "plot.py").write_text(PLOT)

    (scene / "claims.py").write_text(CLAIMS)
    (tmp_path / "docs").mkdir()
    (tmp_path / "docs" / "claims.md").write_text(PAGE)

    def run(*arguments, program="run_scene"):
        return subprocess.run([sys.executable, "-m", f"potdem.scenes.{program}", *arguments], env=project,
                              text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)

    run.scene = scene
    run.page = tmp_path / "docs" / "claims.md"
    return run


@pytest.fixture
def with_reference(examples):
    made = examples("flight", "slow", "fast", "--update-reference")
    assert made.returncode == 0, made.stdout
    return examples


def reference(examples, variant):
    return next(examples.scene.glob(f"log.*.flight.{variant}.g++.1"))


def test_scenes_are_listed(examples):
    text = examples("--list").stdout
    assert "flight: Atoms that fly on" in text and "* slow" in text and "at twice that" in text


def test_a_scene_passes_against_its_own_reference(with_reference):
    run = with_reference("flight")
    assert run.returncode == 0
    assert run.stdout.endswith("5 checks passed, 0 failed\n")
    assert "flight.slow.png" in run.stdout and reference(with_reference, "slow").name in run.stdout


def test_variants_and_ranks(with_reference):
    run = with_reference("flight", "slow", "fast", "-np", "2")
    assert run.returncode == 0, run.stdout
    assert run.stdout.endswith("10 checks passed, 0 failed\n")
    assert "there is no reference" in run.stdout and "fast.np2" in run.stdout


def test_a_changed_reference_fails(with_reference):
    log = reference(with_reference, "slow")
    log.write_text(replaced(log.read_text(), "        10   0.5", "        10   0.6"))
    run = with_reference("flight")
    assert run.returncode == 1
    assert "FAIL" in run.stdout and run.stdout.endswith("4 checks passed, 1 failed\n")


def test_an_error_of_lammps_is_shown(examples):
    (examples.scene / "in.flight").write_text("units si\npair_style no/such/style\n")
    run = examples("flight")
    assert run.returncode == 1
    assert "ERROR: Unrecognized pair style 'no/such/style'" in run.stdout and "log.running" in run.stdout


@pytest.mark.parametrize("arguments, message", [(["fligth"], "no scene 'fligth'; there are: flight"),
                                                (["flight", "high"], "has no variant 'high'; there are: slow, fast"),
                                                (["flight", "slow.drawn"], "has no variant 'slow.drawn'"),
                                                (["flight"], "no reference log")])
def test_what_does_not_exist_is_named(examples, arguments, message):
    run = examples(*arguments)
    assert run.returncode == 1
    assert message in run.stdout


def test_all_scenes_and_their_claims(with_reference):
    run = with_reference(program="run_all")
    assert run.returncode == 0, run.stdout
    assert "| 1 | atoms are there | yes |  | yes | yes |\n| 2 | atoms fly | 42 m | slow and fast | done | no |" in run.stdout
    assert run.stdout.endswith("1 runs; 5 checks passed, 0 failed\n")


def test_the_page_of_the_claims_is_written_when_references_are(with_reference):
    assert with_reference(program="run_all").returncode == 0
    assert with_reference.page.read_text() == PAGE
    log = reference(with_reference, "slow")
    log.write_text(replaced(log.read_text(), "        10   0.5", "        10   0.6"))
    assert with_reference("--update-reference", program="run_all").returncode == 0
    assert "        10   0.5" in log.read_text()
    text = with_reference.page.read_text()
    assert text.startswith("# Claims\nbefore\n<!-- made by") and text.endswith("<!-- end of the table -->\nafter\n")
    assert "| [2](../examples/flight/README.md) | atoms fly | 42 m | slow and fast | done | no |" in text and "an | old" not in text


def test_an_animation_and_files_for_paraview_show_every_frame(with_reference):
    (with_reference.scene / "plot.py").write_text(FILM)
    (with_reference.scene / "in.flight").write_text(replaced(
        replaced(SCRIPT, "custom step", "custom step time"), "run 20\nrun 20", "dump d all custom 10 ${out}/dump.flight id x y z\nrun 40"))
    (with_reference.scene / "scene.yaml").write_text(SETTINGS + "    Time: {all: true, rel: 1e-9}\n")
    run = with_reference("flight", "--animate", "--paraview", "--update-reference")
    assert run.returncode == 0, run.stdout
    film = Image.open(re.search(r"^film: +(.*)$", run.stdout, re.MULTILINE).group(1))
    assert film.n_frames == 5
    series = vtk_files.series(re.search(r"^frames: +(.*)$", run.stdout, re.MULTILINE).group(1))
    assert [time for time, _ in series] == pytest.approx([0, 0.05, 0.1, 0.15, 0.2])
    last = series[-1][1]["particles"]
    assert last.points.shape == (64, 3) and sorted(last.data["id"]) == list(range(1, 65)) and len(last.cells("Verts")) == 64


def test_a_scene_without_a_film_says_so(with_reference):
    run = with_reference("flight", "--animate")
    assert run.returncode == 1 and "flight has no animation" in run.stdout


def test_scenes_may_have_modules_of_the_same_name(with_reference):
    """each scene's claims read their own"""
    other = shutil.copytree(with_reference.scene, with_reference.scene.parent / "gliding")
    for scene, claim in ((with_reference.scene, "3"), (other, "4")):
        (scene / "scan.py").write_text(f"NUMBER = '{claim}'\n")
        (scene / "claims.py").write_text("from pathlib import Path\nfrom potdem.scenes.claim import Claim\n"
                                         "from potdem.scenes.scene import beside\nscan = beside(__file__, 'scan')\n"
                                         "def claims(folder_of):\n"
                                         "    return [Claim(scan.NUMBER, Path(__file__).parent.name, '', '', 'yes')]\n")
    for file in list(other.glob("*flight*")):
        file.rename(file.parent / replaced(file.name, "flight", "gliding"))
    run = with_reference(program="run_all")
    assert run.returncode == 0, run.stdout
    assert "| 3 | flight |" in run.stdout and "| 4 | gliding |" in run.stdout


DRAWS = """
from potdem.scenes.claim import Claim, of_draws
def claims(folder_of):
    seeds = [int((folder_of("slow", draw=draw) / "seed.txt").read_text()) for draw in (1, 2, 3)]
    return [Claim("1", "seeds", "1, 2, 3", str(seeds), of_draws(seed > 1 for seed in seeds))]
"""


def test_draws_are_run_with_seeds_of_their_own_and_without_references(with_reference):
    (with_reference.scene / "in.flight").write_text("variable seed index 1\n" + SCRIPT + 'print "${seed}" file ${out}/seed.txt\n')
    (with_reference.scene / "scene.yaml").write_text(replaced(
        replaced(SETTINGS, "vars: {speed: 2.0}", "vars: {speed: 2.0}, draws: 1"), "default_variants: [slow]",
        "draws: 3\nall_variants: [slow, fast]"))
    (with_reference.scene / "claims.py").write_text(DRAWS)
    before = sorted(with_reference.scene.glob("log.*"))
    run = with_reference("--update-reference", program="run_all")
    assert run.returncode == 0, run.stdout
    assert run.stdout.endswith("4 runs; 12 checks passed, 0 failed\n")
    assert "| 1 | seeds | 1, 2, 3 |  | [1, 2, 3] | partly: 2 of 3 draws |" in run.stdout
    assert sorted(with_reference.scene.glob("log.*")) == before
    again = with_reference("flight", "slow.draw2")
    assert again.returncode == 0 and "flight.slow.draw2" in again.stdout and "compared with nothing" in again.stdout


def test_a_draw_that_fails_leaves_out_the_claims(with_reference):
    (with_reference.scene / "scene.yaml").write_text(SETTINGS + "draws: 2\n")
    (with_reference.scene / "in.flight").write_text("variable seed index 1\n" + SCRIPT +
                                                    'if "${seed} == 2" then "pair_style no/such/style"\n')
    run = with_reference(program="run_all")
    assert run.returncode == 1 and run.stdout.endswith("2 runs; 5 checks passed, 1 failed\n")
    assert "flight.slow.draw2" in run.stdout and "claims of flight are left out" in run.stdout


def test_verdicts_of_several_draws_become_one():
    assert of_draws([True, True, True]) == "yes" and of_draws([False, False]) == "no"
    assert of_draws([True, False, True]) == "partly: 2 of 3 draws"


def test_a_failed_run_is_told_and_leaves_out_its_claims(with_reference):
    (with_reference.scene / "in.flight").write_text("units si\npair_style no/such/style\n")
    run = with_reference(program="run_all")
    assert run.returncode == 1
    assert "Unrecognized pair style 'no/such/style'" in run.stdout and "claims of flight are left out" in run.stdout
    assert "atoms fly" not in run.stdout


def test_every_scene_has_references_for_what_it_runs(root):
    """for one rank, and for four of at least one variant; contact-laws has two particles"""
    for scene in sorted((root / "examples").glob("*/scene.yaml")):
        settings = yaml.safe_load(scene.read_text())
        names = settings.get("all_variants") or settings.get("default_variants") or list(settings.get("variants", {"": 0}))[:1]
        for name in names:
            label = f"{scene.parent.name}.{name}" if name else scene.parent.name
            assert list(scene.parent.glob(f"log.*.{label}.g++.1")), f"no reference log of {label}"
        if scene.parent.name != "contact-laws":
            assert list(scene.parent.glob("log.*.g++.4")), f"no reference log of {scene.parent.name} on 4 ranks"


def test_the_page_of_the_claims_has_all_eleven(root):
    rows = re.findall(r"^\| \[(\d+)\w?\]\(\.\./examples/[\w-]+/README\.md\) \|.*\| *(?:yes|no|partly).*\|$",
                      (root / "docs" / "claims.md").read_text(), re.MULTILINE)
    assert sorted(set(map(int, rows))) == list(range(1, 12))
