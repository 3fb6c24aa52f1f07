/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "core/geometry/triangle_mesh.h"

#include "gtest/gtest.h"

#include <algorithm>
#include <cmath>
#include <random>

using namespace POTDEM;

static constexpr double PI = 3.14159265358979323846;

typedef std::vector<Vector3> Corners;
typedef std::vector<TriangleMesh::Contact> Contacts;

static std::mt19937 random_bits(5);

static double uniform(double lo, double hi)
{
  return std::uniform_real_distribution<double>(lo, hi)(random_bits);
}

static Vector3 random_place(double lo, double hi)
{
  return {uniform(lo, hi), uniform(lo, hi), uniform(lo, hi)};
}

// a rectangle of n x n cells of two triangles, from a corner along two sides; its normal is their cross product
static void add_rectangle(Corners &out, const Vector3 &corner, const Vector3 &a, const Vector3 &b,
                          int n)
{
  const auto at = [&](int i, int j) {
    return add_scaled(add_scaled(corner, i / static_cast<double>(n), a), j / static_cast<double>(n),
                      b);
  };
  for (int i = 0; i < n; i++)
    for (int j = 0; j < n; j++) {
      const bool other = (i + j) % 2;
      const Vector3 p = at(i, j), q = at(i + 1, j), r = at(i + 1, j + 1), s = at(i, j + 1);
      for (const auto &v : other ? Corners{p, q, s, q, r, s} : Corners{p, q, r, p, r, s})
        out.push_back(v);
    }
}

// from 0 to 1 in each direction
static Corners cube(int n)
{
  Corners out;
  const Vector3 o{}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  add_rectangle(out, o, y, x, n);
  add_rectangle(out, z, x, y, n);
  add_rectangle(out, o, z, y, n);
  add_rectangle(out, x, y, z, n);
  add_rectangle(out, o, x, z, n);
  add_rectangle(out, y, z, x, n);
  return out;
}

// two half planes that meet along y, each raised by an angle; seen from above
static Corners valley(double angle)
{
  Corners out;
  const double c = 5 * std::cos(angle), s = 5 * std::sin(angle);
  add_rectangle(out, {0, -5, 0}, {c, 0, s}, {0, 10, 0}, 7);
  add_rectangle(out, {-c, -5, s}, {c, 0, -s}, {0, 10, 0}, 7);
  return out;
}

static Contacts contacts(const TriangleMesh &mesh, const Vector3 &x, double reach)
{
  Contacts out;
  mesh.contacts(x, reach, out);
  return out;
}

// the distance by its definition, over places of the triangle on a fine grid: nothing is nearer than what was found, and the
// nearest of them is so by less than their spacing
TEST(Triangle, NearestPlaceIsNearest)
{
  constexpr int FINE = 60;
  int on[3] = {0, 0, 0};
  for (int sample = 0; sample < 500; sample++) {
    const Vector3 a = random_place(-1, 1), b = random_place(-1, 1), c = random_place(-1, 1),
                 x = random_place(-2, 2);
    const auto found = nearest_place(x, a, b, c);
    const Vector3 del = found.place - x;
    double least = HUGE_VAL, longest = 0.0;
    for (const Vector3 &side : {b - a, c - b, a - c})
      longest = std::max(longest, std::sqrt(dot(side, side)));
    for (int i = 0; i <= FINE; i++)
      for (int j = 0; i + j <= FINE; j++) {
        const Vector3 p = add_scaled(add_scaled(a, i / 1.0 / FINE, b - a), j / 1.0 / FINE, c - a);
        least = std::min(least, dot(p - x, p - x));
      }
    EXPECT_LE(std::sqrt(dot(del, del)), std::sqrt(least) + 1e-12);
    EXPECT_GE(std::sqrt(dot(del, del)), std::sqrt(least) - longest / FINE);
    on[found.on]++;
  }
  for (const int count : on) EXPECT_GT(count, 20);
}

