/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Area factor of a perfect lattice (`area lattice`): the a in A = a pi/4 d^2, with d the spacing of
   nearest neighbours, for which uniaxial tension has exactly the modulus E: along a cube axis, and in hexagonal
   packing along any direction of the basal plane.

   With one truss per pair the stiffness tensor per particle's volume V is, over the bonds of one particle,
     C = (1/2V) sum A E L m (x) m,   m = n (x) n      (pairs counted from both ends)
   In hexagonal packing the two kinds of sites move against each other by u under strain; over the bonds
   between them the energy's mixed and second derivatives with respect to u are
     D = (1/2V) sum A E m (x) n,   K = (1/2V) sum (A E / L) n (x) n,
   and C - D K^-1 D^T takes the place of C. Then 1/S_11 = E, S the inverse, fixes A. Bonds up to and including
   the longest one that is there take part. */

#ifndef POTDEM_LATTICE_AREA_H
#define POTDEM_LATTICE_AREA_H

#include "mandel.h"

#include <vector>

namespace POTDEM {

enum class Lattice { NONE, CUBIC, BCC, FCC, HCP };

// named by the number of nearest neighbours and whether each of them faces another one
inline Lattice lattice_of(int nearest, bool centred)
{
  switch (nearest) {
    case 6:
      return Lattice::CUBIC;
    case 8:
      return Lattice::BCC;
    case 12:
      return centred ? Lattice::FCC : Lattice::HCP;
    default:
      return Lattice::NONE;
  }
}

// an orthogonal cell with nearest neighbours at distance 1; sites in fractions of its edges
struct LatticeCell {
  struct Site {
    Vector3 at;
    bool second;    // of the other kind (hcp)
  };
  Vector3 edge;
  std::vector<Site> sites;
};

inline LatticeCell lattice_cell(Lattice lattice)
{
  const double cube = lattice == Lattice::BCC ? 2.0 / std::sqrt(3.0)
      : lattice == Lattice::FCC               ? std::sqrt(2.0)
                                              : 1.0;
  switch (lattice) {
    case Lattice::BCC:
      return {{cube, cube, cube}, {{{0.0, 0.0, 0.0}, false}, {{0.5, 0.5, 0.5}, false}}};
    case Lattice::FCC:
      return {{cube, cube, cube},
              {{{0.0, 0.0, 0.0}, false},
               {{0.0, 0.5, 0.5}, false},
               {{0.5, 0.0, 0.5}, false},
               {{0.5, 0.5, 0.0}, false}}};
    case Lattice::HCP:
      return {{1.0, std::sqrt(3.0), std::sqrt(8.0 / 3.0)},
              {{{0.0, 0.0, 0.0}, false},
               {{0.5, 0.5, 0.0}, false},
               {{0.5, 1.0 / 6.0, 0.5}, true},
               {{0.0, 2.0 / 3.0, 0.5}, true}}};
    default:
      return {{cube, cube, cube}, {{{0.0, 0.0, 0.0}, false}}};
  }
}

struct LatticeBond {
  Vector3 n;
  double length;
  bool second;    // to a site of the other kind
};

// of one particle, up to and including the shell at `reach`
inline std::vector<LatticeBond> lattice_bonds(Lattice lattice, double reach)
{
  static constexpr double SHELL = 1e-6;    // the reach is measured and carries rounding
  const LatticeCell cell = lattice_cell(lattice);
  int n[3];
  for (int k = 0; k < 3; k++) n[k] = static_cast<int>(reach / cell.edge[k]) + 1;
  std::vector<LatticeBond> found;
  for (int i = -n[0]; i <= n[0]; i++)
    for (int j = -n[1]; j <= n[1]; j++)
      for (int k = -n[2]; k <= n[2]; k++)
        for (const auto &site : cell.sites) {
          Vector3 d = {cell.edge[0] * (i + site.at[0]), cell.edge[1] * (j + site.at[1]),
                       cell.edge[2] * (k + site.at[2])};
          const double r = std::sqrt(dot(d, d));
          if (r == 0.0 || r > reach * (1.0 + SHELL)) continue;
          for (auto &component : d) component /= r;
          found.push_back({d, r, site.second});
        }
  return found;
}

// can a bond of this length (over the nearest distance) occur?
inline bool is_shell(Lattice lattice, double length, double tolerance)
{
  for (const auto &bond : lattice_bonds(lattice, length * (1.0 + tolerance)))
    if (std::fabs(bond.length - length) < tolerance * length) return true;
  return false;
}

struct LatticeAnswer {
  double area_factor;    // 0: a mechanism
  double poisson;
  int bonds;    // per particle
};

// reach: longest bond over spacing
inline LatticeAnswer lattice_area(Lattice lattice, double reach)
{
  static constexpr double SOFT = 1e-9;
  const LatticeCell cell = lattice_cell(lattice);
  const double volume = cell.edge[0] * cell.edge[1] * cell.edge[2] / cell.sites.size();
  const auto bonds = lattice_bonds(lattice, reach);
  Matrix3 normal{}, mixed{}, shift{};    // strains xx yy zz; with u; of u
  bool shifts = false;
  for (const auto &bond : bonds) {
    const Vector3 m = {bond.n[0] * bond.n[0], bond.n[1] * bond.n[1], bond.n[2] * bond.n[2]};
    add_dyad(normal, 0.5 * bond.length / volume, m, m);
    if (!bond.second) continue;
    shifts = true;
    add_dyad(mixed, 0.5 / volume, m, bond.n);
    add_dyad(shift, 0.5 / (volume * bond.length), bond.n, bond.n);
  }
  if (shifts && !cholesky(shift, 3)) return {0.0, 0.0, static_cast<int>(bonds.size())};
  if (shifts)
    for (auto &row : mixed) solve_lower(shift, row, 3);
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) normal[i][j] -= dot(mixed[i], mixed[j]);
  const double least = SOFT * normal[0][0];
  Matrix3 firm = normal;
  for (int i = 0; i < 3; i++) firm[i][i] -= least;
  if (!cholesky(firm, 3)) return {0.0, 0.0, static_cast<int>(bonds.size())};
  cholesky(normal, 3);
  Vector3 strain = {1.0, 0.0, 0.0};    // of the stress 1 along x
  solve_cholesky(normal, strain, 3);
  return {strain[0] / (0.25 * M_PI), -strain[1] / strain[0], static_cast<int>(bonds.size())};
}

}    // namespace POTDEM

#endif
