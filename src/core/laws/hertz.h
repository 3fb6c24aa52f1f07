/* Hertz contact of two spheres (thesis eqs 5.15 to 5.17), overlap w = contact distance - r:

     F = K w^(3/2) + K H w^(1/2) dw/dt        w > 0
     K = (4/3) Ebar sqrt(R),  R effective radius,  1/Ebar = (1-nu_i^2)/E_i + (1-nu_j^2)/E_j
   With equal materials Ebar = E / (2 (1 - nu^2)) (5.15c). Unless asked for, the total force is not
   allowed to attract near separation (5.17 taken literally does).
   E stress, -1 < nu <= 1/2, H time. */

#ifndef POTDEM_HERTZ_H
#define POTDEM_HERTZ_H

#include "core/laws/contact_geometry.h"
#include "evaluation.h"

#include <cmath>

namespace POTDEM {

// Ebar
inline double contact_modulus(double Ei, double nui, double Ej, double nuj)
{
  return 1.0 / ((1.0 - nui * nui) / Ei + (1.0 - nuj * nuj) / Ej);
}

// w^(3/2) law with prefactor K
inline Evaluation hertz(double w, double K)
{
  const double root = std::sqrt(w);
  return {0.4 * K * w * w * root, K * w * root, 1.5 * K * root};
}

struct Hertz {
  static constexpr bool contact_only = true, rate_dependent = true;

  double E, nu;
  double modulus;    // Ebar
  double H;
  int attract;

  static Hertz of(double E, double nu) { return {E, nu, contact_modulus(E, nu, E, nu), 0.0, 0}; }

  static double reach(double dbar) { return dbar; }

  struct Kernel {
    double modulus, H;
    bool attract;

    static constexpr double hard_core(const ContactGeometry &) { return 0.0; }

    Evaluation evaluate(double r, const ContactGeometry &pair) const
    {
      if (r >= pair.contact) return {0.0, 0.0, 0.0};
      return hertz(pair.contact - r, 4.0 / 3.0 * modulus * std::sqrt(pair.effective_radius()));
    }

    // total normal force with the rate of the distance; elastic: the force without it
    double with_rate(double elastic, double r, const ContactGeometry &pair, double rate) const
    {
      const double total = elastic * (1.0 - H * rate / (pair.contact - r));
      return attract || total > 0.0 ? total : 0.0;
    }
  };

  Kernel kernel(bool /*shift*/) const { return {modulus, H, attract != 0}; }
};

}    // namespace POTDEM

#endif
