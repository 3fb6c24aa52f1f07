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

namespace POTDEM {

class StrainFit {
 public:
  static constexpr double ROOT_2 = 1.4142135623730951;

  double matrix[6][6] = {}, right[6] = {};    // normal equations: matrix eps = right
  int bonds = 0;

  // del: the bond in the reference state, of any length
  POTDEM_FUNCTION void add(const double *del, double strain)
  {
    const double d2 = del[0] * del[0] + del[1] * del[1] + del[2] * del[2];
    const double row[6] = {del[0] * del[0] / d2,          del[1] * del[1] / d2,
                           del[2] * del[2] / d2,          ROOT_2 * del[0] * del[1] / d2,
                           ROOT_2 * del[0] * del[2] / d2, ROOT_2 * del[1] * del[2] / d2};
    for (int a = 0; a < 6; a++) {
      right[a] += row[a] * strain;
      for (int b = 0; b < 6; b++) matrix[a][b] += row[a] * row[b];
    }
    bonds++;
  }

  // values, vectors: of the matrix, the largest first. The strain of least norm among those that fit best; returns in how
  // many of six directions the bonds say something: where a value is not above `singular` of the largest they do not
  POTDEM_FUNCTION int solve(const double *values, const double (*vectors)[6], double singular,
                            double *strain) const
  {
    int rank = 0;
    for (int a = 0; a < 6; a++) strain[a] = 0.0;
    for (; rank < 6 && values[rank] > singular * values[0]; rank++) {
      double share = 0.0;
      for (int a = 0; a < 6; a++) share += vectors[rank][a] * right[a];
      for (int a = 0; a < 6; a++) strain[a] += share / values[rank] * vectors[rank][a];
    }
    for (int a = 3; a < 6; a++) strain[a] /= ROOT_2;
    return rank;
  }
};

}    // namespace POTDEM

#endif
