/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Friction of elastic spheres that remember (Mindlin, 1949): tangential_spring.h with the stiffness of the contact itself,

     k = 8 G* sqrt(R w) = ratio * dF/dw,  ratio = 4 G* / E*        of equal materials 2 (1 - nu) / (2 - nu)
     1/G* = 2 (2 - nu_i)(1 + nu_i)/E_i + 2 (2 - nu_j)(1 + nu_j)/E_j

   for laws that know nu, which is Hertz's.

   friction mu mindlin [damping xi] */

#ifndef POTDEM_MINDLIN_H
#define POTDEM_MINDLIN_H

#include "tangential_spring.h"

namespace POTDEM {

struct Mindlin : public RemembersSlip<Mindlin> {
  static constexpr const char *keyword = "mindlin";
  static constexpr bool needs_shear_ratio = true;

  double mu = 0.0, xi = 0.0;

  static constexpr auto coefficients()
  {
    return std::array{required("mu", &Mindlin::mu, nonnegative(), "1"),
                      option("damping", "xi", &Mindlin::xi, nonnegative(), "1")};
  }

  static Mindlin mixed(const Mindlin &a, const Mindlin &b)
  {
    return {{}, std::fmin(a.mu, b.mu), 0.5 * (a.xi + b.xi)};
  }

  POTDEM_FUNCTION Mindlin undamped() const { return {{}, mu, 0.0}; }

  POTDEM_FUNCTION double stiffness(const Slide &at) const { return at.shear_ratio * at.stiffness; }
};

}    // namespace POTDEM

#endif
