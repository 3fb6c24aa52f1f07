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

// 4 G* / Ebar, of the tangential stiffness to the normal one (Mindlin)
inline double shear_ratio(double Ei, double nui, double Ej, double nuj)
{
  const double compliance =
      2.0 * (2.0 - nui) * (1.0 + nui) / Ei + 2.0 * (2.0 - nuj) * (1.0 + nuj) / Ej;
  return 4.0 / (compliance * contact_modulus(Ei, nui, Ej, nuj));
}

// root: sqrt(R w)
POTDEM_FUNCTION inline Evaluation hertz(double w, double root, double modulus)
{
  const double secant = 4.0 / 3.0 * modulus * root, force = secant * w;
  return {0.4 * force * w, force, 1.5 * secant};
}

struct Hertz {
  static constexpr bool contact_only = true, rate_dependent = true, wide = true;

  double E, nu;
  double modulus, shear;    // Ebar; 4 G* / Ebar

  static constexpr auto coefficients()
  {
    return std::array{required("E", &Hertz::E, positive(), "stress").from(FROM_MATERIAL),
                      required("nu", &Hertz::nu, poisson_ratio(), "1").from(FROM_MATERIAL)};
  }

  void complete()
  {
    modulus = contact_modulus(E, nu, E, nu);
    shear = shear_ratio(E, nu, E, nu);
  }

  // 5.15b, kept as two equal materials of that contact modulus and shear ratio 2 (1 - nu)/(2 - nu)
  static Hertz mixed(const Hertz &a, const Hertz &b)
  {
    const double modulus = contact_modulus(a.E, a.nu, b.E, b.nu);
    const double shear = shear_ratio(a.E, a.nu, b.E, b.nu);
    const double nu = (2.0 - 2.0 * shear) / (2.0 - shear);
    return {2.0 * modulus * (1.0 - nu * nu), nu, modulus, shear};
  }

  POTDEM_FUNCTION static double reach(double dbar) { return dbar; }

  struct Kernel {
    double modulus, shear_ratio;

    template <class Geometry>
    POTDEM_FUNCTION static constexpr double hard_core([[maybe_unused]] const Geometry &at)
    {
      if constexpr (Geometry::flat)
        return at.deepest();
      else
        return 0.0;
    }

    template <class Geometry>
    POTDEM_FUNCTION Evaluation evaluate(double r, const Geometry &at) const
    {
      const double apart = at.contact - r, w = apart > 0.0 ? apart : 0.0;
      return hertz(w, std::sqrt(at.effective_radius() * w), modulus);
    }
  };

  Kernel kernel(bool /*shift*/) const { return {modulus, shear}; }
};

}    // namespace POTDEM

#endif
