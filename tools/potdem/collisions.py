# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""The head-on collision of two spheres of the Hertz law: closed forms, and input of LAMMPS for it."""

import numpy as np
from scipy.special import gamma

from potdem import formulas, scripts
from potdem.pair_laws import Hertz

D1, D2, DENSITY = 1.0, 1.6, 2.0
MASSES = [formulas.sphere_mass(d, DENSITY) for d in (D1, D2)]
REDUCED = MASSES[0] * MASSES[1] / sum(MASSES)
CONTACT = 0.5 * (D1 + D2)
HERTZ = Hertz(3e6, 0.3)
K = HERTZ.prefactor(D1, D2)
SPEED = 1.0    # of the adaptive collision


def setting(gap, speed, pair):
    """two particles on the x axis, `gap` beyond contact, approaching; their centre of mass at rest"""
    v = [speed * MASSES[1] / sum(MASSES), -speed * MASSES[0] / sum(MASSES)]
    script = scripts.box(40) + "bond_style none\n"
    script += scripts.particles([(0, 0, 0, D1), (CONTACT + gap, 0, 0, D2)], DENSITY)
    return script + pair + f"""
group one id 1
group two id 2
velocity one set {v[0]:.17g} 0 0
velocity two set {v[1]:.17g} 0 0
variable r equal x[2]-x[1]
variable u equal vx[1]-vx[2]
variable f equal fx[2]
thermo 1
thermo_style custom step v_r v_u v_f pe ke etotal
thermo_modify format float {scripts.ALL_DIGITS}
fix move all nve
"""


def overlap_at_rest(speed):
    """K w^(5/2) 2/5 = m v^2/2"""
    return (1.25 * REDUCED * speed**2 / K) ** 0.4


def duration(speed):
    """2 w/v times the integral of dx/sqrt(1 - x^(5/2)) from 0 to 1, a Beta function"""
    return 2 * overlap_at_rest(speed) / speed * np.sqrt(np.pi) * gamma(0.4) / (2.5 * gamma(0.9))


DURATION = duration(SPEED)
FLIGHT = 3.0 * DURATION    # before the contact


def until(time, what=""):
    """columns and a run that ends at a time"""
    return f"""
thermo 1
thermo_style custom step time dt {what}
thermo_modify format float {scripts.ALL_DIGITS}
variable done equal 'time > {time:.17g}'
fix end all halt 1 v_done != 0 error continue
run 1000000
"""


def adaptive(fraction, every=1, longest=0.6):
    """by fix potdem/timestep. longest step: fraction of it in durations, so that it is halved with the fraction"""
    pace = f"fix pace all potdem/timestep {every} {fraction} max {fraction * longest * DURATION:.17g}"
    script = setting(FLIGHT * SPEED, SPEED, f"pair_style potdem/hertz\npair_coeff * * {HERTZ.coeff}\n{pace}\n"
                     "compute books all potdem/energy\n")
    before, _ = script.split("thermo 1\n")
    return before + "fix move all nve\n" + until(FLIGHT + 1.5 * DURATION, "f_pace v_r v_u v_f c_books")
