/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* What the tests of the laws compare with: numerical derivatives and integrals that share no code with
   src/laws. */

#ifndef POTDEM_TEST_REFERENCE_H
#define POTDEM_TEST_REFERENCE_H

#include "core/laws/evaluation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace reference {

// Five-point central difference: error h^4 f'''''/30.
template <class Function> double slope(Function f, double x, double h)
{
  return (8.0 * (f(x + h) - f(x - h)) - (f(x + 2.0 * h) - f(x - 2.0 * h))) / (12.0 * h);
}

// Gauss-Legendre quadrature of ten points on each of many panels, in long double, from 0 to length.
template <class Function> long double integral(Function f, long double length, int panels = 400)
{
  static const long double at[] = {0.148874338981631210884826L, 0.433395394129247190799266L,
                                   0.679409568299024406234328L, 0.865063366688984510732097L,
                                   0.973906528517171720077964L};
  static const long double weight[] = {0.295524224714752870173815L, 0.269266719309996355091227L,
                                       0.219086362515982043995535L, 0.149451349150580593145863L,
                                       0.066671344308688137593569L};
  long double sum = 0.0L;
  for (int p = 0; p < panels; p++) {
    const long double low = length * p / panels, high = length * (p + 1) / panels;
    const long double mid = 0.5L * (low + high), half = 0.5L * (high - low);
    for (int k = 0; k < 5; k++)
      sum += half * weight[k] * (f(mid - half * at[k]) + f(mid + half * at[k]));
  }
  return sum;
}

// force = -dPhi/dr and stiffness = -dF/dr at x, in the variable whose growth the force opposes if
// `towards` = 1 (a distance) or drives if -1 (an overlap). Step 1e-3 of `scale`, the length over which
// the law varies at x: truncation 1e-12 relative; 1e-9 leaves room for derivatives larger than their
// scale suggests. Rounding of what is differentiated over the step comes on top.
template <class Law>
void expect_derivatives(Law law, double x, double scale, double towards = 1.0,
                        double tolerance = 1e-9)
{
  const double h = 1e-3 * scale;
  const POTDEM::Evaluation here = law(x);
  const double force = -towards *
      slope(
          [&](double t) {
            return law(t).energy;
          },
          x, h);
  const double stiffness = -towards *
      slope(
          [&](double t) {
            return law(t).force;
          },
          x, h);
  const double force_scale = std::max(std::fabs(here.force), std::fabs(here.stiffness) * scale);
  const double rounding = 1e-15 / h;
  EXPECT_NEAR(here.force, force, tolerance * force_scale + rounding * std::fabs(here.energy))
      << "at " << x;
  EXPECT_NEAR(here.stiffness, stiffness,
              tolerance * force_scale / scale + rounding * std::fabs(here.force))
      << "at " << x;
}

}    // namespace reference

#endif
