# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""The sections of the bonds of a body, as LAMMPS finds them."""

import tempfile
from pathlib import Path

import numpy as np

from potdem import dumps, running

SCRIPT = """units si
newton on off
atom_style bpm/sphere
boundary f f f
read_data particles.data
potdem_bonds all 1 {reach:.17g} diameters
pair_style potdem/truss
pair_coeff * * 1 0.5
bond_style potdem/truss
bond_coeff * 1 area {area}
compute ends all property/local batom1 batom2
compute areas all bond/local b3
dump areas all local 1 areas.dump c_ends[1] c_ends[2] c_areas
dump_modify areas format float %.17g
run 0
"""


def areas_in_lammps(lmp, body, pairs, reach, area):
    """(pairs,): the section of each of the pairs (pairs, 2) of a networks.Body with r_infl = reach and the words after `area` of
    bond_coeff; None where the package refuses"""
    density = body.v / (np.pi / 6 * body.d**3)    # mass = volume of the solid
    low, high = body.x.min() - 1.0, body.x.max() + 1.0
    lines = [f"particles\n\n{len(body.x)} atoms\n1 atom types\n1 bond types\n200 extra bond per atom\n"
             "200 extra special per atom\n"]
    lines += [f"{low} {high} {k}lo {k}hi" for k in "xyz"] + ["\nAtoms # bpm/sphere\n"]
    lines += [f"{i + 1} 0 1 {d:.17g} {rho:.17g} {x[0]:.17g} {x[1]:.17g} {x[2]:.17g}"
              for i, (x, d, rho) in enumerate(zip(body.x, body.d, density))]
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        (folder / "particles.data").write_text("\n".join(lines) + "\n")
        if not running.run(SCRIPT.format(reach=reach, area=area), {}, folder, lmp=lmp).ended_well:
            return None
        (frame,) = dumps.read(folder / "areas.dump")
    ends = np.sort([frame["c_ends[1]"], frame["c_ends[2]"]], axis=0).astype(int) - 1
    found = dict(zip(zip(*ends), frame["c_areas"]))
    return np.array([found[tuple(sorted(pair))] for pair in pairs.tolist()])
