/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The stiffness tensor T_i that each particle's bonds shall have: C of the isotropic solid, corrected near surfaces.

   Particles carry the energy of a field at their centres and bonds at their middles, the solid carries it everywhere. With
   the variances of cells and bonds (sixth moment of the bulk) this misses one half of (variance):(second derivative) of the
   energy density in all cells; summed over the body only a layer along the surface is left, which T_i puts back by
   discrete second derivatives. Without it a beam of n particles through the depth is soft in bending by about 1.8/n^2. */

#ifndef POTDEM_AREAS_TARGETS_H
#define POTDEM_AREAS_TARGETS_H

#include "least_squares.h"
#include "surfaces.h"

namespace POTDEM {

class Targets {
 public:
  explicit Targets(const BondedBody &, const Surfaces &);    // C everywhere

  // T of each owned particle, over E; what to ask for to get there
  const std::vector<Matrix6> &wanted() const { return energy; }
  const std::vector<Matrix6> &asked() const { return request; }

  // the surface layer, with the sixth moments of the areas found so far. False: the network is a mechanism. Collective
  bool correct(const LeastSquares &, const std::vector<Matrix6> &admissible);
  // what the areas found still lack is asked for once more: the pull towards equal areas and the bounds leave the least squares
  // short of it
  void ask_for_missing(LeastSquares &);

 private:
  const BondedBody &body;
  const Surfaces &surfaces;
  std::vector<Matrix6> energy, request;

  double cell_variance() const;
};

// how far the bulk's bonds spread the energy: sixth moments, scaled to the solid's stiffness, in units of length^2
struct BulkMoments {
  bool
      stiff;    // false: the fourth moments, the stiffness itself, leave some strain without resistance
  std::array<Matrix6, 6> sixth;

  // from the bonds with at least so many ends inside. Collective
  BulkMoments(const BondedBody &, const Surfaces &, const LeastSquares &, int ends_inside);
};

}    // namespace POTDEM

#endif
