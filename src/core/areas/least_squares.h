/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Areas x A0 of a body's bonds that minimise

     sum_i energy misfit^2 + imbalance^2 + PULL^2 sum (x - 1)^2,    LEAST <= x <= MOST,

   both misfits as seen through K_i: projected gradients, accelerated (FISTA), with restarts. One iteration is two loops over
   the bonds and one exchange of 25 numbers for each copy of a particle. All is dimensionless. */

#ifndef POTDEM_AREAS_LEAST_SQUARES_H
#define POTDEM_AREAS_LEAST_SQUARES_H

#include "bonded_body.h"
#include "moments.h"

namespace POTDEM {

class LeastSquares {
 public:
  // uniform: A0 > 0 of each bond; admissible: K of each owned particle. They and the body must live on. Collective
  LeastSquares(const BondedBody &, const std::vector<double> &uniform,
               const std::vector<Matrix6> &admissible);

  // target: T of each owned particle. Collective
  void iterate(int n, const std::vector<Matrix6> &target);

  const std::vector<double> &solution() const { return x; }    // of each bond
  double area(int bond) const { return x[bond] * uniform[bond]; }
  std::vector<double> areas() const;
  int iterations() const { return done; }
  // of the owned particles with the areas found, those without bonds included
  std::vector<Misfit> misfits(const std::vector<Matrix6> *target);

 private:
  const BondedBody &body;
  const std::vector<double> &uniform;
  const std::vector<Matrix6> &admissible;
  std::vector<double> x, step;
  std::vector<Vector3>
      push;    // of the volume term on each owned particle, for a dilatation of one, over E'; empty: there is none
  std::vector<Moments> moments;    // of all particles; then the misfit's slope with respect to them
  int done;

  void find_step();
  void find_push();
  Misfit misfit(int i, const Matrix6 *target) const;
  double curvature(int bond, const Matrix6 &k, double volume) const;
  double largest_eigenvalue(int i) const;
  void accumulate(const std::vector<double> &z);
  void find_slopes(const std::vector<double> &z, const std::vector<Matrix6> &target);
  double descend(const std::vector<double> &ahead, std::vector<double> &moved) const;
};

}    // namespace POTDEM

#endif
