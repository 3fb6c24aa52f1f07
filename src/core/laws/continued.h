/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* A law that grows without bound as s -> 0, continued below s = least by its tangent there:

     F = F(least) + K(least) (least - s),  Phi its integral,  K = K(least)        s < least

   so that force, energy and stiffness are bounded, energy and force without a jump, and the critical step has a
   least value. least = 0: the law as it is. Lengths. */

#ifndef POTDEM_CONTINUED_H
#define POTDEM_CONTINUED_H

#include "device.h"
#include "evaluation.h"

namespace POTDEM {

// law: s -> Evaluation
template <class Law>
POTDEM_FUNCTION inline Evaluation continued(double s, double least, const Law &law)
{
  if (s >= least) return law(s);
  const auto edge = law(least);
  const double beyond = least - s;
  return {edge.energy + beyond * (edge.force + 0.5 * beyond * edge.stiffness),
          edge.force + beyond * edge.stiffness, edge.stiffness};
}

}    // namespace POTDEM

#endif
