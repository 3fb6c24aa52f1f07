/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "core/laws/shifted_lj.h"

#include "reference.h"

#include <gtest/gtest.h>

#include <vector>

using namespace POTDEM;

namespace {

const double exponents[] = {0.5, 1.0, 1.5, 2.0, 2.3, 3.0, 4.0, 5.5, 6.0, 7.7, 12.0, 24.0};
const double places[] = {0.05, 0.3, 0.7,  0.9,
                         0.99, 1.0, 1.01, 1.03};    // s/R, those below the cut are used

ShiftedLJ law_of(double K0, double R, double n, double alpha)
{
  return {K0, R, n, alpha, ShiftedLJ::default_cut(R, n)};
}

ContactGeometry contact_only(double di, double dj)
{
  return {0.5 * di, 0.5 * dj, 0.5 * (di + dj)};
}

// eqs 5.9 to 5.11 by pow in long double, force > 0 repelling
struct Formula {
  long double K0, R, n;
  long double D() const { return K0 * R * R / (2 * n * n); }
  long double power(long double s, int k) const { return std::pow(R / s, k * n); }
  long double energy(long double s) const { return D() * (power(s, 2) - 2 * power(s, 1)); }
  long double force(long double s) const { return 2 * D() * n / s * (power(s, 2) - power(s, 1)); }
  long double stiffness(long double s) const
  {
    return 2 * D() * n / (s * s) * ((2 * n + 1) * power(s, 2) - (n + 1) * power(s, 1));
  }
};

TEST(ShiftedLJ, IsTheFormula)
{
  const double R = 0.013, dbar = 0.2, alpha = 0.3;
  const auto pair = contact_only(dbar, dbar);
  for (const double K0 : {1e-3, 1e2, 1e7})
    for (const double n : exponents) {
      const auto law = law_of(K0, R, n, alpha);
      const auto kernel = law.kernel(false);
      for (const double place : places) {
        const double r = kernel.hard_core(pair) + place * R, s = r - kernel.hard_core(pair);
        if (s >= law.cut) continue;
        const Formula formula{K0, R, n};
        const auto at = kernel.evaluate(r, pair);
        const double energy = static_cast<double>(formula.energy(s));
        const double force = static_cast<double>(formula.force(s));
        const double stiffness = static_cast<double>(formula.stiffness(s));
        // the power to 1e-14 (test_power), and what cancels between attraction and repulsion
        const double scale = K0 * R * std::pow(place, -2.0 * n) / n;
        EXPECT_NEAR(at.energy, energy, 2e-14 * (std::fabs(energy) + scale * R))
            << n << " " << place;
        EXPECT_NEAR(at.force, force, 2e-14 * (std::fabs(force) + scale / place))
            << n << " " << place;
        EXPECT_NEAR(at.stiffness, stiffness,
                    2e-14 * (std::fabs(stiffness) + n * scale / R / place / place));
      }
    }
}

struct Domain {
  double K0, alpha, di, dj;
};
// stiffness over ten decades, diameters up to 1:20, the co-penetration from hard to soft
const Domain domains[] = {{1.0, 0.1, 1.0, 1.0},  {1e-3, 0.01, 0.02, 0.02}, {1e7, 0.01, 0.02, 0.4},
                          {1e2, 0.9, 20.0, 1.0}, {1e5, 0.5, 1e-3, 2e-2},   {1e7, 0.9, 1e-6, 1e-6}};

TEST(ShiftedLJ, EnergyForceAndStiffnessBelongTogether)
{
  for (const auto &domain : domains)
    for (const double n : exponents)
      for (const bool shift : {false, true}) {
        const auto pair = contact_only(domain.di, domain.dj);
        const double R = domain.alpha * pair.dbar();    // equilibrium at first contact
        const auto law = law_of(domain.K0, R, n, domain.alpha);
        const auto kernel = law.kernel(shift);
        for (const double place : places) {
          const double s = place * R, r = kernel.hard_core(pair) + s;
          double scale = s / (2.0 * n + 5.0);
          if (s + 4e-3 * scale >= law.cut) continue;
          // r is rounded before s is taken from it: 1e-16 r over the differences' step
          const double rounded = 4e-16 * r / (1e-3 * scale);
          reference::expect_derivatives(
              [&](double t) {
                return kernel.evaluate(t, pair);
              },
              r, scale, 1.0, 1e-9 + rounded);
        }
      }
}

TEST(ShiftedLJ, AtRNoForceAndTheStiffnessK0)
{
  for (const auto &domain : domains)
    for (const double n : exponents) {
      const auto pair = contact_only(domain.di, domain.dj);
      const double R = 0.25 * pair.dbar();    // exact in binary, and so is the place of equilibrium
      const auto kernel = ShiftedLJ{domain.K0, R, n, 0.25, 2.0 * R}.kernel(false);
      const double r = kernel.hard_core(pair) + R;
      const auto at = kernel.evaluate(r, pair);
      // s is R but for the rounding of r, at most 4 units of R
      EXPECT_NEAR(at.force, 0.0, 1e-15 * domain.K0 * R);
      EXPECT_NEAR(at.stiffness, domain.K0, 1e-14 * domain.K0 * (2 * n + 3));
      EXPECT_NEAR(at.energy, -domain.K0 * R * R / (2 * n * n), 1e-14 * domain.K0 * R * R);
    }
}

TEST(ShiftedLJ, TheDefaultCutIsTheLargestAttraction)
{
  for (const double n : exponents) {
    const double R = 0.7, cut = ShiftedLJ::default_cut(R, n);
    const auto kernel = ShiftedLJ{5.0, R, n, 0.0, 2.0 * cut}.kernel(false);    // continued beyond
    const auto at = kernel.law_at(cut);
    EXPECT_NEAR(at.stiffness, 0.0, 1e-13 * 5.0 * (2 * n + 1));
    for (const double t : {0.9, 0.99, 1.01, 1.1}) EXPECT_GT(kernel.law_at(t * cut).force, at.force);
    EXPECT_LT(at.force, 0.0);
    EXPECT_GT(kernel.law_at(0.99 * cut).stiffness, 0.0);
    EXPECT_LT(kernel.law_at(1.01 * cut).stiffness,
              0.0);    // the softening branch that the cut leaves out
  }
}

TEST(ShiftedLJ, NothingFromTheCutOn)
{
  const auto pair = contact_only(1.0, 3.0);
  for (const double n : exponents)
    for (const bool shift : {false, true}) {
      const auto law = law_of(100.0, 0.25, n, 0.125);
      const auto kernel = law.kernel(shift);
      EXPECT_DOUBLE_EQ(law.reach(pair.dbar()), kernel.hard_core(pair) + law.cut);
      for (const double beyond : {1e-14, 0.01, 3.0}) {
        const auto at = kernel.evaluate(law.reach(pair.dbar()) * (1.0 + beyond), pair);
        EXPECT_EQ(at.energy, 0.0);
        EXPECT_EQ(at.force, 0.0);
        EXPECT_EQ(at.stiffness, 0.0);
      }
      EXPECT_LT(kernel.evaluate(law.reach(pair.dbar()) * (1.0 - 1e-12), pair).force,
                0.0);    // the jump
    }
}

TEST(ShiftedLJ, TheShiftMakesTheEnergyZeroAtTheCutAndNothingElse)
{
  const auto pair = contact_only(1.0, 1.0);
  for (const double n : exponents)
    for (const double cut_over_R : {0.8, 1.0, 1.05, 2.5}) {
      const double R = 0.2, K0 = 30.0;
      const ShiftedLJ law{K0, R, n, 0.1, cut_over_R * R};
      const auto plain = law.kernel(false), shifted = law.kernel(true);
      const double below = law.reach(1.0) * (1.0 - 1e-13);
      // the force times the distance to the cut
      EXPECT_NEAR(shifted.evaluate(below, pair).energy, 0.0,
                  1e-12 * std::fabs(plain.evaluate(below, pair).force) + 1e-14 * K0 * R * R);
      const double at_cut = plain.law_at(law.cut).energy;
      for (const double place : {0.3, 0.7}) {
        const auto a = plain.evaluate(0.9 + place * R, pair),
                   b = shifted.evaluate(0.9 + place * R, pair);
        EXPECT_EQ(a.force, b.force);
        EXPECT_EQ(a.stiffness, b.stiffness);
        EXPECT_NEAR(a.energy - b.energy, at_cut, 1e-14 * (std::fabs(at_cut) + std::fabs(a.energy)));
      }
    }
}

TEST(ShiftedLJ, TwoParticlesCannotPassTheCore)
{
  for (const double n : exponents) {
    const double R = 0.3;
    const auto kernel = law_of(10.0, R, n, 0.0).kernel(false);
    double previous = 0.0;
    for (const double s : {0.5, 0.1, 1e-2, 1e-3, 1e-6, 1e-30, 1e-300}) {
      const auto at = kernel.law_at(s * R);
      EXPECT_GE(at.force, previous);    // without bound, at last infinite, never NaN
      EXPECT_GT(at.energy, -10.0 * R * R / (n * n));
      EXPECT_GT(at.stiffness, 0.0);
      previous = at.force;
    }
    EXPECT_GT(previous, 1e100);
  }
}

// a pair that failed while it overlapped: everything moves by the same distance
TEST(ShiftedLJ, AShorterContactDistanceMovesTheLaw)
{
  const auto kernel = law_of(10.0, 0.25, 3.0, 0.25).kernel(false);
  const ContactGeometry full{0.5, 0.5, 1.0}, failed{0.5, 0.5, 0.875};
  for (const double r : {0.8, 0.95, 1.0, 1.02}) {
    const auto a = kernel.evaluate(r, full), b = kernel.evaluate(r - 0.125, failed);
    EXPECT_NEAR(a.force, b.force, 1e-13 * 10.0);
    EXPECT_NEAR(a.energy, b.energy, 1e-13 * 10.0);
  }
}

}    // namespace
