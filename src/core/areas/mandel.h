/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Symmetric tensors as vectors and matrices (Mandel's notation): components xx yy zz yz xz xy, the last
   three times sqrt 2, so that a double contraction is a scalar product. And the moments of bond directions,
   kept by their distinct components only: third order 10, fourth order 15.

   Vectors and matrices of any unit; symmetric ones are given in full. Nothing here is an error by itself: cholesky() says
   that a matrix is not positive, all else is defined for every finite argument. */

#ifndef POTDEM_MANDEL_H
#define POTDEM_MANDEL_H

#include "core/geometry/vector3.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace POTDEM {

typedef std::array<Vector3, 3> Matrix3;
typedef std::array<double, 6> Vector6;
typedef std::array<Vector6, 6> Matrix6;

static constexpr double ROOT2 = 1.41421356237309504880;
static constexpr int MANDEL_ROW[6] = {0, 1, 2, 1, 0, 0}, MANDEL_COLUMN[6] = {0, 1, 2, 2, 2, 1};
static constexpr double MANDEL_WEIGHT[6] = {1.0, 1.0, 1.0, ROOT2, ROOT2, ROOT2};

// symmetric part of a (x) b
inline Vector6 mandel(const Vector3 &a, const Vector3 &b)
{
  Vector6 m;
  for (int k = 0; k < 6; k++)
    m[k] = 0.5 * MANDEL_WEIGHT[k] *
        (a[MANDEL_ROW[k]] * b[MANDEL_COLUMN[k]] + a[MANDEL_COLUMN[k]] * b[MANDEL_ROW[k]]);
  return m;
}

inline Matrix3 tensor(const Vector6 &m)
{
  Matrix3 t;
  for (int k = 0; k < 6; k++)
    t[MANDEL_ROW[k]][MANDEL_COLUMN[k]] = t[MANDEL_COLUMN[k]][MANDEL_ROW[k]] =
        m[k] / MANDEL_WEIGHT[k];
  return t;
}

template <class V> double dot(const V &a, const V &b)
{
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); k++) sum += a[k] * b[k];
  return sum;
}

template <class M> M product(const M &a, const M &b)
{
  M c{};
  for (std::size_t i = 0; i < a.size(); i++)
    for (std::size_t k = 0; k < a.size(); k++)
      for (std::size_t j = 0; j < a.size(); j++) c[i][j] += a[i][k] * b[k][j];
  return c;
}

inline Vector6 product(const Matrix6 &a, const Vector6 &b)
{
  Vector6 c;
  for (int k = 0; k < 6; k++) c[k] = dot(a[k], b);
  return c;
}

// sum a_ij b_ji
template <class M> double trace_of_product(const M &a, const M &b)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); i++)
    for (std::size_t j = 0; j < a.size(); j++) sum += a[i][j] * b[j][i];
  return sum;
}

template <class M> M transposed(const M &a)
{
  M t;
  for (std::size_t i = 0; i < a.size(); i++)
    for (std::size_t j = 0; j < a.size(); j++) t[i][j] = a[j][i];
  return t;
}

// a += weight * u (x) v
template <class M, class U, class V> void add_dyad(M &a, double weight, const U &u, const V &v)
{
  for (std::size_t i = 0; i < u.size(); i++)
    for (std::size_t j = 0; j < v.size(); j++) a[i][j] += weight * u[i] * v[j];
}

// a += weight * b
inline void add(Matrix6 &a, double weight, const Matrix6 &b)
{
  for (int i = 0; i < 6; i++)
    for (int j = 0; j < 6; j++) a[i][j] += weight * b[i][j];
}

// isotropic stiffness of Young's modulus 1; compliance is its inverse
inline Matrix6 isotropic_stiffness(double nu)
{
  Matrix6 c{};
  for (int i = 0; i < 6; i++) c[i][i] = 1.0 / (1.0 + nu);
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) c[i][j] += nu / ((1.0 + nu) * (1.0 - 2.0 * nu));
  return c;
}

inline Matrix6 isotropic_compliance(double nu)
{
  Matrix6 s{};
  for (int i = 0; i < 6; i++) s[i][i] = 1.0 + nu;
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) s[i][j] -= nu;
  return s;
}

/* ----------------------------------------------------------------------
   eigenvalues, ascending, and eigenvectors (rows) of a symmetric 3 x 3 matrix: Jacobi's rotations
------------------------------------------------------------------------- */

