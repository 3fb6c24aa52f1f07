/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The dashpot of a bond: a fraction xi of the critical damping of its two particles on this bond alone,

     C = 2 xi sqrt(K m)        K stiffness at rest, m = mi mj/(mi + mj)

   It pulls with C dr/dt along the line of centres. */

#ifndef POTDEM_DASHPOT_H
#define POTDEM_DASHPOT_H

#include "device.h"

#include <cmath>

namespace POTDEM {

// viscosity C
POTDEM_FUNCTION inline double dashpot(double xi, double stiffness, double reduced_mass)
{
  return 2.0 * xi * std::sqrt(stiffness * reduced_mass);
}

}    // namespace POTDEM

#endif
