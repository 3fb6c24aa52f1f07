/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

// the classes under `area body`, each alone, against values obtained otherwise

#include "blocks.h"

#include "core/areas/admissible.h"
#include "core/areas/constants.h"
#include "core/areas/dilatation.h"
#include "core/areas/surface_layer.h"
#include "core/areas/targets.h"
#include "core/areas/volumes.h"

#include <gtest/gtest.h>

using namespace POTDEM;

namespace {

// one particle at the origin and those at the given places, bonded to it
BondedBody star(BodyHalo &halo, const std::vector<Vector3> &places)
{
  BondedBody body(halo);
  body.nowned = body.nall = static_cast<int>(places.size()) + 1;
  body.diameter.assign(body.nall, 1.0);
  for (int i = 0; i < body.nall; i++) body.id.push_back(i + 1);
  for (std::size_t k = 0; k < places.size(); k++) {
    const double r = std::sqrt(dot(places[k], places[k]));
    Vector3 n = places[k];
    for (auto &component : n) component /= r;
    body.bonds.push_back({0, static_cast<int>(k) + 1, n, r, true, 0.0});
  }
  body.list_neighbours();
  return body;
}

std::vector<Vector3> shell(const std::vector<Vector3> &some)
{
  std::vector<Vector3> all;
  for (const auto &at : some)
    for (int sign = 0; sign < 8; sign++) {
      Vector3 turned = at;
      for (int k = 0; k < 3; k++)
        if (sign >> k & 1) turned[k] = -turned[k];
      if (std::find(all.begin(), all.end(), turned) == all.end()) all.push_back(turned);
    }
  return all;
}

struct Solid {
  BodyHalo alone;
  BondedBody body;
  explicit Solid(const Block &block) : body(alone)
  {
    fill(body, block);
    body.list_neighbours();
  }
  int at(const Block &block, int x, int y, int z) const
  {
    return x + block.nx * (y + block.ny * z);
  }
};

TEST(BondedBody, NeighboursAreListedFromBothEndsTheNearestFirst)
{
  BodyHalo alone;
  const BondedBody body = star(alone, {{2.0, 0.0, 0.0}, {0.0, -1.0, 0.0}});
  const auto of = body.neighbours(0);
  ASSERT_EQ(of.size(), 2);
  EXPECT_EQ(of[0].particle, 2);
  EXPECT_EQ(of[1].particle, 1);
  EXPECT_EQ(body.separation(of[0]), (Vector3{0.0, -1.0, 0.0}));
  EXPECT_EQ(body.separation(body.neighbours(2)[0]), (Vector3{0.0, 1.0, 0.0}));
  EXPECT_TRUE(body.bonded(1));
}

TEST(Cells, DirectionsAreSpreadEvenly)
{
  const auto rays = spiral_directions(400);
  Vector3 mean{};
  Matrix3 second{};
  for (const auto &ray : rays) {
    EXPECT_NEAR(dot(ray, ray), 1.0, 1e-14);
    for (int k = 0; k < 3; k++) mean[k] += ray[k] / rays.size();
    add_dyad(second, 1.0 / rays.size(), ray, ray);
  }
  for (int k = 0; k < 3; k++) {
    EXPECT_NEAR(mean[k], 0.0, 2e-3);
    for (int l = 0; l < 3; l++) EXPECT_NEAR(second[k][l], k == l ? 1.0 / 3.0 : 0.0, 2e-3);
  }
}

// volume per site of the lattices: cube 1, rhombic dodecahedron 1/sqrt 2, truncated octahedron 4/(3 sqrt 3)
TEST(Cells, VolumesOfLattices)
{
  const double f = std::sqrt(0.5), b = 1.0 / std::sqrt(3.0);
  const std::pair<std::vector<Vector3>, double> lattices[] = {
      {shell({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}), 1.0},
      {shell({{f, f, 0}, {f, 0, f}, {0, f, f}}), f},
      {shell({{b, b, b}, {2 * b, 0, 0}, {0, 2 * b, 0}, {0, 0, 2 * b}}), 4.0 / 3.0 * b}};
  for (const auto &[places, volume] : lattices) {
    BodyHalo alone;
    const BondedBody body = star(alone, places);
    const Cells cells(body);
    EXPECT_NEAR(cells.volume(0, spiral_directions(areas::LEAST_RAYS)) / volume, 1.0, 1e-2);
    EXPECT_NEAR(cells.volume(0, spiral_directions(areas::MOST_RAYS)) / volume, 1.0, 2e-3);
  }
}

// radical planes: a larger neighbour's plane is nearer, at L/2 + (r1^2 - r2^2)/2L
TEST(Cells, PlanesBetweenUnequalParticles)
{
  BodyHalo alone;
  BondedBody body = star(alone, {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}});
  body.diameter = {1.0, 1.4, 0.8, 1.0};
  const Cells cells(body);
  const double scale = cells.diameter(0);    // spacing over diameter
  EXPECT_NEAR(cells.reach(0, {1, 0, 0}), 0.5 + scale * scale * (0.25 - 0.49) / 2.0, 1e-14);
  EXPECT_NEAR(cells.reach(0, {-1, 0, 0}), 0.5 + scale * scale * (0.25 - 0.16) / 2.0, 1e-14);
  EXPECT_EQ(cells.reach(0, {0, 0, 1}), HUGE_VAL);
}

