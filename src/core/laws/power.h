/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* x^n for the exponents in use: whole and half numbers by multiplication and one square root, all others
   by exp and log; never pow. Domain x > 0. */

#ifndef POTDEM_POWER_H
#define POTDEM_POWER_H

#include "device.h"

#include <cmath>

namespace POTDEM {

class Power {
 public:
  Power() = default;
  explicit Power(double exponent) :
      n(exponent), whole(static_cast<int>(std::floor(exponent))), half(exponent - whole == 0.5),
      general(exponent < 0.0 || exponent > 64.0 || (exponent != whole && !half))
  {
  }

  POTDEM_FUNCTION double operator()(double x) const
  {
    if (general) return std::exp(n * std::log(x));
    double power = half ? std::sqrt(x) : 1.0;
    for (int k = whole; k > 0; k >>= 1, x *= x)
      if (k & 1) power *= x;
    return power;
  }

 private:
  double n = 1.0;
  int whole = 1;
  bool half = false, general = false;
};

}    // namespace POTDEM

#endif
