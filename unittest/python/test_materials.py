# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Material files: the same as the numbers in the script, for every style; units; the bundled files; errors."""

import re
from pathlib import Path

import numpy as np
import pytest

from potdem import dumps, formulas, scripts
from potdem.text import replaced

ROOT = Path(__file__).resolve().parent.parent.parent
BUNDLED = sorted((ROOT / "potentials").glob("*.potdem"))

SOFT = {"E": 500.0, "nu": 0.22, "density": 1.25, "tension": 40.0, "compression": 75.0, "friction": 0.3}
HARD = {"E": 3200.0, "nu": 0.4, "density": 2.5, "friction": 0.7}
PLAIN = {"E": 500.0}
MATERIALS = {"soft": SOFT, "hard": HARD, "plain": PLAIN}

# per style: what follows the materials of a file, and the same in numbers of a material
LENGTH = 0.125    # a power of two: E L has no rounding
CONTACTS = {
    "truss": ("0.6 penetration 3", "{E} 0.6 penetration 3"),
    "truss/omp": ("0.6", "{E} 0.6"),
    "hertz": ("viscous 0.01", "{E} {nu} viscous 0.01"),
    "granular": (f"length {LENGTH} 4 0.6", "{K0} 4 0.6"),
    "lj": (f"length {LENGTH} 0.4 2 0.6", "{K0} 0.4 2 0.6"),
}
CLUSTER = [(0, 0, 0, 1.0, 1), (0.9, 0.1, 0, 1.2, 2), (0.2, 0.95, 0.1, 1.0, 1),
           (0.5, 0.3, 0.6, 0.9, 2), (-0.9, 0.2, 0.1, 1.1, 1)]


def file_text(materials, units="si"):
    lines = [f"# DATE: 2026-01-31 UNITS: {units} COMMENT: for tests", ""]
    for name, properties in materials.items():
        lines += [f"material {name}   # and a comment", *(f"  {key}\t{value:.17g}" for key, value in properties.items()), ""]
    return "\n".join(lines)


@pytest.fixture
def own(tmp_path):
    """own.potdem where the scripts run"""
    (tmp_path / "own.potdem").write_text(file_text(MATERIALS))


def numbers(template, material):
    """a line of coefficients with the numbers of a material"""
    return template.format(K0=LENGTH * material["E"], **material)


def cluster(pair_style, pairs):
    """five overlapping particles of two types that slide along each other"""
    threads = "package omp 1\n" if pair_style.endswith("/omp") else ""
    return (threads + scripts.box(20, types=2) + "bond_style none\n" + scripts.particles(CLUSTER) +
            f"pair_style {pair_style}\n{pairs}\n" + scripts.velocities_by_formula(1.0))


def forces(run_lammps, tmp_path, script, nprocs=1):
    run_lammps(script + "\nrun 0\n" + scripts.write_dump("end.dump", "fx fy fz"), nprocs=nprocs)
    table = dumps.read(tmp_path / "end.dump")[0]
    found = scripts.vectors(table, "fx", "fy", "fz")
    assert np.abs(found).max() > 1.0    # there are forces
    return found


@pytest.mark.usefixtures("own")
@pytest.mark.parametrize("nprocs", [1, 2])
@pytest.mark.parametrize("style", CONTACTS)
def test_contacts_of_a_file_are_those_of_its_numbers(run_lammps, tmp_path, style, nprocs):
    """the same coefficients, types 1 and 2 mixed in both: every digit"""
    follows, template = CONTACTS[style]
    by_file = f"pair_coeff * * own.potdem soft hard {follows} friction file 1.5"
    by_number = "\n".join(f"pair_coeff {t} {t} {numbers(template, m)} friction {m['friction']} 1.5"
                          for t, m in ((1, SOFT), (2, HARD)))
    ours = forces(run_lammps, tmp_path, cluster(f"potdem/{style}", by_file), nprocs)
    theirs = forces(run_lammps, tmp_path, cluster(f"potdem/{style}", by_number), nprocs)
    assert (ours == theirs).all()


@pytest.mark.usefixtures("own")
def test_friction_of_the_file_only_where_the_script_asks(run_lammps, tmp_path):
    silent = forces(run_lammps, tmp_path, cluster("potdem/hertz", "pair_coeff * * own.potdem soft hard"))
    smooth = forces(run_lammps, tmp_path, cluster("potdem/hertz", "pair_coeff * * own.potdem soft hard friction 0 1.5"))
    rough = forces(run_lammps, tmp_path, cluster("potdem/hertz", "pair_coeff * * own.potdem soft hard friction file 1.5"))
    assert (silent == smooth).all()
    assert np.abs(silent - rough).max() > 0.1


