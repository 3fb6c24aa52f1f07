/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Sliding friction (thesis eqs 5.18 and 5.27): T = -min(eta |u|, mu |F|) u/|u|

   u: sliding velocity, F: normal force, eta: mass per time, mu: dimensionless. T is exactly zero at
   u = 0. The pure Coulomb form of 5.27 is the limit eta -> infinity; it reverses the sliding within a
   step. `auto` is the largest eta with which a single contact cannot: effective mass / step.
   At a wall all other forces on the particle are known, and `auto` means the force that brings the
   particle to rest within the step (`stop`), as far as mu |F| allows: it holds a particle at rest
   without creep.
   Where a particle may spin, its surface gives way sooner: `sliding_mass` is what resists there. */

#ifndef POTDEM_SLIDING_H
#define POTDEM_SLIDING_H

#include "coefficients.h"
#include "device.h"
#include "slide.h"

#include <cmath>

namespace POTDEM {

struct Sliding {
  static constexpr int STATE = 0;
  static constexpr const char *keyword = "";

  double mu = 0.0, eta = 0.0, automatic = 0.0;

  static constexpr auto coefficients()
  {
    using Law = Sliding;
    return std::array{required("mu", &Law::mu, nonnegative(), "1"),
                      required("eta", &Law::eta, nonnegative(), "mass/time")
                          .called("friction eta")
                          .or_word("auto", &Law::automatic)};
  }

  // the more slippery material decides; a viscosity is in parallel with the limit, so the larger one
  static Sliding mixed(const Sliding &a, const Sliding &b)
  {
    const bool either = a.automatic != 0.0 || b.automatic != 0.0;
    return {std::fmin(a.mu, b.mu), std::fmax(a.eta, b.eta), either ? 1.0 : 0.0};
  }

  // Coulomb friction against a force `stop` that would end the sliding within the step: its share
  POTDEM_FUNCTION double share(double stop, double normal_force) const
  {
    const double limit = mu * std::fabs(normal_force);
    return stop <= limit ? 1.0 : limit / stop;
  }

  // the factor b of T = -b u
  POTDEM_FUNCTION double factor(double speed, double normal_force, double viscosity) const
  {
    const double limit = mu * std::fabs(normal_force);
    return viscosity * speed <= limit ? viscosity : limit / speed;
  }

  POTDEM_FUNCTION void force(const Slide &at, double * /*state*/, double *f) const
  {
    const double speed = std::sqrt(at.u[0] * at.u[0] + at.u[1] * at.u[1] + at.u[2] * at.u[2]);
    const double b =
        speed > 0.0 ? factor(speed, at.normal, automatic != 0.0 ? at.mass_over_step : eta) : 0.0;
    for (int k = 0; k < 3; k++) f[k] = -b * at.u[k];
  }

  // 'auto' follows the step and does not limit it
  POTDEM_FUNCTION double viscosity(const Slide &) const { return automatic != 0.0 ? 0.0 : eta; }
};

}    // namespace POTDEM

#endif
