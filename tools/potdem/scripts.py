# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""LAMMPS input that tests and reports share, and readers of what it prints."""

import re

import numpy as np

from potdem import lattices

ALL_DIGITS = "%.17g"


def table_of_laws(root, kind):
    """the rows of law_list.h from which the styles of this kind are made"""
    listed = {"pair": "CONTACT_LAWS", "bond": "BOND_LAWS"}[kind]
    (block,) = re.findall(rf"#define {listed}\(X\)((?:.*\\\n)*.*)", (root / "src" / "core" / "laws" / "law_list.h").read_text())
    return block


def laws_of(root, kind):
    """[(name, law)] of the styles of this kind, in the order of law_list.h"""
    return re.findall(r"X\((\w+), (\w+)\)", table_of_laws(root, kind))


def registered_styles(root):
    """(kind, name) of each style of the package: the rows of potdem_styles.h, and of the lists of laws from which it makes some"""
    rows = r"^(\w+)Style\((\S+?),"
    table = (root / "src" / "lammps" / "potdem_styles.h").read_text()
    found = [(kind.lower(), name) for kind, name in re.findall(rows, table, re.MULTILINE)]
    for kind, pattern in re.findall(r"^  (\w+)Style\((potdem/name\S*?),", table, re.MULTILINE):
        found += [(kind.lower(), pattern.replace("name", name)) for name, _ in laws_of(root, kind.lower())]
    return found


def of_page(page):
    """name -> text of the scripts of a page whose name stands above them, in its order"""
    return dict(re.findall(r"^`(\w+\.lmp)`\n\n```LAMMPS\n(.*?)^```$", page.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL))


def box(size, boundary="f f f", types=1, bond_types=1, newton=None, units="si", atom_style="bpm/sphere", skin=0.3,
        centre=0.0, room=0):
    """an empty box, size a number or three, its centre at a place on the diagonal; room: for bonds that do not come from
    potdem_bonds, per atom"""
    half = 0.5 * np.broadcast_to(np.asarray(size, dtype=float), 3)
    sides = " ".join(f"{centre - h:.17g} {centre + h:.17g}" for h in half)
    bonded = atom_style.startswith("bpm")
    return "\n".join([
        f"units {units}",
        f"newton {newton}" if newton else "",
        f"atom_style {atom_style}",
        f"boundary {boundary}",
        f"region box block {sides} units box",
        f"create_box {types} box" + (f" bond/types {bond_types}" if bond_types and bonded else "") +
        (f" extra/bond/per/atom {room} extra/special/per/atom 100" if room else ""),
        f"neighbor {skin} bin",
        "neigh_modify delay 0 every 1 check yes",
        "thermo_modify format float %.17g lost error flush yes",
        "",
    ])


def particles(rows, density=1.0):
    """rows of (x, y, z, diameter) or (x, y, z, diameter, type)"""
    lines = []
    for number, (x, y, z, diameter, *kind) in enumerate(rows, start=1):
        lines.append(f"create_atoms {kind[0] if kind else 1} single {x:.17g} {y:.17g} {z:.17g} units box")
        lines.append(f"set atom {number} diameter {diameter:.17g}")
    lines.append(f"set group all density {density:.17g}")
    return "\n".join(lines) + "\n"


def ball(diameter):
    """a molecule file of one sphere"""
    return f"# one sphere\n\n1 atoms\n\nCoords\n\n1 0 0 0\n\nTypes\n\n1 1\n\nDiameters\n\n1 {diameter}\n"


def crystal(lattice="sc", spacing=1.0, region="box", diameter=None, density=1.0):
    """a lattice with its first site half a spacing from the origin, so that no site lies on a cell's face;
    spacing is the edge of the cube"""
    return f"""
lattice {lattice} {spacing:.17g} origin 0.25 0.25 0.25
create_atoms 1 region {region}
set group all diameter {spacing if diameter is None else diameter:.17g}
set group all density {density:.17g}
"""


def periodic_crystal(lattice, reach, strain=0.0, cells=6):
    """a periodic crystal of E = 1 and density 1, so that c = 1, with nearest neighbours at distance 1; bonds are made at rest, then
    the box is strained"""
    edge = lattices.edge(lattice)
    cell = cells * edge
    return f"""
units si
atom_style bpm/sphere
boundary p p p
lattice {lattice} {edge:.17g}
region box block 0 {cell:.17g} 0 {cell:.17g} 0 {cell:.17g} units box
create_box 1 box bond/types 1
create_atoms 1 box
set group all diameter 1.0
set group all mass {lattices.volume(lattice):.17g}
neighbor 0.3 bin
potdem_bonds all 1 {reach + 0.001:.17g}
bond_style potdem/truss
bond_coeff 1 1.0 area lattice
pair_style potdem/truss
pair_coeff * * 1.0 0.5
run 0
change_box all x scale {1 + strain:.17g} y scale {1 + strain:.17g} z scale {1 + strain:.17g} remap
"""


def elastic(E=1000.0, area="factor 0.5", bond="", contact=None, pair_options=""):
    """pair and bond style with the same modulus in bonds and contacts; area: mode of the bonds' areas, or 'nu X area body'; contact: area
    factor of contacts"""
    areas = area if area.startswith("nu ") else f"area {area}"
    return f"""
pair_style potdem/truss
pair_coeff * * {E:.17g} {contact or 0.5:.17g} {pair_options}
bond_style potdem/truss
bond_coeff * {E:.17g} {areas} {bond}
"""


def velocities_by_formula(amplitude):
    """smooth velocities that differ from particle to particle, the same on any number of ranks"""
    lines = [f"variable v{k} atom {amplitude}*sin(1.3*x+{i})*cos(0.9*y-{i})*sin(1.1*z+{2 * i}+0.4)"
             for i, k in enumerate("xyz")]
    return "\n".join([*lines, "velocity all set v_vx v_vy v_vz", ""])


def result(*expressions):
    """prints LAMMPS expressions with all digits; read them with results()"""
    return 'print "RESULT ' + " ".join(f"$({e}:{ALL_DIGITS})" for e in expressions) + '"\n'


def results(text):
    """one row of numbers per result() line"""
    return np.array([[float(word) for word in line.split()[1:]]
                     for line in text.splitlines() if re.match(r"RESULT\s", line)])


def results_by_length(text):
    """{number of columns: rows} where a script prints several kinds of result() lines"""
    kinds = {}
    for line in text.splitlines():
        if re.match(r"RESULT\s", line):
            row = np.array([float(word) for word in line.split()[1:]])
            kinds.setdefault(len(row), []).append(row)
    return kinds


CRITICAL_STEP = "compute critical all potdem/timestep\nthermo_style custom step c_critical c_critical[*]\nrun 0\n" + result(
    "c_critical", "c_critical[1]", "c_critical[2]", "c_critical[3]")


def write_dump(file, columns):
    return f"write_dump all custom {file} id {columns} modify sort id format float {ALL_DIGITS}\n"


def places(columns):
    """the order of the particles by their positions x y z on a grid: LAMMPS numbers them differently on
    different numbers of ranks"""
    return np.lexsort(np.round(vectors(columns, "z", "y", "x"), 6).T)


def vectors(columns, *names):
    return np.stack([columns[name] for name in names], axis=1)
