/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The motion of two bodies at their contact, for particles with and without spin, spheres and discs, and walls alike.

   del points from the second to the first centre (from a wall's surface to the centre), r is its length, v the velocity of
   the first over the second one. Where surfaces move with the spin (SPIN), `spin` is the sum over the two of
   lever * angular velocity: lever = radius / (ri + rj) of a pair, 1 of a particle at a wall; the arm from a centre to the
   contact is lever * del long. `spin_between` is the angular velocity of the first over that of the second, `spin_of_both` their
   mean. */

#ifndef POTDEM_KINEMATICS_H
#define POTDEM_KINEMATICS_H

#include "core/laws/device.h"

namespace POTDEM {

struct ContactMotion {
  double del[3], r;
  double v[3];
  double spin[3], spin_between[3], spin_of_both[3];
};

// of two particles
POTDEM_FUNCTION inline void spin_of(const double *wi, const double *wj, double ri, double rj,
                                    ContactMotion &at)
{
  const double inverse = 1.0 / (ri + rj);
  for (int k = 0; k < 3; k++) {
    at.spin[k] = inverse * (ri * wi[k] + rj * wj[k]);
    at.spin_between[k] = wi[k] - wj[k];
    at.spin_of_both[k] = 0.5 * (wi[k] + wj[k]);
  }
}

POTDEM_FUNCTION inline double dot(const double *a, const double *b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// dr/dt
POTDEM_FUNCTION inline double rate_of_distance(const ContactMotion &at)
{
  return dot(at.v, at.del) * (1.0 / at.r);
}

// of the first surface over the second
template <bool SPIN>
POTDEM_FUNCTION inline void sliding_velocity(const ContactMotion &at, double *u)
{
  const double inverse = 1.0 / at.r, along = dot(at.v, at.del) * inverse * inverse;
  for (int k = 0; k < 3; k++) u[k] = at.v[k] - along * at.del[k];
  if (!SPIN) return;
  u[0] -= at.spin[1] * at.del[2] - at.spin[2] * at.del[1];
  u[1] -= at.spin[2] * at.del[0] - at.spin[0] * at.del[2];
  u[2] -= at.spin[0] * at.del[1] - at.spin[1] * at.del[0];
}

// of a force f on the first at the contact: the torque on either body is its lever times this
POTDEM_FUNCTION inline void torque_over_lever(const double *del, const double *f, double *torque)
{
  torque[0] = f[1] * del[2] - f[2] * del[1];
  torque[1] = f[2] * del[0] - f[0] * del[2];
  torque[2] = f[0] * del[1] - f[1] * del[0];
}

}    // namespace POTDEM

#endif
