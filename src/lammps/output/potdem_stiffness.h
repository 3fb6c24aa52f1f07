/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The longest stable step, particle by particle. Velocity Verlet, with viscous forces that see the velocity of half
   a step before, is stable if for every motion u of all particles

     step^2 u.K u + 2 step u.C u <= 4 u.M u        K stiffness, C viscosity, M masses

   A pair with tangent H adds (ui - uj).H (ui - uj), which for any t > 0 is at most (1 + t) ui.H ui + (1 + 1/t) uj.H uj;
   t = sqrt(mi/mj) serves equal and very different masses well. A wall adds ui.H ui. So it is enough that every particle
   has

     step^2 k + 2 step c <= 4
     k, c: largest eigenvalues of sum over pairs H (1/mi + 1/sqrt(mi mj)) + sum over walls H/mi

   (core/stability/critical_step.h). */

#ifndef LMP_POTDEM_STIFFNESS_H
#define LMP_POTDEM_STIFFNESS_H

#include "core/stability/spring.h"

#include <cmath>
#include <vector>

namespace LAMMPS_NS {

using PotdemSpring = POTDEM::Spring;

// times; infinite without stiffness and viscosity
struct PotdemSteps {
  double stable;
  double elastic;     // stable without viscosity
  double stiffest;    // sqrt(m/K) with the stiffest of all springs
};

class PotdemStiffness {
 public:
  static constexpr int WIDTH = 13;    // numbers per particle

  void reset(std::vector<double> inverse_root_masses);    // owned and ghost particles
  void add_pair(int i, int j, bool to_both, const PotdemSpring &);
  void add_wall(int i, const PotdemSpring &spring) { add(i, spring, inverse_root[i]); }

  PotdemSteps steps(int i) const;
  PotdemSteps short_of_steps(int i) const;    // not above them, and quick

  void pack(int i, double *buf) const;
  void unpack(int i, const double *buf);
  double memory_usage() const;

 private:
  struct Tensor {
    double xx, yy, zz, xy, xz, yz;
    void add(const double *n, double along, double across);
    void add(const Tensor &);
    double largest_eigenvalue() const;
    double largest_row() const;
  };
  std::vector<double> inverse_root;
  std::vector<Tensor> stiffness, viscosity;    // viscosity: empty until there is some
  std::vector<double> stiffest;

  void add(int i, const PotdemSpring &, double share);
  PotdemSteps steps_of(int i, double (Tensor::*largest)() const) const;
};

// along n n + across (1 - n n)
inline void PotdemStiffness::Tensor::add(const double *n, double along, double across)
{
  const double more = along - across;
  xx += across + more * n[0] * n[0];
  yy += across + more * n[1] * n[1];
  zz += across + more * n[2] * n[2];
  xy += more * n[0] * n[1];
  xz += more * n[0] * n[2];
  yz += more * n[1] * n[2];
}

// 1/sqrt(mi) is left for the end
inline void PotdemStiffness::add(int i, const PotdemSpring &spring, double share)
{
  const double along = spring.along > 0.0 ? spring.along : 0.0;
  const double across = spring.across > 0.0 ? spring.across : 0.0;
  stiffness[i].add(spring.n, share * along, share * across);
  if (along > stiffest[i]) stiffest[i] = along;
  if (spring.viscosity == 0.0 && spring.friction == 0.0) return;
  if (viscosity.empty()) viscosity.assign(stiffness.size(), {});
  viscosity[i].add(spring.n, share * spring.viscosity, share * spring.friction);
}

inline void PotdemStiffness::add_pair(int i, int j, bool to_both, const PotdemSpring &spring)
{
  const double share = inverse_root[i] + inverse_root[j];
  add(i, spring, share);
  if (to_both) add(j, spring, share);
}

}    // namespace LAMMPS_NS

#endif
