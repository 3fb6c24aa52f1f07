/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

// Scatter of strengths: its distribution against the exact one, and that it belongs to the bond alone.

#include "core/laws/strength_scatter.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <vector>

using POTDEM::StrengthScatter;

namespace {

constexpr int N = 100000;

std::vector<double> sample(const StrengthScatter &scatter)
{
  std::vector<double> values;
  for (int a = 1; a <= N / 10; a++)
    for (int b = 1; b <= 10; b++) values.push_back(scatter.factor(a, a + b));
  std::sort(values.begin(), values.end());
  return values;
}

// largest distance of the empirical from the exact distribution; beyond 1.95/sqrt(N) once in a thousand seeds
double distance(const std::vector<double> &values, const std::function<double(double)> &exact)
{
  double most = 0.0;
  for (int k = 0; k < N; k++) {
    const double F = exact(values[k]);
    most = std::max({most, std::fabs(F - k / double(N)), std::fabs(F - (k + 1) / double(N))});
  }
  return most;
}

TEST(StrengthScatter, IsWeibullsWithMeanOne)
{
  for (const double k : {0.8, 3.0, 20.0}) {
    const double gamma = std::tgamma(1.0 + 1.0 / k);
    EXPECT_LT(distance(sample(StrengthScatter::weibull(k, 17)),
                       [&](double s) {
                         return 1.0 - std::exp(-std::pow(s * gamma, k));
                       }),
              1.95 / std::sqrt(N));
  }
}

TEST(StrengthScatter, IsNormalAndCut)
{
  const double cov = 0.2, inside = std::erf(3.0 / std::sqrt(2.0));
  const auto values = sample(StrengthScatter::normal(cov, 4));
  EXPECT_LT(distance(values,
                     [&](double s) {
                       return 0.5 + 0.5 * std::erf((s - 1.0) / cov / std::sqrt(2.0)) / inside;
                     }),
            1.95 / std::sqrt(N));
  EXPECT_GE(values.front(), 1.0 - 3.0 * cov);
  EXPECT_LE(values.back(), 1.0 + 3.0 * cov);
}

TEST(StrengthScatter, BelongsToTheBondAndTheSeed)
{
  const auto a = StrengthScatter::weibull(5.0, 1), b = StrengthScatter::weibull(5.0, 2);
  EXPECT_EQ(a.factor(12, 345), a.factor(345, 12));
  EXPECT_NE(a.factor(12, 345), a.factor(12, 346));
  EXPECT_NE(a.factor(12, 345), b.factor(12, 345));
}

// neighbouring bonds and seeds must not be weak together: correlation of N values is below 4/sqrt(N)
TEST(StrengthScatter, NeighboursAreIndependent)
{
  const auto first = StrengthScatter::normal(0.2, 7), other = StrengthScatter::normal(0.2, 8);
  double along = 0.0, across = 0.0, seeds = 0.0;
  for (int a = 1; a <= N; a++) {
    const double s = first.factor(a, a + 1) - 1.0;
    along += s * (first.factor(a + 1, a + 2) - 1.0);
    across += s * (first.factor(a, a + 2) - 1.0);
    seeds += s * (other.factor(a, a + 1) - 1.0);
  }
  for (const double sum : {along, across, seeds})
    EXPECT_LT(std::fabs(sum), 4.0 * std::sqrt(N) * 0.04);
}

TEST(StrengthScatter, NoneIsOne)
{
  EXPECT_FALSE(StrengthScatter().active());
  EXPECT_EQ(StrengthScatter().factor(1, 2), 1.0);
}

}    // namespace