@pytest.mark.usefixtures("own")
def test_a_material_for_a_pair_of_types(run_lammps, tmp_path):
    """I J other than * *: one material, of which both particles are"""
    rest = "pair_coeff 1 1 100 0.1\npair_coeff 2 2 200 0.2\n"
    ours = forces(run_lammps, tmp_path, cluster("potdem/hertz", rest + "pair_coeff 1 2 own.potdem soft friction file auto"))
    theirs = forces(run_lammps, tmp_path, cluster(
        "potdem/hertz", rest + f"pair_coeff 1 2 {SOFT['E']} {SOFT['nu']} friction {SOFT['friction']} auto"))
    assert (ours == theirs).all()


@pytest.mark.usefixtures("own")
def test_a_list_of_materials_replaces_what_was_there(run_lammps, tmp_path):
    """also for pairs of different types, which are mixed again; and a later line replaces it in turn"""
    listed = "pair_coeff * * own.potdem soft hard"
    pure = forces(run_lammps, tmp_path, cluster("potdem/hertz", listed))
    after = forces(run_lammps, tmp_path, cluster("potdem/hertz", f"pair_coeff * * 1e4 0.1\n{listed}"))
    replaced = forces(run_lammps, tmp_path, cluster("potdem/hertz", f"{listed}\npair_coeff 1 2 1e4 0.1"))
    assert (after == pure).all()
    assert np.abs(replaced - pure).max() > 1.0


@pytest.mark.usefixtures("own")
def test_materials_of_two_files(run_lammps, tmp_path):
    (tmp_path / "other.potdem").write_text(file_text({"hard": HARD}))
    one = forces(run_lammps, tmp_path, cluster("potdem/hertz", "pair_coeff * * own.potdem soft hard"))
    two = forces(run_lammps, tmp_path, cluster(
        "potdem/hertz", "pair_coeff * * own.potdem soft NULL\npair_coeff * * other.potdem NULL hard"))
    assert (one == two).all()


@pytest.mark.usefixtures("own")
@pytest.mark.parametrize("style, others", [
    # 2-2 is left to the truss; LAMMPS does not mix two styles, so 1-2 is given
    ("hybrid potdem/hertz potdem/truss", ["pair_coeff * * potdem/truss own.potdem NULL hard 0.6",
                                          "pair_coeff 1 2 potdem/truss 900 0.6"]),
    # LAMMPS mixes no pairs here, and leaves out those that are not set
    ("hybrid/overlay potdem/hertz zero 2.0", ["pair_coeff * * zero"]),
])
def test_hybrid(run_lammps, tmp_path, style, others):
    """against the same styles with numbers for each pair of types"""
    overlay = "overlay" in style
    hertz = "pair_coeff * * potdem/hertz own.potdem soft " + ("hard" if overlay else "NULL")
    by_number = [f"pair_coeff 1 1 potdem/hertz {SOFT['E']} {SOFT['nu']}"]
    if overlay:
        # two equal materials of the mixed contact modulus
        modulus = 1.0 / ((1 - SOFT["nu"]**2) / SOFT["E"] + (1 - HARD["nu"]**2) / HARD["E"])
        by_number += [f"pair_coeff 2 2 potdem/hertz {HARD['E']} {HARD['nu']}",
                      f"pair_coeff 1 2 potdem/hertz {2 * modulus:.17g} 0"]
    else:
        by_number += [f"pair_coeff 2 2 potdem/truss {HARD['E']} 0.6"]
    by_number += [line for line in others if "own" not in line]
    ours = forces(run_lammps, tmp_path, cluster(style, "\n".join([*others[:1], hertz, *others[1:]])))
    theirs = forces(run_lammps, tmp_path, cluster(style, "\n".join(by_number)))
    # the modulus is computed here in another order
    assert np.abs(ours - theirs).max() < 1e-13 * np.abs(theirs).max()


def body(bond, failure, stretch):
    """two bonded particles, drawn apart"""
    script = scripts.box(20) + scripts.particles([(0, 0, 0, 1.0), (1.0, 0, 0, 1.0)])
    script += f"pair_style zero 2.0\npair_coeff * *\nbond_style potdem/truss\nbond_coeff 1 {bond}\n"
    return script + f"""
potdem_bonds all 1 1.2
group right id 2
displace_atoms right move {stretch:.17g} 0 0 units box
fix cracks all potdem/failure 1 {failure}
timestep 1e-9
fix move all nve
thermo_style custom step f_cracks
run 2
"""


@pytest.mark.usefixtures("own")
def test_bond(run_lammps, tmp_path):
    """the tension of a truss of modulus E and section pi/4 (d = 1, a = 0.5)"""
    script = body("own.potdem soft area factor 0.5", "tension 1e9", 0.05).split("fix move")[0]
    found = forces(run_lammps, tmp_path, script)
    tension = formulas.truss_tension(1.05, SOFT["E"] * formulas.section(1.0, 0.5))
    assert found[0] == pytest.approx([tension, 0, 0], rel=1e-12)


