/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "dilatation.h"

#include "constants.h"

using namespace POTDEM;

namespace {

// 1/2 A L / V m: of a bond, in the strain of the particle at its end
Vector6 share(const BondedBody &body, const std::vector<double> &area, int bond, int particle)
{
  const auto &one = body.bonds[bond];
  Vector6 m = mandel(one.n, one.n);
  for (auto &component : m) component *= 0.5 * area[bond] * one.length / body.volume[particle];
  return m;
}

/* ----------------------------------------------------------------------
   g of the weights c = 1/2 A L / V m . g that make the sum of

     2 V c^2 / (A L) over the bonds, and EXACT_WEIGHT (sum c m - 1) . K (sum c m - 1)

   least, 1 the unit tensor: (K M + 1/EXACT_WEIGHT) g = K 1 with M = sum 1/2 A L / V m (x) m
------------------------------------------------------------------------- */

Vector6 fit(const BondedBody &body, const std::vector<double> &area, const Matrix6 &admissible,
            int i)
{
  Matrix6 stiffness{}, root = admissible;
  for (const auto &to : body.neighbours(i)) {
    const auto &n = body.bonds[to.bond].n;
    add_dyad(stiffness, 1.0, share(body, area, to.bond, i), mandel(n, n));
  }
  for (int a = 0; a < 6; a++) root[a][a] += areas::NO_STATE;
  cholesky(root, 6);
  Vector6 g{};
  for (int a = 0; a < 6; a++) {
    for (int b = a + 1; b < 6; b++) root[a][b] = 0.0;
    for (int k = 0; k < 3; k++) g[a] += root[k][a];
  }
  Matrix6 all = product(transposed(root), product(stiffness, root));
  for (int a = 0; a < 6; a++) all[a][a] += 1.0 / areas::EXACT_WEIGHT;
  cholesky(all, 6);
  solve_cholesky(all, g, 6);
  g = product(root, g);
  // sum of 2 V c^2 / (A L), times -kappa
  const double taken = -body.elasticity.volume_modulus() * dot(product(stiffness, g), g);
  if (taken > areas::LARGEST_SHARE)
    for (auto &component : g) component *= std::sqrt(areas::LARGEST_SHARE / taken);
  return g;
}

}    // namespace

Dilatation::Dilatation(const BondedBody &bonded, const std::vector<double> &area,
                       const std::vector<Matrix6> &admissible) :
    body(bonded)
{
  std::vector<Vector6> fits(body.nall, Vector6{});
  for (int i = 0; i < body.nowned; i++)
    if (body.bonded(i)) fits[i] = fit(body, area, admissible[i], i);
  body.forward(fits);
  weights.reserve(2 * body.bonds.size());
  for (std::size_t b = 0; b < body.bonds.size(); b++)
    for (const int i : {body.bonds[b].low, body.bonds[b].high})
      weights.push_back(dot(share(body, area, b, i), fits[i]));
}

std::vector<Vector3> Dilatation::pushes() const
{
  std::vector<Vector3> sums(body.nowned, Vector3{});
  for (int i = 0; i < body.nowned; i++)
    for (const auto &to : body.neighbours(i)) {
      const auto &bond = body.bonds[to.bond];
      const double force = (body.volume[bond.low] * weight(to.bond, 0) +
                            body.volume[bond.high] * weight(to.bond, 1)) /
          bond.length;
      for (int k = 0; k < 3; k++) sums[i][k] += to.sign * force * bond.n[k];
    }
  return sums;
}
