# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""What the stability report measures besides its matrix: the critical step of lattices, the order of the adaptive step, long
runs, places far from the origin, systems of units."""

from concurrent.futures import ThreadPoolExecutor

import numpy as np

from potdem import collisions, formulas, lattices, logs, running, scripts
from potdem.reports import stability_cases

# LAMMPS's own, src/update.cpp of 4Feb2025: energy of a mass of 1 g/mol at 1 A/ps, in eV
METAL_ENERGY = 1.0364269e-4
ADAPTIVE_FRACTIONS = (0.2, 0.1, 0.05, 0.025)
FAR = 1e6    # diameters
PLACES = scripts.result("x[1]", "x[2]", "vx[1]", "vx[2]")


def results(script, folder):
    return scripts.results(running.must_run(script, {}, folder).stdout)


# --- critical step ----------------------------------------------------------------------------------------------------

def lattice_steps(folder):
    """rows: lattice, r_infl/d, exact step, bound, bound/exact, sqrt(m/K)/exact; times c/d"""
    rows = []
    for number, (kind, reach, _, _) in enumerate(lattices.CRITICAL_STEPS):
        mass = lattices.volume(kind)
        step, _, stiffest, _ = results(scripts.periodic_crystal(kind, reach) + scripts.CRITICAL_STEP, folder / f"lattice{number}")[-1]
        # the stiffest bond is the shortest one
        modulus = mass * lattices.shells(kind, reach)[0].min() / stiffest**2
        exact = 2 / np.sqrt(lattices.largest_frequency2(kind, reach, mass, modulus))
        rows.append([kind, reach, exact, step, step / exact, stiffest / exact])
    return rows


def adaptive_order(folder):
    """rows: fraction, ledger's error in a Hertz collision, how many times smaller than the one before"""
    rows, last = [], None
    for fraction in ADAPTIVE_FRACTIONS:
        done = running.must_run(collisions.adaptive(fraction), {}, folder / f"order{fraction}")
        energy = done.thermo["c_books"]
        error = float(np.ptp(energy) / energy[0])
        rows.append([fraction, error, last / error if last else None])
        last = error
    return rows


# --- long runs --------------------------------------------------------------------------------------------------------

def orbit(bound, steps):
    """two particles for a long time at a tenth of their critical step"""
    if bound == "bond":
        script = stability_cases.bonded_orbit()
        step = 0.1 * np.sqrt(2 / (1000.0 * formulas.section(1.0, 0.5)))    # 2 sqrt(m*/k), m* = 1/2
    else:
        script = stability_cases.lj_orbit()
        step = 0.1 * np.sqrt(2 * formulas.sphere_mass(1.0) / 1000.0)
    return script + f"""timestep {step:.17g}
compute ledger all potdem/energy
thermo_style custom step c_ledger ke
thermo_modify format float %.17g
thermo {max(1, steps // 20000)}
print "LONG RUN"
run {steps}
"""


def drift(name, bound, steps, folder):
    """row: name, steps, fluctuation of the ledger over the kinetic energy, drift of its mean from the first to the last tenth"""
    done = running.must_run(orbit(bound, steps), {}, folder / f"orbit-{bound}")
    table = logs.thermo(done.stdout.split("LONG RUN", 1)[1])
    total, kinetic = table["c_ledger"], table["KinEng"].mean()
    tenth = len(total) // 10
    return [name, steps, float(np.ptp(total) / kinetic), float(abs(total[-tenth:].mean() - total[:tenth].mean()) / kinetic)]


def drifts(folder, short):
    steps = 200000 if short else 10000000
    kinds = [("two bonded particles turn and vibrate", "bond"), ("two particles of potdem/lj in orbit", "lj")]
    with ThreadPoolExecutor(2) as pool:
        return list(pool.map(lambda kind: drift(*kind, steps, folder), kinds))


# --- far from the origin ----------------------------------------------------------------------------------------------

def far_away(folder):
    """rows: law, largest difference of the relative velocity after the collision over the speed; of the distance, in diameters"""
    rows = []
    for law, lines in stability_cases.law_lines().items():
        ends = []
        for centre in (0.0, FAR):
            script = stability_cases.two(lines, 1.0, gap=0.2, centre=centre) + "timestep 1e-3\nrun 1000\n" + scripts.result("x[2]-x[1]", "vx[2]-vx[1]")
            ends.append(results(script, folder / f"far-{law.replace(' ', '-')}-{centre:g}")[-1])
        rows.append([law, float(abs(ends[1][1] - ends[0][1])), float(abs(ends[1][0] - ends[0][0]))])
    return rows


# --- units ------------------------------------------------------------------------------------------------------------

UNITS = [("si", 1.0, 1.0, 1.0, 1.0), ("cgs", 100.0, 1000.0, 1.0, 1.0), ("lj", 7.3, 0.31, 2.9, 1.0), ("metal", 2.7, 41.0, 0.13, METAL_ENERGY)]


def scene_in(units, length, mass, time, energy):
    """a bonded cube falls on a plane with friction, a grain on the cube, one of its bonds would fail; numbers of one scene, scaled"""
    stress = energy * mass / (length * time**2)
    rows = [(x * length, y * length, (z + 0.6) * length, length) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    rows.append((0.4 * length, 0.3 * length, 2.7 * length, 0.8 * length))
    text = scripts.box(20 * length, units=units, skin=0.3 * length) + scripts.particles(rows)
    text += "".join(f"set atom {k} mass {mass * (0.3 if k == 9 else 1.0):.17g}\n" for k in range(1, 10))
    text += scripts.elastic(1000 * stress, "factor 0.5", "damping 0.01", 0.5, f"friction 0.3 {0.5 * energy * mass / time:.17g}")
    return text + f"""
group body id <= 8
set group all vz {-2 * length / time:.17g}
set group all vx {0.5 * length / time:.17g}
potdem_bonds body 1 {1.5 * length:.17g}
region floor plane 0 0 0 0 0 1 units box
fix move all nve
fix weight all gravity {10 * energy * length / time**2:.17g} vector 0 0 -1
fix floor all potdem/wall/region floor {3000 * stress:.17g} 0.2 particle {1000 * stress:.17g} 0.2 friction 0.3 auto
timestep {0.002 * time:.17g}
run 400
""" + "".join(scripts.result(f"x[{k}]/{length:.17g}", f"y[{k}]/{length:.17g}", f"z[{k}]/{length:.17g}") for k in range(1, 10))


def in_units(folder):
    """rows: units, how far particles have moved, largest difference of a coordinate from units si, in diameters"""
    ends = {units: results(scene_in(units, *scales), folder / f"units-{units}") for units, *scales in UNITS}
    return [[units, float(np.ptp(end[:, 2])), float(np.abs(end - ends["si"]).max())] for units, end in ends.items()]