@pytest.mark.usefixtures("own")
def test_bond_coefficients_are_kept_as_numbers(run_lammps, tmp_path):
    run_lammps(scripts.box(5) + scripts.crystal() + "pair_style zero 2.0\npair_coeff * *\nbond_style potdem/truss\n"
               "bond_coeff 1 own.potdem soft area body density own.potdem hard\npotdem_bonds all 1 1.5\nwrite_data out.data\n")
    assert "1 500 area body density 2.5\n" in (tmp_path / "out.data").read_text()


@pytest.mark.usefixtures("own")
@pytest.mark.parametrize("which, stress", [("tension", 40.0), ("compression", -75.0)])
@pytest.mark.parametrize("share, broken", [(0.999, 0), (1.001, 1)])
def test_failure(run_lammps, which, stress, share, broken):
    """E eps just below and just above the strength of the material; E is given as a number"""
    stretch = np.sqrt(1.0 + 2.0 * share * stress / SOFT["E"]) - 1.0
    run = run_lammps(body("500 area factor 0.5", f"{which} own.potdem soft", stretch))
    assert run.thermo["f_cracks"][-1] == broken


@pytest.mark.usefixtures("own")
@pytest.mark.parametrize("by_file, by_number", [
    ("own.potdem hard particle own.potdem soft layer none", "3200 0.4 particle 500 0.22 layer none"),
    ("own.potdem hard particle 500 0.22", "3200 0.4 particle 500 0.22"),
    ("3200 0.4 particle own.potdem soft viscous 0.01", "3200 0.4 particle 500 0.22 viscous 0.01"),
    # the more slippery one
    ("own.potdem hard particle own.potdem soft friction file 1.5", "3200 0.4 particle 500 0.22 friction 0.3 1.5"),
    ("own.potdem soft particle own.potdem hard friction file 1.5", "500 0.22 particle 3200 0.4 friction 0.3 1.5"),
    # the one that is named
    ("own.potdem soft particle own.potdem hard friction own.potdem hard 1.5", "500 0.22 particle 3200 0.4 friction 0.7 1.5"),
    ("law truss own.potdem soft 0.6 friction file 1.5", "law truss 500 0.6 friction 0.3 1.5"),
    (f"law granular own.potdem soft length {LENGTH} 4 0.6", f"law granular {LENGTH * 500} 4 0.6"),
])
def test_wall(run_lammps, tmp_path, by_file, by_number):
    scene = (scripts.box(20) + scripts.particles([(0, 0, 0, 1.0)]) + "pair_style none\nbond_style none\n"
             "region floor plane 0 0 -0.4 0 0 1\nvelocity all set 30 0 -10\nfix w all potdem/wall/region floor ")
    ours = forces(run_lammps, tmp_path, scene + by_file)
    theirs = forces(run_lammps, tmp_path, scene + by_number)
    assert (ours == theirs).all()
    assert ("friction" in by_file) == (theirs[0, 0] != 0.0)


@pytest.mark.usefixtures("own")
def test_data_and_restart_files_need_no_material_file(run_lammps, tmp_path):
    pairs = "pair_coeff * * own.potdem soft hard friction file 1.5"
    script = cluster("potdem/hertz", pairs)
    whole = forces(run_lammps, tmp_path, script + "write_data out.data\nwrite_restart out.restart\n")
    (tmp_path / "own.potdem").unlink()
    read_data = ("units si\natom_style bpm/sphere\nboundary f f f\npair_style potdem/hertz\nbond_style none\n"
                 "read_data out.data\n")
    assert "potdem" not in (tmp_path / "out.data").read_text().split("Atoms")[0].replace("# potdem/hertz", "")
    for again in (read_data, "read_restart out.restart\n"):
        # sums of forces in another order, and diameters from 17 digits of densities
        assert np.abs(forces(run_lammps, tmp_path, again) - whole).max() < 1e-12 * np.abs(whole).max()


@pytest.mark.every_style
@pytest.mark.usefixtures("own")
def test_potdem_material_sets_variables(run_lammps):
    run = run_lammps("units si\npotdem_material own.potdem soft E modulus density rho tension ft compression fc nu nu friction mu\n" +
                     scripts.result(*(f"v_{name}" for name in ("modulus", "rho", "ft", "fc", "nu", "mu"))))
    assert scripts.results(run.stdout)[0].tolist() == [
        SOFT[name] for name in ("E", "density", "tension", "compression", "nu", "friction")]
    assert "rho = 1.25, density of soft in own.potdem of 2026-01-31" in run.stdout


# si units of length, mass and time in the other systems (LAMMPS's manual, units command)
IN_SI = {"si": (1.0, 1.0, 1.0), "cgs": (1e-2, 1e-3, 1.0), "micro": (1e-6, 1e-15, 1e-6), "nano": (1e-9, 1e-21, 1e-9)}