inline void eigen3(Matrix3 a, Vector3 &value, Matrix3 &vector)
{
  Matrix3 v{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
  for (int sweep = 0; sweep < 30; sweep++) {
    const double off = a[0][1] * a[0][1] + a[0][2] * a[0][2] + a[1][2] * a[1][2];
    if (off < 1e-32 * (a[0][0] * a[0][0] + a[1][1] * a[1][1] + a[2][2] * a[2][2]) || off == 0.0)
      break;
    for (int p = 0; p < 2; p++)
      for (int q = p + 1; q < 3; q++) {
        if (a[p][q] == 0.0) continue;
        const double angle = 0.5 * std::atan2(2.0 * a[p][q], a[q][q] - a[p][p]);
        const double c = std::cos(angle), s = std::sin(angle);
        for (int k = 0; k < 3; k++) {
          const double akp = a[k][p], akq = a[k][q];
          a[k][p] = c * akp - s * akq;
          a[k][q] = s * akp + c * akq;
        }
        for (int k = 0; k < 3; k++) {
          const double apk = a[p][k], aqk = a[q][k], vp = v[p][k], vq = v[q][k];
          a[p][k] = c * apk - s * aqk;
          a[q][k] = s * apk + c * aqk;
          v[p][k] = c * vp - s * vq;
          v[q][k] = s * vp + c * vq;
        }
      }
  }
  std::array<int, 3> order = {0, 1, 2};
  std::sort(order.begin(), order.end(), [&a](int i, int j) {
    return a[i][i] < a[j][j];
  });
  for (int k = 0; k < 3; k++) {
    value[k] = a[order[k]][order[k]];
    vector[k] = v[order[k]];
  }
}

/* ----------------------------------------------------------------------
   Cholesky factor (lower) of the leading n rows of a symmetric matrix; false if it is not positive
------------------------------------------------------------------------- */

template <class M> bool cholesky(M &a, int n)
{
  for (int j = 0; j < n; j++) {
    for (int i = j; i < n; i++) {
      double sum = a[i][j];
      for (int k = 0; k < j; k++) sum -= a[i][k] * a[j][k];
      if (i == j) {
        if (!(sum > 0.0)) return false;
        a[j][j] = std::sqrt(sum);
      } else
        a[i][j] = sum / a[j][j];
    }
  }
  return true;
}

// L y = b, in place
template <class M, class V> void solve_lower(const M &lower, V &b, int n)
{
  for (int i = 0; i < n; i++) {
    for (int k = 0; k < i; k++) b[i] -= lower[i][k] * b[k];
    b[i] /= lower[i][i];
  }
}

// L L^T x = b, in place
template <class M, class V> void solve_cholesky(const M &lower, V &b, int n)
{
  solve_lower(lower, b, n);
  for (int i = n - 1; i >= 0; i--) {
    for (int k = i + 1; k < n; k++) b[i] -= lower[k][i] * b[k];
    b[i] /= lower[i][i];
  }
}

/* ----------------------------------------------------------------------
   moments of directions: the products of n of third and fourth order, and where each stands in the
   matrices m (x) n and m (x) m with m = mandel(n, n)
------------------------------------------------------------------------- */

static constexpr int THIRD = 10, FOURTH = 15, MOMENTS = THIRD + FOURTH;

// place of x^a y^b z^c among the products of its order in direction_products(), whatever a is
constexpr int product_place(int b, int c)
{
  return (b + c) * (b + c + 1) / 2 +
      c;    // before it: all products with more x, then those with more y
}

inline void direction_products(const double *n, double *out)
{
  const double x = n[0], y = n[1], z = n[2];
  const double xx = x * x, xy = x * y, xz = x * z, yy = y * y, yz = y * z, zz = z * z;
  const double third[THIRD] = {xx * x, xx * y, xx * z, xy * y, xy * z,
                               xz * z, yy * y, yy * z, yz * z, zz * z};
  for (int k = 0; k < THIRD; k++) out[k] = third[k];
  const double fourth[FOURTH] = {xx * xx, xx * xy, xx * xz, xx * yy, xx * yz,
                                 xx * zz, xy * yy, xy * yz, xy * zz, xz * zz,
                                 yy * yy, yy * yz, yy * zz, yz * zz, zz * zz};
  for (int k = 0; k < FOURTH; k++) out[THIRD + k] = fourth[k];
}

}    // namespace POTDEM

#endif
