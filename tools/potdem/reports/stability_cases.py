# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""The extreme cases of the stability report: LAMMPS scripts without their time step, and how long they run."""

import math
from dataclasses import dataclass, field

from potdem import formulas, scripts
from potdem.text import replaced

NVE = "fix move all nve\n"


@dataclass
class Case:
    """name; script: text before time step and run; time: of the run, or steps: their number; longest: step of the adaptive
    reference; stray: LAMMPS variable of equal style, not 0 when particles are where they cannot get; thesis: its own step;
    scale: energy where none is exchanged; critical: step, where the reference cannot know it; short: part of it in a short report"""

    group: str
    name: str
    script: str
    time: float = 0.0
    longest: float = 0.0
    stray: str = "0"
    thesis: float = None
    scale: float = 0.0
    steps: int = 0
    critical: float = None
    short: float = 1.0
    fractions: tuple = field(default=(0.5, 0.9, 1.1, 2.0))


def pair(law, coeff, more=""):
    return f"pair_style potdem/{law}\npair_modify shift yes\npair_coeff * * {coeff}\n{more}"


def room(size, centre=0.0, **settings):
    """a box for a few particles, in which bins for the neighbour list would cost more than the particles"""
    return replaced(scripts.box(size, centre=centre, **settings), " bin\n", " nsq\n")


def two(coeff_lines, speed, d=(1.0, 1.0), masses=None, gap=0.05, size=40.0, centre=0.0):
    """the second particle flies at the first one along x; they may not pass each other"""
    dbar = 0.5 * (d[0] + d[1])
    at = [(centre, centre, centre, d[0]), (centre + dbar + gap, centre, centre, d[1])]
    text = room(size, centre) + scripts.particles(at)
    for k, mass in enumerate(masses or (), start=1):
        text += f"set atom {k} mass {mass:.17g}\n"
    return text + f"set atom 2 vx {-speed:.17g}\n{coeff_lines}{NVE}"


PASSED = "x[1]>x[2]"
STRAIGHT = 0.6    # of s at rest or at first contact: from there on inwards the laws with `linear` are straight


def law_lines():
    return {
        "truss": pair("truss", "1000 0.5"),
        "hertz": pair("hertz", "1000 0.2"),
        "granular": pair("granular", "1000 4 0.2"),
        "granular linear": pair("granular", f"1000 4 0.2 linear {STRAIGHT}"),
        "lj": pair("lj", "1000 0.2 2 0.2"),
        "lj linear": pair("lj", f"1000 0.2 2 0.2 linear {STRAIGHT * 0.2}"),
    }


# --- stiffness, size and mass that differ by a lot ---------------------------------------------------------------------

def on_wall(wall, speed=1.0, d=1.0, more=""):
    return room(20) + scripts.particles([(0, 0, 0.6 * d, d)]) + f"""
set group all vz {-speed}
pair_style zero 1.0
pair_coeff * *
region floor plane 0 0 0 0 0 1 units box
fix floor all potdem/wall/region floor {wall}
{more}{NVE}"""


def steel_on_beam():
    """a block of stiff bonds hits a cantilever of soft ones"""
    return """
units si
atom_style bpm/sphere
boundary f f f
lattice sc 0.005
region box block -20 40 -20 25 -30 30
create_box 2 box bond/types 2
region beam block 0 12 0 2 0 2
region block block 9 12 0 2 4 6
create_atoms 1 region beam
create_atoms 2 region block
set type 1 diameter 0.005 mass $(2400*0.005^3)
set type 2 diameter 0.005 mass $(7800*0.005^3)
set type 2 vz -1
group beam type 1
group block type 2
displace_atoms block move 0 0 -0.9 units lattice
potdem_bonds beam 1 2.0 diameters
potdem_bonds block 2 2.0 diameters
bond_style potdem/truss
bond_coeff 1 2e5 area lattice
bond_coeff 2 2e11 area lattice
pair_style potdem/truss
pair_coeff 1 1 2e5 0.4
pair_coeff 2 2 2e11 0.4
region free block 1 INF INF INF INF INF
group free region free
fix move free nve
"""


def caught():
    """a ball falls on one of a twentieth of its size on a plate"""
    return room(60) + scripts.particles([(0, 0, 0.5, 1.0), (0, 0, 11.05, 20.0)]) + f"""
set atom 2 vz -0.05
{pair("hertz", "1000 0.2")}
region floor plane 0 0 0 0 0 1 units box
fix floor all potdem/wall/region floor 1000 0.2 particle 1000 0.2 layer none
{NVE}"""


