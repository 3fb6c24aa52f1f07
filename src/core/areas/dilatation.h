/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* What makes a solid of bonds one of another Poisson's ratio than 1/4: an energy of the change of volume at each particle,

     W = 1/2 kappa sum_i V_i theta_i^2,    theta_i = sum over the bonds of i of c_ib eps_b,

   beside that of the bonds. theta_i, the dilatation, is the trace of the strain at the particle. Its weights c_ib give it exactly in every
   uniform strain that is admissible at the particle; of all such weights they are those with the least sum of c^2 2 V/(A L), 3/2
   inside. By Cauchy's inequality W takes back at most -kappa times this sum of the energy of the bonds; where that would be too much, at few
   particles of random packings, the weights are less. So the whole resists every strain if kappa < 0, too.
   Each bond carries the force kappa (V_i theta_i c_ib + V_j theta_j c_jb) / L beside its own. Here forces and energies are over E'
   (elasticity.h). */

#ifndef POTDEM_AREAS_DILATATION_H
#define POTDEM_AREAS_DILATATION_H

#include "bonded_body.h"

namespace POTDEM {

class Dilatation {
 public:
  // areas: of the bonds; admissible: K of each owned particle. Collective
  Dilatation(const BondedBody &, const std::vector<double> &areas,
             const std::vector<Matrix6> &admissible);

  // c of a bond at its low (0) and at its high end (1)
  double weight(std::size_t bond, int end) const { return weights[2 * bond + end]; }
  // force on each owned particle where kappa theta is 1 everywhere
  std::vector<Vector3> pushes() const;

 private:
  const BondedBody &body;
  std::vector<double> weights;
};

}    // namespace POTDEM

#endif
