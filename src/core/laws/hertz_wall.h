/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Hertz contact of a sphere with a flat wall under a soft layer (thesis eqs 5.25 to 5.28):

     w      = ri + gamma - distance of the centre from the surface        contact while w > 0
     chi(w) = min(1, (w/gamma)^(1/m))                                    1 without a layer
     T      = (4/3) Ebar sqrt(ri) w^(3/2) chi(w)
     Phi    = integral of T dw from 0 to w
     1/Ebar = (1 - nu_i^2)/E_i + (1 - nu_j^2)/E_j

   Domain: distance > -ri. Where the centre has passed the surface the force goes on, so that a particle that is pressed
   harder than (4/3) Ebar ri^2 comes back. 5.26 as printed multiplies the tangent stiffness 5.25 by w^(3/2), which is no force law; the secant
   form is meant. gamma = layer * ri with layer dimensionless; m >= 1. */

#ifndef POTDEM_HERTZ_WALL_H
#define POTDEM_HERTZ_WALL_H

#include "device.h"
#include "hertz.h"

namespace POTDEM {

struct HertzWall {
  static constexpr bool contact_only = true, rate_dependent = true;
  // the thesis's soft layer, eq. 5.28
  static constexpr double LAYER = 0.1, LAYER_EXPONENT = 2.0;

  double E, nu, particle_E, particle_nu;
  double layer = LAYER;    // gamma / ri, 0: no layer
  double m = LAYER_EXPONENT;
  double modulus = 0.0, shear = 0.0;    // Ebar; 4 G* / Ebar

  static constexpr auto coefficients()
  {
    using Law = HertzWall;
    return std::array{
        required("E", &Law::E, positive(), "stress").from(FROM_MATERIAL).of(" of the wall"),
        required("nu", &Law::nu, poisson_ratio(), "1").from(FROM_MATERIAL).of(" of the wall"),
        required("E", &Law::particle_E, positive(), "stress")
            .from(FROM_MATERIAL)
            .of(" of the particle")
            .following("particle",
                       "the particles' own elasticity is missing, give 'particle E nu' after E and "
                       "nu of the wall"),
        required("nu", &Law::particle_nu, poisson_ratio(), "1")
            .from(FROM_MATERIAL)
            .of(" of the particle"),
        option("layer", "gamma_over_r", &Law::layer, positive(), "1").or_none(),
        continued_by("layer", "m", &Law::m, at_least(1.0), "1")};
  }

  void complete()
  {
    modulus = contact_modulus(particle_E, particle_nu, E, nu);
    shear = shear_ratio(particle_E, particle_nu, E, nu);
  }

  POTDEM_FUNCTION double reach(double ri) const { return ri + layer * ri; }

  struct Kernel {
    double modulus, layer, m, shear_ratio;

    POTDEM_FUNCTION static double hard_core(const WallGeometry &at) { return at.deepest(); }

    POTDEM_FUNCTION Evaluation evaluate(double r, const WallGeometry &at) const
    {
      if (r >= at.contact) return {0.0, 0.0, 0.0};
      return at_overlap(at.contact - r, at.ri);
    }

    // w >= 0
    POTDEM_FUNCTION Evaluation at_overlap(double w, double ri) const
    {
      const double gamma = layer * ri;
      auto found = hertz(w, std::sqrt(ri * w), modulus);
      if (w < gamma) {
        const double chi = root(w / gamma);
        return {found.energy * chi * layer_share(), found.force * chi,
                found.stiffness * chi * (1.0 + 1.0 / (1.5 * m))};
      }
      if (gamma > 0.0)
        found.energy -= hertz(gamma, std::sqrt(ri * gamma), modulus).energy * (1.0 - layer_share());
      return found;
    }

   private:
    // integral of w^(3/2 + 1/m) over that of w^(3/2)
    POTDEM_FUNCTION double layer_share() const { return 2.5 / (2.5 + 1.0 / m); }

    // no pow for the exponents in use
    POTDEM_FUNCTION double root(double t) const
    {
      if (m == 2.0) return std::sqrt(t);
      if (m == 1.0) return t;
      return std::exp(std::log(t) / m);
    }
  };

  Kernel kernel(bool /*shift*/) const { return {modulus, layer, m, shear}; }
};

}    // namespace POTDEM

#endif
