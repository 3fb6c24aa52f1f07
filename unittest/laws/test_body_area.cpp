/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "blocks.h"
#include "core/areas/body_area.h"

#include <gtest/gtest.h>

using namespace POTDEM;

namespace {

// stiffness of the bonds of one particle over its volume, from the ends of all of them
Matrix6 stiffness_at(const BondedBody &body, int i, double volume)
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
  BondedBody body(alone);
  fill(body, {6, 6, 6, true, 1.0, 2.0});
  const auto report = find_body_areas(body);
  ASSERT_EQ(report.outcome, BodyAreaReport::DONE);
  const Matrix6 c = stiffness_at(body, 17, 1.0), wanted = isotropic_stiffness(0.25);
  for (int i = 0; i < 6; i++)
    for (int j = 0; j < 6; j++) EXPECT_NEAR(c[i][j], wanted[i][j], 5e-3) << i << j;
  EXPECT_NEAR(report.volume, 216.0, 0.1);    // quadrature of the cells
  EXPECT_LT(report.misfit, 0.01);
}

TEST(BodyArea, FreeBlockIsBalancedAndKeepsItsEnergy)
{
  BodyHalo alone;
  BondedBody body(alone);
  const int n[3] = {16, 6, 6};
  fill(body, {n[0], n[1], n[2], false, 1.0, 2.0});
  const auto report = find_body_areas(body);
  ASSERT_EQ(report.outcome, BodyAreaReport::DONE);
  const double uniform = report.factor;
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
  // away from the ends each slice stores the energy of the solid, within 1 %, and the particles are nearly in balance, in a sum over
  // states that has those of torsion in it too: what is left over costs the square of it
  for (int slice = 5; slice < 11; slice++) {
    EXPECT_NEAR(energy[slice] / 36.0, 1.0, 0.01);
    for (int i = slice; i < body.nall; i += n[0])
      EXPECT_LT(std::sqrt(dot(force[i], force[i])), 0.07);
  }
}

TEST(BodyArea, EqualBodiesHaveEqualAreas)
{
  BodyHalo alone;
  BondedBody one(alone), two(alone);
  const Block block = {5, 5, 7, false, 1.0, 2.0};
  fill(one, block);
  fill(two, block, 2);
  ASSERT_EQ(find_body_areas(one).outcome, BodyAreaReport::DONE);
  ASSERT_EQ(find_body_areas(two).outcome, BodyAreaReport::DONE);
  ASSERT_EQ(two.bonds.size(), 2 * one.bonds.size());
  // rounding of sums over the body, carried through the iterations
  for (std::size_t k = 0; k < two.bonds.size(); k++)
    EXPECT_NEAR(two.bonds[k].area / one.bonds[k % one.bonds.size()].area, 1.0, 1e-9);
}

TEST(BodyArea, AreasScaleWithTheSquareOfLengths)
{
  BodyHalo alone;
  BondedBody one(alone), small(alone);
  fill(one, {5, 5, 6, false, 1.0, 2.0});
  fill(small, {5, 5, 6, false, 1e-3, 2.0});
  ASSERT_EQ(find_body_areas(one).outcome, BodyAreaReport::DONE);
  ASSERT_EQ(find_body_areas(small).outcome, BodyAreaReport::DONE);
  for (std::size_t k = 0; k < one.bonds.size(); k++)
    EXPECT_NEAR(1e6 * small.bonds[k].area / one.bonds[k].area, 1.0, 1e-9);
}

// their sum counts, each particle has its own cell; what no surface can explain is taken as given
TEST(BodyArea, VolumesCanBeGiven)
{
  BodyHalo alone;
  BondedBody own(alone), uneven(alone), loose(alone);
  for (auto *body : {&own, &uneven, &loose}) fill(*body, {5, 5, 6, false, 1.0, 2.0});
  for (int i = 0; i < uneven.nall; i++) uneven.volume.push_back(i % 2 == 0 ? 0.8 : 1.2);
  loose.volume.assign(loose.nall, 0.5);
  const BodyAreaReport reports[] = {find_body_areas(own), find_body_areas(uneven),
                                    find_body_areas(loose)};
  for (const auto &report : reports) ASSERT_EQ(report.outcome, BodyAreaReport::DONE);
  EXPECT_NEAR(reports[1].volume, 150.0, 1e-9);
  for (std::size_t k = 0; k < own.bonds.size(); k++)
    EXPECT_NEAR(uneven.bonds[k].area / own.bonds[k].area, 1.0, 1e-3);    // 150 by rays of the cells
  EXPECT_NEAR(reports[2].volume, 75.0, 1e-9);
  EXPECT_NEAR(reports[2].factor / reports[0].factor, 0.5, 1e-3);
}

TEST(BodyArea, CellsEndAtTheSurface)
{
  BodyHalo alone;
  BondedBody body(alone);
  const int n[3] = {5, 6, 7};
  fill(body, {n[0], n[1], n[2], false, 1.0, 2.0});
  body.volume.assign(body.nall,
                     4.6 * 5.6 * 6.6 / body.nall);    // the faces 0.3 outside the outer layer
  ASSERT_EQ(find_body_areas(body).outcome, BodyAreaReport::DONE);
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
  BondedBody plate(alone), hinged(alone);
  fill(plate, {6, 6, 2, false, 1.0, 2.0});
  EXPECT_EQ(find_body_areas(plate).outcome, BodyAreaReport::NO_INSIDE);
  fill(hinged, {5, 5, 5, false, 1.0, 1.0});
  EXPECT_EQ(find_body_areas(hinged).outcome, BodyAreaReport::MECHANISM);
}

}    // namespace
