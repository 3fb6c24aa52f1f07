# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""One scene in every way that is no physics (potdem.same_answer), with what tests cannot have: plugins made by other
compilers and without optimisation, and another release of LAMMPS (POTDEM_OTHER_LMP: its program)."""

import os
from pathlib import Path

import project

from potdem import same_answer
from potdem.reports.writing import table

TITLE = "The same answer everywhere"
PLUGINS = {"the plugin, by Clang": ("clang++", "Release"), "the plugin, by GCC without optimisation": ("g++", "Debug")}


def plugin(folder, compiler, kind):
    """built without LAMMPS, for the LAMMPS of the build"""
    project.build(folder, f"-DCMAKE_CXX_COMPILER={compiler}", f"-DCMAKE_BUILD_TYPE={kind}", targets=["potdemplugin"])
    return folder


def ways(build, work):
    plain = build / "unittest" / "plain" / "lmp"
    yield from same_answer.WAYS
    folders = {"the plugin": build}
    folders.update({name: plugin(work / f"plugin-{how[0].rstrip('+')}-{how[1].lower()}", *how) for name, how in PLUGINS.items()})
    for name, folder in folders.items():
        yield same_answer.Way(name, environment={"LAMMPS_PLUGIN_PATH": str(folder)}, lmp=plain)
    other = os.environ.get("POTDEM_OTHER_LMP")
    if other:
        yield same_answer.Way("another release of LAMMPS", lmp=Path(other))


def measure(build, work):
    lmp = build / "lmp"
    base = same_answer.compute(same_answer.Way("as it comes"), work / "answers", lmp)
    rows, wrong = [], 0
    for number, way in enumerate(ways(build, work)):
        print(f"  {way.name}", flush=True)
        answer = same_answer.compute(way, work / f"answers-{number}", lmp)
        apart, drifts = same_answer.deviation(answer, base), same_answer.drifts(answer)
        good = apart <= same_answer.ROUNDING and drifts["bonds"] == 0 and drifts["momentum"] <= same_answer.ROUNDING \
            and drifts["energy"] <= same_answer.ENERGY
        wrong += not good
        rows.append((way.name, apart or "0", int(answer.last["f_fails"]), int(drifts["bonds"]), drifts["momentum"], drifts["energy"],
                     int(answer.last["c_most"]), "yes" if good else "**no**"))
    other = "" if os.environ.get("POTDEM_OTHER_LMP") else " Another release of LAMMPS was not at hand (`POTDEM_OTHER_LMP`)."
    text = f"""Two blocks with scattered strengths collide in free space and break ({same_answer.BROKEN} steps; friction with springs, dashpots in
the bonds). *apart*: the largest difference to the first row from a run on one rank, of positions and velocities over the largest, after
{same_answer.WHOLE} steps, before a bond has failed. After the end: failed bonds; bonds that are neither there nor failed; momentum and the sum of the
energy ledger, which must stay, as changes over the momentum and the kinetic energy at the start (the energy errs with the step); the largest
number of a piece.{other}

""" + table(["computed", "apart", "failed", "lost bonds", "momentum", "energy", "pieces", "as it must be"], rows)
    return text, wrong