@pytest.mark.parametrize("units", IN_SI)
def test_units_are_converted(run_lammps, tmp_path, units):
    """from each system, against the units of length, mass and time; pure numbers stay as they are"""
    script = f"units {units}\n"
    for other in IN_SI:
        (tmp_path / f"{other}.potdem").write_text(file_text({"soft": SOFT}, other))
        script += f"potdem_material {other}.potdem soft E E density r tension t nu nu friction mu\n"
        script += scripts.result("v_E", "v_r", "v_t", "v_nu", "v_mu")
    run = run_lammps(script)
    for other, found in zip(IN_SI, scripts.results(run.stdout), strict=True):
        length, mass, time = (a / b for a, b in zip(IN_SI[other], IN_SI[units], strict=True))
        stress, density = mass / (length * time**2), mass / length**3
        wanted = [SOFT["E"] * stress, SOFT["density"] * density, SOFT["tension"] * stress, SOFT["nu"], SOFT["friction"]]
        assert found == pytest.approx(wanted, rel=1e-14)
        assert (f"converted from {other}" in run.stdout) == (other != units)


def test_other_units_that_agree(run_lammps, tmp_path):
    (tmp_path / "own.potdem").write_text(file_text({"soft": SOFT}, "lj"))
    run = run_lammps("units lj\npotdem_material own.potdem soft E E\n" + scripts.result("v_E"))
    assert scripts.results(run.stdout)[0] == [SOFT["E"]]


def test_where_a_file_is_looked_for(run_lammps, tmp_path, monkeypatch):
    """the path as it is, then the folders of LAMMPS_POTENTIALS; potdem.running adds the bundled ones"""
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    (elsewhere / "mine.potdem").write_text(file_text({"soft": {"E": 7.0}}))

    def modulus(file, material):
        run = run_lammps(f"units si\npotdem_material {file} {material} E E\n" + scripts.result("v_E"))
        return scripts.results(run.stdout)[0][0]

    assert modulus("elsewhere/mine.potdem", "soft") == 7.0
    assert modulus("thesis.potdem", "concrete") == 3e10
    monkeypatch.setenv("LAMMPS_POTENTIALS", str(elsewhere))
    assert modulus("mine.potdem", "soft") == 7.0
    assert modulus("thesis.potdem", "concrete") == 3e10
    (tmp_path / "thesis.potdem").write_text(file_text({"concrete": {"E": 11.0}}))
    assert modulus("thesis.potdem", "concrete") == 11.0


@pytest.mark.usefixtures("own")
def test_in_the_plugin(build, run_lammps, tmp_path):
    script = cluster("potdem/hertz", "pair_coeff * * own.potdem soft hard friction file 1.5")
    plugin = forces(run_lammps, tmp_path, f"plugin load {build}/potdemplugin.so\n{script}")
    assert (plugin == forces(run_lammps, tmp_path, script)).all()


# ---- the bundled files ----

def read_file(path):
    """{material: ({property: value}, comments)}, by the format that docs/materials.md describes"""
    found = {}
    for line in path.read_text(encoding="utf-8").splitlines():
        if match := re.fullmatch(r"material +(\S+)", line):
            found[match.group(1)] = properties, comments = {}, []
        elif found and line.startswith("#"):
            comments.append(line)
        elif found and line.strip():
            name, value = line.split()
            properties[name] = float(value)
    return found


def bundled():
    for path in BUNDLED:
        for name, (properties, comments) in read_file(path).items():
            yield pytest.param(path, name, properties, comments, id=f"{path.stem}-{name}")


# what solids are like; the thesis's soft ones have E from 3e6
RANGES = {"E": (1e6, 1e12), "nu": (0.0, 0.5), "density": (500, 1e4), "tension": (1e5, 1e9), "compression": (1e6, 1e10),
          "friction": (0.05, 1.0)}


@pytest.mark.parametrize("path, name, properties, comments", bundled())
def test_bundled_material(path, name, properties, comments):
    assert comments and comments[0].startswith("# source: "), f"{name} in {path.name} has no source"
    assert {"E", "nu"} <= set(properties)
    for key, value in properties.items():
        least, most = RANGES[key]
        assert least <= value <= most, key
    if "compression" in properties:
        assert properties["compression"] >= properties["tension"]


@pytest.mark.parametrize("path", BUNDLED, ids=lambda path: path.name)
def test_bundled_file_is_read_as_it_stands(run_lammps, path):
    """every material by potdem_material, and by a pair style"""
    materials = read_file(path)
    assert re.match(r"# DATE: \d{4}-\d\d-\d\d UNITS: si ", path.read_text(encoding="utf-8"))
    script, wanted = scripts.box(1, types=len(materials)), []
    for name, (properties, _) in materials.items():
        script += f"potdem_material {path} {name} " + " ".join(f"{key} v{key}" for key in properties) + "\n"
        script += scripts.result(*(f"v_v{key}" for key in properties))
        wanted.append(list(properties.values()))
    script += f"pair_style potdem/hertz\npair_coeff * * {path} {' '.join(materials)}\n"
    run = run_lammps(script)
    found = [[float(word) for word in line.split()[1:]] for line in run.stdout.splitlines() if line.startswith("RESULT ")]
    assert found == wanted


