# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Elastic waves in truss networks against the dispersion of the lattice: E = 1, cells of volume and mass 1."""

import itertools

import numpy as np
import pytest

from potdem import dumps, formulas, networks, scripts
from potdem.text import replaced

SMALL = 1e-6     # velocities: strains of this order, so that the truss is linear to as much
A = 0.5          # area factor

CELL = {"sc": 1.0, "fcc": 2.0 ** (2 / 3)}    # edge of the cube cell for a volume of 1 per particle
NEAREST = {"sc": 1.0, "fcc": 2.0 ** (1 / 6)}
BASIS = {"sc": [(0, 0, 0)], "fcc": [(0, 0, 0), (0, 0.5, 0.5), (0.5, 0, 0.5), (0.5, 0.5, 0)]}


def bonds(lattice, reach):
    """vectors from a particle to those it is bonded to"""
    corners = np.array(list(itertools.product(range(-4, 5), repeat=3)), dtype=float)
    vectors = CELL[lattice] * (corners[:, None, :] + np.array(BASIS[lattice])).reshape(-1, 3)
    lengths = np.linalg.norm(vectors, axis=1)
    return vectors[(lengths > 0) & (lengths < reach * NEAREST[lattice] * (1 + 1e-6))]


def squared_frequency(lattice, reach, k, polarization):
    """m omega^2 = sum of A E / r n_p^2 (1 - cos k x) over the bonds of a particle"""
    vectors = bonds(lattice, reach)
    lengths = np.linalg.norm(vectors, axis=1)
    stiffness = formulas.section(NEAREST[lattice], A) / lengths
    return np.sum(stiffness * (vectors[:, polarization] / lengths) ** 2 * (1 - np.cos(k * vectors[:, 0])))


def motion(shape, polarization, dt):
    """starts with the velocities SMALL times shape"""
    return f"""
variable shape atom {shape}
variable start atom {SMALL}*v_shape
variable zero atom 0
velocity all set {' '.join('v_start' if p == polarization else 'v_zero' for p in range(3))}
compute u all displace/atom
timestep {dt}
fix move all nve
"""


def projection(polarization, steps, every=1):
    """sum over the particles of displacement times shape"""
    return f"""
variable share atom c_u[{polarization + 1}]*v_shape
compute sum all reduce sum v_share
thermo_style custom step time c_sum
thermo {every}
run {steps}
"""


def body(lattice, edge, reach, boundary="p p p", room=0.0):
    """a block of the lattice; edge: number of cells along x, y, z"""
    sides = np.array(edge) * CELL[lattice]
    script = scripts.box(sides + room, boundary)
    faces = " ".join(f"{-side / 2:.17g} {side / 2:.17g}" for side in sides)
    script += f"region body block {faces} units box\n"
    script += scripts.crystal(lattice, CELL[lattice], "body", NEAREST[lattice]) + "set group all mass 1\n"
    return script + scripts.elastic(1.0, f"factor {A}") + f"potdem_bonds all 1 {reach} diameters\n"


@pytest.mark.parametrize("lattice, reach", [("sc", 1.42), ("sc", 2.0), ("fcc", 1.0), ("fcc", 1.42)])
@pytest.mark.parametrize("polarization", [0, 1], ids=["longitudinal", "transverse"])
@pytest.mark.parametrize("waves", [1, 5])
def test_dispersion_of_plane_waves(run_lammps, lattice, reach, polarization, waves):
    """standing wave along a cube axis of a periodic cell. Leapfrog obeys u(t+dt) - 2 u(t) + u(t-dt) = -(omega dt)^2 u(t)
    exactly, so the step is no source of error"""
    cells, dt = 12, 0.2
    k = 2 * np.pi * waves / (cells * CELL[lattice])
    script = body(lattice, (cells, 5, 5), reach) + motion(f"sin({k:.17g}*x+0.3)", polarization, dt)
    u = run_lammps(script + projection(polarization, 60)).thermo["c_sum"]
    found = -np.dot(u[2:] - 2 * u[1:-1] + u[:-2], u[1:-1]) / np.dot(u[1:-1], u[1:-1]) / dt**2
    assert found == pytest.approx(squared_frequency(lattice, reach, k, polarization), rel=2 * SMALL)


