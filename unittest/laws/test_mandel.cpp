/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "core/areas/mandel.h"

#include <gtest/gtest.h>

using namespace POTDEM;

namespace {

const Vector3 a = {0.3, -1.2, 0.7}, b = {2.0, 0.4, -0.9};

TEST(Mandel, DoubleContractionIsAScalarProduct)
{
  Matrix3 s = tensor(mandel(a, b)), t = tensor(mandel(b, b));
  double contraction = 0.0;
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) {
      EXPECT_NEAR(s[i][j], 0.5 * (a[i] * b[j] + a[j] * b[i]), 1e-15);
      contraction += s[i][j] * t[i][j];
    }
  EXPECT_NEAR(dot(mandel(a, b), mandel(b, b)), contraction, 1e-14);
}

TEST(Mandel, ComplianceIsTheInverseOfStiffness)
{
  const Matrix6 one = product(isotropic_stiffness(0.25), isotropic_compliance(0.25));
  for (int i = 0; i < 6; i++)
    for (int j = 0; j < 6; j++) EXPECT_NEAR(one[i][j], i == j, 1e-15);
  // uniaxial stress 1: strains 1/E, -nu/E
  EXPECT_DOUBLE_EQ(isotropic_compliance(0.25)[0][0], 1.0);
  EXPECT_DOUBLE_EQ(isotropic_compliance(0.25)[1][0], -0.25);
}

TEST(Mandel, EigenvectorsDiagonalise)
{
  Matrix3 m{};
  add_dyad(m, 2.0, a, a);
  add_dyad(m, -0.5, b, b);
  m[0][0] += 1.0;
  Vector3 value;
  Matrix3 axis;
  eigen3(m, value, axis);
  EXPECT_LE(value[0], value[1]);
  EXPECT_LE(value[1], value[2]);
  for (int k = 0; k < 3; k++)
    for (int i = 0; i < 3; i++) {
      EXPECT_NEAR(dot(axis[k], axis[i]), i == k, 1e-14);
      EXPECT_NEAR(dot(m[i], axis[k]), value[k] * axis[k][i], 1e-13);
    }
}

TEST(Mandel, CholeskySolves)
{
  Matrix3 m{};
  add_dyad(m, 2.0, a, a);
  add_dyad(m, 0.5, b, b);
  for (int k = 0; k < 3; k++) m[k][k] += 0.1;
  Matrix3 factor = m;
  ASSERT_TRUE(cholesky(factor, 3));
  Vector3 x = b;
  solve_cholesky(factor, x, 3);
  for (int k = 0; k < 3; k++) EXPECT_NEAR(dot(m[k], x), b[k], 1e-13);
  m[1][1] = -1.0;
  EXPECT_FALSE(cholesky(m, 3));
}

TEST(Mandel, ProductsOfADirectionStandWhereTheyAreLookedFor)
{
  double p[MOMENTS];
  direction_products(a.data(), p);
  for (int order = 3; order <= 4; order++)
    for (int y = 0; y <= order; y++)
      for (int z = 0; y + z <= order; z++)
        EXPECT_NEAR(p[(order == 3 ? 0 : THIRD) + product_place(y, z)],
                    std::pow(a[0], order - y - z) * std::pow(a[1], y) * std::pow(a[2], z), 1e-15);
}

}    // namespace