def test_materials_that_the_project_promises():
    common = read_file(ROOT / "potentials" / "common.potdem")
    for name in ("concrete", "steel", "gravel", "seed-grain"):
        assert {"E", "nu", "density", "friction"} <= set(common[name][0]), name
    for name in ("concrete", "steel", "gravel"):
        assert "tension" in common[name][0]


# as the thesis gives them, section by section
THESIS = {
    "impulse-beam": {"E": 5e9, "nu": 0.1, "density": 2400},
    "impact-beam": {"E": 3e6, "density": 2400, "tension": 2e5},
    "impact-block": {"E": 3e7, "density": 7800},
    "impact-plane": {"E": 3e10},
    "concrete": {"E": 3e10, "nu": 0.18, "density": 2300, "tension": 2.7e6},
    "hammer-steel": {"E": 2e11, "density": 8000},
    "hopper-grain": {"E": 3e6, "density": 2000, "friction": 0.3},
    "hopper-wall": {"E": 3e8, "friction": 0.3},
    "cylinder-brittle": {"E": 3e6, "tension": 1e6},
    "cylinder-weak": {"E": 3e6, "tension": 2e5},
    "cylinder-strong": {"E": 3e6, "tension": 2e8},
    "seed-grain": {"E": 2.76e6, "density": 855, "friction": 0.1},
    "seed-box": {"E": 3e8, "friction": 0.1},
    "column-grain": {"E": 3e6, "density": 2000},
    "column-base": {"friction": 0.5},
    "bed-gravel": {"E": 3e10, "density": 1900},
}


def test_thesis_file_has_the_numbers_of_the_thesis_and_says_what_it_assumes():
    file = read_file(ROOT / "potentials" / "thesis.potdem")
    assert set(file) == set(THESIS)
    for name, stated in THESIS.items():
        properties, comments = file[name]
        assert {key: properties[key] for key in stated} == stated, name
        source = " ".join(comments)
        for key in set(properties) - set(stated):
            assert re.search(rf"\b{key}\b[^;]*\(A\)", source), f"{key} of {name} is not from the thesis and not marked"


def test_documentation_lists_the_bundled_materials_as_they_are():
    page = (ROOT / "docs" / "materials.md").read_text(encoding="utf-8")
    for path in BUNDLED:
        part = page.split(f"### {path.name}\n")[1].split("\n#")[0]
        head, *rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in part.splitlines()
                       if line.startswith("| ")]
        listed = {row[0]: {key: float(cell) for key, cell in zip(head[1:7], row[1:7], strict=True) if cell != "–"}
                  for row in rows}
        assert listed == {name: properties for name, (properties, _) in read_file(path).items()}


def test_script_of_the_documentation(run_lammps):
    page = (ROOT / "docs" / "materials.md").read_text(encoding="utf-8")
    script, = re.findall(r"^```LAMMPS\n(.*?)^```$", page, re.MULTILINE | re.DOTALL)
    run = run_lammps(script)
    # every command there says what it took
    for command in ("potdem_material", "bond_coeff potdem/truss", "pair_coeff potdem/hertz", "fix potdem/wall/region",
                    "fix potdem/failure"):
        assert f"{command}: " in run.stdout
    assert run.thermo["Step"][-1] == 20


# ---- errors ----

def pair(line, style="hertz"):
    return cluster(f"potdem/{style}", f"pair_coeff {line}")