def on_small_ones():
    """a ball falls on a layer of grains of a twentieth of its size"""
    rows = [(x - 4.0, y - 4.0, 0.5, 1.0) for x in range(9) for y in range(9)]
    return scripts.box(60) + scripts.particles(rows + [(0, 0, 11.05, 20.0)]) + f"""
set atom {len(rows) + 1} vz -0.3
{pair("hertz", "1000 0.2 friction 0.3 auto")}
region floor plane 0 0 0 0 0 1 units box
fix floor all potdem/wall/region floor 1000 0.2 particle 1000 0.2
{NVE}"""


def contrasts():
    yield Case("contrast", "soft grain, wall 10^6 times as stiff", on_wall("1e9 0.2 particle 1e3 0.2 layer none"), 0.6, 0.01, "z[1]<0")
    yield Case("contrast", "soft grain, wall 10^6 times as stiff, soft layer", on_wall("1e9 0.2 particle 1e3 0.2"), 0.6, 0.01, "z[1]<0")
    yield Case("contrast", "hard grain, hard wall", on_wall("1e9 0.2 particle 1e9 0.2 layer none"), 0.2, 0.0005, "z[1]<0")
    yield Case("contrast", "hard grain, hard wall, soft layer", on_wall("1e9 0.2 particle 1e9 0.2"), 0.2, 0.0005, "z[1]<0")
    yield Case("contrast", "block on a beam, 10^6 times as stiff", steel_on_beam(), 5e-3, 1e-6, short=0.4)
    yield Case("contrast", "diameters 1:20, collision", two(pair("hertz", "1000 0.2"), 1.0, d=(20.0, 1.0)), 0.6, 0.01, PASSED)
    yield Case("contrast", "diameters 1:20, the small one caught", caught(), 8.0, 0.01, "z[1]<0")
    yield Case("contrast", "diameters 1:20, ball on a layer of grains", on_small_ones(), 3.0, 0.01, short=0.4)
    yield Case("contrast", "masses 1:10^6, collision", two(pair("truss", "1000 0.5"), 1.0, masses=(1e6, 1.0)), 0.3, 0.01, PASSED)
    yield Case("contrast", "masses 1:10^6, bonded", bonded(1.2, masses=(1e6, 1.0)), 3.0, 0.01)


# --- bonds ------------------------------------------------------------------------------------------------------------

def bonded(stretch, options="", masses=(1.0, 1.0), E=1000.0):
    text = room(60) + scripts.particles([(0, 0, 0, 1.0), (1.0, 0, 0, 1.0)])
    for k, mass in enumerate(masses, start=1):
        text += f"set atom {k} mass {mass:.17g}\n"
    return text + scripts.elastic(E, bond=options) + f"potdem_bonds all 1 1.5\nrun 0\nset atom 2 x {stretch:.17g}\n{NVE}"


WALL = "100 0.2 particle 1 0.2"
GRANULAR_WALL = "law granular 1 4 0.5"


def cube_on_wall(speed, wall=WALL, options=""):
    """4^3 particles, c = 1 in units of the spacing over the time"""
    text = room(60) + """
lattice sc 1.0
region cube block -0.1 3.1 -0.1 3.1 0.9 4.1 units box
create_atoms 1 region cube
set group all diameter 1.0 mass 1.0
"""
    return text + scripts.elastic(1.0, "lattice", options, 0.4, options) + f"""
potdem_bonds all 1 2.0 diameters
set group all vz {-speed}
region floor plane 0 0 0 0 0 1 units box
fix floor all potdem/wall/region floor {wall}
{NVE}"""


def bonds():
    yield Case("bonds", "bond stretched by 20 %", bonded(1.2), 3.0, 0.01)
    yield Case("bonds", "bond compressed to 10 % of its length", bonded(0.1), 3.0, 0.01, PASSED)
    yield Case("bonds", "bond compressed to 10 %, penetration 6", bonded(0.1, "penetration 6"), 3.0, 0.01, PASSED)
    for speed in (0.01, 0.1, 1.0, 3.0):
        yield Case("bonds", f"cube hits a wall at {speed:g} times its wave speed", cube_on_wall(speed), 12.0 + 0.6 / speed, 0.1)
    for speed in (1.0, 3.0):
        yield Case("bonds", f"cube at {speed:g} times, penetration 6, granular law of the wall",
                   cube_on_wall(speed, GRANULAR_WALL, "penetration 6"), 12.0, 0.1)


