/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "core/laws/strength.h"

#include <gtest/gtest.h>

using namespace POTDEM;

namespace {

constexpr double E = 5e3, ft = 3.0, fc = 11.0;

// load: stress over E/2
double load(double stress)
{
  return 2.0 * stress / E;
}

TEST(Strength, IsReachedByStress)
{
  const auto strength = Strength::of_stresses(ft, fc, E);
  EXPECT_TRUE(strength.reached_by(load(ft), 1.0));
  EXPECT_FALSE(strength.reached_by(load(0.999 * ft), 1.0));
  EXPECT_TRUE(strength.reached_by(load(-fc), 1.0));
  EXPECT_FALSE(strength.reached_by(load(-0.999 * fc), 1.0));
}

TEST(Strength, ScalesWithTheBond)
{
  const auto strength = Strength::of_stresses(ft, fc, E);
  EXPECT_TRUE(strength.reached_by(load(0.51 * ft), 0.5));
  EXPECT_FALSE(strength.reached_by(load(1.01 * ft), 2.0));
}

TEST(Strength, NoneThatIsNotGiven)
{
  EXPECT_FALSE(Strength().reached_by(1e200, 1.0));
  EXPECT_FALSE(Strength::of_stresses(-1.0, fc, E).reached_by(1e200, 1.0));
  EXPECT_FALSE(Strength::of_stresses(ft, -1.0, E).reached_by(-1e200, 1.0));
}

}    // namespace
