/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "core/contact/contact.h"
#include "core/laws/hertz.h"
#include "core/laws/mindlin.h"
#include "core/laws/rolling.h"
#include "core/laws/tangential_spring.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace POTDEM;

namespace {

constexpr double mu = 0.1, ratio = 0.5, kn = 2e4, normal = 50.0, R = 0.25, dt = 1e-5;
constexpr double k = ratio * kn, limit = mu * normal;

Slide rolling(double speed)
{
  return {{speed, 0.0, 0.0}, {0.0, 0.0, 1.0}, normal, kn, 0.0, 0.3 / dt, dt, true};
}

// the torque after n steps at a speed of rolling along x and of twisting
void torque(const RollingResistance &law, double *state, double along, double twist, int n,
            double *found)
{
  for (int s = 0; s < n; s++)
    law.torque(rolling(along / (n * dt)), R, twist / (n * dt), state, found);
}

TEST(Rolling, TurnsAgainstRollingByItsSpringUpToTheLimit)
{
  const RollingResistance law{mu, ratio, 0.0, 0.0, 0.0, 0.0};
  double state[RollingResistance::STATE] = {}, M[3];
  torque(law, state, 0.5 * limit / k, 0.0, 10, M);
  // R n x T with T = -limit/2 along x
  EXPECT_NEAR(M[1], -0.5 * R * limit, 1e-13 * limit);
  EXPECT_EQ(M[0], 0.0);
  EXPECT_EQ(M[2], 0.0);
  EXPECT_NEAR(law.energy(state), 0.5 * 0.25 * limit * limit / k, 1e-13 * limit * limit / k);
  torque(law, state, 9.0 * limit / k, 0.0, 10, M);
  EXPECT_NEAR(M[1], -R * limit, 1e-13 * limit);
  torque(law, state, -limit / k, 0.0, 10, M);
  EXPECT_NEAR(M[1], 0.0, 1e-12 * limit);
}

TEST(Rolling, TurnsAgainstTwistingByItsSpringUpToTheLimit)
{
  const RollingResistance law{0.0, 0.0, 0.0, mu, ratio, 0.0};
  double state[RollingResistance::STATE] = {}, M[3];
  torque(law, state, 0.0, 0.5 * limit / (k * R), 10, M);
  EXPECT_NEAR(M[2], -0.5 * R * limit, 1e-13 * limit);
  EXPECT_EQ(M[0], 0.0);
  EXPECT_EQ(M[1], 0.0);
  EXPECT_NEAR(law.energy(state), 0.5 * 0.25 * limit * limit / k, 1e-13 * limit * limit / k);
  torque(law, state, 0.0, -5.0 * limit / (k * R), 10, M);
  EXPECT_NEAR(M[2], R * limit, 1e-13 * limit);
}

// a spring that gets softer keeps its angle, and what it has beyond that is lost: no energy comes from nowhere
TEST(Rolling, SofterSpringsBearLess)
{
  const RollingResistance law{mu, ratio, 0.0, mu, ratio, 0.0};
  double state[RollingResistance::STATE] = {}, M[3];
  torque(law, state, 0.5 * limit / k, 0.5 * limit / (k * R), 10, M);
  const double along = M[1], twist = M[2], energy = law.energy(state);
  Slide softer = rolling(0.0);
  softer.stiffness = 0.25 * kn;
  law.torque(softer, R, 0.0, state, M);
  EXPECT_NEAR(M[1], 0.25 * along, 1e-13 * R * limit);
  EXPECT_NEAR(M[2], 0.25 * twist, 1e-13 * R * limit);
  EXPECT_NEAR(law.energy(state), 0.25 * energy, 1e-13 * energy);
}

TEST(Rolling, MixedIsThatOfSpringsInSeries)
{
  const RollingResistance soft{0.1, 0.2, 0.3, 0.0, 0.0, 0.0}, hard{0.4, 0.6, 0.5, 0.0, 0.0, 0.0};
  const auto found = RollingResistance::mixed(soft, hard);
  EXPECT_EQ(found.mu, 0.1);
  EXPECT_DOUBLE_EQ(found.ratio, 2.0 / (1.0 / 0.2 + 1.0 / 0.6));
  EXPECT_DOUBLE_EQ(found.xi, 0.4);
  // what neither has they do not have together
  EXPECT_EQ(found.twist_mu, 0.0);
  EXPECT_EQ(found.twist_ratio, 0.0);
  EXPECT_EQ(found.twist_xi, 0.0);
}

// the spring stays with the two when they turn about the normal as one
TEST(Rolling, AndFrictionTurnWithTheTwoAboutTheNormal)
{
  const TangentialSpring law{{}, mu, ratio, 0.0};
  double state[4] = {}, f[3];
  law.force(rolling(0.5 * limit / k / dt), state, f);
  const double degree = M_PI / 180.0;
  Slide turning = rolling(0.0);
  turning.turn = degree;
  for (int step = 1; step <= 90; step++) law.force(turning, state, f);
  // each step turns by atan of the angle, by a third of its cube less
  EXPECT_NEAR(f[0], 0.0, 90.0 * std::pow(degree, 3) * limit);
  EXPECT_NEAR(f[1], -0.5 * limit, 1e-6 * limit);
}

// two spheres that roll on each other, whichever is the first: opposite torques, and the power is the force of the spring times its speed
TEST(Rolling, OfTwoSpheresSeenFromEither)
{
  Hertz law{1e6, 0.3, 0.0, 0.0};
  law.complete();
  const auto kernel = law.kernel(false);
  const double wi[3] = {0.3, -0.2, 0.5}, wj[3] = {-0.1, 0.4, 0.2}, ri = 0.2, rj = 0.3, r = 0.49;
  const Rolls<Mindlin> rough{{{}, 0.4, 0.0}, {mu, ratio, 0.1, mu, ratio, 0.1}};
  double found[2][3];
  for (int turned = 0; turned < 2; turned++) {
    const double sign = turned ? -1.0 : 1.0;
    const double a = turned ? rj : ri, b = turned ? ri : rj;
    ContactMotion at{{sign * 0.6 * r, 0.0, sign * 0.8 * r}, r, {}, {}, {}, {}};
    spin_of(turned ? wj : wi, turned ? wi : wj, a, b, at);
    const auto motion = [&at] {
      return at;
    };
    const auto masses = [a, b] {
      return with_rolling({2.0 / 7.0, 2.0, 1e-4, 1e-4, 2.0 / 7.0}, 1.0, 1.0, a, b);
    };
    double state[Rolls<Mindlin>::STATE] = {};
    const auto forces = contact_forces<true>(kernel, r, ContactGeometry{a, b, 0.5}, 1.0, Elastic(),
                                             rough, state, true, motion, masses);
    std::copy(forces.surface.torque, forces.surface.torque + 3, found[turned]);
  }
  double power = 0.0;
  for (int c = 0; c < 3; c++) {
    EXPECT_NEAR(found[0][c], -found[1][c], 1e-15);
    power += found[0][c] * (wi[c] - wj[c]);
  }
  EXPECT_LT(power, 0.0);
}

// what the springs resist: a rotation of both with the inertia of spheres
TEST(Rolling, ItsMassIsThatOfTheRotation)
{
  const double mi = 2.0, mj = 0.5, ri = 0.3, rj = 0.2;
  const double radius = ri * rj / (ri + rj);
  const auto masses = with_rolling({1.0, 1.0, 1.0, 1.0}, mi, mj, ri, rj);
  const double Ii = 0.4 * mi * ri * ri, Ij = 0.4 * mj * rj * rj;
  EXPECT_NEAR(masses.rolling, 1.0 / (radius * radius * (1.0 / Ii + 1.0 / Ij)), 1e-14);
}

TEST(Rolling, TheEasierOfTwoMaterialsDecides)
{
  const auto both =
      RollingResistance::mixed({0.1, 0.5, 0.2, 0.3, 0.4, 0.0}, {0.2, 1.0, 0.4, 0.0, 0.0, 0.0});
  EXPECT_EQ(both.mu, 0.1);
  EXPECT_NEAR(both.ratio, 2.0 / 3.0, 1e-15);
  EXPECT_NEAR(both.xi, 0.3, 1e-15);
  EXPECT_EQ(both.twist_mu, 0.0);
}

}    // namespace
