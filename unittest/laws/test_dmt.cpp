/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "core/laws/dmt.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace POTDEM;

namespace {

constexpr double E = 4e6, nu = 0.25, gamma_ = 3.0, ri = 0.3, rj = 0.6;
const ContactGeometry spheres{ri, rj, ri + rj};

Dmt law_of(double E, double nu, double gamma)
{
  Dmt law{E, nu, gamma, 0.0, 0.0};
  law.complete();
  return law;
}

TEST(Dmt, IsHertzLessAConstantPull)
{
  const auto kernel = law_of(E, nu, gamma_).kernel(false);
  const double K = 4.0 / 3.0 * E / (2.0 * (1.0 - nu * nu)) * std::sqrt(ri * rj / (ri + rj));
  const double P = 4.0 * M_PI * gamma_ * ri * rj / (ri + rj);
  for (const double w : {1e-6, 1e-3, 0.1}) {
    const auto found = kernel.evaluate(spheres.contact - w, spheres);
    EXPECT_NEAR(found.force, K * std::pow(w, 1.5) - P, 1e-9 * P);
    EXPECT_NEAR(found.energy, 0.4 * K * std::pow(w, 2.5) - P * w, 1e-9 * P * w);
    EXPECT_NEAR(found.stiffness, 1.5 * K * std::sqrt(w), 1e-9 * K * std::sqrt(w));
  }
  EXPECT_NEAR(kernel.pull(spheres), P, 1e-14 * P);
}

TEST(Dmt, IsNothingBeyondTouch)
{
  const auto kernel = law_of(E, nu, gamma_).kernel(false);
  for (const double r : {spheres.contact, 2.0 * spheres.contact}) {
    const auto found = kernel.evaluate(r, spheres);
    EXPECT_EQ(found.force, 0.0);
    EXPECT_EQ(found.energy, 0.0);
    EXPECT_EQ(found.stiffness, 0.0);
  }
}

TEST(Dmt, AtAWallTheRadiusIsTheParticles)
{
  const auto kernel = law_of(E, nu, gamma_).kernel(false);
  EXPECT_NEAR(kernel.pull(WallGeometry{ri, ri}), 4.0 * M_PI * gamma_ * ri, 1e-13);
}

TEST(Dmt, SurfaceEnergiesMixByTheirGeometricMean)
{
  const auto mixed = Dmt::mixed(law_of(E, nu, 4.0), law_of(2.0 * E, 0.4, 9.0));
  EXPECT_DOUBLE_EQ(mixed.gamma, 6.0);
  EXPECT_DOUBLE_EQ(mixed.modulus, contact_modulus(E, nu, 2.0 * E, 0.4));
}

}    // namespace
