/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Strain at a particle (thesis eq. 5.24): the symmetric tensor eps that fits its bonds best,

     sum over bonds (n.eps n - eps_bond)^2 -> least        n: direction of the bond in the reference state

   which is Green and Lagrange's, as eps_bond is (5.19). As vectors of six, xx yy zz xy xz yz, with shear times sqrt(2), so
   that the norm is that of the tensor. */

#ifndef POTDEM_GREEN_LAGRANGE_H
#define POTDEM_GREEN_LAGRANGE_H

#include "device.h"

#include <cmath>

namespace POTDEM {

// what bonds say, one by one or four at a time: the right side of the normal equations, shear without its factor
template <class Number> struct StrainSum {
  Number of[6]{};

  // del: the bond in the reference state, of any length
  POTDEM_FUNCTION void add(const Number *del, const Number &strain)
  {
    const Number d2 = del[0] * del[0] + del[1] * del[1] + del[2] * del[2], share = strain / d2;
    const Number x = share * del[0], y = share * del[1], z = share * del[2];
    of[0] += x * del[0];
    of[1] += y * del[1];
    of[2] += z * del[2];
    of[3] += x * del[1];
    of[4] += x * del[2];
    of[5] += y * del[2];
  }
};

// what makes the strain of it, as long as the bonds are the same: a symmetric matrix, row by row up to the diagonal
struct StrainInverse {
  static constexpr double ROOT_2 = 1.4142135623730951;

  double rows[21];

  POTDEM_FUNCTION void apply(const double *sum, double *strain) const
  {
    double right[6], left[6];
    for (int a = 0; a < 6; a++) right[a] = a < 3 ? sum[a] : ROOT_2 * sum[a];
    const double *row = rows;
    for (int a = 0; a < 6; row += ++a) {
      left[a] = row[a] * right[a];
      for (int b = 0; b < a; b++) {
        left[a] += row[b] * right[b];
        left[b] += row[b] * right[a];
      }
    }
    for (int a = 0; a < 6; a++) strain[a] = a < 3 ? left[a] : left[a] / ROOT_2;
  }
};

// of the bonds of one particle in the reference state
class StrainFit {
 public:
  double matrix[6][6] = {};    // of the normal equations
  int bonds = 0;

  // weight: how much its strain counts; that of the sum is as heavy
  POTDEM_FUNCTION void add(const double *del, double weight = 1.0)
  {
    StrainSum<double> row;
    row.add(del, 1.0);
    for (int a = 3; a < 6; a++) row.of[a] *= StrainInverse::ROOT_2;
    for (int a = 0; a < 6; a++)
      for (int b = 0; b < 6; b++) matrix[a][b] += weight * row.of[a] * row.of[b];
    bonds++;
  }

  // by Cholesky's factors, if certainly no eigenvalue is below `least` of the largest: the product of the five others is not above
  // the fifth power of their mean, nor the largest above the trace
  POTDEM_FUNCTION bool invert(double least, StrainInverse &inverse) const
  {
    double factor[6][6], trace = 0.0, determinant = 1.0;
    for (int a = 0; a < 6; a++) trace += matrix[a][a];
    for (int a = 0; a < 6; a++) {
      double pivot = matrix[a][a];
      for (int b = 0; b < a; b++) {
        factor[a][b] = matrix[a][b];
        for (int c = 0; c < b; c++) factor[a][b] -= factor[a][c] * factor[b][c];
        factor[a][b] /= factor[b][b];
        pivot -= factor[a][b] * factor[a][b];
      }
      if (!(pivot > 0.0)) return false;
      determinant *= pivot;
      factor[a][a] = std::sqrt(pivot);
    }
    const double mean = trace / 5.0;
    if (!(determinant > least * trace * mean * mean * mean * mean * mean)) return false;
    multiply_inverses(factor, inverse);
    return true;
  }

  // values, vectors: of the matrix, the largest first. The strain of least norm among those that fit best; returns in how
  // many of six directions the bonds say something: where a value is not above `singular` of the largest they do not
  POTDEM_FUNCTION int invert(const double *values, const double (*vectors)[6], double singular,
                             StrainInverse &inverse) const
  {
    inverse = {};
    int rank = 0;
    for (; rank < 6 && values[rank] > singular * values[0]; rank++) {
      double *element = inverse.rows;
      for (int a = 0; a < 6; a++)
        for (int b = 0; b <= a; b++)
          *element++ += vectors[rank][a] / values[rank] * vectors[rank][b];
    }
    return rank;
  }

 private:
  // of a lower triangle: its inverse, from the left by its own transpose
  POTDEM_FUNCTION static void multiply_inverses(const double (*factor)[6], StrainInverse &inverse)
  {
    double lower[6][6];
    for (int a = 0; a < 6; a++) {
      lower[a][a] = 1.0 / factor[a][a];
      for (int b = 0; b < a; b++) {
        double sum = 0.0;
        for (int c = b; c < a; c++) sum += factor[a][c] * lower[c][b];
        lower[a][b] = -sum * lower[a][a];
      }
    }
    double *element = inverse.rows;
    for (int a = 0; a < 6; a++)
      for (int b = 0; b <= a; b++, element++) {
        *element = 0.0;
        for (int c = a; c < 6; c++) *element += lower[c][a] * lower[c][b];
      }
  }
};

}    // namespace POTDEM

#endif
