/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "core/laws/continued.h"
#include "core/laws/regularised_granular.h"
#include "core/laws/shifted_lj.h"

#include "reference.h"

#include <gtest/gtest.h>

using namespace POTDEM;

namespace {

const double dbar = 1.0, alpha = 0.2, r0 = 0.8;

ContactGeometry contact_only()
{
  return {0.5, 0.5, dbar};
}

// the law with and without the end, and the s at which it goes straight
template <class Check> void for_each_law(Check check)
{
  for (const double n : {2.5, 3.0, 6.0})
    for (const double share : {0.3, 0.7, 0.95}) {
      ShiftedLJ lj{300.0, 0.2, n, alpha, ShiftedLJ::default_cut(0.2, n)};
      auto straight_lj = lj;
      straight_lj.least = share * 0.2;
      check(lj.kernel(true), straight_lj.kernel(true), share * 0.2);
      RegularisedGranular granular{300.0, n, alpha, 3.0};
      auto straight_granular = granular;
      straight_granular.least = share;
      check(granular.kernel(true), straight_granular.kernel(true), share * alpha * dbar);
    }
}

TEST(Continued, LeavesTheRestOfTheLawAsItIs)
{
  for_each_law([](const auto &law, const auto &straight, double least) {
    for (const double r : {r0 + 1.0001 * least, r0 + 1.1 * least, r0 + 0.25, 1.3, 2.5}) {
      if (r < r0 + least) continue;
      const auto a = law.evaluate(r, contact_only()), b = straight.evaluate(r, contact_only());
      EXPECT_EQ(a.energy, b.energy);
      EXPECT_EQ(a.force, b.force);
      EXPECT_EQ(a.stiffness, b.stiffness);
    }
  });
}

TEST(Continued, ForceAndStiffnessAreTheDerivatives)
{
  for_each_law([](const auto &, const auto &straight, double least) {
    for (const double r : {0.01, 0.3, r0 - 0.1, r0, r0 + 0.5 * least, r0 + 0.99 * least})
      reference::expect_derivatives(
          [&](double t) {
            return straight.evaluate(t, contact_only());
          },
          r, 1e-3);
  });
}

TEST(Continued, StaysAtTheStiffnessWhereItBegins)
{
  for_each_law([](const auto &law, const auto &straight, double least) {
    const auto edge = law.evaluate(r0 + least, contact_only());
    for (const double r : {0.0, 0.5, r0, r0 + 0.9 * least}) {
      const auto at = straight.evaluate(r, contact_only());
      // r0 + least is rounded, and the law is steep
      EXPECT_NEAR(at.stiffness, edge.stiffness, 1e-12 * edge.stiffness);
      EXPECT_NEAR(at.force, edge.force + edge.stiffness * (r0 + least - r), 1e-12 * at.force);
      EXPECT_TRUE(std::isfinite(at.energy));
    }
  });
}

TEST(Continued, HasNoJump)
{
  for_each_law([](const auto &, const auto &straight, double least) {
    const double width = 1e-9;
    const auto below = straight.evaluate(r0 + least - width, contact_only());
    const auto above = straight.evaluate(r0 + least + width, contact_only());
    EXPECT_NEAR(below.energy - above.energy, 2.0 * width * above.force, 1e-5 * width * above.force);
    EXPECT_NEAR(below.force - above.force, 2.0 * width * above.stiffness,
                1e-5 * width * above.stiffness);
  });
}

TEST(Continued, ReachesTheCentre)
{
  for_each_law([](const auto &law, const auto &straight, double) {
    EXPECT_DOUBLE_EQ(law.hard_core(contact_only()), r0);
    EXPECT_EQ(straight.hard_core(contact_only()), 0.0);
  });
}

TEST(Continued, ServesWalls)
{
  RegularisedGranular law{300.0, 4.0, alpha, 3.0, 0.5};
  const auto wall = law.kernel(false);
  const WallGeometry at{0.5, 0.5};
  EXPECT_EQ(wall.hard_core(at), 0.0);
  reference::expect_derivatives(
      [&](double z) {
        return wall.evaluate(z, at);
      },
      0.3, 1e-3);
  EXPECT_GT(wall.evaluate(0.1, at).force, wall.evaluate(0.3, at).force);
}

}    // namespace
