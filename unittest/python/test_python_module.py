# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""What LAMMPS's Python module reads from the styles of this package, against what the same run wrote to its log and its
dumps in the same step."""

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from potdem import dumps, logs, running
from potdem.text import replaced

GLOBAL, ATOM, LOCAL = 0, 1, 2            # LMP_STYLE_...
SCALAR, VECTOR, ARRAY = 0, 1, 2          # LMP_TYPE_...
READER = Path(__file__).resolve().parent / "read_by_python.py"
STEPS = 3000

# a block breaks a beam, two grains slide on a rough floor: something of everything is not zero at the end
E, A, MU, ETA, XI = 3e6, 0.4, 0.3, 0.5, 0.02
SCRIPT = f"""
units           si
atom_style      bpm/sphere
boundary        f f f
lattice         sc 0.005
region          box block -20 44 -20 25 -15 30
create_box      1 box bond/types 1
region          beam block 0 14 0 3 0 3
region          block block 10 14 0 3 6 9
create_atoms    1 region beam
create_atoms    1 region block
create_atoms    1 single 18 1 -1
create_atoms    1 single 22 2 -1
set             group all diameter 0.005 mass $(2400*0.005^3)
set             region block vz -3
potdem_bonds    all 1 2.0 diameters
bond_style      potdem/truss
bond_coeff      1 {E} area lattice damping {XI}
pair_style      potdem/truss
pair_coeff      1 1 {E} {A} friction {MU} {ETA}
region          free block 1 INF INF INF INF INF
group           free region free
region          grains block 16 INF INF INF INF INF
group           grains region grains
velocity        grains set 0.4 0.1 0
region          floor plane 0 0 -1.5 0 0 1
fix             move free nve
fix             weight free gravity 9.81 vector 0 0 -1
fix             floor free potdem/wall/region floor 3e10 0.2 particle {E} 0.2 layer none friction 0.4 0.5
fix             cracks all potdem/failure 1 tension 1e5 compression 4e5
fix             pace free potdem/timestep 20 0.2 max 2e-5
fix             damp free potdem/damping 0.05
compute         ledger all potdem/energy
compute         critical free potdem/timestep
compute         strain all potdem/strain/atom
compute         bonds all bond/local dist engpot force b1 b2 b3 b4
compute         pairs all pair/local dist eng force p1 p2 p3 p4 p5 p6 p7
thermo_style    custom step f_cracks f_cracks[*] f_floor f_floor[*] f_pace c_ledger c_ledger[*] c_critical c_critical[*]
thermo_modify   format float %.17g
thermo          {STEPS}
dump            cracks all local {STEPS} cracks.dump f_cracks[*]
dump            bonds all local {STEPS} bonds.dump c_bonds[*]
dump            pairs all local {STEPS} pairs.dump c_pairs[*]
dump            strain all custom {STEPS} strain.dump id c_strain[*]
dump_modify     cracks format float %.17g
dump_modify     bonds format float %.17g
dump_modify     pairs format float %.17g
dump_modify     strain format float %.17g sort id
run             {STEPS}
"""


def global_values(kind, name, length):
    """a scalar and, unless length is 0, a vector"""
    function = f"extract_{kind}"
    yield f"{kind[0]}_{name}", function, [name, GLOBAL, SCALAR]
    for k in range(length):
        # of a fix the module hands out single components
        if kind == "fix":
            yield f"f_{name}[{k + 1}]", function, [name, GLOBAL, VECTOR, k]
    if kind == "compute" and length:
        yield f"c_{name}[*]", "numpy.extract_compute", [name, GLOBAL, VECTOR]


WANTED = [
    *global_values("fix", "cracks", 4), *global_values("fix", "floor", 6), *global_values("fix", "pace", 0),
    *global_values("compute", "ledger", 10), *global_values("compute", "critical", 3),
    ("cracks", "numpy.extract_fix", ["cracks", LOCAL, ARRAY]),
    ("bonds", "numpy.extract_compute", ["bonds", LOCAL, ARRAY]),
    ("pairs", "numpy.extract_compute", ["pairs", LOCAL, ARRAY]),
    ("strain", "numpy.extract_compute", ["strain", ATOM, ARRAY]),
    ("id", "numpy.extract_atom", ["id"]),
    *((f"pair {name}", "extract_pair", [name]) for name in ("E", "a", "mu", "eta")),
    # what a style does not have
    ("damp", "extract_fix", ["damp", GLOBAL, SCALAR]),
    ("pace vector", "extract_fix", ["pace", GLOBAL, VECTOR, 0]),
    ("pair nonsense", "extract_pair", ["nonsense"]),
]


def read(build, folder, script, wanted):
    """{name: value} of a run in a Python of its own"""
    module = logs.lammps_tree() / "python"
    if not (build / "liblammps.so").exists() or not (module / "lammps").exists():
        pytest.skip(f"no Python module of LAMMPS: it wants {build}/liblammps.so, a shared library, and {module}/lammps")
    (folder / "in.test").write_text(script)
    (folder / "wanted.json").write_text(json.dumps(wanted))
    environment = running.environment(PYTHONPATH=str(module),
                                      LD_LIBRARY_PATH=os.pathsep.join([str(build), os.environ.get("LD_LIBRARY_PATH", "")]))
    done = subprocess.run([sys.executable, READER, "in.test", "wanted.json", "found.json"], cwd=folder, env=environment, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL, timeout=300, check=False)
    assert done.returncode == 0, done.stdout[-3000:]
    return json.loads((folder / "found.json").read_text())


@pytest.fixture(scope="module")
def run(build, tmp_path_factory):
    """(what the module gave, the last thermo row, the folder with the dumps)"""
    folder = tmp_path_factory.mktemp("python")
    found = read(build, folder, SCRIPT, WANTED)
    thermo = {name: column[-1] for name, column in logs.thermo((folder / "log.python").read_text()).items()}
    assert thermo["Step"] == STEPS
    return found, thermo, folder


def last_of(path):
    """columns of the last snapshot of a dump"""
    table = dumps.read(path)[-1]
    assert table.step == STEPS
    return table


def test_scalars_and_vectors(run):
    found, thermo, _ = run
    for name in thermo:
        if name == "Step":
            continue
        if name.startswith("c_") and "[" in name:
            stem, number = re.fullmatch(r"(c_\w+)\[(\d+)\]", name).groups()
            value = found[f"{stem}[*]"][int(number) - 1]
        else:
            value = found[name]
        assert value == pytest.approx(thermo[name], rel=1e-15), name
    # each of them has something to say, but for bonds that soften and springs of friction, which are not there, and the work of walls, which
    # do not move
    silent = [name for name, value in thermo.items() if value == 0.0]
    assert silent == ["f_cracks[4]", "c_ledger[10]", "c_ledger[11]"]


@pytest.mark.parametrize("name, columns, rows", [("cracks", 10, 100), ("bonds", 7, 1000), ("pairs", 10, 3)])
def test_local_arrays(run, name, columns, rows):
    found, thermo, folder = run
    table = last_of(folder / f"{name}.dump")
    dumped = np.stack(list(table.values()), axis=1)
    ours = np.array(found[name])
    assert ours.shape == dumped.shape == (len(dumped), columns)
    assert len(dumped) > rows
    assert (ours == dumped).all()
    if name == "cracks":
        assert len(ours) == thermo["f_cracks"]


def test_strain(run):
    found, _, folder = run
    table = last_of(folder / "strain.dump")
    dumped = np.stack(list(table.values()), axis=1)
    ours = np.column_stack([found["id"][:len(found["strain"])], found["strain"]])
    ours = ours[np.argsort(ours[:, 0])]
    assert ours.shape == dumped.shape == (len(dumped), 9)
    assert (ours == dumped).all()
    assert np.abs(ours[:, 1:]).max(axis=0).min() > 0.0


def test_coefficients_of_pairs(run):
    """as the script gives them; row and column 0 are of no type"""
    found, *_ = run
    for name, value in {"E": E, "a": A, "mu": MU, "eta": ETA}.items():
        assert found[f"pair {name}"][1][1] == value
    assert found["pair nonsense"] is None


def test_what_a_style_does_not_have_is_nothing(run):
    found, *_ = run
    assert found["damp"] is None and found["pace vector"] is None


def test_no_failures_are_no_rows(build, tmp_path):
    quiet = replaced(replaced(SCRIPT, "tension 1e5 compression 4e5", "tension 1e9"), f"run             {STEPS}", "run 20")
    quiet = re.sub(r"^dump.*\n", "", quiet, flags=re.MULTILINE)
    found = read(build, tmp_path, quiet, [("cracks", "numpy.extract_fix", ["cracks", LOCAL, ARRAY]),
                                          ("f_cracks", "extract_fix", ["cracks", GLOBAL, SCALAR])])
    assert found == {"cracks": None, "f_cracks": 0.0}
