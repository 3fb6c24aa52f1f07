/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Hertz contact of two spheres (thesis eqs 5.15 and 5.16), overlap w = contact distance - r:

     F = K w^(3/2)        w > 0
     K = (4/3) Ebar sqrt(R),  R effective radius,  1/Ebar = (1-nu_i^2)/E_i + (1-nu_j^2)/E_j

   With equal materials Ebar = E / (2 (1 - nu^2)) (5.15c). The viscous term of 5.17 is viscous.h.
   E stress, -1 < nu <= 1/2. */

#ifndef POTDEM_HERTZ_H
#define POTDEM_HERTZ_H

#include "coefficients.h"
#include "contact_geometry.h"
#include "device.h"
#include "evaluation.h"

#include <cmath>

namespace POTDEM {

// Ebar
POTDEM_FUNCTION inline double contact_modulus(double Ei, double nui, double Ej, double nuj)
{
  return 1.0 / ((1.0 - nui * nui) / Ei + (1.0 - nuj * nuj) / Ej);
}

// w^(3/2) law with prefactor K
POTDEM_FUNCTION inline Evaluation hertz(double w, double K)
{
  const double root = std::sqrt(w);
  return {0.4 * K * w * w * root, K * w * root, 1.5 * K * root};
}

struct Hertz {
  static constexpr bool contact_only = true, rate_dependent = true;

  double E, nu;
  double modulus;    // Ebar

  static constexpr auto coefficients()
  {
    return std::array{required("E", &Hertz::E, positive(), "stress").from(FROM_MATERIAL),
                      required("nu", &Hertz::nu, poisson_ratio(), "1").from(FROM_MATERIAL)};
  }

  void complete() { modulus = contact_modulus(E, nu, E, nu); }

  // 5.15b, kept as two equal materials with that contact modulus
  static Hertz mixed(const Hertz &a, const Hertz &b)
  {
    const double modulus = contact_modulus(a.E, a.nu, b.E, b.nu);
    return {2.0 * modulus, 0.0, modulus};
  }

  POTDEM_FUNCTION static double reach(double dbar) { return dbar; }

  struct Kernel {
    double modulus;

    template <class Geometry> POTDEM_FUNCTION static constexpr double hard_core(const Geometry &)
    {
      return 0.0;
    }

    template <class Geometry>
    POTDEM_FUNCTION Evaluation evaluate(double r, const Geometry &at) const
    {
      if (r >= at.contact) return {0.0, 0.0, 0.0};
      return hertz(at.contact - r, 4.0 / 3.0 * modulus * std::sqrt(at.effective_radius()));
    }
  };

  Kernel kernel(bool /*shift*/) const { return {modulus}; }
};

}    // namespace POTDEM

#endif
