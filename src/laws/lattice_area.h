/* Area factor of a perfect lattice (`area lattice`): the a in A = a pi/4 d^2, with d the spacing of
   nearest neighbours, for which uniaxial tension along a cube axis has exactly the modulus E.

   With one truss per pair the stiffness tensor per cell volume V is, over the bonds of one particle,
     C_ijkl = (1/2V) sum A E r n_i n_j n_k n_l      (pairs counted from both ends)
   and 1/S_11 = C11 - 2 C12^2/(C11 + C12) = E fixes A. Bonds up to and including the longest one that is
   there take part. Cubic lattices only: in them every site is a centre of inversion, so that the sum is
   exact (hexagonal packing has two sites per cell, which move against each other under strain). */

#ifndef POTDEM_LATTICE_AREA_H
#define POTDEM_LATTICE_AREA_H

#include <cmath>

namespace POTDEM {

enum class Lattice { NONE, CUBIC, BCC, FCC };

// named by the number of nearest neighbours; 12 is taken for fcc (the caller excludes hcp)
inline Lattice lattice_of(int nearest)
{
  switch (nearest) {
    case 6:
      return Lattice::CUBIC;
    case 8:
      return Lattice::BCC;
    case 12:
      return Lattice::FCC;
    default:
      return Lattice::NONE;
  }
}

// is (i,j,k), in half cube edges, a site of the lattice?
inline bool is_site(Lattice lattice, int i, int j, int k)
{
  switch (lattice) {
    case Lattice::CUBIC:
      return i % 2 == 0 && j % 2 == 0 && k % 2 == 0;
    case Lattice::BCC:
      return (i % 2 == 0) == (j % 2 == 0) && (j % 2 == 0) == (k % 2 == 0);
    case Lattice::FCC:
      return (i + j + k) % 2 == 0;
    default:
      return false;
  }
}

// half cube edge in units of the nearest distance
inline double half_edge(Lattice lattice)
{
  return lattice == Lattice::CUBIC ? 0.5
      : lattice == Lattice::BCC    ? 1.0 / std::sqrt(3.0)
                                   : 1.0 / std::sqrt(2.0);
}

// can a bond of this length (over the nearest distance) occur? Its square counts half edges.
inline bool is_shell(Lattice lattice, double length, double tolerance)
{
  const double n = length * length / (half_edge(lattice) * half_edge(lattice));
  return std::fabs(n - std::round(n)) < 2.0 * tolerance * n;
}

struct LatticeAnswer {
  double area_factor;
  double poisson;
  int bonds;    // per particle
};

// reach: longest bond over spacing
inline LatticeAnswer lattice_area(Lattice lattice, double reach)
{
  const double half = half_edge(lattice);
  const double sites = lattice == Lattice::CUBIC ? 1.0 : lattice == Lattice::BCC ? 2.0 : 4.0;
  const double volume =    // cell volume per particle
      8.0 * half * half * half / sites;
  const int n = static_cast<int>(reach / half) + 1;
  double c11 = 0.0, c12 = 0.0;
  int bonds = 0;
  for (int i = -n; i <= n; i++)
    for (int j = -n; j <= n; j++)
      for (int k = -n; k <= n; k++) {
        const double r = half * std::sqrt(static_cast<double>(i * i + j * j + k * k));
        if ((i == 0 && j == 0 && k == 0) || r > reach * (1.0 + 1e-6) || !is_site(lattice, i, j, k))
          continue;
        const double x = half * i / r, y = half * j / r;
        c11 += r * x * x * x * x / (2.0 * volume);
        c12 += r * x * x * y * y / (2.0 * volume);
        bonds++;
      }
  const double modulus = c11 - 2.0 * c12 * c12 / (c11 + c12);
  return {1.0 / (modulus * 0.25 * M_PI), c12 / (c11 + c12), bonds};
}

}    // namespace POTDEM

#endif
