/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "core/areas/lattice_area.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

using namespace POTDEM;

namespace {

struct Row {
  Lattice lattice;
  double reach;
  int bonds;
  double area, poisson;
};

// the table of the model's description (exact sums worked out apart from this code), three digits as printed
const Row table[] = {
    {Lattice::CUBIC, 1.42, 18, 0.608, 0.227}, {Lattice::CUBIC, 1.75, 26, 0.566, 0.317},
    {Lattice::CUBIC, 2.00, 32, 0.281, 0.222}, {Lattice::CUBIC, 2.50, 80, 0.094, 0.249},
    {Lattice::FCC, 1.00, 12, 1.350, 0.333},   {Lattice::FCC, 1.42, 18, 0.401, 0.172},
    {Lattice::FCC, 2.00, 54, 0.150, 0.291},
};

TEST(LatticeArea, IsTheTableOfTheModel)
{
  for (const auto &row : table) {
    const auto answer = lattice_area(row.lattice, row.reach);
    EXPECT_EQ(answer.bonds, row.bonds) << row.reach;
    EXPECT_NEAR(answer.area_factor, row.area, 0.5e-3) << row.reach;
    EXPECT_NEAR(answer.poisson, row.poisson, 0.5e-3) << row.reach;
  }
}

using Vector = std::array<double, 3>;

struct Cell {
  double edge;    // of the cube, nearest neighbours at distance 1
  std::vector<Vector> sites;
};

Cell cell_of(Lattice lattice)
{
  if (lattice == Lattice::CUBIC) return {1.0, {{0.0, 0.0, 0.0}}};
  if (lattice == Lattice::BCC) return {2.0 / std::sqrt(3.0), {{0.0, 0.0, 0.0}, {0.5, 0.5, 0.5}}};
  return {std::sqrt(2.0), {{0.0, 0.0, 0.0}, {0.5, 0.5, 0.0}, {0.5, 0.0, 0.5}, {0.0, 0.5, 0.5}}};
}

// Energy per volume of a crystal of unit trusses (A E = 1) under the strains exx and eyy = ezz, of first
// order in each bond: W = 1/(4V) sum r (nx^2 exx + (ny^2 + nz^2) e)^2; uniaxial stress is the e that
// minimises it.
struct Uniaxial {
  double modulus, poisson;
  int bonds;
};

Uniaxial pull(Lattice lattice, double reach)
{
  const Cell cell = cell_of(lattice);
  const double volume = std::pow(cell.edge, 3) / cell.sites.size();
  const int n = static_cast<int>(reach / cell.edge) + 2;
  double xx = 0.0, xe = 0.0, ee = 0.0;
  int bonds = 0;
  for (int i = -n; i <= n; i++)
    for (int j = -n; j <= n; j++)
      for (int k = -n; k <= n; k++)
        for (const auto &site : cell.sites) {
          const Vector d = {cell.edge * (i + site[0]), cell.edge * (j + site[1]),
                            cell.edge * (k + site[2])};
          const double r = std::hypot(d[0], d[1], d[2]);
          if (r < 1e-9 || r > reach + 1e-6) continue;
          const double x = d[0] * d[0] / (r * r), yz = (d[1] * d[1] + d[2] * d[2]) / (r * r);
          xx += r * x * x / (2.0 * volume);
          xe += r * x * yz / (2.0 * volume);
          ee += r * yz * yz / (2.0 * volume);
          bonds++;
        }
  const double lateral = -xe / ee;
  return {xx + xe * lateral, -lateral, bonds};
}

// rounding of a sum of at most 300 terms: 1e-13
TEST(LatticeArea, GivesTheModulusUnderUniaxialTension)
{
  const Row rows[] = {{Lattice::CUBIC, 2.0, 32, 0, 0}, {Lattice::CUBIC, 3.0, 122, 0, 0},
                      {Lattice::FCC, 2.0, 54, 0, 0},   {Lattice::BCC, 1.16, 14, 0, 0},
                      {Lattice::BCC, 1.64, 26, 0, 0},  {Lattice::BCC, 2.0, 58, 0, 0}};
  for (const auto &row : rows) {
    const auto crystal = pull(row.lattice, row.reach);
    const auto answer = lattice_area(row.lattice, row.reach);
    EXPECT_EQ(crystal.bonds, row.bonds);
    EXPECT_EQ(answer.bonds, row.bonds);
    EXPECT_NEAR(answer.area_factor * M_PI / 4.0 * crystal.modulus, 1.0, 1e-12);
    EXPECT_NEAR(answer.poisson, crystal.poisson, 1e-12);
  }
}

// every shell up to three diameters, from the first with which the lattice is stiff
TEST(LatticeArea, GivesTheModulusForEveryReach)
{
  const std::pair<Lattice, double> first[] = {
      {Lattice::CUBIC, 1.42}, {Lattice::FCC, 1.0}, {Lattice::BCC, 1.16}};
  for (const auto &[lattice, least] : first)
    for (double reach = least; reach < 3.0; reach += 0.03) {
      const auto crystal = pull(lattice, reach);
      const auto answer = lattice_area(lattice, reach);
      EXPECT_EQ(answer.bonds, crystal.bonds) << reach;
      EXPECT_NEAR(answer.area_factor * M_PI / 4.0 * crystal.modulus, 1.0, 1e-12) << reach;
      EXPECT_NEAR(answer.poisson, crystal.poisson, 1e-12) << reach;
    }
}

// the reach is measured on bonds, so it carries their rounding
TEST(LatticeArea, TheShellAtTheReachBelongs)
{
  EXPECT_EQ(lattice_area(Lattice::CUBIC, std::sqrt(2.0) * (1.0 - 1e-9)).bonds, 18);
  EXPECT_EQ(lattice_area(Lattice::FCC, std::sqrt(2.0) * (1.0 - 1e-9)).bonds, 18);
  EXPECT_EQ(lattice_area(Lattice::BCC, 2.0 / std::sqrt(3.0) * (1.0 - 1e-9)).bonds, 14);
}

// a cubic lattice with its nearest neighbours only has stiffness along the axes, and no Poisson's ratio
TEST(LatticeArea, NearestNeighboursOfACubicLattice)
{
  const auto answer = lattice_area(Lattice::CUBIC, 1.0);
  EXPECT_EQ(answer.bonds, 6);
  EXPECT_DOUBLE_EQ(answer.area_factor, 4.0 / M_PI);    // one truss of unit section per unit area
  EXPECT_EQ(answer.poisson, 0.0);
}

// bcc with its nearest neighbours only is a mechanism: there is no area that makes it stiff
TEST(LatticeArea, AMechanismHasNoArea)
{
  EXPECT_EQ(lattice_area(Lattice::BCC, 1.0).area_factor, 0.0);
}

TEST(LatticeArea, LatticesAreKnownByTheirNearestNeighbours)
{
  EXPECT_EQ(lattice_of(6, true), Lattice::CUBIC);
  EXPECT_EQ(lattice_of(8, true), Lattice::BCC);
  EXPECT_EQ(lattice_of(12, true), Lattice::FCC);
  EXPECT_EQ(lattice_of(12, false), Lattice::HCP);
  EXPECT_EQ(lattice_of(7, true), Lattice::NONE);
}

// neighbours of hexagonal packing (any crystallography text): 12 at 1, 6 at sqrt 2, 2 at sqrt(8/3), 18 at sqrt 3,
// 12 at sqrt(11/3)
TEST(LatticeArea, HexagonalPacking)
{
  const int expected[] = {12, 18, 20, 38, 50};
  const double reach[] = {1.0, std::sqrt(2.0), std::sqrt(8.0 / 3.0), std::sqrt(3.0),
                          std::sqrt(11.0 / 3.0)};
  for (int k = 0; k < 5; k++) EXPECT_EQ(lattice_area(Lattice::HCP, reach[k]).bonds, expected[k]);
  EXPECT_TRUE(is_shell(Lattice::HCP, std::sqrt(8.0 / 3.0), 1e-3));
  EXPECT_FALSE(is_shell(Lattice::FCC, std::sqrt(8.0 / 3.0), 1e-3));
}

// the relaxed energy of a pulled cell of the two sublattices, minimised over the lateral strains and the shift by
// Gauss-Newton sweeps on each unknown in turn, is that of the modulus 1
TEST(LatticeArea, HexagonalPackingGivesTheModulusInItsBasalPlane)
{
  for (const double reach : {1.0, 1.42, 1.64, 1.75, 1.92, 2.0, 2.25, 2.5}) {
    const auto answer = lattice_area(Lattice::HCP, reach);
    const double area = 0.25 * M_PI * answer.area_factor, height = std::sqrt(8.0 / 3.0),
                 row = std::sqrt(3.0);
    std::vector<std::array<double, 7>> terms;    // length and factors of exx eyy ezz ux uy uz
    for (int i = -5; i <= 5; i++)
      for (int j = -5; j <= 5; j++)
        for (int k = -5; k <= 5; k++) {
          // rows of the close-packed plane, every other plane shifted by a third of the triangle's height times two
          const double shift = k % 2 == 0 ? 0.0 : 1.0;
          const double x = i + 0.5 * (j + shift), y = 0.5 * row * (j + shift / 3.0),
                       z = 0.5 * height * k;
          const double r = std::sqrt(x * x + y * y + z * z);
          if (r < 1e-9 || r > reach + 1e-6) continue;
          terms.push_back(
              {r, x * x / r, y * y / r, z * z / r, shift * x / r, shift * y / r, shift * z / r});
        }
    EXPECT_EQ(static_cast<int>(terms.size()), answer.bonds);
    std::array<double, 6> unknown = {1.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    for (int sweep = 0; sweep < 2000; sweep++)
      for (int c = 1; c < 6; c++) {
        double slope = 0.0, curvature = 0.0;
        for (const auto &term : terms) {
          double stretch = 0.0;
          for (int e = 0; e < 6; e++) stretch += term[e + 1] * unknown[e];
          slope += stretch * term[c + 1] / term[0];
          curvature += term[c + 1] * term[c + 1] / term[0];
        }
        if (curvature > 1e-12) unknown[c] -= slope / curvature;
      }
    double energy = 0.0;
    for (const auto &term : terms) {
      double stretch = 0.0;
      for (int e = 0; e < 6; e++) stretch += term[e + 1] * unknown[e];
      energy += 0.25 * area * stretch * stretch / term[0];
    }
    const double volume = std::sqrt(0.5);
    EXPECT_NEAR(2.0 * energy / volume, 1.0, 1e-9) << reach;
    EXPECT_NEAR(-unknown[1], answer.poisson, 1e-9) << reach;
  }
}

TEST(LatticeArea, ShellsOfALattice)
{
  for (const double length : {1.0, std::sqrt(2.0), std::sqrt(3.0), 2.0})
    EXPECT_TRUE(is_shell(Lattice::CUBIC, length, 1e-3));
  EXPECT_FALSE(is_shell(Lattice::CUBIC, 1.2, 1e-3));
  EXPECT_TRUE(is_shell(Lattice::BCC, 2.0 / std::sqrt(3.0), 1e-3));
  EXPECT_TRUE(is_shell(Lattice::FCC, std::sqrt(2.0), 1e-3));
  EXPECT_FALSE(is_shell(Lattice::FCC, 1.2, 1e-3));
}

}    // namespace
