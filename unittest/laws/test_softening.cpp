/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "core/laws/softening.h"

#include <gtest/gtest.h>

using namespace POTDEM;

namespace {

// stress over E on the way from the onset to the end
double falling(const Softening &law, double strain)
{
  return law.onset * (law.end - strain) / (law.end - law.onset);
}

TEST(Softening, NoneAtFirst)
{
  EXPECT_FALSE(Softening().begun());
  EXPECT_FALSE(Softening().spent());
}

TEST(Softening, FallsInProportionToTheStrain)
{
  Softening law{1e-3, 9e-3, 0.0};
  EXPECT_TRUE(law.begun());
  EXPECT_EQ(law.after(1e-3), 0.0);
  for (const double strain : {2e-3, 5e-3, 8.9e-3})
    EXPECT_NEAR((1.0 - law.after(strain)) * strain, falling(law, strain), 1e-18);
  EXPECT_EQ(law.after(9e-3), 1.0);
  EXPECT_EQ(law.after(1.0), 1.0);
}

TEST(Softening, RemembersTheLargestStrain)
{
  Softening law{1e-3, 9e-3, 0.0};
  law.damage = law.after(4e-3);
  EXPECT_EQ(law.after(2e-3), law.damage);
  EXPECT_EQ(law.after(-1.0), law.damage);
  EXPECT_GT(law.after(4.1e-3), law.damage);
  EXPECT_NEAR(law.largest_strain(), 4e-3, 1e-17);
  EXPECT_FALSE(law.spent());
}

// the work up to a strain less what comes back, by Simpson's rule over r/re
TEST(Softening, LosesTheWorkThatDoesNotComeBack)
{
  for (const double size : {1e-6, 1e-3, 0.1})
    for (const double reached : {1.5, 4.0, 9.0}) {
      Softening law{size, 9.0 * size, 0.0};
      law.damage = law.after(reached * size);
      const double from = sqrt(1.0 + 2.0 * law.onset), to = sqrt(1.0 + 2.0 * reached * size);
      const int pieces = 2000;
      const auto work = [&](double x0, double x1, const auto &stress) {
        double sum = 0.0;
        const double h = (x1 - x0) / pieces;
        for (int k = 0; k <= pieces; k++) {
          const double y = x0 - 1.0 + k * h;
          const double strain = y + 0.5 * y * y;
          sum += stress(strain) * (k == 0 || k == pieces ? 1.0 : k % 2 ? 4.0 : 2.0);
        }
        return sum * h / 3.0;
      };
      const auto elastic = [](double strain) {
        return strain;
      };
      const double lost = work(1.0, from, elastic) +
          work(from, to, [&](double strain) { return falling(law, strain); }) -
          (1.0 - law.damage) * work(1.0, to, elastic);
      // the rule's own rounding, at small strains that of r/re - 1
      EXPECT_NEAR(law.lost(), lost, (1e-12 + 1e-15 / size) * lost) << size << " " << reached;
    }
}

// small strains: the area of the triangle
TEST(Softening, LosesHalfTheStressTimesTheEnd)
{
  const Softening law{1e-7, 7e-7, 1.0};
  EXPECT_TRUE(law.spent());
  EXPECT_NEAR(law.lost(), 0.5 * law.onset * law.end, 1e-6 * law.lost());
  EXPECT_EQ((Softening{1e-7, 7e-7, 0.0}).lost(), 0.0);
}

}    // namespace
