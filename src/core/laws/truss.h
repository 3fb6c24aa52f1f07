/* The truss (thesis eqs 5.19 to 5.21): Green-Lagrange strain of the line of centres.

     x   = r / re                                    re = reference length
     eps = (r-re)/re + ((r-re)/re)^2 / 2 = (x^2 - 1) / 2
     F   = A E c(x) eps                              tension; force = -F in LAMMPS's sign
     Phi = A E re * integral of c eps dx from 1 to x (so that Phi(re) = 0)

   Centre distances are used throughout: the thesis's second form with surface distances agrees with
   the first only for r0 = 0, and its potential (5.21) is shifted here to vanish at re. c = 1 unless
   the non-penetration factor is asked for (penetration.h). Domain r > 0.
   Units: A E force, re and r length. */

#ifndef POTDEM_TRUSS_H
#define POTDEM_TRUSS_H

#include "evaluation.h"
#include "penetration.h"

#include <cmath>

namespace POTDEM {

// section of a truss between two particles of mean diameter dbar: the circle with the mean radius
// (the thesis's own definition; its printed formula with d_i + d_j is four times as large)
inline double truss_section(double dbar)
{
  return 0.25 * M_PI * dbar * dbar;
}

// strain from q = (r/re)^2
inline double truss_strain(double q)
{
  return 0.5 * (q - 1.0);
}

// modulus: A E; re: reference length
inline Evaluation truss(double r, double re, double modulus)
{
  const double x = r / re;
  const double dx = x - 1.0;
  return {modulus * re * dx * dx * (x + 2.0) / 6.0, -modulus * truss_strain(x * x),
          modulus * x / re};
}

// the same with the non-penetration factor
inline Evaluation truss(double r, double re, double modulus, const Penetration &factor)
{
  const double x = r / re;
  const double eps = truss_strain(x * x);
  const double c = factor.value(x);
  return {modulus * re * factor.integral(x), -modulus * c * eps,
          modulus / re * (c * x + factor.slope(x) * eps)};
}

}    // namespace POTDEM

#endif