# --- laws -------------------------------------------------------------------------------------------------------------

def overlapping(lines):
    """27 particles, each 30 % in its neighbours"""
    rows = [(0.7 * x, 0.7 * y, 0.7 * z, 1.0) for x in range(3) for y in range(3) for z in range(3)]
    return room(400, skin=1.0) + scripts.particles(rows) + lines + NVE


def laws():
    for name, lines in law_lines().items():
        for speed, words in ((1.0, "collision"), (30.0, "violent collision")):
            if name in ("truss", "hertz") and speed > 1.0:
                continue
            yield Case("laws", f"{name}, {words}", two(lines, speed, gap=0.8 if name.startswith("granular") else 0.2), 1.5 / speed, 0.01 / speed, PASSED)
    for name, lines in law_lines().items():
        yield Case("laws", f"{name}, packing overlaps by 30 %", overlapping(lines), 0.2, 0.002,
                   critical=None if "linear" in name or name in ("truss", "hertz") else 0.02)


# --- friction, heaps, edges, the thesis's scenes ----------------------------------------------------------------------

def on_slope():
    """a grain at rest where Hertz balances its weight, on a slope of 20 degrees, friction of 40"""
    angle, E, g = math.radians(20), 1e5, 10.0
    mass, modulus = formulas.sphere_mass(1.0), E / (2 * (1 - 0.2**2))
    overlap = (mass * g * math.cos(angle) / (4 / 3 * modulus * math.sqrt(0.5))) ** (2 / 3)
    return room(40) + scripts.particles([(0, 0, 0.5 - overlap, 1.0)]) + f"""
pair_style zero 1.0
pair_coeff * *
region floor plane 0 0 0 0 0 1 units box
fix weight all gravity {g} vector {math.sin(angle):.17g} 0 {-math.cos(angle):.17g}
fix floor all potdem/wall/region floor {E} 0.2 particle {E} 0.2 layer none friction 0.84 auto
{NVE}"""


def heap(mu):
    """64 grains fall into a box"""
    return scripts.box(40) + f"""
lattice sc 1.15
region fill block -2 2 -2 2 1 5.5 units box
create_atoms 1 region fill
set group all diameter 1.0
set group all density 1.0
displace_atoms all random 0.05 0.05 0.05 1234
variable outside atom "z<0 || abs(x)>3 || abs(y)>3"
compute outside all reduce sum v_outside
{pair("hertz", f"1e4 0.2 friction {mu} auto")}
region walls block -3 3 -3 3 0 18 units box
fix move all nve
fix weight all gravity 10 vector 0 0 -1
fix walls all potdem/wall/region walls 1e4 0.2 particle 1e4 0.2 friction {mu} auto
fix damp all potdem/damping 0.1
"""


def over_the_edge():
    """grains slide over the edge of a block and strike its side and the floor"""
    rows = [(-2.0 - 1.1 * k, 0.0, 0.55, 1.0) for k in range(4)]
    return room(60) + scripts.particles(rows) + f"""
set group all vx 2
{pair("hertz", "1e4 0.2")}
region step block INF 0 INF INF INF 0 side out units box
region floor plane 0 0 -6 0 0 1 units box
fix move all nve
fix weight all gravity 10 vector 0 0 -1
fix step all potdem/wall/region step 1e4 0.2 particle 1e4 0.2
fix floor all potdem/wall/region floor 1e4 0.2 particle 1e4 0.2
"""


def through_the_opening():
    """a box without its right side: what leaves flies on"""
    rows = [(x - 2.0, y, z + 0.6, 1.0) for x in range(3) for y in (-0.5, 0.5) for z in range(2)]
    return room(80) + scripts.particles(rows) + f"""
set group all vx 4
{pair("hertz", "1e4 0.2")}
region box0 block -3 3 -2 2 0 4 open 2 units box
fix move all nve
fix weight all gravity 10 vector 0 0 -1
fix box0 all potdem/wall/region box0 1e4 0.2 particle 1e4 0.2
"""


