/* Hertz contact of a sphere with a flat wall under a soft layer (thesis eqs 5.25 to 5.28):

     w      = ri + gamma - distance of the centre from the surface        contact while w > 0
     chi(w) = min(1, (w/gamma)^(1/m))                                    1 without a layer
     T      = (4/3) Ebar sqrt(ri) w^(3/2) chi(w)
     Phi    = integral of T dw from 0 to w
     1/Ebar = (1 - nu_i^2)/E_i + (1 - nu_j^2)/E_j

   5.26 as printed multiplies the tangent stiffness 5.25 by w^(3/2), which is no force law; the secant
   form is meant. The optional viscous term of 5.17, T H (dw/dt)/w, belongs to the same chi and may not
   make the wall attract. gamma = layer * ri with layer dimensionless; m >= 1; H time.
   Units: Ebar stress; T force. Returned force > 0 pushes the particle off the wall. */

#ifndef POTDEM_HERTZ_WALL_H
#define POTDEM_HERTZ_WALL_H

#include "hertz.h"

namespace POTDEM {

struct HertzWall {
  double modulus;    // Ebar
  double layer;      // gamma / ri, 0: no layer
  double m;

  double thickness(double ri) const { return layer * ri; }

  Evaluation evaluate(double w, double ri) const
  {
    const double K = 4.0 / 3.0 * modulus * std::sqrt(ri);
    const double gamma = thickness(ri);
    auto at = hertz(w, K);
    if (w < gamma) {
      const double chi = root(w / gamma);
      return {at.energy * chi * layer_share(), at.force * chi,
              at.stiffness * chi * (1.0 + 1.0 / (1.5 * m))};
    }
    if (gamma > 0.0) at.energy -= hertz(gamma, K).energy * (1.0 - layer_share());
    return at;
  }

 private:
  // integral of w^(3/2 + 1/m) over that of w^(3/2)
  double layer_share() const { return 2.5 / (2.5 + 1.0 / m); }

  // no pow for the exponents in use
  double root(double t) const
  {
    if (m == 2.0) return std::sqrt(t);
    if (m == 1.0) return t;
    return std::exp(std::log(t) / m);
  }
};

}    // namespace POTDEM

#endif
