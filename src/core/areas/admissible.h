/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The strains in which a particle's energy and balance count: K_i = sum trust^2 eps (x) eps over the strains of the stress states
   that are admissible at it, orthonormal in energy. Inside the body these are all states, and K_i is the compliance.
   States with a traction on a blocked direction drop out. Below a surface the normal stress across it counts less, the more so the
   nearer it is: it grows with the square of the depth. By how much is told by the second moment of the bonds, which are cut off
   there, and by the blocked directions of all particles nearby. Shear grows with the depth itself, as in a bar under torsion, and
   counts as much as the better of its two directions; in the cell of an edge there is some, too, that goes around the edge. */

#ifndef POTDEM_AREAS_ADMISSIBLE_H
#define POTDEM_AREAS_ADMISSIBLE_H

#include "surfaces.h"
#include "uniform_areas.h"

namespace POTDEM {

// K of the owned particles, symmetric, >= 0, dimensionless; 0 where there are no bonds. Collective
std::vector<Matrix6> admissible_strains(const BondedBody &, const Surfaces &, const UniformAreas &);

struct StressState {
  double trust;    // 0 to 1
  Vector6 stress;
};
// K of independent states; the most trusted come first in making them orthonormal
Matrix6 energy_norm(std::vector<StressState> states, const Matrix6 &compliance);

}    // namespace POTDEM

#endif
