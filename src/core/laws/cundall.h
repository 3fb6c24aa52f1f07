/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Numerical damping (thesis eq. 5.30, after Cundall):  Fd = -lambda F sgn(F.v), F the total force on a particle, v its
   velocity; by component: -lambda |Fk| sgn(vk). sgn(0) = 0. 0 <= lambda < 1. */

#ifndef POTDEM_CUNDALL_H
#define POTDEM_CUNDALL_H

#include "device.h"

#include <cmath>

namespace POTDEM {

struct Cundall {
  double lambda;
  bool by_component;

  POTDEM_FUNCTION static double sign(double value) { return (value > 0.0) - (value < 0.0); }

  POTDEM_FUNCTION void force(const double *f, const double *v, double *damping) const
  {
    const double along = sign(f[0] * v[0] + f[1] * v[1] + f[2] * v[2]);
    for (int k = 0; k < 3; k++)
      damping[k] = -lambda * (by_component ? std::fabs(f[k]) * sign(v[k]) : along * f[k]);
  }

  // a force is raised by this factor at most, as it would be by a smaller mass
  POTDEM_FUNCTION double amplification() const { return 1.0 + lambda; }
};

}    // namespace POTDEM

#endif
