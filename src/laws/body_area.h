/* One area per bond of a body of any packing and shape (`area body`), such that the network is an
   isotropic solid of modulus E (Poisson's ratio 1/4, the only one of central forces) up to its free surfaces.

   Bonds A, L, n; m = n (x) n; particle i of volume V_i. In the strain eps the bond pulls with A E m:eps.
   A stress state sigma is admissible at a particle on a free surface if its traction there vanishes. The
   strains of the admissible states, orthonormal in energy, make the tensor K_i = sum eps (x) eps (inside the
   body: all states, and K_i is the compliance). Two conditions for every particle:

     energy   sum_j A L m (x) m / 2 = V_i T_i        seen through K_i
     balance  sum_j A m (x) n       = 0              seen through K_i

   The energy decides the stiffness to first order, the imbalance to second (what the body gains by giving
   way). T_i is the stiffness tensor C of the solid, corrected near surfaces: particles carry the energy of a
   field at their centres and bonds at their middles, the solid carries it everywhere. With the variances
   of cells and bonds (sixth moment of the bulk) this misses one half of (variance):(second derivative) of
   the energy density in all cells; summed over the body only a layer along the surface is left, which T_i
   puts back by discrete second derivatives. Without it a beam of n particles through the depth is soft in
   bending by about 1.8/n^2.

   V_i is the volume of the particle's own cell, which ends at a surface at the tangent planes of the faces: the
   second moment of the volumes, and with it bending, is then that of the body for random packings too.

   Minimised: sum_i energy misfit^2 + imbalance^2 + pull^2 sum (A/A0 - 1)^2, A0 = a d^2 with one a,
   within bounds LEAST A0 <= A <= MOST A0, by accelerated projected gradients (FISTA) with restarts. Then twice again, with what
   the energy still lacks added to T_i.

   Nothing here knows of LAMMPS. A rank owns the first `nowned` particles, the others are copies; each rank holds all bonds of
   its own particles. */

#ifndef POTDEM_BODY_AREA_H
#define POTDEM_BODY_AREA_H

#include "mandel.h"

#include <cstdint>
#include <vector>

namespace POTDEM {

// exchange of per-particle values between ranks; by itself: one rank, no copies
struct BodyHalo {
  virtual ~BodyHalo() = default;
  virtual void forward(double *, int) {}    // copies take the owner's values; width per particle
  virtual void reverse(double *, int) {}    // owners add the copies' values
  virtual void sum(double *, int) {}        // over ranks
};

class BodyArea {
 public:
  struct Bond {
    int low, high;    // ends, the one with the lower ID first
    double n[3];      // from low to high
    double length;    // at rest
    bool counted;     // by exactly one rank
    double area;      // the answer
  };

  static constexpr int WIDEST = 37;    // values per particle that the halo carries at a time

  enum Outcome { DONE, NO_INSIDE, MECHANISM };
  struct Report {
    int iterations;
    double misfit;           // root mean square over the inner particles, energy and balance
    double least, most;      // area over A0
    double volume, start;    // of all particles; a in A0 = a d^2
  };

  std::vector<Bond> bonds;
  int nowned, nall;
  std::vector<double> diameter,
      volume;    // of nall particles, their sum counts; no volumes: from the inner particles' cells
  std::vector<std::int64_t> id;
  Report report;

  explicit BodyArea(BodyHalo &halo) :
      nowned(0), nall(0), report{}, halo(halo), largest_diameter(0.0)
  {
  }
  Outcome solve();

 private:
  static constexpr double POISSON = 0.25;
  static constexpr double LEAST = 0.1, MOST = 4.0, PULL = 0.02;
  static constexpr int FIRST_ITERATIONS = 20, ITERATIONS = 20, ROUNDS = 3;

  struct Half {
    int bond, other;
    double sign;
  };
  struct State {
    double trust;
    Vector6 stress;
  };
  struct Stencil {
    std::array<Vector3, 6> slope;      // takes the first derivatives out of dx dx
    Matrix6 matrix, factor, wanted;    // wanted: one row for each component that is asked for
  };

  BodyHalo &halo;
  double largest_diameter;
  std::vector<int> first;    // half bonds of each owned particle
  std::vector<Half> halves;
  std::vector<double> open;    // share of the directions that meet no neighbour, of all particles
  std::vector<double>
      normal;    // outward, of the particles on a face, three for each of all particles; else 0
  std::vector<Matrix3> blocked;
  std::vector<Matrix6> admissible, target;
  std::vector<double> moments;    // third and fourth, of all particles
  std::vector<double> x, start, step;

  bool inside(int i) const { return open[i] == 0.0 && first[i] < first[i + 1]; }
  void list_halves();

  double diameter_scale();
  double reach(int i, const Vector3 &direction, double scale, double enough) const;
  void find_surfaces(double scale);
  bool find_volumes(double scale);
  double count_inside() const;
  double cell(int i, double scale, int rays) const;
  Vector3 cell_at_surface(int i, double scale, int rays) const;
  bool find_start();

  std::vector<double> surfaces_nearby();
  void find_admissible();
  int free_axes(int i, const double *nearby, Vector3 &bonded, Matrix3 &axis) const;
  static Matrix6 energy_norm(std::vector<State> &);

  void accumulate(const std::vector<double> &z);
  void gather(const std::vector<double> &z, bool with_target);
  void residual(int i, bool with_target, Matrix6 &energy, double (*force)[3]) const;
  void pull_back(int i, bool with_target);
  double slope(int b) const;
  void find_step();
  double curvature(int b, const double *k, double v) const;
  double largest_eigenvalue(int i);
  void iterate(int n);
  void add_missing_energy(const std::vector<Matrix6> &wanted);

