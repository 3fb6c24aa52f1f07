/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The viscous part of a contact force (thesis eq. 5.17), over the elastic force F at overlap w:

     F + F H (dw/dt) / w        w > 0

   which for Hertz is K w^(3/2) + K H w^(1/2) dw/dt. Unless asked for, the total force is not allowed to attract near
   separation (5.17 taken literally does). H time. */

#ifndef POTDEM_VISCOUS_H
#define POTDEM_VISCOUS_H

#include "approach.h"
#include "coefficients.h"
#include "device.h"

namespace POTDEM {

struct Viscous {
  double H, attract;

  static constexpr auto coefficients()
  {
    return std::array{option("viscous", "H", &Viscous::H, nonnegative(), "time"),
                      setting("attract", &Viscous::attract)};
  }

  template <class Law> static constexpr bool serves() { return Law::rate_dependent; }

  POTDEM_FUNCTION bool active() const { return H > 0.0; }

  static Viscous mixed(const Viscous &a, const Viscous &b)
  {
    return {0.5 * (a.H + b.H), a.attract != 0.0 || b.attract != 0.0 ? 1.0 : 0.0};
  }

  POTDEM_FUNCTION double total(const Approach &at) const
  {
    const double sum = at.force * (1.0 - H * at.rate / at.overlap);
    return attract != 0.0 || sum > 0.0 ? sum : 0.0;
  }

  // force over velocity
  POTDEM_FUNCTION double viscosity(const Approach &at) const { return at.force * H / at.overlap; }
};

}    // namespace POTDEM

#endif
