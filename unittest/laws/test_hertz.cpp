/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "core/laws/hertz.h"
#include "core/laws/viscous.h"

#include "reference.h"

#include <gtest/gtest.h>

using namespace POTDEM;

namespace {

Hertz hertz_of(double E, double nu)
{
  Hertz law{E, nu, 0.0, 0.0};
  law.complete();
  return law;
}

struct Material {
  double E, nu;
};
// moduli over ten decades
const Material materials[] = {{1e2, 0.0},  {5e7, 0.45}, {2.1e11, 0.3},
                              {1e12, 0.2}, {1.0, 0.5},  {3e4, -0.9}};
const double diameters[][2] = {{1.0, 1.0}, {0.02, 0.4}, {20.0, 1.0}, {1e-6, 1e-6}};
const double overlaps[] = {1e-8, 1e-5, 1e-3, 0.1, 0.5, 0.9};    // over the smaller diameter

ContactGeometry contact_only(const double d[2])
{
  return {0.5 * d[0], 0.5 * d[1], 0.5 * (d[0] + d[1])};
}

// eqs 5.15 and 5.16 as they are printed, equal materials
long double prefactor(const Material &material, const double d[2])
{
  const long double modulus =
      material.E / (2.0L * (1.0L - static_cast<long double>(material.nu) * material.nu));
  const long double dstar = 1.0L / (1.0L / d[0] + 1.0L / d[1]);
  return 4.0L / 3.0L * modulus * std::sqrt(dstar / 2.0L);
}

TEST(Hertz, IsTheFormula)
{
  for (const auto &material : materials)
    for (const auto &d : diameters) {
      const auto kernel = hertz_of(material.E, material.nu).kernel(false);
      const auto pair = contact_only(d);
      for (const double overlap : overlaps) {
        const double r = pair.contact - overlap * std::fmin(d[0], d[1]);
        const long double w = static_cast<long double>(pair.contact) - r,
                          K = prefactor(material, d);
        const auto at = kernel.evaluate(r, pair);
        const double force = static_cast<double>(K * std::pow(w, 1.5L));
        EXPECT_NEAR(at.force, force, 1e-14 * force);
        EXPECT_NEAR(at.energy, static_cast<double>(0.4L * K * std::pow(w, 2.5L)),
                    1e-14 * at.energy);
        EXPECT_NEAR(at.stiffness, static_cast<double>(1.5L * K * std::sqrt(w)),
                    1e-14 * at.stiffness);
        EXPECT_GT(at.energy, 0.0);
      }
    }
}

TEST(Hertz, EnergyForceAndStiffnessBelongTogether)
{
  for (const auto &material : materials)
    for (const auto &d : diameters) {
      const auto kernel = hertz_of(material.E, material.nu).kernel(false);
      const auto pair = contact_only(d);
      for (const double overlap : overlaps) {
        const double w = overlap * std::fmin(d[0], d[1]), r = pair.contact - w;
        // r is rounded before w is taken from it; over the differences' step
        const double rounded = 4e-16 * r / (1e-3 * w);
        reference::expect_derivatives(
            [&](double t) {
              return kernel.evaluate(t, pair);
            },
            r, w, 1.0, 1e-9 + 4.0 * rounded);
      }
    }
}

TEST(Hertz, NothingFromTheContactDistanceOn)
{
  for (const auto &d : diameters) {
    const auto kernel = hertz_of(1e7, 0.3).kernel(false);
    const auto pair = contact_only(d);
    EXPECT_EQ(Hertz::reach(pair.dbar()), pair.dbar());
    for (const double r : {pair.contact, std::nextafter(pair.contact, 100.0), 2.0 * pair.contact}) {
      const auto at = kernel.evaluate(r, pair);
      EXPECT_EQ(at.energy, 0.0);
      EXPECT_EQ(at.force, 0.0);
      EXPECT_EQ(at.stiffness, 0.0);
    }
  }
}

TEST(Hertz, StartsFromNothing)
{
  const auto kernel = hertz_of(1e7, 0.3).kernel(false);
  const ContactGeometry pair{0.5, 0.5, 1.0};
  const auto at = kernel.evaluate(std::nextafter(1.0, 0.0), pair);
  EXPECT_GT(at.force, 0.0);
  EXPECT_LT(at.force, 1e7 * 1e-23);       // w = 1.1e-16: w^1.5 = 1.2e-24
  EXPECT_LT(at.energy, 1e7 * 1e-39);      // w^2.5 = 1.3e-40
  EXPECT_LT(at.stiffness, 1e7 * 2e-8);    // w^0.5 = 1.05e-8
}

TEST(Hertz, TwoMaterials)
{
  const double E1 = 2e11, nu1 = 0.3, E2 = 3e9, nu2 = 0.4;
  EXPECT_NEAR(contact_modulus(E1, nu1, E2, nu2), 1.0 / (0.91 / E1 + 0.84 / E2), 1e-15 * E2 * 10);
  EXPECT_EQ(hertz_of(E1, nu1).modulus, contact_modulus(E1, nu1, E1, nu1));
}

TEST(Hertz, EffectiveRadius)
{
  const ContactGeometry pair{0.01, 0.2, 0.21};
  EXPECT_DOUBLE_EQ(pair.effective_radius(), 1.0 / (1.0 / 0.01 + 1.0 / 0.2));
  // a plane: the sphere's own radius; what remains is 1e-9
  EXPECT_NEAR((ContactGeometry{0.01, 1e7, 1e7}.effective_radius()), 0.01, 2e-11);
}

// a pair that failed while it overlapped starts from zero at its distance of failure; its radii stay
TEST(Hertz, AShorterContactDistance)
{
  const auto kernel = hertz_of(1e7, 0.3).kernel(false);
  const ContactGeometry full{0.5, 0.25, 0.75}, failed{0.5, 0.25, 0.625};
  EXPECT_EQ(kernel.evaluate(0.625, failed).force, 0.0);
  for (const double w : {0.0625, 0.25}) {    // exact in binary
    EXPECT_EQ(kernel.evaluate(0.75 - w, full).force, kernel.evaluate(0.625 - w, failed).force);
    EXPECT_EQ(kernel.evaluate(0.75 - w, full).energy, kernel.evaluate(0.625 - w, failed).energy);
  }
}

// --- eq. 5.17: F = K w^(3/2) + K H w^(1/2) dw/dt ------------------------------------------------------

constexpr double H = 0.02, E = 4e6, nu = 0.25, r = 0.9;
const ContactGeometry spheres{0.5, 0.5, 1.0};

Approach approach(double rate)
{
  const auto elastic = hertz_of(E, nu).kernel(false).evaluate(r, spheres);
  return {elastic.force, elastic.energy, spheres.contact - r, rate, 1.0, 1.0};
}

double total(bool attract, double rate)
{
  return Viscous{H, attract ? 1.0 : 0.0}.total(approach(rate));
}

double literal(double rate)
{
  const double w = 1.0 - r, K = 4.0 / 3.0 * E / (2.0 * (1.0 - nu * nu)) * std::sqrt(0.25);
  return K * std::pow(w, 1.5) -
      K * H * std::sqrt(w) * rate;    // the distance grows: the overlap shrinks
}

TEST(HertzViscous, IsTheFormula)
{
  for (const double rate : {-100.0, -3.0, -1e-3, 0.0, 1e-3, 3.0, 4.9}) {
    EXPECT_NEAR(total(false, rate), literal(rate), 1e-13 * literal(-std::fabs(rate)));
    EXPECT_NEAR(total(true, rate), literal(rate), 1e-13 * literal(-std::fabs(rate)));
  }
}

TEST(HertzViscous, DoesNotAttractUnlessAskedTo)
{
  const double parting = 0.1 / H;    // H rate = w: nothing is left
  for (const double rate : {1.001 * parting, 2.0 * parting, 1e6 * parting}) {
    EXPECT_EQ(total(false, rate), 0.0);
    EXPECT_LT(total(true, rate), 0.0);
    EXPECT_NEAR(total(true, rate), literal(rate), 1e-12 * std::fabs(literal(rate)));
  }
  EXPECT_GT(total(false, 0.999 * parting), 0.0);
}

TEST(HertzViscous, WithoutViscosityTheElasticForce)
{
  for (const double rate : {-1e6, 0.0, 1e6})
    EXPECT_EQ((Viscous{0.0, 0.0}.total(approach(rate))), approach(rate).force);
}

TEST(HertzViscous, ItsViscosityIsTheSlopeOverTheRate)
{
  const Viscous law{H, 0.0};
  EXPECT_DOUBLE_EQ(law.viscosity(approach(0.0)), literal(-1.0) - literal(0.0));
}

}    // namespace
