/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Where two particles that approach each other turn back if nothing else acts on them:

     Phi(r) = Phi(outer) + kinetic        kinetic: half the reduced mass times the square of the closing speed

   to a tenth of `kinetic`, which is what a time step needs. Newton's iteration, from the inner side where the potential
   is convex and it cannot pass the answer. Returns a distance between core and outer; lengths, energies. */

#ifndef POTDEM_TURNING_POINT_H
#define POTDEM_TURNING_POINT_H

#include "core/laws/device.h"

#include <cmath>

namespace POTDEM {

// law: distance -> Evaluation
template <class Law>
POTDEM_FUNCTION inline double turning_point(double outer, double core, double kinetic,
                                            const Law &law)
{
  constexpr int most = 30;
  constexpr double enough = 0.1, rounding = 1e-10, within = 1.0 - 1e-9;
  const auto start = law(core + within * (outer - core));    // at a cut the energy may jump
  const double energy = start.energy + kinetic;
  const double tolerance = enough * kinetic + rounding * std::fabs(energy);
  double r = core + 0.5 * (outer - core);
  if (start.force > 0.0) r = std::fmax(r, outer - kinetic / start.force);
  for (int k = 0; k < most; k++) {
    const auto at = law(r);
    const double excess = at.energy - energy;
    if (std::fabs(excess) <= tolerance) break;
    r = excess < 0.0 ? core + 0.5 * (r - core) : r + excess / at.force;
  }
  return r;
}

// how near two bodies come that are r apart and whose distance changes with `rate`, if they touch within the time `ahead`;
// else r. reach, hard_core: where the law begins and ends; mass: the effective one
template <class Law>
POTDEM_FUNCTION inline double closest_approach(double r, double rate, double ahead, double reach,
                                               double hard_core, double mass, const Law &law)
{
  if (rate >= 0.0 || r + rate * ahead >= reach) return r;
  return turning_point(std::fmin(r, reach), hard_core, 0.5 * mass * rate * rate, law);
}

}    // namespace POTDEM

#endif