@pytest.mark.parametrize("reach", [1, 2], ids=["nearest", "second"])
def test_pulse_over_200_particles(run_lammps, tmp_path, reach):
    """a line of particles; one is struck. On a periodic line of N each wave k = 2 pi m / N goes its own way: the velocities
    are v_j(t) = 1/N sum cos(omega_k t) cos(k j), dispersion and all"""
    stiffness = formulas.section(1.0, A) / np.arange(1, reach + 1)
    front = np.sqrt(np.sum(stiffness * np.arange(1, reach + 1) ** 2))    # speed of the longest waves
    number, dt = 500, 0.02
    steps = 2 * round(205 / (2 * front * dt))
    script = scripts.box((number, 20, 20), "p f f") + f"region line block {-number / 2} {number / 2} -0.4 0.4 -0.4 0.4\n"
    script += "lattice sc 1.0 origin 0.5 0 0\ncreate_atoms 1 region line\nset group all diameter 1 mass 1\n"
    script += scripts.elastic(1.0, f"factor {A}") + f"potdem_bonds all 1 {reach} diameters\n" + motion("x==0.5", 0, dt)
    script += f"dump v all custom {steps // 2} v.dump id x vx\ndump_modify v sort id format float {scripts.ALL_DIGITS}\n"
    run_lammps(script + f"thermo {steps}\nrun {steps}\n")

    k = 2 * np.pi * np.arange(number) / number
    squared = sum(2 * s * (1 - np.cos(n * k)) for n, s in enumerate(stiffness, start=1))
    # what the step makes of each frequency: sin(omega' dt / 2) = omega dt / 2
    omega = 2 / dt * np.arcsin(np.sqrt(squared) * dt / 2)
    for table in dumps.read(tmp_path / "v.dump")[1:]:
        place = np.round(table["x"] - 0.5)
        expected = SMALL * np.cos(np.outer(place, k)) @ np.cos(omega * table.step * dt) / number
        assert np.abs(table["vx"] - expected).max() < 1e-5 * SMALL
    # at the end 200 particles on either side have been passed, and no more than a few beyond
    moved = np.abs(table["vx"])
    assert moved[(np.abs(place) > 195) & (np.abs(place) < 200)].max() > 0.01 * SMALL
    assert moved[np.abs(place) > 230].max() < 1e-4 * SMALL


def axial_modulus(points, reach):
    """of a bar along x with 25 particles in each layer"""
    return networks.axial_stiffness(points, networks.stiffness(points, networks.bonds(points, reach), formulas.section(1.0, A))) / 25


def first_vibration(run_lammps, script, length, expected, dt=0.3):
    """circular frequency of the first longitudinal vibration of a free bar, near the expected one"""
    script += motion(f"sin({np.pi / length:.17g}*x)", 0, dt)
    thermo = run_lammps(script + projection(0, 1000, every=5)).thermo
    time, u = thermo["Time"], thermo["c_sum"]

    def misfit(omega):
        wave = np.sin(omega * time)
        return np.sum((u - wave * (u @ wave) / (wave @ wave)) ** 2)

    trials = expected * np.linspace(0.8, 1.2, 4001)
    return trials[np.argmin([misfit(trial) for trial in trials])]


# soft ends and the inertia of the lateral contraction lower the first vibration, by (pi nu a / L)^2 / 12 the latter
LOWERED = 0.003


def test_speed_of_waves_along_a_bar(run_lammps):
    """first longitudinal vibration of a free bar of 5 x 5 x 48: c = (E / rho)^(1/2) with the axial modulus of this network,
    which is not that of the infinite one"""
    length = 48
    sides = [np.arange(count) - (count - 1) / 2 for count in (length, 5, 5)]
    speed = np.sqrt(axial_modulus(np.stack(np.meshgrid(*sides), axis=-1).reshape(-1, 3), 2.0))
    found = first_vibration(run_lammps, body("sc", (length, 5, 5), 2.0, "f f f", room=4.0), length, np.pi / length * speed)
    assert found * length / np.pi == pytest.approx(speed, rel=LOWERED)


@pytest.mark.parametrize("reach, axial", [(1.42, 0.025), (2.0, 0.01)])
def test_speed_of_waves_along_a_bar_of_the_right_area(run_lammps, reach, axial):
    """area body: c = (E / rho)^(1/2) of the solid, as its axial stiffness is right within so much (docs/area.md), half of that in c"""
    length = 48
    script = replaced(body("sc", (length, 5, 5), reach, "f f f", room=4.0), f"area factor {A}", "area body density 1")
    found = first_vibration(run_lammps, script, length, np.pi / length)
    assert found * length / np.pi == pytest.approx(1.0, abs=LOWERED + axial / 2)
