/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Cohesive contact of two spheres after Derjaguin, Muller and Toporov (1975): Hertz, pulled by a constant force as long as they touch,
   overlap w = contact distance - r:

     F = K w^(3/2) - P        w > 0
     P = 4 pi gamma R         gamma surface energy, R effective radius; P is the force that pulls them apart

   K: hertz.h. The force jumps by P where they touch, the energy does not. Dashpots and friction act on the Hertz part, by which
   the two are pressed together.
   E stress, -1 < nu <= 1/2, gamma >= 0 energy per area. */

#ifndef POTDEM_DMT_H
#define POTDEM_DMT_H

#include "coefficients.h"
#include "contact_geometry.h"
#include "device.h"
#include "evaluation.h"
#include "hertz.h"

#include <cmath>

namespace POTDEM {

struct Dmt {
  static constexpr bool contact_only = true, rate_dependent = true, wide = true;

  double E, nu, gamma;
  double modulus, shear;    // Ebar, 4 G*/Ebar

  static constexpr auto coefficients()
  {
    return std::array{required("E", &Dmt::E, positive(), "stress").from(FROM_MATERIAL),
                      required("nu", &Dmt::nu, poisson_ratio(), "1").from(FROM_MATERIAL),
                      required("gamma", &Dmt::gamma, nonnegative(), "energy/area")};
  }

  void complete()
  {
    modulus = contact_modulus(E, nu, E, nu);
    shear = shear_ratio(E, nu, E, nu);
  }

  static Dmt mixed(const Dmt &a, const Dmt &b)
  {
    const auto elastic =
        Hertz::mixed({a.E, a.nu, a.modulus, a.shear}, {b.E, b.nu, b.modulus, b.shear});
    return {elastic.E, elastic.nu, std::sqrt(a.gamma * b.gamma), elastic.modulus, elastic.shear};
  }

  POTDEM_FUNCTION static double reach(double dbar) { return dbar; }

  struct Kernel {
    Hertz::Kernel elastic;
    double gamma, shear_ratio;

    template <class Geometry> POTDEM_FUNCTION static constexpr double hard_core(const Geometry &)
    {
      return 0.0;
    }

    // P
    template <class Geometry> POTDEM_FUNCTION double pull(const Geometry &at) const
    {
      constexpr double four_pi = 12.566370614359172;
      return four_pi * gamma * at.effective_radius();
    }

    template <class Geometry>
    POTDEM_FUNCTION Evaluation pressing(double r, const Geometry &at) const
    {
      return elastic.evaluate(r, at);
    }

    template <class Geometry>
    POTDEM_FUNCTION Evaluation evaluate(double r, const Geometry &at) const
    {
      const auto hertz = pressing(r, at);
      const double w = at.contact - r, P = w > 0.0 ? pull(at) : 0.0;
      return {hertz.energy - P * w, hertz.force - P, hertz.stiffness};
    }
  };

  Kernel kernel(bool /*shift*/) const { return {{modulus, shear}, gamma, shear}; }
};

}    // namespace POTDEM

#endif