TEST(Surfaces, OfABlock)
{
  const Block block = {5, 5, 5, false, 1.0, 2.0};
  Solid solid(block);
  const Surfaces surfaces(solid.body, Cells(solid.body));
  const int corner = solid.at(block, 0, 0, 0), edge = solid.at(block, 0, 0, 2),
            face = solid.at(block, 4, 2, 2), middle = solid.at(block, 2, 2, 2);
  const int blocked[] = {3, 2, 1, 0};
  int k = 0;
  for (const int i : {corner, edge, face, middle}) {
    const Matrix3 &b = surfaces.blocked[i];
    EXPECT_NEAR(b[0][0] + b[1][1] + b[2][2], blocked[k++], 1e-12);
  }
  EXPECT_TRUE(surfaces.inside(solid.body, middle));
  EXPECT_FALSE(surfaces.inside(solid.body, face));
  EXPECT_NEAR(surfaces.normal[face][0], 1.0, 0.02);    // 400 rays
  EXPECT_EQ(surfaces.normal[edge], Vector3{});
  EXPECT_EQ(surfaces.normal[middle], Vector3{});
}

// the sites of a simple cubic lattice in a ball: most of its outermost particles look like those of an edge or a corner, of which a
// ball has none
TEST(Surfaces, StepsOfABallAreNoEdges)
{
  const double radius = 6.0;
  BodyHalo alone;
  BondedBody body(alone);
  std::vector<Vector3> at;
  for (int x = -6; x <= 6; x++)
    for (int y = -6; y <= 6; y++)
      for (int z = -6; z <= 6; z++)
        if (x * x + y * y + z * z <= radius * radius)
          at.push_back({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
  body.nowned = body.nall = static_cast<int>(at.size());
  body.diameter.assign(body.nall, 1.0);
  for (int i = 0; i < body.nall; i++) {
    body.id.push_back(i + 1);
    for (int j = i + 1; j < body.nall; j++) {
      const Vector3 d = {at[j][0] - at[i][0], at[j][1] - at[i][1], at[j][2] - at[i][2]};
      const double r = std::sqrt(dot(d, d));
      if (r < 2.001) body.bonds.push_back({i, j, {d[0] / r, d[1] / r, d[2] / r}, r, true, 0.0});
    }
  }
  body.list_neighbours();
  const Surfaces surfaces(body, Cells(body));
  for (int i = 0; i < body.nall; i++) {
    const double r = std::sqrt(dot(at[i], at[i]));
    if (r < radius - 0.5) continue;
    const Matrix3 &b = surfaces.blocked[i];
    EXPECT_NEAR(b[0][0] + b[1][1] + b[2][2], 1.0, 1e-12);
    EXPECT_GT(dot(Vector3{dot(b[0], at[i]), dot(b[1], at[i]), dot(b[2], at[i])}, at[i]) / (r * r),
              0.7);    // terraces of steps one spacing high: cos^2 of 32 degrees
  }
}

TEST(Volumes, ACellAtASurfaceGrowsWithItsFace)
{
  const Block block = {5, 5, 5, false, 1.0, 2.0};
  Solid solid(block);
  const Cells cells(solid.body);
  const Surfaces surfaces(solid.body, cells);
  const Vector3 c = volume_at_surface(solid.body, cells, surfaces, solid.at(block, 4, 2, 2),
                                      spiral_directions(2000));
  for (const double lambda : {0.6, 0.8, 1.0})    // the half cell behind and lambda/2 in front
    EXPECT_NEAR(c[0] + lambda * (c[1] + lambda * c[2]), 0.5 + 0.5 * lambda, 0.01);
}

// sum A L/2 = 6 V over 32 bonds of lengths 1, sqrt 2, sqrt 3, 2
TEST(UniformAreas, OfACrystal)
{
  Solid solid({6, 6, 6, true, 1.0, 2.0});
  solid.body.volume.assign(solid.body.nall, 1.0);
  const UniformAreas uniform(solid.body, Surfaces(solid.body, Cells(solid.body)));
  const double lengths = 6.0 + 12.0 * std::sqrt(2.0) + 8.0 * std::sqrt(3.0) + 6.0 * 2.0;
  EXPECT_NEAR(uniform.factor, 12.0 / lengths, 1e-12);
  EXPECT_DOUBLE_EQ(uniform.volume, 216.0);
  EXPECT_DOUBLE_EQ(uniform.area.front(), uniform.factor);
}

TEST(UniformAreas, TheSolidsTraceIsSix)
{
  const Matrix6 c = isotropic_stiffness(areas::POISSON);
  double trace = 0.0;
  for (int k = 0; k < 6; k++) trace += c[k][k];
  EXPECT_NEAR(areas::SOLID_TRACE, trace, 1e-14);
  EXPECT_DOUBLE_EQ(areas::GOLDEN_ANGLE, M_PI * (3.0 - std::sqrt(5.0)));
}

// all six states, in whatever basis: the compliance; one alone: its strain over the root of its energy
TEST(Admissible, StatesAreOrthonormalInEnergy)
{
  Matrix3 axis{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const double c = std::cos(0.4), s = std::sin(0.4);
  axis[0] = {c, s, 0};
  axis[1] = {-s, c, 0};
  std::vector<StressState> states;
  for (int k = 0; k < 3; k++)
    for (int l = k; l < 3; l++) states.push_back({1.0, mandel(axis[k], axis[l])});
  const Matrix6 all = energy_norm(states, isotropic_compliance(0.25)),
                compliance = isotropic_compliance(0.25);
  for (int i = 0; i < 6; i++)
    for (int j = 0; j < 6; j++) EXPECT_NEAR(all[i][j], compliance[i][j], 1e-14);
  const Matrix6 one = energy_norm({{0.5, {3.0, 0.0, 0.0, 0.0, 0.0, 0.0}}}, compliance);
  EXPECT_NEAR(one[0][0], 0.25, 1e-15);
  EXPECT_NEAR(one[1][2], 0.25 / 16.0, 1e-15);
  EXPECT_EQ(one[3][3], 0.0);
}

TEST(Admissible, AFaceCarriesNoTraction)
{
  const Block block = {9, 9, 9, false, 1.0, 2.0};
  Solid solid(block);
  solid.body.volume.assign(solid.body.nall, 1.0);
  const Surfaces surfaces(solid.body, Cells(solid.body));
  const UniformAreas uniform(solid.body, surfaces);
  const auto k = admissible_strains(solid.body, surfaces, uniform);
  const Matrix6 stiffness = isotropic_stiffness(0.25), compliance = isotropic_compliance(0.25);
  const Matrix6 seen = product(stiffness, product(k[solid.at(block, 8, 4, 4)], stiffness));
  for (const int traction :
       {0, 4, 5})    // xx, xz, xy of the stress states; the normal is told by 400 rays
    EXPECT_NEAR(seen[traction][traction], 0.0, 1e-3);
  const Matrix6 &middle = k[solid.at(block, 4, 4, 4)];
  for (int i = 0; i < 6; i++)
    for (int j = 0; j < 6; j++) EXPECT_NEAR(middle[i][j], compliance[i][j], 1e-12);
}

// along an edge: tension, and the shear that torsion causes there, which turns around the edge and vanishes on it
TEST(Admissible, AnEdgeCarriesTensionAndTorsion)
{
  const Block block = {9, 9, 9, false, 1.0, 2.0};
  Solid solid(block);
  solid.body.volume.assign(solid.body.nall, 1.0);
  const Surfaces surfaces(solid.body, Cells(solid.body));
  const auto k = admissible_strains(solid.body, surfaces, UniformAreas(solid.body, surfaces));
  const Matrix6 stiffness = isotropic_stiffness(0.25);
  const Matrix6 seen = product(stiffness, product(k[solid.at(block, 4, 8, 8)], stiffness));
  const auto share = [&](const Vector6 &stress) {
    return dot(product(seen, stress), stress) / dot(product(stiffness, stress), stress);
  };
  const double root = std::sqrt(0.5);
  // xx; x with the direction around the edge; x with the one out of it; yy
  EXPECT_NEAR(seen[0][0], 1.0, 1e-3);
  EXPECT_GT(share({0.0, 0.0, 0.0, 0.0, root, -root}), 0.99);
  EXPECT_LT(share({0.0, 0.0, 0.0, 0.0, root, root}), 0.01);
  EXPECT_NEAR(seen[1][1], 0.0, 1e-3);
}

// of a solid of modulus E: lambda + 2 G and G, over the modulus 5/2 G of its bonds
TEST(Elasticity, IsThatOfTheSolid)
{
  for (const double nu : {0.0, 0.1, 0.25, 0.42}) {
    const Elasticity elasticity{nu};
    const Matrix6 c = elasticity.stiffness();
    const double shear = 0.5 / (1.0 + nu), lame = nu / ((1.0 + nu) * (1.0 - 2.0 * nu));
    EXPECT_NEAR(elasticity.bonds_modulus(), 2.5 * shear, 1e-15);
    EXPECT_NEAR(c[0][0] * elasticity.bonds_modulus(), lame + 2.0 * shear, 1e-14);
    EXPECT_NEAR(c[0][1] * elasticity.bonds_modulus(), lame, 1e-14);
    EXPECT_NEAR(c[3][3] * elasticity.bonds_modulus(), 2.0 * shear, 1e-14);    // Mandel
    const Matrix6 one = product(c, elasticity.compliance());
    for (int i = 0; i < 6; i++)
      for (int j = 0; j < 6; j++) EXPECT_NEAR(one[i][j], i == j, 1e-13);
    EXPECT_EQ(elasticity.has_volume_term(), nu != 0.25);
  }
}

// the trace of every uniform strain inside, of the strains without traction on a face; no net force inside
TEST(Dilatation, IsTheTraceOfAdmissibleStrains)
{
  const Block block = {9, 9, 9, false, 1.0, 2.0};
  Solid solid(block);
  BondedBody &body = solid.body;
  body.volume.assign(body.nall, 1.0);
  body.elasticity.poisson = 0.1;
  const Surfaces surfaces(body, Cells(body));
  const UniformAreas uniform(body, surfaces);
  const Dilatation dilatation(body, uniform.area, admissible_strains(body, surfaces, uniform));
  const auto theta = [&](int i, const Vector6 &strain) {
    double sum = 0.0;
    for (const auto &to : body.neighbours(i)) {
      const auto &n = body.bonds[to.bond].n;
      sum += dilatation.weight(to.bond, to.sign > 0.0 ? 0 : 1) * dot(mandel(n, n), strain);
    }
    return sum;
  };
  const Vector6 any = {0.7, -0.3, 0.5, 0.2, -0.6, 0.4};
  const int middle = solid.at(block, 4, 4, 4), face = solid.at(block, 8, 4, 4);
  EXPECT_NEAR(theta(middle, any), 0.9, 1e-4);    // EXACT_WEIGHT
  const Vector6 pulled = {-0.1, 1.0, -0.1, 0.0, 0.0, 0.0};
  EXPECT_NEAR(theta(face, pulled), 0.8, 1e-3);    // the normal is told by 400 rays
  const auto pushes = dilatation.pushes();
  for (const double force : pushes[middle])
    EXPECT_NEAR(force, 0.0, 1e-7);     // the rays of its neighbours
  EXPECT_LT(pushes[face][0], -0.1);    // tension in its bonds pulls a face inwards
}

// kappa < 0: the weights are such that the volume does not take back the energy of the bonds
TEST(Dilatation, TakesBackAShareOnly)
{
  BodyHalo alone;
  BondedBody body = star(alone, shell({{1.0, 0.0, 0.0}, {0.9, 0.3, 0.2}}));
  body.volume.assign(body.nall, 5.0);    // bonds too weak for so much
  body.elasticity.poisson = 0.0;
  const std::vector<double> area(body.bonds.size(), 0.5);
  const Dilatation dilatation(body, area,
                              std::vector<Matrix6>(body.nowned, body.elasticity.compliance()));
  double share = 0.0;
  for (std::size_t b = 0; b < body.bonds.size(); b++) {
    const double c = dilatation.weight(b, 0);
    share += 0.4 * c * c * 2.0 * 5.0 / (0.5 * body.bonds[b].length);    // kappa/E' = -0.4
  }
  EXPECT_NEAR(share, areas::LARGEST_SHARE, 1e-12);
}

// the slope is that of the square, by differences
TEST(Misfit, SlopeIsTheDerivativeOfTheSquare)
{
  const double volume = 0.7, h = 1e-6;
  const Matrix6 k = isotropic_compliance(0.25), target = isotropic_stiffness(0.25);
  Moments m;
  for (int c = 0; c < MOMENTS; c++) m[c] = std::sin(1.0 + c);
  const Moments slope = Misfit(m, volume, &target).slope(k, volume);
  for (int c = 0; c < MOMENTS; c++) {
    Moments up = m, down = m;
    up[c] += h;
    down[c] -= h;
    const double difference =
        Misfit(up, volume, &target).square(k) - Misfit(down, volume, &target).square(k);
    EXPECT_NEAR(slope[c], 0.5 * difference / (2.0 * h), 1e-7 * std::fabs(slope[c]) + 1e-8);
  }
}

// simple cubic, bonds 1 (section a) and sqrt 2 (section b): C1111 = a + sqrt 2 b, C1122 = b/sqrt 2 are 6/5 and 2/5
TEST(LeastSquares, FindsTheIsotropicCrystal)
{
  Solid solid({6, 6, 6, true, 1.0, std::sqrt(2.0)});
  BondedBody &body = solid.body;
  body.volume.assign(body.nall, 1.0);
  const Surfaces surfaces(body, Cells(body));
  const UniformAreas uniform(body, surfaces);
  const auto admissible = admissible_strains(body, surfaces, uniform);
  LeastSquares squares(body, uniform.area, admissible);
  const std::vector<Matrix6> target(body.nowned, isotropic_stiffness(0.25));
  squares.iterate(100, target);
  EXPECT_EQ(squares.iterations(), 100);
  for (std::size_t b = 0; b < body.bonds.size(); b++)    // the pull has the weight 0.02^2
    EXPECT_NEAR(squares.area(b), body.bonds[b].length < 1.2 ? 0.4 : 0.4 * std::sqrt(2.0), 1e-3);
  for (const auto &misfit : squares.misfits(&target)) EXPECT_LT(misfit.square(admissible[0]), 1e-5);
}

// a sum over all particles of the weights is nothing; inside they cancel; a layer is left along the faces
TEST(SurfaceLayer, AddsUpToNothing)
{
  const Block block = {11, 11, 11, false, 1.0, 2.0};
  Solid solid(block);
  solid.body.volume.assign(solid.body.nall, 1.0);
  const Surfaces surfaces(solid.body, Cells(solid.body));
  const auto layer = surface_layer(solid.body, surfaces);
  Vector6 sum{};
  for (const auto &at : layer)
    for (int c = 0; c < 6; c++) sum[c] += at[c];
  for (int c = 0; c < 6; c++) {
    EXPECT_NEAR(sum[c], 0.0, 1e-9);
    EXPECT_NEAR(layer[solid.at(block, 5, 5, 5)][c], 0.0, 1e-12);
  }
  EXPECT_GT(layer[solid.at(block, 10, 5, 5)][0], 0.1);
}

// sum over cells of the second derivative of a quadratic field, from its values: of g = x^2 it is V for every particle that
// has found its stencil
TEST(SurfaceLayer, DifferentiatesAQuadraticField)
{
  const Block block = {9, 9, 9, false, 1.0, 2.0};
  Solid solid(block);
  solid.body.volume.assign(solid.body.nall, 1.0);
  const Surfaces surfaces(solid.body, Cells(solid.body));
  const auto layer = surface_layer(solid.body, surfaces);
  double xx = 0.0, yy = 0.0;
  for (int i = 0; i < solid.body.nall; i++) {
    const double x = i % block.nx;
    xx += layer[i][0] * x * x;
    yy += layer[i][1] * x * x;
  }
  EXPECT_NEAR(xx / 729.0, 1.0, 0.05);    // the ridge, and four rounds of handing over
  EXPECT_NEAR(yy / 729.0, 0.0, 0.05);
}

// bonds along the axes only leave shear without resistance
TEST(Targets, AMechanismIsKnownByItsMoments)
{
  for (const double reach : {1.0, 2.0}) {
    Solid solid({6, 6, 6, true, 1.0, reach});
    BondedBody &body = solid.body;
    body.volume.assign(body.nall, 1.0);
    const Surfaces surfaces(body, Cells(body));
    const UniformAreas uniform(body, surfaces);
    const auto admissible = admissible_strains(body, surfaces, uniform);
    const LeastSquares squares(body, uniform.area, admissible);
    const BulkMoments bulk(body, surfaces, squares, 2);
    EXPECT_EQ(bulk.stiff, reach > 1.0);
    Targets targets(body, surfaces);
    EXPECT_EQ(targets.correct(squares, admissible), reach > 1.0);
    // without surfaces the target is the solid's stiffness
    const Matrix6 stiffness = isotropic_stiffness(0.25);
    for (int a = 0; a < 6; a++)
      for (int b = 0; b < 6; b++) EXPECT_NEAR(targets.wanted()[0][a][b], stiffness[a][b], 1e-12);
  }
}

}    // namespace
