/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* What the two conditions of a particle need to know of its bonds: sum A n n n (third order, balance) and sum A L/2 n n n n (fourth
   order, energy), as 10 + 15 distinct components in the order of direction_products(). */

#ifndef POTDEM_AREAS_MOMENTS_H
#define POTDEM_AREAS_MOMENTS_H

#include "mandel.h"

namespace POTDEM {

typedef std::array<double, MOMENTS> Moments;

// what is left of the conditions at a particle, dimensionless
struct Misfit {
  Matrix6 energy;                  // sum A L m (x) m / 2 over V, less the target
  std::array<Vector3, 6> force;    // sum A m (x) n over V^(2/3)

  // volume > 0; target: null for none
  Misfit(const Moments &, double volume, const Matrix6 *target);
  // push: force of the unit dilatation, over E'
  void add_push(const Vector3 &push, double volume);
  // energy^2 + force^2 as seen through K
  double square(const Matrix6 &admissible) const;
  // half of that square's slope with respect to the moments
  Moments slope(const Matrix6 &admissible, double volume) const;
};

}    // namespace POTDEM

#endif
