/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Shifted Lennard-Jones (thesis eqs 5.7 to 5.11), in the distance s from the largest admissible co-penetration:

     s   = r - r0,  r0 = (1 - alpha) dbar
     Phi = D [(R/s)^2n - 2 (R/s)^n],  D = K0 R^2 / (2 n^2)        s > 0
   The force vanishes at s = R, where the stiffness is K0. Cut at s_c, by default
     s_d = R ((2n+1)/(n+1))^(1/n)                                 where the attraction is largest
   the thesis's choice: no softening branch. The force jumps there by design.
   K0 force/length; R, s_c length; n > 0 real; 0 <= alpha < 1. For a pair with a shorter contact distance
   (ContactGeometry) r0 moves by the same amount. With `least` the law goes on straight below that s (continued.h), 0 < least < R. */

#ifndef POTDEM_SHIFTED_LJ_H
#define POTDEM_SHIFTED_LJ_H

#include "coefficients.h"
#include "contact_geometry.h"
#include "continued.h"
#include "device.h"
#include "evaluation.h"
#include "power.h"

namespace POTDEM {

struct ShiftedLJ {
  static constexpr bool contact_only = false, rate_dependent = false;

  double K0, R, n, alpha;
  double cut;            // s_c
  double least = 0.0;    // 0: none

  static constexpr auto coefficients()
  {
    return std::array{
        required("K0", &ShiftedLJ::K0, positive(), "force/length").from(FROM_MATERIAL_LENGTH),
        required("R", &ShiftedLJ::R, positive(), "length"),
        required("n", &ShiftedLJ::n, positive(), "1").must_agree(),
        required("alpha", &ShiftedLJ::alpha, fraction(), "1"),
        option("cut", "s_c", &ShiftedLJ::cut, positive(), "length"),
        option("linear", "s_min", &ShiftedLJ::least, positive(), "length").below(&ShiftedLJ::R)};
  }

  void complete()
  {
    if (cut == 0.0) cut = default_cut(R, n);
  }

  // springs in series, mean distances; linear only if both are
  static ShiftedLJ mixed(const ShiftedLJ &a, const ShiftedLJ &b)
  {
    const double least = a.least > 0.0 && b.least > 0.0 ? 0.5 * (a.least + b.least) : 0.0;
    return {series_modulus(a.K0, b.K0), 0.5 * (a.R + b.R),     a.n,
            0.5 * (a.alpha + b.alpha),  0.5 * (a.cut + b.cut), least};
  }

  static double default_cut(double R, double n)
  {
    return R * std::pow((2.0 * n + 1.0) / (n + 1.0), 1.0 / n);
  }

  POTDEM_FUNCTION double reach(double dbar) const { return (1.0 - alpha) * dbar + cut; }

  struct Kernel {
    double D, R, n, alpha, cut, least, offset;
    Power power;

    template <class Geometry> POTDEM_FUNCTION double r0(const Geometry &at) const
    {
      return at.contact - alpha * at.dbar();
    }
    template <class Geometry> POTDEM_FUNCTION double hard_core(const Geometry &at) const
    {
      return least > 0.0 ? 0.0 : r0(at);
    }

    POTDEM_FUNCTION Evaluation law_at(double s) const
    {
      const double p = power(R / s);
      const double slope = 2.0 * D * n / s;
      return {D * p * (p - 2.0) - offset, slope * p * (p - 1.0),
              slope / s * p * ((2.0 * n + 1.0) * p - (n + 1.0))};
    }

    template <class Geometry>
    POTDEM_FUNCTION Evaluation evaluate(double r, const Geometry &at) const
    {
      const double s = r - r0(at);
      if (s >= cut) return {0.0, 0.0, 0.0};
      return continued(s, least, [this](double t) {
        return law_at(t);
      });
    }
  };

  // shift: energy zero at the cut
  Kernel kernel(bool shift) const
  {
    Kernel made{K0 * R * R / (2.0 * n * n), R, n, alpha, cut, least, 0.0, Power(n)};
    if (shift) made.offset = made.law_at(cut).energy;
    return made;
  }
};

}    // namespace POTDEM

#endif