TEST(TriangleTree, FindsWhatALoopOverAllFinds)
{
  Corners soup;
  for (int k = 0; k < 3000; k++) {
    const Vector3 middle = random_place(0, 10);
    for (int c = 0; c < 3; c++) soup.push_back(add_scaled(middle, 0.2, random_place(-1, 1)));
  }
  std::vector<Box> boxes;
  for (std::size_t k = 0; k < soup.size(); k += 3) {
    boxes.push_back({soup[k], soup[k]});
    for (int c = 1; c < 3; c++) boxes.back().include({soup[k + c], soup[k + c]});
  }
  TriangleTree tree;
  tree.build(boxes);
  for (int sample = 0; sample < 100; sample++) {
    const Vector3 x = random_place(-1, 11);
    std::vector<int> found, right;
    int asked = 0;
    tree.search(x, 1.0, [&](int t, double &) {
      asked++;
      if (boxes[t].distance2(x) <= 1.0) found.push_back(t);
    });
    for (int t = 0; t < 3000; t++)
      if (boxes[t].distance2(x) <= 1.0) right.push_back(t);
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, right);
    EXPECT_LT(asked, 300);
  }
}

TEST(TriangleMesh, ClosedAndItsVolume)
{
  for (const int n : {1, 4}) {
    const TriangleMesh mesh(cube(n));
    EXPECT_EQ(mesh.size(), 12 * n * n);
    EXPECT_TRUE(mesh.is_closed());
    EXPECT_NEAR(mesh.volume(), 1.0, 1e-14);
  }
  auto inside_out = cube(3);
  for (std::size_t k = 0; k < inside_out.size(); k += 3)
    std::swap(inside_out[k], inside_out[k + 1]);
  EXPECT_NEAR(TriangleMesh(inside_out).volume(), 1.0, 1e-14);
  EXPECT_TRUE(TriangleMesh(inside_out).is_inside({0.5, 0.5, 0.5}));
}

TEST(TriangleMesh, HolesAndTurnedTrianglesAreTold)
{
  auto with_hole = cube(2);
  with_hole.resize(with_hole.size() - 3);
  EXPECT_EQ(TriangleMesh(with_hole).open_edges(), 3);
  auto turned = cube(2);
  std::swap(turned[0], turned[1]);
  EXPECT_EQ(TriangleMesh(turned).open_edges(), 6);
  auto with_needle = cube(2);
  with_needle.insert(with_needle.end(), {{0, 0, 0}, {1, 0, 0}, {0.5, 0, 0}});
  EXPECT_TRUE(TriangleMesh(with_needle).is_closed());
  EXPECT_EQ(TriangleMesh(with_needle).left_out(), 1);
}

TEST(TriangleMesh, InsideOfACube)
{
  const TriangleMesh mesh(cube(3));
  int inside = 0;
  for (int sample = 0; sample < 5000; sample++) {
    const Vector3 x = random_place(-0.3, 1.3);
    const bool right = std::all_of(x.begin(), x.end(), [](double k) {
      return k > 0.0 && k < 1.0;
    });
    EXPECT_EQ(mesh.is_inside(x), right);
    inside += right;
  }
  EXPECT_GT(inside, 500);
}

// a cube with a cube cut out of its corner: places near the edges that point inwards, too
TEST(TriangleMesh, InsideOfANotch)
{
  Corners notch;
  const auto rectangle = [&notch](Vector3 o, Vector3 a, Vector3 b) {
    add_rectangle(notch, o, a, b, 1);
  };
  const Vector3 X{1, 0, 0}, Y{0, 1, 0}, Z{0, 0, 1};
  for (int k = 0; k < 2; k++)
    for (int j = 0; j < 2; j++)
      for (int i = 0; i < 2; i++) {
        const auto full = [](int a, int b, int c) {
          return a >= 0 && a < 2 && b >= 0 && b < 2 && c >= 0 && c < 2 && a + b + c < 3;
        };
        if (!full(i, j, k)) continue;
        const double x = i, y = j, z = k;
        if (!full(i - 1, j, k)) rectangle({x, y, z}, Z, Y);
        if (!full(i + 1, j, k)) rectangle({x + 1, y, z}, Y, Z);
        if (!full(i, j - 1, k)) rectangle({x, y, z}, X, Z);
        if (!full(i, j + 1, k)) rectangle({x, y + 1, z}, Z, X);
        if (!full(i, j, k - 1)) rectangle({x, y, z}, Y, X);
        if (!full(i, j, k + 1)) rectangle({x, y, z + 1}, X, Y);
      }
  const TriangleMesh mesh(notch);
  ASSERT_TRUE(mesh.is_closed());
  EXPECT_NEAR(mesh.volume(), 7.0, 1e-13);
  for (int sample = 0; sample < 5000; sample++) {
    const Vector3 x = random_place(-0.5, 2.5);
    bool in = true, cut = true;
    for (const double k : x) {
      in = in && k > 0.0 && k < 2.0;
      cut = cut && k > 1.0;
    }
    EXPECT_EQ(mesh.is_inside(x), in && !cut);
  }
}

