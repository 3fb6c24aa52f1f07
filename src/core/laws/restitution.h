/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* A dashpot beside any elastic law that only repels, which gives a collision the coefficient of restitution e, whatever its
   speed and whatever the law:

     F + c dw/dt,    c = 2 zeta F sqrt(m / (2 Phi))        w > 0,    not allowed to attract

   m reduced mass, Phi energy, F = dPhi/dw force of the elastic law. With y = sqrt(2 Phi) the motion m w'' = -F - c w' reads
   m v dv + 2 zeta sqrt(m) v dy + y dy = 0, v = w': in the plane of y and v that of a linear oscillator with the fraction zeta of
   critical damping. So e depends on zeta alone, and is that of the linear dashpot that lets go where the force has fallen to zero,
   which it does after the phase 2 acos(zeta):

     ln e = -2 zeta acos(zeta) / sqrt(1 - zeta^2)        zeta > 1: acosh(zeta)/sqrt(zeta^2 - 1)

   For Hertz c is that of Tsuji, Tanaka and Ishida (1992), sqrt(5) zeta sqrt(m K) w^(1/4); with the force cut at zero, e and zeta go
   together as in Schwager and Poeschel (2007) for the linear law.

   0 < e <= 1. */

#ifndef POTDEM_RESTITUTION_H
#define POTDEM_RESTITUTION_H

#include "approach.h"
#include "coefficients.h"
#include "device.h"

#include <cmath>

namespace POTDEM {

struct Restitution {
  double e = 1.0;
  double zeta = 0.0;    // of critical damping

  static constexpr auto coefficients()
  {
    return std::array{option("restitution", "e", &Restitution::e, up_to_one(), "1")};
  }

  template <class Law> static constexpr bool serves() { return Law::contact_only; }

  void complete() { zeta = damping_for(e); }

  POTDEM_FUNCTION bool active() const { return zeta > 0.0; }

  static Restitution mixed(const Restitution &a, const Restitution &b)
  {
    Restitution both{std::sqrt(a.e * b.e)};
    both.complete();
    return both;
  }

  POTDEM_FUNCTION double total(const Approach &at) const
  {
    const double sum = at.force - viscosity(at) * at.rate;
    return sum > 0.0 ? sum : 0.0;
  }

  // force over velocity
  POTDEM_FUNCTION double viscosity(const Approach &at) const
  {
    const double share = 0.5 * at.product / (at.sum * at.energy);
    return at.energy > 0.0 ? 2.0 * zeta * at.force * std::sqrt(share) : 0.0;
  }

  static double log_restitution(double zeta)
  {
    const double s = std::sqrt(std::fabs(1.0 - zeta * zeta));
    if (s < 1e-8) return -2.0;    // at zeta = 1
    const double angle = zeta < 1.0 ? std::acos(zeta) : std::acosh(zeta);
    return -2.0 * zeta * angle / s;
  }

 private:
  // halving; e falls as zeta grows, to 1/(2 zeta)^2 where zeta is large
  static double damping_for(double e)
  {
    if (e == 1.0) return 0.0;
    const double wanted = std::log(e);
    double low = 0.0, high = 1.0 + 1.0 / std::sqrt(e);
    for (int k = 0; k < 100; k++) {
      const double middle = 0.5 * (low + high);
      (log_restitution(middle) > wanted ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }
};

}    // namespace POTDEM

#endif
