/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "core/laws/dashpot.h"

#include <gtest/gtest.h>

using namespace POTDEM;

namespace {

// x'' m + C x' + K x = 0 has a double root for xi = 1
TEST(Dashpot, IsTheFractionOfCriticalDamping)
{
  const double stiffness = 3.7e4, mass = 0.21;
  const double critical = dashpot(1.0, stiffness, mass);
  EXPECT_NEAR(critical * critical, 4.0 * stiffness * mass, 1e-12 * stiffness * mass);
  EXPECT_DOUBLE_EQ(dashpot(0.03, stiffness, mass), 0.03 * critical);
}

}    // namespace