BAD = {
    "no such file": (pair("* * mine.potdem soft hard"), ["pair_coeff potdem/hertz", "'mine.potdem'", "LAMMPS_POTENTIALS"]),
    "no such material": (pair("* * own.potdem soft herd"), ["'herd'", "own.potdem", "hard, plain, soft"]),
    "too few": (pair("* * own.potdem soft"), ["each of the 2 atom types", "only 1"]),
    "a keyword for a material": (pair("* * own.potdem soft friction 0.3 auto"), ["'friction'", "each of the 2 atom types"]),
    "too many": (pair("* * own.potdem soft hard plain"), ["'plain' is one too many", "2 atom types"]),
    "none at all": (pair("* * own.potdem NULL NULL"), ["all are NULL"]),
    "property missing": (pair("* * own.potdem soft plain"), ["'plain' in own.potdem has no nu", "add the line"]),
    "friction missing": (pair("* * own.potdem soft plain 0.5 friction file auto", "truss"), ["'plain'", "no friction"]),
    "friction of no material": (pair("1 1 500 0.2 friction file auto"), ["'friction file'", "give a number"]),
    "friction without eta": (pair("1 1 own.potdem soft friction file"), ["pair_coeff potdem/hertz", "missing"]),
    "material left out": (pair("1 1 own.potdem"), ["pair_coeff potdem/hertz", "missing"]),
    "two materials for a pair": (pair("1 2 own.potdem soft hard"), ["'hard'", "viscous, restitution, friction, rolling or twisting"]),
    "NULL for a pair": (pair("1 2 own.potdem NULL"), ["'NULL'", "which has"]),
    "area factor left out": (pair("* * own.potdem soft hard", "truss"), ["pair_coeff potdem/truss", "missing"]),
    "stiffness of a material": (pair("* * own.potdem soft hard 4 0.6", "granular"), ["K0", "'length L'"]),
    "length of zero": (pair("* * own.potdem soft hard length 0 4 0.6", "granular"), ["length L = 0", "> 0"]),
    "later keyword": (pair("* * own.potdem soft hard viscos 1"), ["'viscos'", "viscous, restitution, friction, rolling or twisting"]),
    "bond": (scripts.box(5) + "bond_style potdem/truss\nbond_coeff 1 own.potdem sift area lattice", ["bond_coeff", "'sift'"]),
    "strength": (body("500 area factor 0.5", "compression own.potdem hard", 0.0), ["fix potdem/failure", "'hard'", "no compression"]),
    "wall": (scripts.box(5) + "region r plane 0 0 -1 0 0 1\nfix w all potdem/wall/region r own.potdem hard particle own.potdem plain",
             ["fix potdem/wall/region", "'plain'", "no nu"]),
    "lj units": ("units lj\npotdem_material own.potdem soft E E", ["si units", "lj units", "'units si'", "UNITS: lj"]),
    "real units": ("units real\npotdem_material own.potdem soft E E", ["si units", "real units", "si, cgs, micro and nano"]),
    "not a material file": ("potdem_material own.txt soft E E", ["'own.txt'", ".potdem"]),
    "unknown property": ("units si\npotdem_material own.potdem soft rho r", ["'rho'", "density"]),
    "variable left out": ("units si\npotdem_material own.potdem soft density", ["potdem_material", "missing"]),
    "variable of another kind": ("units si\nvariable r index 1\npotdem_material own.potdem soft density r", ["Cannot redefine", "variable", "style"]),
}


@pytest.mark.usefixtures("own")
@pytest.mark.parametrize("name", BAD)
def test_message(run_lammps, name):
    script, words = BAD[name]
    message = run_lammps(script + "\n", expect_error="").error
    assert not [word for word in words if word not in message], message


BAD_FILES = {
    "no units": (["# DATE: 2026-01-31", "material soft", "E 1"], ["bad.potdem", "does not say its units", "UNITS: si"]),
    "empty": ([""], ["bad.potdem", "does not say its units"]),
    "units of no system": (["# UNITS: mks", "material soft", "E 1"], ["mks units", "si units"]),
    "unknown property": (["# UNITS: si", "material soft", "young 1"], ["material 'soft' in bad.potdem", "'young'", "expected material, E, nu"]),
    "before any material": (["# UNITS: si", "E 1", "material soft"], ["'E 1'", "no material", "'material NAME'"]),
    "no value": (["# UNITS: si", "material soft", "E"], ["material 'soft'", "'E'", "one value"]),
    "two values": (["# UNITS: si", "material soft", "E 1 2"], ["material 'soft'", "'E 1 2'", "one value"]),
    "a word for a value": (["# UNITS: si", "material soft", "E high"], ["material 'soft'", "E must be a number", "'high'"]),
    "E of zero": (["# UNITS: si", "material soft", "E 0"], ["material 'soft'", "E = 0", "> 0"]),
    "nu": (["# UNITS: si", "material soft", "nu 0.6"], ["nu = 0.6", "<= 0.5"]),
    "friction": (["# UNITS: si", "material soft", "friction -1"], ["friction mu = -1", ">= 0"]),
    "density": (["# UNITS: si", "material soft", "density -1"], ["density = -1", "> 0"]),
    "twice the same property": (["# UNITS: si", "material soft", "E 1", "E 2"], ["E is given twice"]),
    "twice the same material": (["# UNITS: si", "material soft", "E 1", "material soft"], ["'soft'", "taken"]),
    "called NULL": (["# UNITS: si", "material NULL", "E 1"], ["'NULL'"]),
}


@pytest.mark.parametrize("name", BAD_FILES)
def test_message_of_a_bad_file(run_lammps, tmp_path, name):
    """on two ranks, of which one has read it: one message"""
    lines, words = BAD_FILES[name]
    (tmp_path / "bad.potdem").write_text("\n".join(lines) + "\n")
    message = run_lammps("units si\npotdem_material bad.potdem soft E E\n", nprocs=2, expect_error="").error
    assert not [word for word in words if word not in message], message


