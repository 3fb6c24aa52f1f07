/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "core/laws/hertz.h"
#include "core/laws/mindlin.h"
#include "core/laws/tangential_spring.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace POTDEM;

namespace {

constexpr double mu = 0.4, ratio = 0.75, kn = 2e4, normal = 50.0, mass = 0.3, dt = 1e-5;
constexpr double k = ratio * kn, limit = mu * normal;

Slide slide(double speed, double force = normal, double stiffness = kn)
{
  return {{speed, 0.0, 0.0}, {0.0, 0.0, 1.0}, force, stiffness, 0.8, mass / dt, dt, true};
}

// force along x after a displacement along x in n steps
double displaced(const TangentialSpring &law, double *state, double by, int n)
{
  double f[3];
  for (int s = 0; s < n; s++) law.force(slide(by / (n * dt)), state, f);
  EXPECT_EQ(f[1], 0.0);
  EXPECT_EQ(f[2], 0.0);
  return f[0];
}

TEST(TangentialSpring, SticksByItsStiffnessAndSlipsAtTheLimit)
{
  const TangentialSpring law{{}, mu, ratio, 0.0};
  double state[4] = {};
  const double slip = limit / k;
  EXPECT_NEAR(displaced(law, state, 0.5 * slip, 10), -0.5 * limit, 1e-13 * limit);
  EXPECT_NEAR(displaced(law, state, -0.25 * slip, 10), -0.25 * limit, 1e-13 * limit);
  EXPECT_NEAR(displaced(law, state, 5.0 * slip, 10), -limit, 1e-13 * limit);
  // turned back it sticks again: no play
  EXPECT_NEAR(displaced(law, state, -0.5 * slip, 10), -0.5 * limit, 1e-13 * limit);
  EXPECT_NEAR(displaced(law, state, -3.0 * slip, 10), limit, 1e-13 * limit);
}

// a cycle between -A and A loses 4 mu F (A - mu F/k), and nothing if it does not slip; the work is summed by the rectangle
// rule, which errs by a step's share
TEST(TangentialSpring, ACycleLosesTheAreaOfItsLoop)
{
  const TangentialSpring law{{}, mu, ratio, 0.0};
  const double slip = limit / k;
  for (const double amplitude : {0.9 * slip, 2.0 * slip, 4.0 * slip}) {
    double state[4] = {}, work = 0.0;
    const int n = 4000;
    displaced(law, state, amplitude, n);
    for (const double sign : {-1.0, 1.0})
      for (int s = 0; s < n; s++) {
        const double by = sign * 2.0 * amplitude / n;
        work -= displaced(law, state, by, 1) * by;
      }
    const double loop = 4.0 * limit * std::fmax(0.0, amplitude - slip);
    EXPECT_NEAR(work, loop, 4.0 / n * limit * amplitude);
  }
}

TEST(TangentialSpring, ItsEnergyIsTheWorkThatCanBeHadBack)
{
  const TangentialSpring law{{}, mu, ratio, 0.0};
  double state[4] = {};
  EXPECT_EQ(law.energy(state), 0.0);
  const double by = 0.8 * limit / k;
  displaced(law, state, by, 7);
  EXPECT_NEAR(law.energy(state), 0.5 * k * by * by, 1e-13 * k * by * by);
}

// the displacement T/k stays when the contact unloads, so that the energy falls with k; T stays when it is loaded
TEST(TangentialSpring, MakesNoEnergyWhenTheNormalForceChanges)
{
  const TangentialSpring law{{}, mu, ratio, 0.0};
  double state[4] = {}, f[3];
  displaced(law, state, 0.2 * limit / k, 7);
  const double before = law.energy(state);
  law.force(slide(0.0, 4.0 * normal, 4.0 * kn), state, f);
  EXPECT_NEAR(f[0], -0.2 * limit, 1e-13 * limit);
  EXPECT_NEAR(law.energy(state), 0.25 * before, 1e-13 * before);
  law.force(slide(0.0, normal, kn), state, f);
  EXPECT_NEAR(f[0], -0.05 * limit, 1e-13 * limit);
  EXPECT_LT(law.energy(state), before);
  // and at a normal force near nothing it holds nearly nothing
  law.force(slide(0.0, 1e-6 * normal, kn), state, f);
  EXPECT_NEAR(f[0], -1e-6 * limit, 1e-18 * limit);
}

TEST(TangentialSpring, TurnsWithThePlaneOfContact)
{
  const TangentialSpring law{{}, mu, ratio, 0.0};
  double state[4] = {}, f[3];
  displaced(law, state, 0.5 * limit / k, 7);
  for (int degree = 1; degree <= 90; degree++) {
    const double angle = degree * M_PI / 180.0;
    Slide turned = slide(0.0);
    turned.n[0] = std::sin(angle);
    turned.n[2] = std::cos(angle);
    law.force(turned, state, f);
    EXPECT_NEAR(f[0], -0.5 * limit * std::cos(angle), 1e-12 * limit);
    EXPECT_NEAR(f[2], 0.5 * limit * std::sin(angle), 1e-12 * limit);
  }
}

TEST(TangentialSpring, ItsDashpotIsAFractionOfTheCriticalOne)
{
  const TangentialSpring law{{}, mu, ratio, 0.25};
  EXPECT_DOUBLE_EQ(law.viscosity(slide(0.0)), 0.5 * std::sqrt(k * mass));
  // where energy is counted in 1/9 of mass * velocity^2, mass over step is 9 times less
  Slide other_units = slide(0.0);
  other_units.mass_over_step *= 9.0;
  EXPECT_DOUBLE_EQ(law.viscosity(other_units), 1.5 * std::sqrt(k * mass));
  double state[4] = {}, f[3];
  const double speed = 1e-6;
  law.force(slide(speed), state, f);
  EXPECT_NEAR(f[0], -k * speed * dt - 0.5 * std::sqrt(k * mass) * speed, 1e-20);
  // together they carry no more than friction does
  law.force(slide(1e3), state, f);
  EXPECT_NEAR(f[0], -limit, 1e-13 * limit);
}

TEST(TangentialSpring, StaysWhereNoStepIsMade)
{
  const TangentialSpring law{{}, mu, ratio, 0.0};
  double state[4] = {}, copy[4], f[3];
  displaced(law, state, 0.5 * limit / k, 7);
  std::copy(state, state + 4, copy);
  Slide still = slide(100.0, 0.1 * normal, 0.5 * kn);
  still.advance = false;
  still.turn = 0.3;
  law.force(still, state, f);
  EXPECT_NEAR(f[0], -0.1 * limit, 1e-13 * limit);
  EXPECT_EQ(f[1], 0.0);
  for (int c = 0; c < 4; c++) EXPECT_EQ(state[c], copy[c]);
}

TEST(TangentialSpring, SeenFromTheOtherParticle)
{
  const TangentialSpring law{{}, mu, ratio, 0.0};
  double one[4] = {}, other[4] = {}, f[3], g[3];
  displaced(law, one, 0.3 * limit / k, 5);
  std::copy(one, one + 4, other);
  law.turn(other);
  Slide at = slide(0.1), from_there = at;
  for (int c = 0; c < 3; c++) {
    from_there.u[c] = -at.u[c];
    from_there.n[c] = -at.n[c];
  }
  law.force(at, one, f);
  law.force(from_there, other, g);
  for (int c = 0; c < 3; c++) EXPECT_EQ(f[c], -g[c]);
  EXPECT_EQ(law.energy(one), law.energy(other));
}

// of equal materials 2 (1 - nu)/(2 - nu); of different ones by their shear moduli, written out
TEST(Mindlin, TheRatioOfTheStiffnesses)
{
  for (const double nu : {0.0, 0.2, 0.3, 0.5})
    EXPECT_NEAR(shear_ratio(7e10, nu, 7e10, nu), 2.0 * (1.0 - nu) / (2.0 - nu), 1e-15);
  const double G1 = 7e10 / 2.6, G2 = 2e9 / 2.9, R = 0.01, w = 1e-5;
  const double G = 1.0 / ((2.0 - 0.3) / G1 + (2.0 - 0.45) / G2);
  const double E = contact_modulus(7e10, 0.3, 2e9, 0.45);
  const double kt = 8.0 * G * std::sqrt(R * w), kn_hertz = 2.0 * E * std::sqrt(R * w);
  EXPECT_NEAR(shear_ratio(7e10, 0.3, 2e9, 0.45), kt / kn_hertz, 1e-14);
  EXPECT_DOUBLE_EQ((Mindlin{{}, mu, 0.0}.stiffness(slide(0.0))), 0.8 * kn);
}

// what restart files keep of two materials that were mixed
TEST(Mindlin, MixedHertzIsTheSameWhenReadBack)
{
  Hertz a{7e10, 0.3, 0.0, 0.0}, b{2e9, 0.45, 0.0, 0.0};
  a.complete();
  b.complete();
  const auto mixed = Hertz::mixed(a, b);
  auto again = mixed;
  again.complete();
  EXPECT_NEAR(again.modulus, mixed.modulus, 1e-14 * mixed.modulus);
  EXPECT_NEAR(again.shear, mixed.shear, 1e-14);
}

}    // namespace