def disc_bed():
    """section 6.9 of the thesis in small: its materials, particles and speed, a disc of radius 0.24 m and a thin bed"""
    return """
units si
atom_style bpm/sphere
boundary f f f
lattice sc 0.06
region box block -2 2 -2 2 -0.3 2 units box
create_box 2 box bond/types 1
region disc cylinder y 0 0.75 0.24 -0.1 0.1 units box
region bed block -0.5 0.5 -0.1 0.1 0.0 0.2 units box
create_atoms 1 region disc
create_atoms 2 region bed
set group all diameter 0.06
set type 1 mass $(2300*0.06^3)
set type 2 density 1900
group disc type 1
set group disc vz -5
displace_atoms disc move 0 0 -0.2 units box
potdem_bonds disc 1 2.0 diameters
bond_style potdem/truss
bond_coeff 1 3e10 area lattice
pair_style potdem/truss
pair_coeff 1 1 3e10 0.4
pair_coeff 2 2 3e10 0.4
region walls block -0.7 0.7 -0.33 0.33 -0.0305 1.5 units box
fix move all nve
fix weight all gravity 9.81 vector 0 0 -1
fix walls all potdem/wall/region walls 3e10 0.2 particle 3e10 0.2
fix cracks disc potdem/failure 1 tension 2.7e6
"""


def blade_cut():
    """section 6.7 of the thesis in small: its material and speed, 120 grains in front of a blade"""
    return """
units si
atom_style bpm/sphere
boundary f f f
region box block -1 1 -1 1 -1 1 units box
create_box 1 box
lattice sc 0.0202
region fill block -0.07 0.11 -0.04 0.04 0.0 0.08 units box
create_atoms 1 region fill
displace_atoms all move 0 0 0.0101 units box
set group all diameter 0.02
set group all density 855
pair_style potdem/truss
pair_coeff * * 2.76e6 0.4 friction 0.1 auto
variable place equal 0.1*time
variable speed equal 0.1
region tray block -0.15 0.15 -0.05 0.05 0 0.4 units box
region blade block -0.102 -0.092 -0.045 0.045 0.03 0.3 side out units box move v_place NULL NULL
fix move all nve
fix weight all gravity 9.81 vector 0 0 -1
fix tray all potdem/wall/region tray 3e8 0.2 particle 2.76e6 0.2 friction 0.1 auto
fix blade all potdem/wall/region blade 3e8 0.2 particle 2.76e6 0.2 friction 0.1 auto
fix damp all potdem/damping 0.2
"""


def scenes():
    yield Case("scenes", "grain at rest on a slope", on_slope(), longest=0.05, stray="abs(x[1])>0.01", scale=formulas.sphere_mass(1.0) * 10.0,
               steps=1000000, short=0.02)
    for mu in (0, 10):
        yield Case("scenes", f"64 grains heap up, mu = {mu}", heap(mu), 4.0, 0.01, "c_outside", short=0.5)
    yield Case("scenes", "grains slide over the edge of a block", over_the_edge(), 4.0, 0.01)
    yield Case("scenes", "grains leave through an open side", through_the_opening(), 1.5, 0.01)
    yield Case("scenes", "disc-bed in small", disc_bed(), 0.01, 2e-5, thesis=50e-6)
    yield Case("scenes", "blade-cut in small", blade_cut(), 0.3, 1e-3, thesis=0.2e-3, short=0.3)


# --- long runs --------------------------------------------------------------------------------------------------------

def bonded_orbit():
    """a bond that turns and vibrates"""
    return bonded(1.0) + "set atom 1 vy -1.0\nset atom 2 vy 1.0\nset atom 2 vx 0.5\nvelocity all zero linear\n"


def lj_orbit():
    """two particles that turn about each other"""
    return replaced(two(pair("lj", "1000 0.2 2 0.2 cut 1.0"), 0.0, gap=0.1), "set atom 2 vx -0\n", "set atom 1 vy -1.0\nset atom 2 vy 1.0\n")


def orbits():
    yield Case("long runs", "two bonded particles turn and vibrate", bonded_orbit(), longest=0.05, steps=1000000, short=0.02)
    yield Case("long runs", "two particles of potdem/lj in orbit", lj_orbit(), longest=0.05, steps=1000000, short=0.02)


def cases():
    return [*contrasts(), *bonds(), *laws(), *scenes(), *orbits()]