# ---- text that is not as it should be ----

GOOD = b"# DATE: 2026-01-31 UNITS: si\n\nmaterial soft   # a comment\nE 500\nnu 0.22\n"

# the same file, written otherwise: E is 500 and nu 0.22 all the same
SAME = {
    "Windows line ends": replaced(GOOD, b"\n", b"\r\n"),
    "byte-order mark": b"\xef\xbb\xbf" + GOOD,
    "both": b"\xef\xbb\xbf" + replaced(GOOD, b"\n", b"\r\n"),
    "empty line first": b"\n" + GOOD,
    "quotes in comments": replaced(replaced(GOOD, b"a comment", b"the thesis's \"soft\" one"), b"UNITS: si", b"UNITS: si COMMENT: don't"),
    "comment of another encoding": replaced(GOOD, b"a comment", b"b\xe9ton \xff\x01"),
    "first line of another encoding": replaced(GOOD, b"UNITS: si", b"UNITS: si CITATION: M\xfcller"),
    "date of another encoding": replaced(GOOD, b"DATE: 2026-01-31", b"DATE: 3.\xe4"),
    "comment in UTF-8": replaced(GOOD, b"a comment", "Beton, ν = 0,22 – „weich“".encode()),
    "long comment": replaced(GOOD, b"a comment", 20000 * b"long "),
    "long first line": replaced(GOOD, b"UNITS: si", 5000 * b"CITATION: " + b"UNITS: si"),
    "many blanks": replaced(GOOD, b"E 500", 3000 * b" " + b"E" + 3000 * b"\t" + b"500" + 3000 * b" "),
    "many comments": GOOD + 10000 * b"# more\n",
}


def modulus_and_ratio(run_lammps, **more):
    return run_lammps("units si\npotdem_material odd.potdem soft E E nu nu\n" + scripts.result("v_E", "v_nu"), **more)


@pytest.mark.parametrize("nprocs", [1, 2])
@pytest.mark.parametrize("name", SAME)
def test_text_that_is_read_as_what_it_means(run_lammps, tmp_path, name, nprocs):
    (tmp_path / "odd.potdem").write_bytes(SAME[name])
    run = modulus_and_ratio(run_lammps, nprocs=nprocs)
    assert scripts.results(run.stdout).tolist() == [[500.0, 0.22]]
    assert ("of 2026-01-31" in run.stdout) == ("date" not in name)


CUT = ["odd.potdem seems to be cut off in line {}", "end its last line with a newline"]
ODD = {
    "quoted name": (replaced(GOOD, b"material soft", b"material 'soft'"), ["odd.potdem, line 3", "a quote", "without quotes"]),
    "open quote": (replaced(GOOD, b"E 500", b"E \"500"), ["odd.potdem, line 4", "a quote"]),
    "apostrophe": (replaced(GOOD, b"nu 0.22", b"young's 1"), ["odd.potdem, line 5", "a quote"]),
    "cut in a number": (GOOD[:-3], [CUT[0].format(5), CUT[1]]),
    "cut after a number": (GOOD[:-1], [CUT[0].format(5), CUT[1]]),
    "cut in a comment": (GOOD[:40], [CUT[0].format(3), CUT[1]]),
    "cut in Windows text": (replaced(GOOD, b"\n", b"\r\n")[:-1], [CUT[0].format(5), CUT[1]]),
    "no bytes at all": (b"", ["odd.potdem does not say its units"]),
    "UTF-16": (b"\xff\xfe" + GOOD.decode().encode("utf-16-le"), ["odd.potdem has bytes of zero", "UTF-16", "save it as plain text"]),
    "a zero byte": (replaced(GOOD, b"500", b"5\x000"), ["odd.potdem has bytes of zero"]),
    "a zero byte in a comment": (replaced(GOOD, b"a comment", b"a\x00comment"), ["odd.potdem has bytes of zero"]),
    "old Macintosh line ends": (replaced(GOOD, b"\n", b"\r"), ["odd.potdem seems to be cut off in line 1"]),
    "one lost line feed": (replaced(GOOD, b"500\nnu", b"500\rnu"), ["odd.potdem, line 4", "a carriage return", "as on Unix or Windows"]),
    "name of another encoding": (replaced(GOOD, b"soft ", b"b\xe9ton "), ["odd.potdem, line 3", "0xe9", "not printable ASCII"]),
    "no-break space": (replaced(GOOD, b"E 500", "E\u00a0500".encode()), ["odd.potdem, line 4", "0xc2", "special blank"]),
    "minus sign": (replaced(GOOD, b"nu 0.22", "nu −0.1".encode()), ["odd.potdem, line 5", "0xe2", "sign"]),
    "mark in the middle": (GOOD + b"\xef\xbb\xbf" + GOOD, ["odd.potdem, line 6", "0xef"]),
    "control character": (replaced(GOOD, b"E 500", b"E \x1b500"), ["odd.potdem, line 4", "0x1b"]),
    "escape": (replaced(GOOD, b"E 500", b"E\\ 500"), ["odd.potdem, line 4", "unknown keyword 'E\\'"]),
    "long word": (replaced(GOOD, b"500", 100000 * b"5"), ["material 'soft' in odd.potdem, line 4", "too long"]),
    "long line": (replaced(GOOD, b"500", 100000 * b"5 "), ["material 'soft' in odd.potdem, line 4", "too long"]),
    "units of 100000 letters": (replaced(GOOD, b"UNITS: si", b"UNITS: " + 100000 * b"s"), ["odd.potdem does not say its units"]),
    "too large": (GOOD + 100000 * b"# more more\n", ["odd.potdem has more than 1000000 bytes"]),
    "beyond double precision": (replaced(GOOD, b"500", b"1e400"), ["material 'soft' in odd.potdem, line 4", "E = 1e400", "too large or too small"]),
    "below double precision": (replaced(GOOD, b"500", b"1e-400"), ["material 'soft' in odd.potdem, line 4", "E = 1e-400", "too large or too small"]),
    "denormal": (replaced(GOOD, b"500", b"1e-310"), ["material 'soft' in odd.potdem, line 4", "E = 1e-310"]),
    "decimal comma": (replaced(GOOD, b"0.22", b"0,22"), ["material 'soft' in odd.potdem, line 5", "nu must be a number, not '0,22'"]),
    "Fortran exponent": (replaced(GOOD, b"500", b"5d2"), ["material 'soft' in odd.potdem, line 4", "E must be a number, not '5d2'"]),
}


