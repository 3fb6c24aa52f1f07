/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "core/laws/power.h"

#include <gtest/gtest.h>

using namespace POTDEM;

namespace {

const double bases[] = {1e-6, 1e-3, 0.1, 0.5, 0.9,  0.999999, 1.0, 1.000001,
                        1.1,  1.7,  2.0, 3.3, 10.0, 1e3,      1e6};

// Each multiplication rounds by 1.1e-16, up to 64 times; where exp and log are used, the rounding of the
// exponent's n log x is that of the result.
double rounding(double exponent, double base)
{
  return std::fmax(1e-14, 2.5e-16 * std::fabs(exponent * std::log(base)));
}

TEST(Power, IsThePower)
{
  for (const double exponent : {
           0.0,  0.5,   1.0,   1.5,       2.0,      2.5,   3.0,     3.5,  4.0,
           5.0,  6.0,   7.5,   11.5,      12.0,     13.0,  23.5,    24.0, 31.0,
           48.0, 63.5,  64.0,  64.5,      65.0,     200.0,                         // whole and half
           0.1,  0.499, 0.501, 1.0 / 3.0, 1.999999, 2.1,   3.14159, 6.7,  24.3,    // neither
           -0.5, -1.0,  -2.3})
    for (const double base : bases) {
      const double expected = std::pow(base, exponent);
      if (!std::isfinite(expected) || expected < 1e-300) continue;
      EXPECT_NEAR(Power(exponent)(base), expected, rounding(exponent, base) * expected)
          << base << "^" << exponent;
    }
}

TEST(Power, OfOneIsOne)
{
  for (double exponent = 0.0; exponent < 70.0; exponent += 0.25)
    EXPECT_EQ(Power(exponent)(1.0), 1.0) << exponent;
}

TEST(Power, SmallWholeExponentsAreProducts)
{
  for (const double x : bases) {
    EXPECT_EQ(Power(0.0)(x), 1.0);
    EXPECT_EQ(Power(1.0)(x), x);
    EXPECT_EQ(Power(2.0)(x), x * x);
    EXPECT_EQ(Power(0.5)(x), std::sqrt(x));
  }
}

// an exponent next to a whole number is not taken for it
TEST(Power, NextToAWholeExponent)
{
  const double n = 6.0 + 1e-6;
  for (const double x : {0.1, 2.0, 10.0}) {
    EXPECT_NEAR(Power(n)(x) / Power(6.0)(x) - 1.0, 1e-6 * std::log(x),
                1e-11);    // (1e-6 log x)^2/2 = 3e-12
  }
}

}    // namespace
