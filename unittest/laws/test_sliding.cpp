/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "core/laws/sliding.h"

#include <gtest/gtest.h>

using namespace POTDEM;

namespace {

Sliding friction(double mu, double eta, bool automatic = false)
{
  return {mu, eta, automatic ? 1.0 : 0.0};
}

// |T|; opposite to u, or the test fails
double traction(const Sliding &f, double speed, double normal, double mass = 1.0, double step = 1.0)
{
  const double along[3] = {2.0 / 3.0, -1.0 / 3.0, 2.0 / 3.0};
  Slide slide{{}, {0.0, 0.0, 1.0}, normal, 0.0, 0.0, mass / step, step, true};
  for (int k = 0; k < 3; k++) slide.u[k] = speed * along[k];
  double force[3];
  f.force(slide, nullptr, force);
  double sum = 0.0;
  for (int k = 0; k < 3; k++) sum -= force[k] * along[k];
  for (int k = 0; k < 3; k++) EXPECT_NEAR(force[k], -sum * along[k], 1e-15 * std::fabs(sum));
  return sum;
}

TEST(Sliding, NoSlidingNoTraction)
{
  const auto f = friction(0.5, 10.0);
  EXPECT_EQ(traction(f, 0.0, 3.0), 0.0);
  EXPECT_EQ(traction(f, 0.0, 0.0), 0.0);    // and no 0/0
}

TEST(Sliding, ViscousBelowTheLimitCoulombAbove)
{
  const double mu = 0.5, eta = 10.0, normal = 3.0, limit = mu * normal;
  const auto f = friction(mu, eta);
  EXPECT_DOUBLE_EQ(traction(f, 0.01, normal), eta * 0.01);
  EXPECT_DOUBLE_EQ(traction(f, 0.99 * limit / eta, normal), 0.99 * limit);
  EXPECT_DOUBLE_EQ(traction(f, 1.01 * limit / eta, normal), limit);
  EXPECT_DOUBLE_EQ(traction(f, 1e6, normal), limit);
}

TEST(Sliding, TheSignOfTheNormalForceDoesNotMatter)
{
  EXPECT_EQ(traction(friction(0.5, 10.0), 7.0, -3.0), traction(friction(0.5, 10.0), 7.0, 3.0));
}

TEST(Sliding, NothingWithoutNormalForceOrCoefficient)
{
  EXPECT_EQ(traction(friction(0.5, 10.0), 7.0, 0.0), 0.0);
  EXPECT_EQ(traction(friction(0.0, 10.0), 7.0, 3.0), 0.0);
}

TEST(Sliding, GivenViscosityIsUsedUnlessAutomatic)
{
  const double speed = 1e-6, normal = 3.0;
  EXPECT_DOUBLE_EQ(traction(friction(0.5, 10.0), speed, normal, 2.0, 1e-3), 10.0 * speed);
  EXPECT_DOUBLE_EQ(traction(friction(0.5, 10.0, true), speed, normal, 2.0, 1e-3), 2000.0 * speed);
  // as the critical step sees it: auto follows the step and does not limit it
  EXPECT_EQ(friction(0.5, 10.0).viscosity(Slide{}), 10.0);
  EXPECT_EQ(friction(0.5, 10.0, true).viscosity(Slide{}), 0.0);
}

// one explicit step of m du/dt = -T: stops at most, reverses never, and is the largest that does so
TEST(Sliding, AutomaticStopsTheSlidingInOneStepAtMost)
{
  const double mass = 0.3, step = 2e-4, normal = 5.0;
  const auto f = friction(0.4, 0.0, true);
  const double eta = mass / step;
  for (const double speed : {1e-9, 1e-4, 1e-3, 1e-2, 10.0}) {
    const double after = speed - step / mass * traction(f, speed, normal, mass, step);
    EXPECT_GE(after, -2e-15 * speed);    // rounding of eta step/mass
    EXPECT_LT(after, speed);
    const bool viscous = eta * speed < f.mu * normal;
    EXPECT_EQ(viscous, after < 2e-15 * speed) << speed;
  }
}

// what a tangential force does to the surface of a free solid: dv/dt + arm dspin/dt = f/m + arm^2 f/I
TEST(Sliding, MassThatResistsAtTheSurface)
{
  EXPECT_DOUBLE_EQ(sliding_mass(1.0, SPHERE_INERTIA), 2.0 / 7.0);
  EXPECT_DOUBLE_EQ(sliding_mass(1.0, DISC_INERTIA), 1.0 / 3.0);
  EXPECT_EQ(sliding_mass(0.0, SPHERE_INERTIA), 1.0);
  const double mass = 1.7, radius = 0.3, force = 2.5;
  for (const double inertia : {SPHERE_INERTIA, DISC_INERTIA})
    for (const double arm : {0.5, 0.98, 1.1}) {
      const double spin = arm * radius * force / (inertia * mass * radius * radius);
      const double surface = force / mass + arm * radius * spin;
      EXPECT_NEAR(force / surface, mass * sliding_mass(arm, inertia), 1e-15 * mass);
    }
}

}    // namespace