@pytest.mark.parametrize("nprocs", [1, 2])
@pytest.mark.parametrize("name", ODD)
def test_text_that_cannot_be_read(run_lammps, tmp_path, name, nprocs):
    """one error, which names the file, and the line where there is one; it is short and plain text itself"""
    text, words = ODD[name]
    (tmp_path / "odd.potdem").write_bytes(text)
    run = modulus_and_ratio(run_lammps, nprocs=nprocs, expect_error="")
    assert not [word for word in words if word not in run.error], run.error
    assert run.stdout.count("ERROR") == 1
    assert len(run.error) < 500 and run.error.isprintable() and run.error.isascii()


def test_a_folder_is_no_material_file(run_lammps, tmp_path):
    (tmp_path / "odd.potdem").mkdir()
    message = modulus_and_ratio(run_lammps, expect_error="").error
    assert "'odd.potdem'" in message and "can be read" in message


# in units of the other system: stress si 1, cgs 0.1 Pa, micro 1e3 Pa, nano 1e6 Pa
@pytest.mark.parametrize("units, wanted, key, value, word", [
    ("si", "cgs", "E", "1e308", "large"),           # 1e309
    ("nano", "si", "tension", "1e305", "large"),    # 1e311
    ("si", "nano", "E", "1e-305", "small"),         # 1e-311, denormal
    ("cgs", "nano", "compression", "3e-308", "small"),    # 3e-315
    ("si", "micro", "density", "3e-308", "small"),  # 3e-311
])
def test_values_that_other_units_cannot_hold(run_lammps, tmp_path, units, wanted, key, value, word):
    (tmp_path / "odd.potdem").write_text(f"# UNITS: {units}\nmaterial soft\n{key} {value}\n")
    message = run_lammps(f"units {wanted}\npotdem_material odd.potdem soft {key} x\n", nprocs=2, expect_error="").error
    for part in (f"{key} of material 'soft' in odd.potdem", f"is {value.replace('e', 'e+') if '-' not in value else value} in {units} units",
                 f"too {word}", f"in {wanted} units"):
        assert part in message


@pytest.mark.parametrize("units, wanted, value, stress", [("si", "cgs", 1e306, 1e307), ("si", "nano", 3e-301, 3e-307)])
def test_values_that_other_units_just_hold(run_lammps, tmp_path, units, wanted, value, stress):
    (tmp_path / "odd.potdem").write_text(f"# UNITS: {units}\nmaterial soft\nE {value:g}\nfriction 0\nnu 0\n")
    run = run_lammps(f"units {wanted}\npotdem_material odd.potdem soft E E friction mu nu nu\n" + scripts.result("v_E", "v_mu", "v_nu"))
    assert scripts.results(run.stdout)[0] == pytest.approx([stress, 0, 0], rel=1e-14)


@pytest.mark.parametrize("path", BUNDLED, ids=lambda path: path.name)
def test_bundled_files_end_with_a_newline(path):
    assert path.read_bytes().endswith(b"\n")