// however fine the triangles are
TEST(TriangleMesh, OneContactForAFaceAnEdgeAndACornerSeenFromOutside)
{
  for (const int n : {1, 2, 9}) {
    const TriangleMesh mesh(cube(n));
    for (int sample = 0; sample < 300; sample++) {
      const Vector3 x = random_place(-0.6, 1.6);
      double r2 = 0.0;
      for (const double k : x) {
        const double beyond = std::max(0.0, std::max(-k, k - 1.0));
        r2 += beyond * beyond;
      }
      const double r = std::sqrt(r2);
      if (r == 0.0 || r >= 0.5) continue;
      const auto found = contacts(mesh, x, 0.5);
      ASSERT_EQ(found.size(), 1U);
      EXPECT_NEAR(found[0].r, r, 1e-14);
    }
  }
}

TEST(TriangleMesh, AContactForEachFaceSeenFromInside)
{
  for (const int n : {1, 2, 9}) {
    const TriangleMesh mesh(cube(n));
    for (int sample = 0; sample < 300; sample++) {
      const Vector3 x = random_place(0.01, 0.99);
      std::vector<double> right;
      for (const double k : x)
        for (const double r : {k, 1.0 - k})
          if (r < 0.3) right.push_back(r);
      std::sort(right.begin(), right.end());
      const auto found = contacts(mesh, x, 0.3);
      ASSERT_EQ(found.size(), right.size());
      for (std::size_t k = 0; k < right.size(); k++) EXPECT_NEAR(found[k].r, right[k], 1e-14);
    }
  }
}

// the sides of a groove are two surfaces, those of a facet's edge one
TEST(TriangleMesh, GroovesAndFacets)
{
  const double degree = PI / 180.0;
  for (const double angle : {1.0, 5.0, 14.0}) {
    const TriangleMesh mesh(valley(angle * degree));
    EXPECT_EQ(contacts(mesh, {0.01, 0.2, 1.0}, 1.2).size(), 1U);
  }
  for (const double angle : {16.0, 30.0, 60.0}) {
    const double c = std::cos(angle * degree), s = std::sin(angle * degree);
    const TriangleMesh mesh(valley(angle * degree));
    const auto found = contacts(mesh, {0.01, 0.2, 1.0}, 1.2);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_NEAR(found[0].r, c - 0.01 * s, 1e-14);
    EXPECT_NEAR(found[1].r, c + 0.01 * s, 1e-14);
  }
  const TriangleMesh ridge(valley(-40.0 * degree));
  EXPECT_EQ(contacts(ridge, {0.3, 0.2, 0.5}, 1.2).size(), 1U);
}

// The energy of a sphere that overlaps by 3 % of its radius at most does not jump anywhere: its change over a way h is at most
// the force times h
TEST(TriangleMesh, EnergyIsContinuous)
{
  const double degree = PI / 180.0, h = 1e-4;
  for (const double angle : {-50.0, -20.0, 5.0, 14.0, 20.0, 45.0}) {
    const TriangleMesh mesh(valley(angle * degree));
    const auto energy = [&](const Vector3 &x) {
      double sum = 0.0;
      for (const auto &contact : contacts(mesh, x, 1.0))
        sum += 0.5 * (1.0 - contact.r) * (1.0 - contact.r);
      return sum;
    };
    for (int way = 0; way < 5; way++) {
      const double height = uniform(0.97, 1.0), skew = uniform(-1.0, 1.0);
      double before = -1.0, touched = 0.0;
      for (double x = -0.5; x < 0.5; x += h) {
        const double along = std::fabs(x) * std::tan(angle * degree);
        const double z = height / (angle > 0.0 ? std::cos(angle * degree) : 1.0) + along;
        const double now = energy({x, skew * x, z});
        const double most = 2 * std::sqrt(2 * std::max(now, before)) * 2 * h + 4 * h * h;
        if (before >= 0.0) { EXPECT_LE(std::fabs(now - before), most) << angle << " " << x; }
        before = now;
        touched += now;
      }
      EXPECT_GT(touched, 0.0);
    }
  }
}
