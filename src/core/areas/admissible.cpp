/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "admissible.h"

#include "constants.h"

using namespace POTDEM;

namespace {

// mean of the blocked directions over the particles nearby (as often as there are ways to them), weighted with their volumes
std::vector<Matrix3> surfaces_nearby(const BondedBody &body, const Surfaces &surfaces)
{
  static constexpr int VOLUME = 9, WIDTH = 10;
  typedef std::array<double, WIDTH> Sum;
  std::vector<Sum> sums(body.nall, Sum{});
  for (int i = 0; i < body.nowned; i++) {
    for (int k = 0; k < 9; k++) sums[i][k] = body.volume[i] * surfaces.blocked[i][k / 3][k % 3];
    sums[i][VOLUME] = body.volume[i];
  }
  for (int round = 0; round < areas::NEARBY_BONDS; round++) {
    body.forward(sums);
    const auto last = sums;
    for (int i = 0; i < body.nowned; i++)
      for (const auto &to : body.neighbours(i))
        for (int k = 0; k < WIDTH; k++) sums[i][k] += last[to.particle][k];
  }
  std::vector<Matrix3> mean(body.nowned);
  for (int i = 0; i < body.nowned; i++)
    for (int k = 0; k < 9; k++) mean[i][k / 3][k % 3] = sums[i][k] / sums[i][VOLUME];
  return mean;
}

struct Axes {
  int free;          // number of directions without a free surface; they come last
  Vector3 bonded;    // second moment of the bonds along each, less the surfaces nearby
  Matrix3 axis;
};

Axes free_axes(const BondedBody &body, const Matrix3 &blocked, const Matrix3 &nearby,
               const UniformAreas &uniform, int i)
{
  Matrix3 second{}, inward{};
  double free = 0.0;
  for (int k = 0; k < 3; k++) {
    for (int l = 0; l < 3; l++) inward[k][l] = (k == l) - blocked[k][l];
    free += inward[k][k];
  }
  for (const auto &to : body.neighbours(i)) {
    const auto &bond = body.bonds[to.bond];
    add_dyad(second, 0.25 * uniform.area[to.bond] * bond.length / body.volume[i], bond.n, bond.n);
  }
  for (int k = 0; k < 3; k++)
    for (int l = 0; l < 3; l++) second[k][l] -= areas::NEARBY * nearby[k][l];
  second = product(inward, product(second, inward));
  for (int k = 0; k < 3; k++)
    for (int l = 0; l < 3; l++) second[k][l] -= areas::BEHIND * blocked[k][l];
  Axes axes;
  axes.free = static_cast<int>(std::lround(free));
  eigen3(second, axes.bonded, axes.axis);
  return axes;
}

// from the second moment along a direction over the largest
double trust(double bonded)
{
  const double share = (bonded - areas::CUT_OFF) / (areas::COMPLETE - areas::CUT_OFF);
  return std::pow(std::clamp(share, areas::FLOOR, 1.0), 2);
}

}    // namespace

std::vector<Matrix6> POTDEM::admissible_strains(const BondedBody &body, const Surfaces &surfaces,
                                                const UniformAreas &uniform)
{
  const Matrix6 compliance = body.elasticity.compliance();
  const auto nearby = surfaces_nearby(body, surfaces);
  std::vector<Matrix6> admissible(body.nowned, Matrix6{});
  for (int i = 0; i < body.nowned; i++) {
    if (!body.bonded(i)) continue;
    const Axes axes = free_axes(body, surfaces.blocked[i], nearby[i], uniform, i);
    // where two directions are alike, no matter which axes they are given
    std::vector<StressState> states;
    for (int k = 3 - axes.free; k < 3; k++)
      for (int l = k; l < 3; l++)
        states.push_back(
            {trust(axes.bonded[l] / axes.bonded[2]), mandel(axes.axis[k], axes.axis[l])});
    if (axes.free == 1) {    // an edge
      const Vector3 around = cross(axes.axis[2], surfaces.outward[i]);
      if (dot(around, around) > 0.0) states.push_back({1.0, mandel(axes.axis[2], around)});
    }
    admissible[i] = energy_norm(states, compliance);
  }
  return admissible;
}

Matrix6 POTDEM::energy_norm(std::vector<StressState> states, const Matrix6 &compliance)
{
  std::stable_sort(states.begin(), states.end(), [](const StressState &a, const StressState &b) {
    return a.trust > b.trust;
  });
  Matrix6 sum{};
  for (std::size_t k = 0; k < states.size(); k++) {
    Vector6 &stress = states[k].stress;
    for (std::size_t l = 0; l < k; l++) {
      const double share = dot(product(compliance, states[l].stress), stress);
      for (int c = 0; c < 6; c++) stress[c] -= share * states[l].stress[c];
    }
    const double norm = std::sqrt(dot(product(compliance, stress), stress));
    for (auto &component : stress) component /= norm;
    const Vector6 strain = product(compliance, stress);
    add_dyad(sum, states[k].trust * states[k].trust, strain, strain);
  }
  return sum;
}
