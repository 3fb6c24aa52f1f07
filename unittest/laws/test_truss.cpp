/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "core/laws/contact_geometry.h"
#include "core/laws/truss.h"

#include "reference.h"

#include <gtest/gtest.h>

using namespace POTDEM;

namespace {

constexpr double re = 0.37, modulus = 5.3e4;    // any values: the law must not depend on a unit
const int exponents[] = {1, 2, 3, 6, 12};

// stretches over the whole domain, both ends included
const double stretches[] = {1e-4,  1e-2, 0.1, 0.3, 0.5, 0.9, 0.999, 1.0,
                            1.001, 1.1,  1.5, 2.0, 3.7, 4.3, 6.0};

// c(x) as the thesis prints it, 5.22
double c_of(double x, int m)
{
  const double p = std::pow(1.0 + x, -m);
  return (1.0 + p) / (1.0 - p);
}

double strain_of(double x)
{
  const double e = x - 1.0;
  return e + 0.5 * e * e;
}

// without the factor of penetration, and with it
Evaluation truss(double r)
{
  return Truss{modulus, 0, 0}.kernel().evaluate(r, re, modulus);
}

Truss::Kernel truss(int m, bool normalized)
{
  return Truss{modulus, static_cast<double>(m), normalized ? 1.0 : 0.0}.kernel();
}

TEST(Truss, ForceIsGreenLagrangeStrainTimesModulus)
{
  for (const double x : stretches)
    EXPECT_NEAR(truss(x * re).force, -modulus * strain_of(x), 1e-13 * modulus);
}

// what the loop over bonds takes, and what all others do
TEST(Truss, LoadIsStressOverHalfTheModulus)
{
  for (const int m : {0, 1, 4})
    for (const double x : stretches) {
      const auto kernel = truss(m, false);
      const double force = kernel.evaluate(x * re, re, modulus).force;
      EXPECT_NEAR(0.5 * modulus * kernel.load(x * x), -force, 1e-13 * (modulus + std::fabs(force)));
      EXPECT_EQ(kernel.load<false>(x * x), x * x - 1.0);
    }
}

TEST(Truss, FourLoadsHaveTheBitsOfOne)
{
  for (const int m : {0, 1, 4}) {
    const auto kernel = truss(m, false);
    const Four q{0.81, 0.998, 1.02, 1.44}, load = kernel.load(q);
    for (int k = 0; k < 4; k++) EXPECT_EQ(load[k], kernel.load(q[k]));
  }
}

TEST(Truss, FourEnergiesHaveTheBitsOfOne)
{
  for (const int m : {0, 4}) {
    const auto kernel = truss(m, false);
    const Four x{0.9, 0.999, 1.001, 4.2}, unit{1.0, 2.0, 3.0, 4.0}, energy = kernel.energy(x, unit);
    for (int k = 0; k < 4; k++) {
      EXPECT_EQ(energy[k], kernel.energy(x[k], unit[k]));
      EXPECT_NEAR(energy[k], kernel.evaluate(x[k], 1.0, unit[k]).energy, 1e-15 * energy[k]);
    }
  }
}

TEST(Truss, EnergyForceAndStiffnessBelongTogether)
{
  for (const double x : stretches)
    reference::expect_derivatives(
        [](double r) {
          return truss(r);
        },
        x * re, 0.1 * x * re);
}

TEST(Truss, AtRestNothing)
{
  const auto rest = truss(re);
  EXPECT_EQ(rest.energy, 0.0);
  EXPECT_EQ(rest.force, 0.0);
  EXPECT_DOUBLE_EQ(rest.stiffness, modulus / re);
}

// without the factor a crushed truss loses its stiffness and stays finite: what the factor is for
TEST(Truss, CrushedWithoutFactorStaysFinite)
{
  const auto crushed = truss(1e-12 * re);
  EXPECT_NEAR(crushed.force, 0.5 * modulus, 1e-9 * modulus);
  EXPECT_NEAR(crushed.energy, modulus * re / 3.0, 1e-9 * modulus * re);    // integral of (1-x^2)/2
}

TEST(Truss, SectionIsTheCircleOfTheMeanRadius)
{
  const double di = 0.02, dj = 0.05, mean_radius = 0.5 * (0.5 * di + 0.5 * dj);
  EXPECT_DOUBLE_EQ(truss_section(0.5 * (di + dj)), M_PI * mean_radius * mean_radius);
}

TEST(Truss, ModuliInSeries)
{
  EXPECT_DOUBLE_EQ(series_modulus(7.0, 7.0), 7.0);
  EXPECT_DOUBLE_EQ(series_modulus(2.0, 6.0), series_modulus(6.0, 2.0));
  // two half lengths under the same stress: 1/E = (1/Ei + 1/Ej)/2
  EXPECT_DOUBLE_EQ(series_modulus(2.0, 6.0), 1.0 / (0.5 / 2.0 + 0.5 / 6.0));
  EXPECT_NEAR(series_modulus(2.0, 1e300), 4.0, 1e-12);    // a rigid half
}

TEST(Penetration, IsTheThesisFormula)
{
  for (const int m : exponents)
    for (const double x : stretches) {
      const double expected = c_of(x, m);
      // 1 - (1+x)^-m cancels for small x: rounding eps/(m x)
      EXPECT_NEAR(Penetration(m, false).value(x), expected,
                  4e-16 * expected * (4.0 + 1.0 / (m * x)));
    }
}

TEST(Penetration, NormalizedIsOneAtRest)
{
  for (const int m : exponents) {
    EXPECT_DOUBLE_EQ(Penetration(m, true).value(1.0), 1.0);
    EXPECT_DOUBLE_EQ(Penetration(m, false).value(1.0),
                     (std::pow(2.0, m) + 1.0) / (std::pow(2.0, m) - 1.0));
    for (const double x : {0.2, 0.8, 2.5})
      EXPECT_NEAR(Penetration(m, true).value(x), c_of(x, m) / c_of(1.0, m), 1e-14 * c_of(x, m));
  }
}

TEST(Penetration, SlopeIsTheDerivative)
{
  for (const int m : exponents)
    for (const double x : stretches) {
      const Penetration factor(m, false);
      // length over which c varies: x near 0, 1/m elsewhere; five-point formula at 1e-3 of it: 1e-12 relative
      const double scale = std::fmin(x, 1.0 / m);
      const double expected = reference::slope(
          [&](double t) {
            return factor.value(t);
          },
          x, 1e-3 * scale);
      EXPECT_NEAR(factor.slope(x), expected, 1e-9 * std::fabs(expected) + 1e-12 / scale)
          << "m " << m << " x " << x;
    }
}

// integral of c eps from 1 to x; integrated from the lower end, so that s is the distance from it
long double energy_integral(double x, int m)
{
  const bool stretched = x > 1.0;
  const auto integrand = [&](long double s) {
    const long double d = stretched ? s : -s, t = 1.0L + d;    // t - 1 = d without cancellation
    const long double p = std::pow(1.0L + t, -static_cast<long double>(m));
    return (1.0L + p) / (1.0L - p) * d * (1.0L + 0.5L * d);
  };
  const long double length = stretched ? static_cast<long double>(x) - 1.0L
                                       : 1.0L - static_cast<long double>(x);
  const long double sum = reference::integral(integrand, length, 3000);
  return stretched ? sum : -sum;
}

// what penetration.h promises: the energy to 1e-10 relative
TEST(Penetration, EnergyIsTheIntegralOfTheForce)
{
  for (const int m : exponents)
    for (const bool normalized : {false, true}) {
      const Penetration factor(m, normalized);
      const double scale = normalized ? 1.0 / c_of(1.0, m) : 1.0;
      for (const double x : {5e-4, 1e-3, 0.02, 0.3, 0.71, 0.9, 1.1, 1.37, 2.2, 3.99, 4.01, 6.0}) {
        const double expected = scale * static_cast<double>(energy_integral(x, m));
        EXPECT_NEAR(factor.integral(x), expected, 1e-10 * std::fabs(expected))
            << "m " << m << " x " << x;
      }
    }
}

// The strains of a body in use are 1e-5 to 1e-2. Rounding of x itself leaves eps/|x - 1| relative in the
// energy of any formula in x = r/re.
TEST(Penetration, EnergyOfSmallStrains)
{
  for (const int m : exponents) {
    const Penetration factor(m, false);
    for (const double strain : {1e-2, 1e-3, 3e-4, 1e-4, 1e-5})
      for (const double x : {1.0 - strain, 1.0 + strain}) {
        const double expected = static_cast<double>(energy_integral(x, m));
        EXPECT_NEAR(factor.integral(x), expected, (1e-10 + 4e-16 / strain) * expected)
            << "m " << m << " x " << x;
      }
  }
}

// 1e-7: the energy may be interpolated to 1e-10, and over a step of 1e-3 its slope is then off by 1e-7
TEST(Penetration, EnergyForceAndStiffnessBelongTogether)
{
  for (const int m : exponents)
    for (const bool normalized : {false, true}) {
      const auto kernel = truss(m, normalized);
      for (const double x : stretches)
        reference::expect_derivatives(
            [&](double r) {
              return kernel.evaluate(r, re, modulus);
            },
            x * re, re * std::fmin(x, 1.0 / m), 1.0, 1e-7);
    }
}

TEST(Penetration, TwoCentresCannotPass)
{
  for (const int m : exponents) {
    const auto kernel = truss(m, false);
    double previous = 0.0;
    for (const double x : {1e-1, 1e-2, 1e-4, 1e-8, 1e-12}) {
      const auto at = kernel.evaluate(x * re, re, modulus);
      EXPECT_GT(at.force, previous);    // repels, and without bound
      EXPECT_TRUE(std::isfinite(at.force));
      EXPECT_GT(at.energy, 0.0);
      EXPECT_GT(at.stiffness, 0.0);
      previous = at.force;
    }
    // F -> A E/(m x): what remains is of relative order x
    EXPECT_NEAR(kernel.evaluate(1e-6 * re, re, modulus).force, modulus / (m * 1e-6),
                1e-4 * modulus / (m * 1e-6));
  }
}

TEST(Penetration, StiffnessIsPositiveEverywhere)
{
  for (int m = 1; m <= 64; m++) {
    const auto kernel = truss(m, false);
    for (double x = 0.01; x < 5.0; x += 0.01)
      EXPECT_GT(kernel.evaluate(x * re, re, modulus).stiffness, 0.0) << m << " " << x;
  }
}

}    // namespace
