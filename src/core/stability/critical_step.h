/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The critical step of one particle (thesis eq. 5.34 with sqrt(1 + xi^2), where sqrt(1 - xi^2) is printed): velocity Verlet,
   with viscous forces that see the velocity of half a step before, is stable as long as

     step^2 k + 2 step c <= 4        or  step <= 2/omega (sqrt(1 + xi^2) - xi),  omega^2 = k, xi = c/(2 omega)

   k: stiffness over mass, c: viscosity over mass. Infinite without both. */

#ifndef POTDEM_CRITICAL_STEP_H
#define POTDEM_CRITICAL_STEP_H

#include "core/laws/device.h"

#include <cmath>

namespace POTDEM {

POTDEM_FUNCTION inline double critical_step(double k, double c)
{
  return 4.0 / (c + std::sqrt(c * c + 4.0 * k));
}

}    // namespace POTDEM

#endif
