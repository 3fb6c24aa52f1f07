#include "core/laws/friction.h"

#include <gtest/gtest.h>

using namespace POTDEM;

namespace {

Friction friction(double mu, double eta, bool automatic = false)
{
  Friction f;
  f.mu = mu;
  f.eta = eta;
  f.automatic = automatic;
  return f;
}

double traction(const Friction &f, double speed, double normal, double eta)
{
  return f.factor(speed, normal, eta) * speed;
}

TEST(Friction, NoSlidingNoTraction)
{
  const auto f = friction(0.5, 10.0);
  EXPECT_EQ(traction(f, 0.0, 3.0, 10.0), 0.0);
  EXPECT_EQ(traction(f, 0.0, 0.0, 10.0), 0.0);    // and no 0/0
}

TEST(Friction, ViscousBelowTheLimitCoulombAbove)
{
  const double mu = 0.5, eta = 10.0, normal = 3.0, limit = mu * normal;
  const auto f = friction(mu, eta);
  EXPECT_DOUBLE_EQ(traction(f, 0.01, normal, eta), eta * 0.01);
  EXPECT_DOUBLE_EQ(traction(f, 0.99 * limit / eta, normal, eta), 0.99 * limit);
  EXPECT_DOUBLE_EQ(traction(f, 1.01 * limit / eta, normal, eta), limit);
  EXPECT_DOUBLE_EQ(traction(f, 1e6, normal, eta), limit);
}

TEST(Friction, TheSignOfTheNormalForceDoesNotMatter)
{
  EXPECT_EQ(traction(friction(0.5, 10.0), 7.0, -3.0, 10.0),
            traction(friction(0.5, 10.0), 7.0, 3.0, 10.0));
}

TEST(Friction, NothingWithoutNormalForceOrCoefficient)
{
  EXPECT_EQ(traction(friction(0.5, 10.0), 7.0, 0.0, 10.0), 0.0);
  EXPECT_EQ(traction(friction(0.0, 10.0), 7.0, 3.0, 10.0), 0.0);
}

TEST(Friction, GivenViscosityIsUsedUnlessAutomatic)
{
  EXPECT_EQ(friction(0.5, 10.0).viscosity(2.0, 1e-3), 10.0);
  EXPECT_DOUBLE_EQ(friction(0.5, 10.0, true).viscosity(2.0, 1e-3), 2000.0);
}

// one explicit step of m du/dt = -T: stops at most, reverses never, and is the largest that does so
TEST(Friction, AutomaticStopsTheSlidingInOneStepAtMost)
{
  const double mass = 0.3, step = 2e-4, normal = 5.0;
  const auto f = friction(0.4, 0.0, true);
  const double eta = f.viscosity(mass, step);
  for (const double speed : {1e-9, 1e-4, 1e-3, 1e-2, 10.0}) {
    const double after = speed - step / mass * traction(f, speed, normal, eta);
    EXPECT_GE(after, -1e-15 * speed);    // rounding of eta step/mass
    EXPECT_LT(after, speed);
    const bool viscous = eta * speed < f.mu * normal;
    EXPECT_EQ(viscous, after < 1e-15 * speed) << speed;
  }
}

// what a tangential force does to the surface of a free solid: dv/dt + arm dspin/dt = f/m + arm^2 f/I
TEST(Friction, MassThatResistsAtTheSurface)
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
