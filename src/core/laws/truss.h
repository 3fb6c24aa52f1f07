/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The truss (thesis eqs 5.19 to 5.21): Green-Lagrange strain of the line of centres.

     x   = r / re                                    re = reference length
     eps = (r-re)/re + ((r-re)/re)^2 / 2 = (x^2 - 1) / 2
     F   = A E c(x) eps                              tension; force = -F in LAMMPS's sign
     Phi = A E re * integral of c eps dx from 1 to x (so that Phi(re) = 0)

   Centre distances are used throughout: the thesis's second form with surface distances agrees with
   the first only for r0 = 0, and its potential (5.21) is shifted here to vanish at re. c = 1 unless
   the non-penetration factor is asked for (penetration.h). Domain r > 0.
   Units: A E force, re and r length. */

#ifndef POTDEM_TRUSS_H
#define POTDEM_TRUSS_H

#include "coefficients.h"
#include "device.h"
#include "evaluation.h"
#include "four.h"
#include "penetration.h"

#include <cmath>

namespace POTDEM {

// section of a truss between two particles of mean diameter dbar: the circle with the mean radius
// (the thesis's own definition; its printed formula with d_i + d_j is four times as large)
POTDEM_FUNCTION inline double truss_section(double dbar)
{
  return 0.25 * M_PI * dbar * dbar;
}

// strain from q = (r/re)^2
template <class Number> POTDEM_FUNCTION inline Number truss_strain(const Number &q)
{
  return 0.5 * (q - 1.0);
}

struct Truss {
  static constexpr int STATE = 0;
  static constexpr bool optional_penetration = true, wide = true;

  double E, m, normalized;    // m = 0: no non-penetration factor

  static constexpr auto coefficients()
  {
    return std::array{required("E", &Truss::E, positive(), "stress").from(FROM_MATERIAL),
                      option("penetration", "m", &Truss::m, whole(MAX_PENETRATION), "1"),
                      flag("normalized", &Truss::normalized)};
  }

  struct Kernel {
    bool has_penetration = false;
    Penetration factor;

    // 2 c eps, the stress over E/2, from q = (r/re)^2, of one bond or of four. PENETRATION: some bond type has the factor
    template <bool PENETRATION = true, class Number>
    POTDEM_FUNCTION Number load(const Number &q, double * /*state*/ = nullptr) const
    {
      if constexpr (PENETRATION)
        if (has_penetration) return (q - 1.0) * factor.value(square_root(q));
      return q - 1.0;
    }

    // from x = r/re, of one bond or of four; unit: A E re
    template <class Number> POTDEM_FUNCTION Number energy(const Number &x, const Number &unit) const
    {
      if (has_penetration) {
        const auto integral = [this](double one) {
          return factor.integral(one);
        };
        return unit * of_each(x, integral);
      }
      const Number dx = x - 1.0;
      return (1.0 / 6.0) * unit * (dx * dx * (x + 2.0));
    }

    // modulus: A E; re: reference length
    POTDEM_FUNCTION Evaluation evaluate(double r, double re, double modulus,
                                        const double * /*state*/ = nullptr) const
    {
      const double x = r / re, q = x * x, stored = energy(x, modulus * re);
      if (!has_penetration) return {stored, -0.5 * modulus * load<false>(q), modulus * x / re};
      const double c = factor.value(x);
      return {stored, -0.5 * modulus * (q - 1.0) * c,
              modulus / re * (c * x + factor.slope(x) * truss_strain(q))};
    }
  };

  Kernel kernel() const
  {
    if (m == 0.0) return {};
    return {true, Penetration(static_cast<int>(m), normalized != 0.0)};
  }
};

}    // namespace POTDEM

#endif
