/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Regularised granular contact (thesis eqs 5.12 to 5.14), in s = r - r0, r0 = (1 - alpha) dbar, with
   2 delta = alpha dbar the value of s at first contact:

     F   = c / s^n   repulsive,   Phi = c / ((n-1) s^(n-1)),   c = K0 (2 delta)^(n+1) / n     s > 0
   so that the stiffness at first contact is K0. F never vanishes by itself: it is cut at s = x 2 delta,
   by default where it has fallen to 1e-3 of its value at first contact, x = 10^(3/n).
   With `least` the law goes on straight below s = least 2 delta (continued.h).
   K0 force/length; n > 2 real; 0 < alpha < 1; x > 1; 0 < least < 1. */

#ifndef POTDEM_REGULARISED_GRANULAR_H
#define POTDEM_REGULARISED_GRANULAR_H

#include "coefficients.h"
#include "contact_geometry.h"
#include "continued.h"
#include "device.h"
#include "evaluation.h"
#include "power.h"

namespace POTDEM {

struct RegularisedGranular {
  static constexpr bool contact_only = false, rate_dependent = false;

  double K0, n, alpha;
  double cut;            // x
  double least = 0.0;    // 0: none

  static constexpr auto coefficients()
  {
    using Law = RegularisedGranular;
    return std::array{
        required("K0", &Law::K0, positive(), "force/length").from(FROM_MATERIAL_LENGTH),
        required("n", &Law::n, above(2.0), "1").must_agree(),
        required("alpha", &Law::alpha, between(0.0, 1.0), "1"),
        option("cut", "x", &Law::cut, above(1.0), "1"),
        option("linear", "x_min", &Law::least, between(0.0, 1.0), "1")};
  }

  void complete()
  {
    if (cut == 0.0) cut = default_cut(n);
  }

  // springs in series, mean co-penetration, the longer cut; linear only if both are
  static RegularisedGranular mixed(const RegularisedGranular &a, const RegularisedGranular &b)
  {
    const double least = a.least > 0.0 && b.least > 0.0 ? std::fmax(a.least, b.least) : 0.0;
    return {series_modulus(a.K0, b.K0), a.n, 0.5 * (a.alpha + b.alpha), std::fmax(a.cut, b.cut),
            least};
  }

  static constexpr double faded = 1e-3;
  static double default_cut(double n) { return std::pow(faded, -1.0 / n); }

  POTDEM_FUNCTION double reach(double dbar) const { return (1.0 + (cut - 1.0) * alpha) * dbar; }

  struct Kernel {
    double K0, n, alpha, cut, least;
    double tail;    // energy at the cut over that at first contact, 0: no shift
    Power power;

    template <class Geometry> POTDEM_FUNCTION double r0(const Geometry &at) const
    {
      return at.contact - alpha * at.dbar();
    }
    template <class Geometry> POTDEM_FUNCTION double hard_core(const Geometry &at) const
    {
      return least > 0.0 ? 0.0 : r0(at);
    }

    template <class Geometry>
    POTDEM_FUNCTION Evaluation evaluate(double r, const Geometry &at) const
    {
      const double first = alpha * at.dbar(), s = r - r0(at);
      if (s >= cut * first) return {0.0, 0.0, 0.0};
      return continued(s, least * first, [this, first](double distance) {
        return law_at(distance, first);
      });
    }

    POTDEM_FUNCTION Evaluation law_at(double s, double first) const
    {
      const double t = first / s, p = power(t);
      const double force = K0 * first / n * p;
      return {force * s / (n - 1.0) - tail * K0 * first * first / (n * (n - 1.0)), force,
              K0 * t * p};
    }
  };

  Kernel kernel(bool shift) const
  {
    return {K0, n, alpha, cut, least, shift ? cut * Power(n)(1.0 / cut) : 0.0, Power(n)};
  }
};

}    // namespace POTDEM

#endif