  bool bulk_moments(std::array<Matrix6, 6> &sixth, int ends_inside);
  std::vector<double> surface_layer();
  Vector3 separation(const Half &) const;
  double closeness(int i, const Half &) const;
  Stencil second_derivative(int i) const;
  void apply(int i, Stencil &, std::vector<double> &layer) const;
  void hand_over(int i, Matrix6 &wanted, std::vector<double> &handed) const;
  void correct_target(const std::array<Matrix6, 6> &sixth);
  static Matrix6 layer_energy(const Vector6 &layer, double cell,
                              const std::array<Matrix6, 6> &sixth);
  void judge();
};

/* ---------------------------------------------------------------------- */

static constexpr int SURFACE_RAYS = 400;
static constexpr double GOLDEN_ANGLE = 2.39996322972865332;

// directions spread evenly over the sphere along a spiral
inline Vector3 spiral_direction(int k, int n)
{
  const double z = 1.0 - (2.0 * k + 1.0) / n, s = std::sqrt(1.0 - z * z);
  return {s * std::cos(GOLDEN_ANGLE * k), s * std::sin(GOLDEN_ANGLE * k), z};
}

inline BodyArea::Outcome BodyArea::solve()
{
  list_halves();
  const double scale = diameter_scale();
  find_surfaces(scale);
  if (!find_volumes(scale) || !find_start()) return NO_INSIDE;
  find_admissible();
  target.assign(nowned, isotropic_stiffness(POISSON));
  x.assign(bonds.size(), 1.0);
  find_step();
  iterate(FIRST_ITERATIONS);
  std::array<Matrix6, 6> sixth{};
  // three particles through the depth: no bond has both ends inside
  if (!bulk_moments(sixth, 2) && !bulk_moments(sixth, 1)) return MECHANISM;
  correct_target(sixth);
  const auto wanted = target;
  for (int round = 0; round < ROUNDS; round++) {
    if (round > 0) add_missing_energy(wanted);
    iterate(ITERATIONS);
  }
  target = wanted;
  judge();
  for (std::size_t b = 0; b < bonds.size(); b++) bonds[b].area = x[b] * start[b];
  return DONE;
}

inline void BodyArea::list_halves()
{
  first.assign(nowned + 1, 0);
  for (const auto &bond : bonds)
    for (const int i : {bond.low, bond.high})
      if (i < nowned) first[i + 1]++;
  for (int i = 0; i < nowned; i++) first[i + 1] += first[i];
  halves.resize(first[nowned]);
  std::vector<int> at(first.begin(), first.end() - 1);
  for (std::size_t b = 0; b < bonds.size(); b++) {
    const auto &bond = bonds[b];
    if (bond.low < nowned) halves[at[bond.low]++] = {static_cast<int>(b), bond.high, 1.0};
    if (bond.high < nowned) halves[at[bond.high]++] = {static_cast<int>(b), bond.low, -1.0};
  }
  // the nearest first: they end most rays
  for (int i = 0; i < nowned; i++)
    std::sort(halves.begin() + first[i], halves.begin() + first[i + 1],
              [this](const Half &a, const Half &b) {
                return bonds[a.bond].length != bonds[b.bond].length
                    ? bonds[a.bond].length < bonds[b.bond].length
                    : id[a.other] < id[b.other];
              });
}

/* ----------------------------------------------------------------------
   spacing over diameter: mean of the third shortest bond of each particle (a corner has three close
   neighbours), so that only the ratios of the diameters matter
------------------------------------------------------------------------- */

inline double BodyArea::diameter_scale()
{
  largest_diameter = diameter.empty() ? 0.0 : *std::max_element(diameter.begin(), diameter.end());
  double total[2] = {0.0, 0.0};
  for (int i = 0; i < nowned; i++) {
    if (first[i + 1] - first[i] < 3) continue;
    const Half &third = halves[first[i] + 2];
    total[0] += 2.0 * bonds[third.bond].length / (diameter[i] + diameter[third.other]);
    total[1] += 1.0;
  }
  halo.sum(total, 2);
  return total[1] > 0.0 ? total[0] / total[1] : 1.0;
}

// how far a ray from particle i stays in its cell (radical planes between neighbours); stops below `enough`
inline double BodyArea::reach(int i, const Vector3 &direction, double scale, double enough) const
{
  const double di = scale * diameter[i], largest = scale * largest_diameter;
  double farthest = HUGE_VAL;
  for (int h = first[i]; h < first[i + 1] && farthest >= enough; h++) {
    const Bond &bond = bonds[halves[h].bond];
    auto plane = [&bond, di](double d) {
      return 0.5 * bond.length + 0.125 * (di * di - d * d) / bond.length;
    };
    if (plane(largest) > farthest) break;
    const double along = halves[h].sign *
        (direction[0] * bond.n[0] + direction[1] * bond.n[1] + direction[2] * bond.n[2]);
    if (along > 0.0)
      farthest =
          std::min(farthest, std::max(plane(scale * diameter[halves[h].other]), 0.0) / along);
  }
  return farthest;
}

/* ----------------------------------------------------------------------
   a free surface is where the rays go beyond one diameter; the directions in which their second moment is large are
   blocked: no traction there. One of them, and the rays go to one side of it: the particle is on a face
------------------------------------------------------------------------- */

inline void BodyArea::find_surfaces(double scale)
{
  static constexpr double SHARE =
      0.2;    // of the trace: face below 0.12, edge and corner above 0.29
  static constexpr double ONE_SIDE =
      0.5;    // of the rays' length along the normal is left of their sum
  open.assign(nall, 0.0);
  normal.assign(3 * static_cast<std::size_t>(nall), 0.0);
  blocked.assign(nowned, Matrix3{});
  std::vector<Vector3> rays(SURFACE_RAYS);
  for (int k = 0; k < SURFACE_RAYS; k++) rays[k] = spiral_direction(k, SURFACE_RAYS);
  for (int i = 0; i < nowned; i++) {
    const double gap = scale * diameter[i];
    Matrix3 second{};
    Vector3 sum{};
    int count = 0;
    for (const auto &ray : rays)
      if (reach(i, ray, scale, gap) > gap) {
        add_dyad(second, 1.0 / SURFACE_RAYS, ray, ray);
        for (int k = 0; k < 3; k++) sum[k] += ray[k];
        count++;
      }
    if (count < 2) continue;    // a pore
    open[i] = static_cast<double>(count) / SURFACE_RAYS;
    Vector3 value;
    Matrix3 axis;
    eigen3(second, value, axis);
    for (int k = 0; k < 3; k++)
      if (value[k] > SHARE * open[i]) add_dyad(blocked[i], 1.0, axis[k], axis[k]);
    const double outward = dot(sum, axis[2]);
    if (value[1] > SHARE * open[i] || std::fabs(outward) < ONE_SIDE * count) continue;
    for (int k = 0; k < 3; k++)
      normal[3 * static_cast<std::size_t>(i) + k] = outward > 0.0 ? axis[2][k] : -axis[2][k];
  }
  halo.forward(open.data(), 1);
  halo.forward(normal.data(), 3);
}

/* ----------------------------------------------------------------------
   Each particle has the volume of its own cell. At a surface the cell ends at the planes of the faces nearby, which are
   lambda times the radius outside the faces' particles. lambda is such that the volumes given add up; without any, such
   that all together have c d^3, c the mean of the closed cells. Where no lambda does that, V is as given, or c d^3. Few cells
   need many rays.
------------------------------------------------------------------------- */

inline bool BodyArea::find_volumes(double scale)
{
  static constexpr double RAYS = 2e7, LEAST_LAMBDA = 0.5, MOST_LAMBDA = 1.2;
  const double count = count_inside();
  if (count == 0.0) return false;
  const int rays = static_cast<int>(std::clamp(RAYS / count, 400.0, 2000.0));
  std::vector<double> cells(nall, 0.0);
  std::vector<Vector3> ends(nowned, Vector3{});
  // closed cells: volume, d^3; open ones: c0, c1, c2; all: d^3, given
  double total[7] = {};
  for (int i = 0; i < nowned; i++) {
    if (first[i] == first[i + 1]) continue;
    const double cube = diameter[i] * diameter[i] * diameter[i];
    if (inside(i)) {
      total[0] += cells[i] = cell(i, scale, rays);
      total[1] += cube;
    } else {
      ends[i] = cell_at_surface(i, scale, rays);
      for (int k = 0; k < 3; k++) total[2 + k] += ends[i][k];
    }
    total[5] += cube;
    if (!volume.empty()) total[6] += volume[i];
  }
  halo.sum(total, 7);
  const double per_cube = total[0] / total[1];
  if (volume.empty()) {
    for (const double d : diameter) volume.push_back(per_cube * d * d * d);
    total[6] = per_cube * total[5];
  }
  auto missing = [&total](double lambda) {
    return total[6] - total[0] - total[2] - lambda * (total[3] + lambda * total[4]);
  };
  double low = LEAST_LAMBDA, high = MOST_LAMBDA;
  if (missing(low) < 0.0 || missing(high) > 0.0) return true;
  while (high - low > 1e-15) (missing(0.5 * (low + high)) > 0.0 ? low : high) = 0.5 * (low + high);
  for (int i = 0; i < nowned; i++)
    if (first[i] < first[i + 1])
      volume[i] = cells[i] + ends[i][0] + low * (ends[i][1] + low * ends[i][2]);
  halo.forward(volume.data(), 1);
  return true;
}

inline double BodyArea::count_inside() const
{
  double count = 0.0;
  for (int i = 0; i < nowned; i++) count += inside(i);
  halo.sum(&count, 1);
  return count;
}

inline double BodyArea::cell(int i, double scale, int rays) const
{
  double cubes = 0.0;
  for (int k = 0; k < rays; k++) {
    const double r = reach(i, spiral_direction(k, rays), scale, 0.0);
    cubes += r * r * r;
  }
  return 4.0 * M_PI / 3.0 * cubes / rays;
}

// coefficients of the volume as a polynomial in lambda. A ray ends at the latest where `open` begins
inline Vector3 BodyArea::cell_at_surface(int i, double scale, int rays) const
{
  static constexpr double LAMBDA[3] = {0.6, 0.8, 1.0};
  struct Plane {
    Vector3 normal;
    double height, radius;    // of the particle that it touches
  };
  std::vector<Plane> planes;
  auto add = [this, scale, &planes](int j, const Vector3 &dx) {
    const double *n = &normal[3 * static_cast<std::size_t>(j)];
    const Plane plane = {
        {n[0], n[1], n[2]}, n[0] * dx[0] + n[1] * dx[1] + n[2] * dx[2], 0.5 * scale * diameter[j]};
    if (dot(plane.normal, plane.normal) > 0.0) planes.push_back(plane);
  };
  add(i, {});
  for (int h = first[i]; h < first[i + 1]; h++) add(halves[h].other, separation(halves[h]));

  const double radius = 0.5 * scale * diameter[i];
  Vector3 cubes{};
  for (int k = 0; k < rays; k++) {
    const Vector3 ray = spiral_direction(k, rays);
    const double cell = std::min(reach(i, ray, scale, 0.0), 2.0 * radius);
    for (int l = 0; l < 3; l++) {
      double r = cell;
      for (const auto &plane : planes) {
        const double along = dot(ray, plane.normal);
        // no plane cuts into the particle itself
        const double height = std::max(plane.height + LAMBDA[l] * plane.radius, LAMBDA[l] * radius);
        if (along * r > height) r = height / along;
      }
      cubes[l] += r * r * r;
    }
  }
  for (auto &v : cubes) v *= 4.0 * M_PI / 3.0 / rays;
  const double h = LAMBDA[1] - LAMBDA[0],
               curved = (cubes[0] - 2.0 * cubes[1] + cubes[2]) / (2.0 * h * h);
  const double slope = (cubes[2] - cubes[0]) / (2.0 * h) - 2.0 * curved * LAMBDA[1];
  return {cubes[1] - LAMBDA[1] * (slope + curved * LAMBDA[1]), slope, curved};
}

/* ----------------------------------------------------------------------
   A0 = a dbar^2: in an isotropic solid of nu = 1/4 the sum of A L / 2 over the bonds of a particle is 6 V
------------------------------------------------------------------------- */

inline bool BodyArea::find_start()
{
  start.resize(bonds.size());
  for (std::size_t b = 0; b < bonds.size(); b++) {
    const double d = 0.5 * (diameter[bonds[b].low] + diameter[bonds[b].high]);
    start[b] = d * d;
  }
  double total[3] = {0.0, 0.0, 0.0};
  for (int i = 0; i < nowned; i++) {
    if (first[i] == first[i + 1]) continue;
    total[2] += volume[i];
    if (open[i] > 0.0) continue;
    total[0] += 6.0 * volume[i];
    for (int h = first[i]; h < first[i + 1]; h++)
      total[1] += 0.5 * start[halves[h].bond] * bonds[halves[h].bond].length;
  }
  halo.sum(total, 3);
  if (!(total[1] > 0.0)) return false;
  report.start = total[0] / total[1];
  report.volume = total[2];
  for (auto &area : start) area *= report.start;
  return true;
}

/* ----------------------------------------------------------------------
   K_i. States with a traction on a blocked direction drop out. Below a surface they count less, the more so the nearer
   it is: by how much is told by the second moment of the bonds, which are cut off there, and by the blocked directions of
   all particles within two bonds.
------------------------------------------------------------------------- */

// mean of the blocked directions over the particles within two bonds (as often as there are ways to them)
inline std::vector<double> BodyArea::surfaces_nearby()
{
  static constexpr int BONDS = 2, WIDTH = 10;    // last: volume
  std::vector<double> sum(WIDTH * static_cast<std::size_t>(nall), 0.0);
  for (int i = 0; i < nowned; i++) {
    double *mine = &sum[WIDTH * static_cast<std::size_t>(i)];
    for (int k = 0; k < 9; k++) mine[k] = volume[i] * blocked[i][k / 3][k % 3];
    mine[9] = volume[i];
  }
  for (int round = 0; round < BONDS; round++) {
    halo.forward(sum.data(), WIDTH);
    const auto last = sum;
    for (int i = 0; i < nowned; i++)
      for (int h = first[i]; h < first[i + 1]; h++)
        for (int k = 0; k < WIDTH; k++)
          sum[WIDTH * static_cast<std::size_t>(i) + k] +=
              last[WIDTH * static_cast<std::size_t>(halves[h].other) + k];
  }
  std::vector<double> mean(9 * static_cast<std::size_t>(nowned));
  for (int i = 0; i < nowned; i++)
    for (int k = 0; k < 9; k++)
      mean[9 * static_cast<std::size_t>(i) + k] = sum[WIDTH * static_cast<std::size_t>(i) + k] /
          sum[WIDTH * static_cast<std::size_t>(i) + 9];
  return mean;
}

inline void BodyArea::find_admissible()
{
  static constexpr double CUT_OFF = 0.7, COMPLETE = 0.9, FLOOR = 0.3;
  const auto nearby = surfaces_nearby();
  admissible.assign(nowned, Matrix6{});
  for (int i = 0; i < nowned; i++) {
    if (first[i] == first[i + 1]) continue;
    Vector3 bonded;
    Matrix3 axis;
    const int free = free_axes(i, &nearby[9 * static_cast<std::size_t>(i)], bonded, axis);
    std::vector<State> states;
    for (int k = 3 - free; k < 3; k++)
      for (int l = k; l < 3; l++) {
        double trust = 1.0;
        for (const int e : {k, l})
          trust *= std::clamp((bonded[e] / bonded[2] - CUT_OFF) / (COMPLETE - CUT_OFF), FLOOR, 1.0);
        states.push_back({trust, mandel(axis[k], axis[l])});
      }
    admissible[i] = energy_norm(states);
  }
}

// the directions without a free surface, last, and the second moment of the bonds along them, less the surfaces nearby
inline int BodyArea::free_axes(int i, const double *nearby, Vector3 &bonded, Matrix3 &axis) const
{
  static constexpr double NEARBY = 5.0;
  static constexpr double BEHIND = 10.0;    // puts the blocked directions first
  Matrix3 second{}, inward{};
  double free = 0.0;
  for (int k = 0; k < 3; k++) {
    for (int l = 0; l < 3; l++) inward[k][l] = (k == l) - blocked[i][k][l];
    free += inward[k][k];
  }
  for (int h = first[i]; h < first[i + 1]; h++) {
    const Bond &bond = bonds[halves[h].bond];
    const Vector3 n = {bond.n[0], bond.n[1], bond.n[2]};
    add_dyad(second, 0.25 * start[halves[h].bond] * bond.length / volume[i], n, n);
  }
  for (int k = 0; k < 9; k++) second[k / 3][k % 3] -= NEARBY * nearby[k];
  second = product(inward, product(second, inward));
  for (int k = 0; k < 3; k++)
    for (int l = 0; l < 3; l++) second[k][l] -= BEHIND * blocked[i][k][l];
  eigen3(second, bonded, axis);
  return static_cast<int>(std::lround(free));
}

// sum of trust^2 eps (x) eps over the strains of the states, made orthonormal in energy, the most trusted first
inline Matrix6 BodyArea::energy_norm(std::vector<State> &states)
{
  const Matrix6 compliance = isotropic_compliance(POISSON);
  auto strain_of = [&compliance](const Vector6 &stress) {
    Vector6 strain;
    for (int k = 0; k < 6; k++) strain[k] = dot(compliance[k], stress);
    return strain;
  };
  std::stable_sort(states.begin(), states.end(), [](const State &a, const State &b) {
    return a.trust > b.trust;
  });
  Matrix6 sum{};
  for (std::size_t k = 0; k < states.size(); k++) {
    Vector6 &stress = states[k].stress;
    for (std::size_t l = 0; l < k; l++) {
      const double share = dot(strain_of(states[l].stress), stress);
      for (int c = 0; c < 6; c++) stress[c] -= share * states[l].stress[c];
    }
    const double norm = std::sqrt(dot(strain_of(stress), stress));
    for (auto &component : stress) component /= norm;
    const Vector6 strain = strain_of(stress);
    add_dyad(sum, states[k].trust * states[k].trust, strain, strain);
  }
  return sum;
}

/* ----------------------------------------------------------------------
   moments of the areas z A0 about each owned particle, turned into the misfit's slope with respect to
   them (pull_back), for all particles
------------------------------------------------------------------------- */

inline void BodyArea::accumulate(const std::vector<double> &z)
{
  std::fill(moments.begin(), moments.end(), 0.0);
  double p[MOMENTS];
  for (std::size_t b = 0; b < bonds.size(); b++) {
    const Bond &bond = bonds[b];
    direction_products(bond.n, p);
    const double area = z[b] * start[b], work = 0.5 * area * bond.length;
    for (int end = 0; end < 2; end++) {
      const int i = end == 0 ? bond.low : bond.high;
      if (i >= nowned) continue;
      const double pull = end == 0 ? area : -area;
      double *m = &moments[static_cast<std::size_t>(i) * MOMENTS];
      for (int k = 0; k < THIRD; k++) m[k] += pull * p[k];
      for (int k = THIRD; k < MOMENTS; k++) m[k] += work * p[k];
    }
  }
}

inline void BodyArea::gather(const std::vector<double> &z, bool with_target)
{
  accumulate(z);
  for (int i = 0; i < nowned; i++)
    if (first[i] < first[i + 1]) pull_back(i, with_target);
  halo.forward(moments.data(), MOMENTS);
}

struct ProductPlaces {
  int fourth[6][6], third[6][3];
  constexpr ProductPlaces() : fourth(), third()
  {
    for (int a = 0; a < 6; a++) {
      int y = (MANDEL_ROW[a] == 1) + (MANDEL_COLUMN[a] == 1);
      int z = (MANDEL_ROW[a] == 2) + (MANDEL_COLUMN[a] == 2);
      for (int k = 0; k < 3; k++) third[a][k] = product_place(y + (k == 1), z + (k == 2));
      for (int b = 0; b < 6; b++)
        fourth[a][b] = THIRD +
            product_place(y + (MANDEL_ROW[b] == 1) + (MANDEL_COLUMN[b] == 1),
                          z + (MANDEL_ROW[b] == 2) + (MANDEL_COLUMN[b] == 2));
    }
  }
};

static constexpr ProductPlaces PLACES;

// what is left of the two conditions at a particle, over V and V^(2/3)
inline void BodyArea::residual(int i, bool with_target, Matrix6 &energy, double (*force)[3]) const
{
  const double *m = &moments[static_cast<std::size_t>(i) * MOMENTS];
  const double v = volume[i], surface = std::cbrt(v * v);
  for (int a = 0; a < 6; a++) {
    for (int b = 0; b < 6; b++)
      energy[a][b] = MANDEL_WEIGHT[a] * MANDEL_WEIGHT[b] * m[PLACES.fourth[a][b]] / v -
          (with_target ? target[i][a][b] : 0.0);
    for (int c = 0; c < 3; c++) force[a][c] = MANDEL_WEIGHT[a] * m[PLACES.third[a][c]] / surface;
  }
}

inline void BodyArea::pull_back(int i, bool with_target)
{
  const Matrix6 &k = admissible[i];
  const double v = volume[i], surface = std::cbrt(v * v);
  Matrix6 energy;
  double force[6][3];
  residual(i, with_target, energy, force);
  energy = product(k, product(energy, k));
  double *m = &moments[static_cast<std::size_t>(i) * MOMENTS];
  std::fill(m, m + MOMENTS, 0.0);
  for (int a = 0; a < 6; a++) {
    for (int b = 0; b < 6; b++)
      m[PLACES.fourth[a][b]] += MANDEL_WEIGHT[a] * MANDEL_WEIGHT[b] * energy[a][b] / v;
    for (int c = 0; c < 3; c++) {
      double seen = 0.0;
      for (int b = 0; b < 6; b++) seen += k[a][b] * force[b][c];
      m[PLACES.third[a][c]] += MANDEL_WEIGHT[a] * seen / surface;
    }
  }
}

// of the misfit with respect to the bond's area over A0, from the moments' slopes
inline double BodyArea::slope(int b) const
{
  const Bond &bond = bonds[b];
  const double *low = &moments[static_cast<std::size_t>(bond.low) * MOMENTS];
  const double *high = &moments[static_cast<std::size_t>(bond.high) * MOMENTS];
  double p[MOMENTS], force = 0.0, work = 0.0;
  direction_products(bond.n, p);
  for (int k = 0; k < THIRD; k++) force += (low[k] - high[k]) * p[k];
  for (int k = THIRD; k < MOMENTS; k++) work += (low[k] + high[k]) * p[k];
  return start[b] * (force + 0.5 * bond.length * work);
}

/* ----------------------------------------------------------------------
   Step of the gradient method: one over a diagonal that is nowhere below the second derivative. The misfit of
   particle i alone has a second derivative H_i with the diagonal D_i, H_i <= l_i D_i with l_i the largest
   eigenvalue of H_i scaled by D_i; so their sum is below sum_i l_i D_i.
------------------------------------------------------------------------- */

inline void BodyArea::find_step()
{
  moments.assign(static_cast<std::size_t>(nall) * MOMENTS, 0.0);
  std::vector<double> seen(static_cast<std::size_t>(nall) * WIDEST);
  for (int i = 0; i < nowned; i++) {
    double *mine = &seen[WIDEST * static_cast<std::size_t>(i)];
    for (int k = 0; k < 36; k++) mine[k] = admissible[i][k / 6][k % 6];
    mine[36] = largest_eigenvalue(i);
  }
  halo.forward(seen.data(), WIDEST);
  step.resize(bonds.size());
  for (std::size_t b = 0; b < bonds.size(); b++) {
    double above = PULL * PULL;
    for (const int i : {bonds[b].low, bonds[b].high}) {
      const double *k = &seen[WIDEST * static_cast<std::size_t>(i)];
      above += k[36] * curvature(b, k, volume[i]);
    }
    step[b] = 1.0 / above;
  }
}

// second derivative of one particle's misfit with respect to the area of one of its bonds; k: its K
inline double BodyArea::curvature(int b, const double *k, double v) const
{
  const Bond &bond = bonds[b];
  const Vector3 n = {bond.n[0], bond.n[1], bond.n[2]};
  const Vector6 m = mandel(n, n);
  double seen = 0.0;
  for (int a = 0; a < 36; a++) seen += k[a] * m[a / 6] * m[a % 6];
  const double work = 0.5 * start[b] * bond.length / v * seen;
  return work * work + start[b] * start[b] * seen / std::cbrt(v * v * v * v);
}

// power iteration; bonds that the particle does not see are left out
inline double BodyArea::largest_eigenvalue(int i)
{
  static constexpr int ITERATIONS = 12;
  static constexpr double UNSEEN = 1e-9;
  const int n = first[i + 1] - first[i];
  std::vector<double> diagonal(n), products(static_cast<std::size_t>(n) * MOMENTS);
  double most = 0.0;
  for (int h = 0; h < n; h++) {
    const Half &half = halves[first[i] + h];
    diagonal[h] = curvature(half.bond, &admissible[i][0][0], volume[i]);
    most = std::max(most, diagonal[h]);
    double *p = &products[static_cast<std::size_t>(h) * MOMENTS];
    direction_products(bonds[half.bond].n, p);
    for (int k = 0; k < THIRD; k++) p[k] *= half.sign * start[half.bond];
    for (int k = THIRD; k < MOMENTS; k++) p[k] *= 0.5 * start[half.bond] * bonds[half.bond].length;
  }
  double *m = &moments[static_cast<std::size_t>(i) * MOMENTS], answer = 1.0;
  for (int k = 0; k < MOMENTS; k++)
    m[k] = 1.0 / (1.0 + k) / (k < THIRD ? 1.0 : std::cbrt(volume[i]));
  std::vector<double> z(n, 0.0);
  for (int iteration = 0; iteration < ITERATIONS && most > 0.0; iteration++) {
    double norm = 0.0;
    for (int h = 0; h < n; h++) {
      const double *p = &products[static_cast<std::size_t>(h) * MOMENTS];
      z[h] = 0.0;
      if (diagonal[h] < UNSEEN * most) continue;
      for (int k = 0; k < MOMENTS; k++) z[h] += p[k] * m[k];
      norm += z[h] * z[h] / diagonal[h];
      z[h] /= diagonal[h];
    }
    if (iteration > 0) answer = std::sqrt(norm);
    std::fill(m, m + MOMENTS, 0.0);
    for (int h = 0; h < n; h++)
      for (int k = 0; k < MOMENTS; k++)
        m[k] += z[h] / std::sqrt(norm) * products[static_cast<std::size_t>(h) * MOMENTS + k];
    pull_back(i, false);
  }
  return answer;
}

// accelerated projected gradients; the momentum is dropped where it points uphill
inline void BodyArea::iterate(int n)
{
  std::vector<double> ahead = x, moved(x.size());
  double t = 1.0;
  for (int iteration = 0; iteration < n; iteration++) {
    gather(ahead, true);
    double uphill = 0.0;
    for (std::size_t b = 0; b < bonds.size(); b++) {
      const double g = slope(b) + PULL * PULL * (ahead[b] - 1.0);
      moved[b] = std::clamp(ahead[b] - step[b] * g, LEAST, MOST);
      if (bonds[b].counted) uphill += (ahead[b] - moved[b]) * (moved[b] - x[b]) / step[b];
    }
    halo.sum(&uphill, 1);
    const double next = 0.5 * (1.0 + std::sqrt(1.0 + 4.0 * t * t));
    const double momentum = uphill > 0.0 ? 0.0 : (t - 1.0) / next;
    t = uphill > 0.0 ? 1.0 : next;
    for (std::size_t b = 0; b < bonds.size(); b++) {
      ahead[b] = moved[b] + momentum * (moved[b] - x[b]);
      x[b] = moved[b];
    }
    report.iterations++;
  }
}

/* ----------------------------------------------------------------------
   what a particle's energy still lacks is asked for once more: the pull towards equal areas and the bounds
   leave the least squares short of it
------------------------------------------------------------------------- */

inline void BodyArea::add_missing_energy(const std::vector<Matrix6> &wanted)
{
  accumulate(x);
  Matrix6 energy;
  double force[6][3];
  for (int i = 0; i < nowned; i++) {
    if (first[i] == first[i + 1]) continue;
    residual(i, false, energy, force);
    for (int a = 0; a < 6; a++)
      for (int b = 0; b < 6; b++) target[i][a][b] += wanted[i][a][b] - energy[a][b];
  }
}

/* ----------------------------------------------------------------------
   sixth moments of the bulk's bonds (how far they spread the energy), scaled to the solid's stiffness. False if the
   fourth moments, the stiffness itself, leave some strain without resistance: the network is a mechanism.
------------------------------------------------------------------------- */

inline bool BodyArea::bulk_moments(std::array<Matrix6, 6> &sixth, int ends_inside)
{
  static constexpr double SOFT = 0.02;    // least stiffness over E
  std::array<Matrix6, 7> total{};         // the last one: fourth moments
  for (std::size_t b = 0; b < bonds.size(); b++) {
    const Bond &bond = bonds[b];
    if (!bond.counted || (open[bond.low] == 0.0) + (open[bond.high] == 0.0) < ends_inside) continue;
    const Vector3 n = {bond.n[0], bond.n[1], bond.n[2]};
    const Vector6 m = mandel(n, n);
    const double work = 0.5 * x[b] * start[b] * bond.length;
    for (int l = 0; l < 6; l++)
      add_dyad(total[l], 0.25 * work * bond.length * bond.length * m[l], m, m);
    add_dyad(total[6], work, m, m);
  }
  halo.sum(&total[0][0][0], 7 * 36);
  const Matrix6 stiffness = isotropic_stiffness(POISSON);
  double trace = 0.0, wanted = 0.0;
  for (int k = 0; k < 6; k++) {
    trace += total[6][k][k];
    wanted += stiffness[k][k];
  }
  if (!(trace > 0.0)) return false;
  for (auto &matrix : total)
    for (auto &row : matrix)
      for (auto &value : row) value *= wanted / trace;
  std::copy_n(total.begin(), 6, sixth.begin());
  for (int k = 0; k < 6; k++) total[6][k][k] -= SOFT;
  return cholesky(total[6], 6);
}

/* ----------------------------------------------------------------------
   Discrete second derivatives. For every particle k weights w_j on its neighbours with sum w dx = 0 and
   sum w dx dx = V_k I: then sum w_j (g_j - g_k) is V_k times half of the second derivatives of g, on
   surfaces too. Close neighbours are preferred (r^-4). What a particle without depth cannot form it hands
   to neighbours that are deeper inside.
   Returned, per particle j and component of the tensor: all weights that it receives minus those it gives.
------------------------------------------------------------------------- */

inline std::vector<double> BodyArea::surface_layer()
{
  static constexpr int ROUNDS = 4;
  std::vector<Stencil> stencils(nowned);
  for (int i = 0; i < nowned; i++)
    if (first[i] < first[i + 1]) stencils[i] = second_derivative(i);

  std::vector<double> layer(static_cast<std::size_t>(nall) * 6, 0.0);
  std::vector<double> handed(static_cast<std::size_t>(nall) * 36);
  for (int round = 0; round < ROUNDS; round++) {
    std::fill(handed.begin(), handed.end(), 0.0);
    for (int i = 0; i < nowned; i++)
      if (first[i] < first[i + 1]) {
        apply(i, stencils[i], layer);
        hand_over(i, stencils[i].wanted, handed);
      }
    halo.reverse(handed.data(), 36);
    for (int i = 0; i < nowned; i++)
      for (int k = 0; k < 36; k++)
        stencils[i].wanted[k / 6][k % 6] += handed[36 * static_cast<std::size_t>(i) + k];
  }
  halo.reverse(layer.data(), 6);
  return layer;
}

inline Vector3 BodyArea::separation(const Half &half) const
{
  const Bond &bond = bonds[half.bond];
  const double r = half.sign * bond.length;
  return {r * bond.n[0], r * bond.n[1], r * bond.n[2]};
}

inline double BodyArea::closeness(int i, const Half &half) const
{
  const double q = bonds[half.bond].length * bonds[half.bond].length;
  return std::cbrt(volume[i] * volume[i]) / (q * q);
}

inline BodyArea::Stencil BodyArea::second_derivative(int i) const
{
  static constexpr double RIDGE = 0.3;    // of the mean eigenvalue: keeps the weights small
  static constexpr double FLAT = 1e-9;    // bonds in one plane
  Stencil s{};
  Matrix3 gradient{};
  for (int h = first[i]; h < first[i + 1]; h++) {
    const Vector3 dx = separation(halves[h]);
    const Vector6 m = mandel(dx, dx);
    const double g = closeness(i, halves[h]);
    add_dyad(gradient, g, dx, dx);
    add_dyad(s.slope, g, m, dx);
    add_dyad(s.matrix, g, m, m);
  }
  const double trace = gradient[0][0] + gradient[1][1] + gradient[2][2];
  for (int k = 0; k < 3; k++) gradient[k][k] += FLAT * trace;
  cholesky(gradient, 3);
  double mean = 0.0;
  for (int c = 0; c < 6; c++) mean += s.matrix[c][c] / 6.0;
  const auto crossed = s.slope;
  for (int c = 0; c < 6; c++) solve_cholesky(gradient, s.slope[c], 3);
  for (int c = 0; c < 6; c++)
    for (int e = 0; e < 6; e++) s.matrix[c][e] -= dot(s.slope[c], crossed[e]);
  s.factor = s.matrix;
  for (int c = 0; c < 6; c++) {
    s.factor[c][c] += RIDGE * mean;
    s.wanted[c][c] = volume[i];
  }
  cholesky(s.factor, 6);
  return s;
}

// the stencil's weights for what is still wanted go into the layer
inline void BodyArea::apply(int i, Stencil &s, std::vector<double> &layer) const
{
  Matrix6 answer = s.wanted;
  for (auto &row : answer) solve_cholesky(s.factor, row, 6);
  for (int h = first[i]; h < first[i + 1]; h++) {
    const Vector3 dx = separation(halves[h]);
    Vector6 m = mandel(dx, dx);
    for (int c = 0; c < 6; c++) m[c] -= dot(s.slope[c], dx);
    const double g = closeness(i, halves[h]);
    for (int c = 0; c < 6; c++) {
      const double weight = g * dot(m, answer[c]);
      layer[6 * static_cast<std::size_t>(halves[h].other) + c] += weight;
      layer[6 * static_cast<std::size_t>(i) + c] -= weight;
    }
  }
  for (int c = 0; c < 6; c++)
    for (int e = 0; e < 6; e++) s.wanted[c][e] -= dot(answer[c], s.matrix[e]);
}

inline void BodyArea::hand_over(int i, Matrix6 &wanted, std::vector<double> &handed) const
{
  static constexpr double DEEPER = 0.02;    // less of the directions open
  auto depth = [this, i](const Half &half) {
    const double gain = open[i] - open[half.other];
    return gain > DEEPER ? closeness(i, half) * gain : 0.0;
  };
  double total = 0.0;
  for (int h = first[i]; h < first[i + 1]; h++) total += depth(halves[h]);
  if (total == 0.0) return;
  for (int h = first[i]; h < first[i + 1]; h++) {
    const double share = depth(halves[h]) / total;
    double *to = &handed[36 * static_cast<std::size_t>(halves[h].other)];
    for (int k = 0; k < 36; k++) to[k] += share * wanted[k / 6][k % 6];
  }
  wanted = Matrix6{};
}

/* ----------------------------------------------------------------------
   T_i = C + the energy that the surface layer asks for, in the states without traction along the layer's
   principal directions, as far as it has a share in them
------------------------------------------------------------------------- */

inline void BodyArea::correct_target(const std::array<Matrix6, 6> &sixth)
{
  static constexpr double LIMIT = 1.5, NOTHING = 1e-6;
  double mean[2] = {0.0, 0.0};
  for (int i = 0; i < nowned; i++)
    if (inside(i)) {
      mean[0] += std::cbrt(volume[i] * volume[i]);
      mean[1] += 1.0;
    }
  halo.sum(mean, 2);
  const double cell = mean[0] / mean[1] / 12.0;    // variance of a cell along any direction
  const auto layers = surface_layer();
  for (int i = 0; i < nowned; i++) {
    if (first[i] == first[i + 1]) continue;
    Vector6 layer;
    for (int c = 0; c < 6; c++) layer[c] = layers[6 * static_cast<std::size_t>(i) + c] / volume[i];
    if (dot(layer, layer) * cell * cell < NOTHING * NOTHING) continue;
    const Matrix6 change = layer_energy(layer, cell, sixth);
    const Matrix6 seen = product(admissible[i], change);
    double size2 = 0.0;
    for (int a = 0; a < 6; a++)
      for (int b = 0; b < 6; b++) size2 += seen[a][b] * seen[b][a];
    const double share = size2 > LIMIT * LIMIT ? LIMIT / std::sqrt(size2) : 1.0;
    for (int a = 0; a < 6; a++)
      for (int b = 0; b < 6; b++) target[i][a][b] += share * change[a][b];
  }
}

inline Matrix6 BodyArea::layer_energy(const Vector6 &layer, double cell,
                                      const std::array<Matrix6, 6> &sixth)
{
  const Matrix6 stiffness = isotropic_stiffness(POISSON),
                compliance = isotropic_compliance(POISSON);
  Matrix6 change{};
  for (int a = 0; a < 6; a++)
    for (int b = 0; b < 6; b++) {
      change[a][b] = (layer[0] + layer[1] + layer[2]) * cell * stiffness[a][b];
      for (int c = 0; c < 6; c++) change[a][b] += layer[c] * sixth[c][a][b];
    }
  Vector3 value, kept;
  Matrix3 axis;
  eigen3(tensor(layer), value, axis);
  const double largest = std::max(std::fabs(value[0]), std::fabs(value[2]));
  for (int k = 0; k < 3; k++) kept[k] = 1.0 - value[k] * value[k] / (largest * largest);
  // strain -> strain of the stress that is left
  Matrix6 left{};
  for (int k = 0; k < 3; k++)
    for (int l = k; l < 3; l++) {
      const Vector6 state = mandel(axis[k], axis[l]);
      add_dyad(left, kept[k] * kept[l] / dot(state, state), state, state);
    }
  left = product(compliance, product(left, stiffness));
  return product(transposed(left), product(change, left));
}

/* ---------------------------------------------------------------------- */

inline void BodyArea::judge()
{
  accumulate(x);
  double total[2] = {0.0, 0.0};
  report.least = MOST;
  report.most = LEAST;
  for (const double value : x) {
    report.least = std::min(report.least, value);
    report.most = std::max(report.most, value);
  }
  for (int i = 0; i < nowned; i++) {
    if (!inside(i)) continue;
    Matrix6 energy;
    double force[6][3];
    residual(i, true, energy, force);
    const Matrix6 seen = product(admissible[i], energy);
    total[1] += 1.0;
    for (int a = 0; a < 6; a++)
      for (int b = 0; b < 6; b++) {
        total[0] += seen[a][b] * seen[b][a];
        for (int c = 0; c < 3; c++) total[0] += admissible[i][a][b] * force[a][c] * force[b][c];
      }
  }
  halo.sum(total, 2);
  report.misfit = std::sqrt(total[0] / total[1]);
}

}    // namespace POTDEM

#endif
