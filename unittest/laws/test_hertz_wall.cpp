/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "core/laws/hertz_wall.h"

#include "reference.h"

#include <gtest/gtest.h>

using namespace POTDEM;

namespace {

constexpr double modulus = 2.1e9, ri = 0.013;

struct Case {
  double layer, m;
};
HertzWall::Kernel wall(const Case &c)
{
  return {modulus, c.layer, c.m, 0.0};
}

const Case cases[] = {{0.0, 2.0}, {0.1, 1.0}, {0.1, 2.0}, {0.1, 3.0}, {0.4, 2.5}};
const double overlaps[] = {1e-6, 1e-3, 0.05, 0.099, 0.101, 0.2, 0.399, 0.401, 0.9};    // over ri

// eq. 5.26 in the secant form, with the layer of 5.28
long double force_of(long double w, const Case &c)
{
  const long double gamma = c.layer * ri;
  const long double chi = gamma > 0.0L && w < gamma ? std::pow(w / gamma, 1.0L / c.m) : 1.0L;
  return 4.0L / 3.0L * modulus * std::sqrt(static_cast<long double>(ri)) * std::pow(w, 1.5L) * chi;
}

TEST(HertzWall, ForceIsTheFormula)
{
  for (const auto &c : cases)
    for (const double overlap : overlaps) {
      const double w = overlap * ri, expected = static_cast<double>(force_of(w, c));
      EXPECT_NEAR(wall(c).at_overlap(w, ri).force, expected, 1e-14 * expected);
    }
}

// w = t^4 takes the half powers (and thirds, nearly) out of the integrand, so that the quadrature converges;
// 1e-11: its error for the exponent 1.5 + 1/3
TEST(HertzWall, EnergyIsTheIntegralOfTheForce)
{
  for (const auto &c : cases)
    for (const double overlap : overlaps) {
      const double w = overlap * ri, gamma = std::fmin(w, c.layer * ri);
      const auto inside = [&](long double t) {
        return force_of(t * t * t * t, c) * 4.0L * t * t * t;
      };
      const auto above = [&](long double s) {
        return force_of(gamma + s, c);
      };
      const long double start = gamma > 0.0 ? gamma : w;
      long double expected = reference::integral(inside, std::pow(start, 0.25L));
      if (gamma > 0.0 && w > gamma)
        expected += reference::integral(above, w - static_cast<long double>(gamma));
      EXPECT_NEAR(wall(c).at_overlap(w, ri).energy, static_cast<double>(expected),
                  1e-11 * static_cast<double>(expected))
          << "layer " << c.layer << " m " << c.m << " w/ri " << overlap;
    }
}

TEST(HertzWall, EnergyForceAndStiffnessBelongTogether)
{
  for (const auto &c : cases)
    for (const double overlap : overlaps) {
      const double w = overlap * ri;
      // differences must not reach over the kink at the layer's edge
      const double edge = std::fabs(w - c.layer * ri), scale = std::fmin(w, edge > 0.0 ? edge : w);
      const auto law = wall(c);
      reference::expect_derivatives(
          [&](double t) {
            return law.at_overlap(t, ri);
          },
          w, scale, -1.0);
    }
}

TEST(HertzWall, StartsFromNothing)
{
  for (const auto &c : cases) {
    const auto law = wall(c);
    const auto touch = law.at_overlap(0.0, ri);
    EXPECT_EQ(touch.energy, 0.0);
    EXPECT_EQ(touch.force, 0.0);
    EXPECT_EQ(touch.stiffness, 0.0);
    const auto near = law.at_overlap(1e-14 * ri, ri);
    EXPECT_GT(near.force, 0.0);
    EXPECT_LT(near.force,
              1e-20 * modulus * ri * ri);    // (4/3) 1e-21 without a layer, less with one
  }
}

TEST(HertzWall, EnergyAndForceAreContinuousAtTheLayersEdge)
{
  for (const auto &c : cases) {
    if (c.layer == 0.0) continue;
    const auto law = wall(c);
    const double gamma = c.layer * ri;
    const auto below = law.at_overlap(gamma * (1.0 - 1e-13), ri),
               above = law.at_overlap(gamma * (1.0 + 1e-13), ri);
    EXPECT_NEAR(below.force, above.force, 1e-12 * above.force);
    EXPECT_NEAR(below.energy, above.energy, 1e-12 * above.energy);
    EXPECT_NEAR(below.stiffness, above.stiffness * (1.5 + 1.0 / c.m) / 1.5,
                1e-12 * below.stiffness);
  }
}

TEST(HertzWall, TheLayerSoftensOnlyInside)
{
  const auto bare = wall({0.0, 2.0}), soft = wall({0.1, 2.0});
  EXPECT_LT(soft.at_overlap(0.05 * ri, ri).force, bare.at_overlap(0.05 * ri, ri).force);
  EXPECT_DOUBLE_EQ(soft.at_overlap(0.15 * ri, ri).force, bare.at_overlap(0.15 * ri, ri).force);
}

TEST(HertzWall, ReachesToTheFaceOfTheLayerAndBeginsThere)
{
  HertzWall law{};
  law.layer = 0.1;
  law.m = 2.0;
  law.modulus = modulus;
  EXPECT_DOUBLE_EQ(law.reach(ri), 1.1 * ri);
  const WallGeometry at{ri, law.reach(ri)};
  EXPECT_EQ(law.kernel(false).evaluate(law.reach(ri), at).force, 0.0);
  const double w = 0.25 * ri, expected = static_cast<double>(force_of(w, {0.1, 2.0}));
  EXPECT_NEAR(law.kernel(false).evaluate(law.reach(ri) - w, at).force, expected, 1e-14 * expected);
}

TEST(HertzWall, ContactModulus)
{
  const double E = 2e11, nu = 0.3;
  EXPECT_DOUBLE_EQ(contact_modulus(E, nu, E, nu), 0.5 * E / (1.0 - nu * nu));
  EXPECT_DOUBLE_EQ(contact_modulus(E, nu, 1e7, 0.1), contact_modulus(1e7, 0.1, E, nu));
  // a rigid wall leaves the particle's own plane modulus; what remains is 1e-11
  EXPECT_NEAR(contact_modulus(E, nu, 1e22, 0.0), E / (1.0 - nu * nu), 1e-10 * E);
}

}    // namespace
