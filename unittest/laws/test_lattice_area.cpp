#include "laws/lattice_area.h"

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
          const Vector d = {cell.edge * (i + site[0]), cell.edge * (j + site[1]), cell.edge * (k + site[2])};
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
  const Row rows[] = {{Lattice::CUBIC, 2.0, 32, 0, 0}, {Lattice::CUBIC, 3.0, 122, 0, 0}, {Lattice::FCC, 2.0, 54, 0, 0},
                      {Lattice::BCC, 1.16, 14, 0, 0},  {Lattice::BCC, 1.64, 26, 0, 0},   {Lattice::BCC, 2.0, 58, 0, 0}};
  for (const auto &row : rows) {
    const auto crystal = pull(row.lattice, row.reach);
    const auto answer = lattice_area(row.lattice, row.reach);
    EXPECT_EQ(crystal.bonds, row.bonds);
    EXPECT_EQ(answer.bonds, row.bonds);
    EXPECT_NEAR(answer.area_factor * M_PI / 4.0 * crystal.modulus, 1.0, 1e-12);
    EXPECT_NEAR(answer.poisson, crystal.poisson, 1e-12);
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
  const double area = lattice_area(Lattice::BCC, 1.0).area_factor;
  EXPECT_FALSE(area > 0.0 && area < 1e6);
}

TEST(LatticeArea, LatticesAreKnownByTheirNearestNeighbours)
{
  EXPECT_EQ(lattice_of(6), Lattice::CUBIC);
  EXPECT_EQ(lattice_of(8), Lattice::BCC);
  EXPECT_EQ(lattice_of(12), Lattice::FCC);
  EXPECT_EQ(lattice_of(7), Lattice::NONE);
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
