/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* No rate law, no tangential law. */

#ifndef POTDEM_NONE_H
#define POTDEM_NONE_H

#include "coefficients.h"

namespace POTDEM {

struct Elastic {
  static constexpr std::array<Coefficient<Elastic>, 0> coefficients() { return {}; }
  template <class Law> static constexpr bool serves() { return true; }
  static constexpr bool active() { return false; }
  static Elastic mixed(const Elastic &, const Elastic &) { return {}; }
};
struct Frictionless {
  static constexpr int STATE = 0;
  static constexpr double mu = 0.0;
};

}    // namespace POTDEM

#endif
