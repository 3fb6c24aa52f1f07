#include "laws/body_area.h"

#include <gtest/gtest.h>

using namespace POTDEM;

namespace {

struct Block {
  int nx, ny, nz;
  bool periodic;
  double spacing, reach;    // reach in spacings
};

// a simple cubic block on one rank
void fill(BodyArea &body, const Block &block, int copies = 1)
{
  const int n[3] = {block.nx, block.ny, block.nz}, size = n[0] * n[1] * n[2];
  body.nowned = body.nall = copies * size;
  body.diameter.assign(body.nall, block.spacing);
  for (int i = 0; i < body.nall; i++) body.id.push_back(i + 1);
  const int far = static_cast<int>(block.reach);
  for (int i = 0; i < body.nall; i++) {
    const int site = i % size, at[3] = {site % n[0], site / n[0] % n[1], site / (n[0] * n[1])};
    for (int x = -far; x <= far; x++)
      for (int y = -far; y <= far; y++)
        for (int z = -far; z <= far; z++) {
          const double r = std::sqrt(x * x + y * y + z * z);
          int to[3] = {at[0] + x, at[1] + y, at[2] + z};
          bool outside = r == 0.0 || r > block.reach + 1e-9;
          for (int k = 0; k < 3; k++) {
            if (block.periodic) to[k] = (to[k] + n[k]) % n[k];
            outside = outside || to[k] < 0 || to[k] >= n[k];
          }
          if (outside) continue;
          const int j = i - site + to[0] + n[0] * (to[1] + n[1] * to[2]);
          if (i < j)
            body.bonds.push_back({i, j, {x / r, y / r, z / r}, r * block.spacing, true, 0.0});
        }
  }
}

// stiffness of the bonds of one particle over its volume, from the ends of all of them
Matrix6 stiffness_at(const BodyArea &body, int i, double volume)
{
  Matrix6 c{};
  for (const auto &bond : body.bonds)
    if (bond.low == i || bond.high == i) {
      const Vector3 n = {bond.n[0], bond.n[1], bond.n[2]};
      add_dyad(c, 0.5 * bond.area * bond.length / volume, mandel(n, n), mandel(n, n));
    }
  return c;
}

// C11 = 6/5, C12 = 2/5 of nu = 1/4. The pull towards equal areas has the weight 0.02 against 1
TEST(BodyArea, InfiniteCrystalIsAnIsotropicSolid)
{
  BodyHalo alone;
  BodyArea body(alone);
  fill(body, {6, 6, 6, true, 1.0, 2.0});
  ASSERT_EQ(body.solve(), BodyArea::DONE);
  const Matrix6 c = stiffness_at(body, 17, 1.0), wanted = isotropic_stiffness(0.25);
  for (int i = 0; i < 6; i++)
    for (int j = 0; j < 6; j++) EXPECT_NEAR(c[i][j], wanted[i][j], 5e-3) << i << j;
  EXPECT_NEAR(body.report.volume, 216.0, 0.1);    // quadrature of the cells
  EXPECT_LT(body.report.misfit, 0.01);
}

TEST(BodyArea, FreeBlockIsBalancedAndKeepsItsEnergy)
{
  BodyHalo alone;
  BodyArea body(alone);
  const int n[3] = {16, 6, 6};
  fill(body, {n[0], n[1], n[2], false, 1.0, 2.0});
  ASSERT_EQ(body.solve(), BodyArea::DONE);
  const double uniform = body.report.start;
  // uniaxial stress along the block, which all long faces can carry: strains 1, -1/4, -1/4
  std::vector<double> energy(n[0], 0.0);
  std::vector<Vector3> force(body.nall, Vector3{});
  for (const auto &bond : body.bonds) {
    EXPECT_GE(bond.area, 0.0999 * uniform);
    EXPECT_LE(bond.area, 4.001 * uniform);
    const double strain = 1.25 * bond.n[0] * bond.n[0] - 0.25;
    for (int k = 0; k < 3; k++) {
      force[bond.low][k] += bond.area * strain * bond.n[k];
      force[bond.high][k] -= bond.area * strain * bond.n[k];
    }
    for (const int i : {bond.low, bond.high})
      energy[i % n[0]] += 0.5 * bond.area * bond.length * strain * strain;
  }
  // away from the ends each slice stores the energy of the solid, within 1 %, and the particles are in balance:
  // what is left over costs the square of it
  for (int slice = 5; slice < 11; slice++) {
    EXPECT_NEAR(energy[slice] / 36.0, 1.0, 0.01);
    for (int i = slice; i < body.nall; i += n[0])
      EXPECT_LT(std::sqrt(dot(force[i], force[i])), 0.05);
  }
}

TEST(BodyArea, EqualBodiesHaveEqualAreas)
{
  BodyHalo alone;
  BodyArea one(alone), two(alone);
  const Block block = {5, 5, 7, false, 1.0, 2.0};
  fill(one, block);
  fill(two, block, 2);
  ASSERT_EQ(one.solve(), BodyArea::DONE);
  ASSERT_EQ(two.solve(), BodyArea::DONE);
  ASSERT_EQ(two.bonds.size(), 2 * one.bonds.size());
  // rounding of sums over the body, carried through the iterations
  for (std::size_t k = 0; k < two.bonds.size(); k++)
    EXPECT_NEAR(two.bonds[k].area / one.bonds[k % one.bonds.size()].area, 1.0, 1e-9);
}

TEST(BodyArea, AreasScaleWithTheSquareOfLengths)
{
  BodyHalo alone;
  BodyArea one(alone), small(alone);
  fill(one, {5, 5, 6, false, 1.0, 2.0});
  fill(small, {5, 5, 6, false, 1e-3, 2.0});
  ASSERT_EQ(one.solve(), BodyArea::DONE);
  ASSERT_EQ(small.solve(), BodyArea::DONE);
  for (std::size_t k = 0; k < one.bonds.size(); k++)
    EXPECT_NEAR(1e6 * small.bonds[k].area / one.bonds[k].area, 1.0, 1e-9);
}

// their sum counts, each particle has its own cell; what no surface can explain is taken as given
TEST(BodyArea, VolumesCanBeGiven)
{
  BodyHalo alone;
  BodyArea own(alone), uneven(alone), loose(alone);
  for (auto *body : {&own, &uneven, &loose}) fill(*body, {5, 5, 6, false, 1.0, 2.0});
  for (int i = 0; i < uneven.nall; i++) uneven.volume.push_back(i % 2 == 0 ? 0.8 : 1.2);
  loose.volume.assign(loose.nall, 0.5);
  for (auto *body : {&own, &uneven, &loose}) ASSERT_EQ(body->solve(), BodyArea::DONE);
  EXPECT_NEAR(uneven.report.volume, 150.0, 1e-9);
  for (std::size_t k = 0; k < own.bonds.size(); k++)
    EXPECT_NEAR(uneven.bonds[k].area / own.bonds[k].area, 1.0, 1e-3);    // 150 by rays of the cells
  EXPECT_NEAR(loose.report.volume, 75.0, 1e-9);
  EXPECT_NEAR(loose.report.start / own.report.start, 0.5, 1e-3);
}

TEST(BodyArea, CellsEndAtTheSurface)
{
  BodyHalo alone;
  BodyArea body(alone);
  const int n[3] = {5, 6, 7};
  fill(body, {n[0], n[1], n[2], false, 1.0, 2.0});
  body.volume.assign(body.nall,
                     4.6 * 5.6 * 6.6 / body.nall);    // the faces 0.3 outside the outer layer
  ASSERT_EQ(body.solve(), BodyArea::DONE);
  for (int i = 0; i < body.nall; i++) {
    const int at[3] = {i % n[0], i / n[0] % n[1], i / (n[0] * n[1])};
    double exact = 1.0;
    for (int k = 0; k < 3; k++)
      if (at[k] == 0 || at[k] == n[k] - 1) exact *= 0.8;
    EXPECT_NEAR(body.volume[i], exact, 0.02);    // rays; normals from few directions
  }
}

TEST(BodyArea, RefusesWhatIsNoSolid)
{
  BodyHalo alone;
  BodyArea plate(alone), hinged(alone);
  fill(plate, {6, 6, 2, false, 1.0, 2.0});
  EXPECT_EQ(plate.solve(), BodyArea::NO_INSIDE);
  fill(hinged, {5, 5, 5, false, 1.0, 1.0});
  EXPECT_EQ(hinged.solve(), BodyArea::MECHANISM);
}

}    // namespace
