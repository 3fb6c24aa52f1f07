/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "core/laws/regularised_granular.h"

#include "reference.h"

#include <gtest/gtest.h>

using namespace POTDEM;

namespace {

const double exponents[] = {2.01, 2.5, 3.0, 3.7, 4.0, 5.5, 6.0, 12.0, 24.0};
struct Domain {
  double K0, alpha, di, dj;
};
// stiffness over ten decades, diameters up to 1:20, the co-penetration from hard to soft
const Domain domains[] = {{1.0, 0.1, 1.0, 1.0},  {1e-3, 0.01, 0.02, 0.02}, {1e7, 0.01, 0.02, 0.4},
                          {1e2, 0.9, 20.0, 1.0}, {1e5, 0.5, 1e-3, 2e-2},   {1e7, 0.9, 1e-6, 1e-6}};
const double places[] = {0.01, 0.1, 0.5, 0.9,
                         1.0,  1.1, 1.3};    // s/2delta, those below the cut are used

RegularisedGranular law_of(const Domain &domain, double n)
{
  return {domain.K0, n, domain.alpha, RegularisedGranular::default_cut(n)};
}

ContactGeometry contact_only(const Domain &domain)
{
  return {0.5 * domain.di, 0.5 * domain.dj, 0.5 * (domain.di + domain.dj)};
}

// eqs 5.12 to 5.14, c = K0 (2 delta)^(n+1) / n
TEST(RegularisedGranular, IsTheFormula)
{
  for (const auto &domain : domains)
    for (const double n : exponents) {
      const auto pair = contact_only(domain);
      const auto law = law_of(domain, n);
      const auto kernel = law.kernel(false);
      const long double first = static_cast<long double>(domain.alpha) * pair.dbar();
      for (const double place : places) {
        if (place >= law.cut) continue;
        const double r = (1.0 - domain.alpha) * pair.dbar() + place * domain.alpha * pair.dbar();
        const long double s = r - (pair.dbar() - first),
                          t = std::pow(first / s, static_cast<long double>(n));
        const double force = static_cast<double>(domain.K0 * first / n * t);
        const auto at = kernel.evaluate(r, pair);
        // s is a difference of lengths near dbar: its rounding, times the exponent
        const double rounded = 1e-14 + 4e-16 * (n + 1.0) * pair.dbar() / static_cast<double>(s);
        EXPECT_NEAR(at.force, force, rounded * force) << n << " " << place;
        EXPECT_NEAR(at.energy, force * static_cast<double>(s) / (n - 1.0), rounded * at.energy);
        EXPECT_NEAR(at.stiffness, n * force / static_cast<double>(s), rounded * at.stiffness);
      }
    }
}

TEST(RegularisedGranular, EnergyForceAndStiffnessBelongTogether)
{
  for (const auto &domain : domains)
    for (const double n : exponents)
      for (const bool shift : {false, true}) {
        const auto pair = contact_only(domain);
        const auto law = law_of(domain, n);
        const auto kernel = law.kernel(shift);
        for (const double place : places) {
          const double s = place * domain.alpha * pair.dbar(), r = kernel.hard_core(pair) + s;
          const double scale = s / (n + 5.0);
          if (s + 4e-3 * scale >= law.cut * domain.alpha * pair.dbar()) continue;
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

TEST(RegularisedGranular, StiffnessK0AtFirstContact)
{
  for (const auto &domain : domains)
    for (const double n : exponents) {
      const auto pair = contact_only(domain);
      const auto at = law_of(domain, n).kernel(false).evaluate(pair.dbar(), pair);
      const double rounded = 4e-16 * (n + 1.0) / domain.alpha + 1e-14;
      EXPECT_NEAR(at.stiffness, domain.K0, rounded * domain.K0);
      const double force = domain.K0 * domain.alpha * pair.dbar() / n;
      EXPECT_NEAR(at.force, force, rounded * force);
    }
}

TEST(RegularisedGranular, TheDefaultCutIsWhereAThousandthIsLeft)
{
  for (const auto &domain : domains)
    for (const double n : exponents) {
      const auto pair = contact_only(domain);
      const auto law = law_of(domain, n);
      const auto kernel = law.kernel(false);
      const double reach = law.reach(pair.dbar()), first = kernel.evaluate(pair.dbar(), pair).force;
      EXPECT_GT(reach, pair.dbar());
      const double rounded =
          1e-11 * (n + 1.0) / domain.alpha;    // 1e-12 from the cut, relative to s
      EXPECT_NEAR(kernel.evaluate(reach * (1.0 - 1e-12), pair).force / first, 1e-3, 1e-3 * rounded);
      for (const double beyond : {1e-12, 0.1, 10.0}) {
        const auto at = kernel.evaluate(reach * (1.0 + beyond), pair);
        EXPECT_EQ(at.energy, 0.0);
        EXPECT_EQ(at.force, 0.0);
        EXPECT_EQ(at.stiffness, 0.0);
      }
    }
}

TEST(RegularisedGranular, TheShiftMakesTheEnergyZeroAtTheCutAndNothingElse)
{
  for (const auto &domain : domains)
    for (const double n : exponents)
      for (const double cut : {1.01, 1.5, 4.0}) {
        const auto pair = contact_only(domain);
        const RegularisedGranular law{domain.K0, n, domain.alpha, cut};
        const auto plain = law.kernel(false), shifted = law.kernel(true);
        const double below = law.reach(pair.dbar()) * (1.0 - 1e-12);
        const auto at = plain.evaluate(below, pair);
        EXPECT_NEAR(shifted.evaluate(below, pair).energy, 0.0,
                    2e-12 * at.force * below + 1e-13 * at.energy);
        const auto a = plain.evaluate(pair.dbar(), pair), b = shifted.evaluate(pair.dbar(), pair);
        EXPECT_EQ(a.force, b.force);
        EXPECT_EQ(a.stiffness, b.stiffness);
        // the work of the force from the cut to first contact
        const double first = domain.alpha * pair.dbar();
        const double work =
            domain.K0 * first * first / (n * (n - 1.0)) * (1.0 - std::pow(cut, 1.0 - n));
        // small near the cut, where it is a difference
        const double rounded = 1e-14 * (n + 1.0) / domain.alpha * a.energy;
        EXPECT_NEAR(b.energy, work, rounded) << n << " " << cut;
      }
}

TEST(RegularisedGranular, NeverAttractsAndCannotPassTheCore)
{
  const Domain domain = domains[0];
  for (const double n : exponents) {
    const auto kernel = law_of(domain, n).kernel(false);
    const auto pair = contact_only(domain);
    double previous = 0.0;
    for (double s = 3.0; s > 1e-12; s *= 0.7) {
      const auto at = kernel.evaluate(kernel.hard_core(pair) + 0.1 * s, pair);
      EXPECT_GE(at.force, previous);
      EXPECT_GE(at.stiffness, 0.0);
      previous = at.force;
    }
    EXPECT_GT(previous, 1e20);
  }
}

TEST(RegularisedGranular, AShorterContactDistanceMovesTheLaw)
{
  const auto kernel = law_of({10.0, 0.25, 1.0, 1.0}, 3.0).kernel(false);
  const ContactGeometry full{0.5, 0.5, 1.0}, failed{0.5, 0.5, 0.875};
  for (const double r : {0.8, 0.95, 1.0, 1.1}) {
    const auto a = kernel.evaluate(r, full), b = kernel.evaluate(r - 0.125, failed);
    EXPECT_GT(a.force, 0.0);
    EXPECT_NEAR(a.force, b.force, 1e-13 * a.force);
    EXPECT_NEAR(a.energy, b.energy, 1e-13 * a.energy);
  }
}

}    // namespace
