# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""The wrong scripts of ../wrong-scripts.yaml, each on one rank and on two: LAMMPS stops by itself and says what is wrong."""

import os
import re
from concurrent.futures import ThreadPoolExecutor

import pytest
import yaml

from potdem import running
from potdem.paths import ROOT

CATALOGUE = yaml.safe_load((ROOT / "unittest" / "wrong-scripts.yaml").read_text(encoding="utf-8"))
BEGIN = "---- after the prelude ----"
LIMIT = 300    # seconds; the longest takes one or two on a quiet machine, and fifty times that under the sanitizers on a busy one


def cases(kind):
    return [(kind, name, ranks) for name, entry in CATALOGUE[kind].items() for ranks in entry.get("ranks", [1, 2])]


def title(case):
    return f"{case[1]}-{case[2]}"


def prelude(name):
    def lines(match):
        return prelude(match.group(1)).rstrip("\n")

    return re.sub(r"^\{(.*)\}$", lines, CATALOGUE["preludes"][name], flags=re.MULTILINE)


def script(entry):
    before = prelude(entry["after"]) if "after" in entry else ""
    return f'{before}print "{BEGIN}"\n{entry["lines"].rstrip()}\n'


def run(case, folder, lmp):
    kind, name, ranks = case
    text = script(CATALOGUE[kind][name])
    folder.mkdir(parents=True)
    for file, content in CATALOGUE["files"].items():
        if file in text:
            (folder / file).write_text(content, encoding="utf-8")
    return running.run(text, {}, folder, ranks, limit=LIMIT, lmp=lmp)


@pytest.fixture(scope="module")
def ended(request, lmp, tmp_path_factory):
    """case -> what will have become of its run. To start MPI and to end it is mostly to wait: there are more at a time than cores"""
    folder = tmp_path_factory.mktemp("wrong")
    chosen = [item.callspec.params["case"] for item in request.session.items if "ended" in item.fixturenames]
    with ThreadPoolExecutor(4 * len(os.sched_getaffinity(0))) as pool:
        yield {case: pool.submit(run, case, folder / f"{number}", lmp) for number, case in enumerate(chosen)}
        pool.shutdown(cancel_futures=True)


def errors(text):
    """each on one line"""
    found = re.findall(r"^ERROR[^:\n]*: (.*?)(?:\s\(\S*:\d+\)|\nLast (?:input|command)|\Z)", text, re.MULTILINE | re.DOTALL)
    return [" ".join(one.split()) for one in found]


@pytest.mark.parametrize("case", cases("wrong"), ids=title)
def test_says(ended, case):
    _, name, ranks = case
    done = ended[case].result()
    # of several ranks one may be heard before the other (test_right has the preludes)
    before, _, after = done.stdout.partition(BEGIN)
    assert BEGIN in done.stdout and (ranks > 1 or "ERROR" not in before), f"the prelude fails:\n{done.stdout[-3000:]}"
    # 1 is LAMMPS's own exit; a signal is negative or above 128, a run that hangs is killed
    assert done.status == 1, done.stdout[-3000:]
    said = errors(before + after)
    # what one rank finds it says alone; several may find it at once
    assert 1 <= len(said) <= (ranks if "ERROR on proc" in done.stdout else 1), said
    for one in said:
        missing = [word for word in CATALOGUE["wrong"][name]["says"] if word not in one]
        assert not missing, f"{missing} not in: {one}"
        assert one.isprintable() and len(one) < 500
    numbers = re.findall(r"^\s+\d+( .*)$", done.stdout, re.MULTILINE)
    assert not re.search(r"\bnan\b", "".join(numbers)), numbers


@pytest.mark.parametrize("case", cases("right"), ids=title)
def test_right(ended, case):
    done = ended[case].result()
    assert done.ended_well, done.stdout[-3000:]


def test_catalogue():
    """every prelude is used and tried alone; entries have words, and files are read"""
    used = {entry.get("after") for entry in CATALOGUE["wrong"].values()}
    tried = {entry["after"] for entry in CATALOGUE["right"].values()}
    named = set(re.findall(r"^\{(.*)\}$", "\n".join(CATALOGUE["preludes"].values()), re.MULTILINE))
    assert used - {None} <= set(CATALOGUE["preludes"]) and set(CATALOGUE["preludes"]) == tried | named
    texts = [script(entry) for entry in [*CATALOGUE["wrong"].values(), *CATALOGUE["right"].values()]]
    assert all(any(file in text for text in texts) for file in CATALOGUE["files"])
    assert all(entry["says"] and all(entry["says"]) for entry in CATALOGUE["wrong"].values())
    assert len(CATALOGUE["wrong"]) >= 120
