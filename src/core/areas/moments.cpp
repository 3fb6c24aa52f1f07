/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "moments.h"

using namespace POTDEM;

namespace {

// where the components of m (x) m and m (x) n stand among the moments
struct Places {
  int fourth[6][6], third[6][3];
  constexpr Places() : fourth(), third()
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

constexpr Places PLACES;

}    // namespace

Misfit::Misfit(const Moments &m, double v, const Matrix6 *target)
{
  const double surface = std::cbrt(v * v);
  for (int a = 0; a < 6; a++) {
    for (int b = 0; b < 6; b++)
      energy[a][b] = MANDEL_WEIGHT[a] * MANDEL_WEIGHT[b] * m[PLACES.fourth[a][b]] / v -
          (target ? (*target)[a][b] : 0.0);
    for (int c = 0; c < 3; c++) force[a][c] = MANDEL_WEIGHT[a] * m[PLACES.third[a][c]] / surface;
  }
}

void Misfit::add_push(const Vector3 &push, double v)
{
  const double surface = std::cbrt(v * v);
  for (int a = 0; a < 3; a++)
    for (int c = 0; c < 3; c++) force[a][c] += push[c] / surface;
}

double Misfit::square(const Matrix6 &k) const
{
  const Matrix6 seen = product(k, energy);
  double sum = trace_of_product(seen, seen);
  for (int a = 0; a < 6; a++)
    for (int b = 0; b < 6; b++) sum += k[a][b] * dot(force[a], force[b]);
  return sum;
}

Moments Misfit::slope(const Matrix6 &k, double v) const
{
  const double surface = std::cbrt(v * v);
  const Matrix6 seen = product(k, product(energy, k));
  Moments m{};
  for (int a = 0; a < 6; a++) {
    for (int b = 0; b < 6; b++)
      m[PLACES.fourth[a][b]] += MANDEL_WEIGHT[a] * MANDEL_WEIGHT[b] * seen[a][b] / v;
    for (int c = 0; c < 3; c++) {
      double pulled = 0.0;
      for (int b = 0; b < 6; b++) pulled += k[a][b] * force[b][c];
      m[PLACES.third[a][c]] += MANDEL_WEIGHT[a] * pulled / surface;
    }
  }
  return m;
}
