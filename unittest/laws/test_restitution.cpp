/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "core/laws/hertz.h"
#include "core/laws/hertz_wall.h"
#include "core/laws/restitution.h"
#include "core/laws/truss_contact.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace POTDEM;

namespace {

Restitution of(double e)
{
  Restitution law{e};
  law.complete();
  return law;
}

/* the classical Runge-Kutta method over an impact at the given speed, until the overlap is gone; steps shrink towards first touch,
   where the law of the dashpot is not smooth. Returns the speed apart over the speed of approach */
template <class Kernel, class Geometry>
double measured(const Kernel &kernel, const Geometry &geometry, const Restitution &law,
                double speed, double mass, double duration)
{
  const auto acceleration = [&](double w, double v) {
    if (w <= 0.0) return 0.0;
    const auto elastic = kernel.evaluate(geometry.contact - w, geometry);
    return -law.total({elastic.force, elastic.energy, w, -v, mass, 1.0}) / mass;
  };
  double w = 0.0, v = speed, h = 1e-7 * duration;
  for (int step = 0; step < 1000000 && (w > 0.0 || step == 0); step++) {
    const double a1 = acceleration(w, v), v2 = v + 0.5 * h * a1;
    const double a2 = acceleration(w + 0.5 * h * v, v2), v3 = v + 0.5 * h * a2;
    const double a3 = acceleration(w + 0.5 * h * v2, v3), v4 = v + h * a3;
    const double a4 = acceleration(w + h * v3, v4);
    w += h / 6.0 * (v + 2.0 * v2 + 2.0 * v3 + v4);
    v += h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
    h = std::fmin(1.01 * h, 1e-4 * duration);
  }
  return -v / speed;
}

constexpr double mass = 0.3;
const double all[] = {0.05, 0.3, 0.5, 0.9, 0.99};

TEST(Restitution, IsMeasuredWithHertzAtAnySpeed)
{
  Hertz law{3e6, 0.2, 0.0, 0.0};
  law.complete();
  const ContactGeometry geometry{0.5, 0.5, 1.0};
  for (const double e : all)
    for (const double speed : {1e-3, 1e-1, 10.0})
      EXPECT_NEAR(measured(law.kernel(false), geometry, of(e), speed, mass,
                           std::pow(mass * mass / (3e6 * 3e6 * 0.25 * speed), 0.2)),
                  e, 1e-3 * e);
}

TEST(Restitution, IsMeasuredWithTheTrussContactAtAnySpeed)
{
  const TrussContact law{1e4, 0.4, 0.0, 0.0};
  const ContactGeometry geometry{0.5, 0.5, 1.0};
  for (const double e : all)
    for (const double speed : {1e-3, 1e-1, 5.0})
      EXPECT_NEAR(measured(law.kernel(false), geometry, of(e), speed, mass, 0.03), e, 1e-3 * e);
}

TEST(Restitution, IsMeasuredUnderTheSoftLayerOfAWall)
{
  HertzWall law{3e6, 0.2, 3e6, 0.2};
  law.complete();
  const WallGeometry geometry{0.5, 0.55};
  for (const double e : all)
    for (const double speed : {0.1, 10.0})
      EXPECT_NEAR(measured(law.kernel(false), geometry, of(e), speed, mass, 0.01), e, 1e-3 * e);
}

// from a table of the linear dashpot without attraction, ln e = -2 zeta acos(zeta)/sqrt(1 - zeta^2) by hand
TEST(Restitution, OfALinearDashpot)
{
  EXPECT_NEAR(Restitution::log_restitution(0.5), -2.0 * 0.5 * (M_PI / 3.0) / std::sqrt(0.75),
              1e-15);
  EXPECT_NEAR(Restitution::log_restitution(1.0), -2.0, 1e-15);
  EXPECT_NEAR(Restitution::log_restitution(1.0 - 1e-9), -2.0, 1e-8);
  EXPECT_NEAR(Restitution::log_restitution(1.0 + 1e-9), -2.0, 1e-8);
  EXPECT_NEAR(Restitution::log_restitution(2.0),
              -4.0 * std::log(2.0 + std::sqrt(3.0)) / std::sqrt(3.0), 1e-14);
}

TEST(Restitution, OneIsElastic)
{
  EXPECT_FALSE(of(1.0).active());
  EXPECT_EQ(of(1.0).total({5.0, 1.0, 0.1, 3.0, mass, 1.0}), 5.0);
}

TEST(Restitution, NeverAttracts)
{
  const auto law = of(0.5);
  EXPECT_GT(law.total({5.0, 1.0, 0.1, -3.0, mass, 1.0}), 5.0);
  EXPECT_EQ(law.total({5.0, 1.0, 0.1, 1e9, mass, 1.0}), 0.0);
  EXPECT_EQ(law.total({0.0, 0.0, 0.0, -1.0, mass, 1.0}), 0.0);
}

TEST(Restitution, ItsViscosityIsTheSlopeOverTheSpeed)
{
  const auto law = of(0.7);
  const Approach at{5.0, 1.0, 0.1, -1.0, mass, 1.0};
  EXPECT_NEAR(law.viscosity(at), law.total(at) - 5.0, 1e-14);
}

}    // namespace
