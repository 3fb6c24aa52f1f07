/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "core/laws/hertz.h"
#include "core/laws/regularised_granular.h"
#include "core/laws/shifted_lj.h"
#include "core/laws/truss_contact.h"
#include "core/stability/turning_point.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace POTDEM;

namespace {

Hertz hertz_of(double E, double nu)
{
  Hertz law{E, nu, 0.0, 0.0};
  law.complete();
  return law;
}

const ContactGeometry spheres{0.5, 0.5, 1.0};

template <class Kernel> double turn(const Kernel &kernel, double outer, double kinetic)
{
  return turning_point(outer, kernel.hard_core(spheres), kinetic, [&kernel](double r) {
    return kernel.evaluate(r, spheres);
  });
}

// the overlap at rest of eq. 5.16, for energies over ten decades
TEST(TurningPoint, OfHertz)
{
  const auto kernel = hertz_of(1e6, 0.3).kernel(false);
  const double K = 4.0 / 3.0 * 1e6 / (2.0 * (1.0 - 0.09)) * std::sqrt(0.25);
  for (double w = 1e-5; w < 0.3; w *= 1.7)
    for (const double start : {0.0, 0.5, 0.999}) {
      const double all = 0.4 * K * std::pow(w, 2.5),
                   kinetic = all - 0.4 * K * std::pow(start * w, 2.5);
      const double r = turn(kernel, 1.0 - start * w, kinetic);
      EXPECT_NEAR(0.4 * K * std::pow(1.0 - r, 2.5), all, 0.1 * kinetic + 1e-9 * all)
          << w << " from " << start;
    }
}

// every law: the energy is there, from the place where it begins to act and from within, however hard the blow
TEST(TurningPoint, OfEveryLaw)
{
  const auto check = [](const auto &law) {
    const auto kernel = law.kernel(false);
    const double most = law.reach(1.0), core = kernel.hard_core(spheres);
    for (const double share : {1.0, 0.9, 0.6})
      for (double kinetic = 1e-9; kinetic < 1e3; kinetic *= 10.0) {
        const double outer = core + share * (most - core), r = turn(kernel, outer, kinetic);
        ASSERT_GT(r, core);
        ASSERT_LT(r, outer);
        const double before = kernel.evaluate(core + (1.0 - 1e-9) * (outer - core), spheres).energy;
        EXPECT_NEAR(kernel.evaluate(r, spheres).energy - before, kinetic,
                    0.1 * kinetic + 1e-9 * std::fabs(before))
            << "share " << share;
      }
  };
  check(ShiftedLJ{2e4, 0.35, 3.0, 0.45, ShiftedLJ::default_cut(0.35, 3.0)});
  check(RegularisedGranular{2e4, 3.0, 0.4, RegularisedGranular::default_cut(3.0)});
  check(TrussContact{1e6, 0.5, 0, 0});
  check(TrussContact{1e6, 0.5, 3, 1});
}

// a blow beyond what the law can take up ends at the smallest distance
TEST(TurningPoint, OfABlowBeyondTheLaw)
{
  const auto kernel = hertz_of(1.0, 0.0).kernel(false);
  const double r = turn(kernel, 1.0, 1e6);
  EXPECT_GT(r, 0.0);
  EXPECT_LT(r, 1e-6);
}

}    // namespace
