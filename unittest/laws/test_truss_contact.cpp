/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "core/laws/truss_contact.h"

#include "reference.h"

#include <gtest/gtest.h>

using namespace POTDEM;

namespace {

constexpr double E = 3e7, a = 0.8, dbar = 0.05;

TEST(TrussContact, NothingFromTheContactDistanceOn)
{
  for (const double m : {0, 2}) {
    const auto kernel = TrussContact{E, a, m, 0}.kernel(false);
    for (const double dref : {dbar, 0.7 * dbar})
      for (const double r : {dref, std::nextafter(dref, 1.0), 1.5 * dref}) {
        const auto at = kernel.evaluate(r, ContactGeometry{0.5 * dbar, 0.5 * dbar, dref});
        EXPECT_EQ(at.energy, 0.0);
        EXPECT_EQ(at.force, 0.0);
        EXPECT_EQ(at.stiffness, 0.0);
      }
  }
}

TEST(TrussContact, StartsFromZeroForceAndEnergy)
{
  for (const double m : {0, 3}) {
    const auto kernel = TrussContact{E, a, m, 0}.kernel(false);
    const double dref = 0.9 * dbar, modulus = E * a * M_PI / 4.0 * dbar * dbar;
    const auto at =
        kernel.evaluate(dref * (1.0 - 1e-9), ContactGeometry{0.5 * dbar, 0.5 * dbar, dref});
    EXPECT_GT(at.force, 0.0);
    EXPECT_LT(at.force, 1e-8 * modulus);             // about c(1) 1e-9 modulus
    EXPECT_LT(at.energy, 1e-15 * modulus * dref);    // about c(1) 1e-18/2; rounding 1e-16
  }
}

TEST(TrussContact, ForceIsTheTrussOfTheContactDistance)
{
  const auto kernel = TrussContact{E, a, 0, 0}.kernel(false);
  for (const double dref : {dbar, 0.8 * dbar})
    for (const double x : {0.1, 0.5, 0.99}) {
      const double modulus = E * a * M_PI / 4.0 * dbar * dbar;
      EXPECT_NEAR(kernel.evaluate(x * dref, ContactGeometry{0.5 * dbar, 0.5 * dbar, dref}).force,
                  modulus * 0.5 * (1.0 - x * x), 1e-13 * modulus);
    }
}

TEST(TrussContact, EnergyForceAndStiffnessBelongTogether)
{
  for (const double m : {0, 1, 2, 3, 6, 12})
    for (const double normalized : {0, 1}) {
      const auto kernel = TrussContact{E, a, m, normalized}.kernel(false);
      for (const double dref : {dbar, 0.8 * dbar})
        for (const double x : {1e-3, 0.05, 0.4, 0.8, 0.97})
          reference::expect_derivatives(
              [&](double r) {
                return kernel.evaluate(r, ContactGeometry{0.5 * dbar, 0.5 * dbar, dref});
              },
              x * dref, dref * std::fmin(x, m ? 1.0 / m : 1.0) * 0.1, 1.0, 1e-7);
    }
}

TEST(TrussContact, NeverAttracts)
{
  for (const double m : {0, 1, 12}) {
    const auto kernel = TrussContact{E, a, m, 0}.kernel(false);
    for (double x = 0.001; x < 2.0; x += 0.001) {
      EXPECT_GE(kernel.evaluate(x * dbar, ContactGeometry{0.5 * dbar, 0.5 * dbar, dbar}).force,
                0.0);
      EXPECT_GE(kernel.evaluate(x * dbar, ContactGeometry{0.5 * dbar, 0.5 * dbar, dbar}).energy,
                0.0);
    }
  }
}

}    // namespace
