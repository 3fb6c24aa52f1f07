/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "surface_layer.h"

#include "constants.h"

using namespace POTDEM;

namespace {

double closeness(const BondedBody &body, int i, const BondedBody::Neighbour &to)
{
  const double q = body.bonds[to.bond].length * body.bonds[to.bond].length;
  return std::cbrt(body.volume[i] * body.volume[i]) / (q * q);
}

class Stencil {
 public:
  Matrix6 wanted{};    // one row for each component that is asked for

  Stencil() = default;
  Stencil(const BondedBody &, int i);
  void apply(const BondedBody &, int i, std::vector<Vector6> &layer);

 private:
  std::array<Vector3, 6> slope{};    // takes the first derivatives out of dx dx
  Matrix6 matrix{}, factor{};
};

Stencil::Stencil(const BondedBody &body, int i)
{
  Matrix3 gradient{};
  for (const auto &to : body.neighbours(i)) {
    const Vector3 dx = body.separation(to);
    const Vector6 m = mandel(dx, dx);
    const double g = closeness(body, i, to);
    add_dyad(gradient, g, dx, dx);
    add_dyad(slope, g, m, dx);
    add_dyad(matrix, g, m, m);
  }
  const double trace = gradient[0][0] + gradient[1][1] + gradient[2][2];
  for (int k = 0; k < 3; k++) gradient[k][k] += areas::FLAT * trace;
  cholesky(gradient, 3);
  double mean = 0.0;
  for (int c = 0; c < 6; c++) mean += matrix[c][c] / 6.0;
  const auto crossed = slope;
  for (int c = 0; c < 6; c++) solve_cholesky(gradient, slope[c], 3);
  for (int c = 0; c < 6; c++)
    for (int e = 0; e < 6; e++) matrix[c][e] -= dot(slope[c], crossed[e]);
  factor = matrix;
  for (int c = 0; c < 6; c++) {
    factor[c][c] += areas::RIDGE * mean;
    wanted[c][c] = body.volume[i];
  }
  cholesky(factor, 6);
}

// the weights for what is still wanted go into the layer
void Stencil::apply(const BondedBody &body, int i, std::vector<Vector6> &layer)
{
  Matrix6 answer = wanted;
  for (auto &row : answer) solve_cholesky(factor, row, 6);
  for (const auto &to : body.neighbours(i)) {
    const Vector3 dx = body.separation(to);
    Vector6 m = mandel(dx, dx);
    for (int c = 0; c < 6; c++) m[c] -= dot(slope[c], dx);
    const double g = closeness(body, i, to);
    for (int c = 0; c < 6; c++) {
      const double weight = g * dot(m, answer[c]);
      layer[to.particle][c] += weight;
      layer[i][c] -= weight;
    }
  }
  for (int c = 0; c < 6; c++)
    for (int e = 0; e < 6; e++) wanted[c][e] -= dot(answer[c], matrix[e]);
}

// what is still wanted goes to neighbours that are deeper inside
void hand_over(const BondedBody &body, const Surfaces &surfaces, int i, Matrix6 &wanted,
               std::vector<Matrix6> &handed)
{
  auto depth = [&](const BondedBody::Neighbour &to) {
    const double gain = surfaces.open[i] - surfaces.open[to.particle];
    return gain > areas::DEEPER ? closeness(body, i, to) * gain : 0.0;
  };
  double total = 0.0;
  for (const auto &to : body.neighbours(i)) total += depth(to);
  if (total == 0.0) return;
  for (const auto &to : body.neighbours(i)) add(handed[to.particle], depth(to) / total, wanted);
  wanted = Matrix6{};
}

}    // namespace

std::vector<Vector6> POTDEM::surface_layer(const BondedBody &body, const Surfaces &surfaces)
{
  std::vector<Stencil> stencils(body.nowned);
  for (int i = 0; i < body.nowned; i++)
    if (body.bonded(i)) stencils[i] = Stencil(body, i);

  std::vector<Vector6> layer(body.nall, Vector6{});
  std::vector<Matrix6> handed(body.nall);
  for (int round = 0; round < areas::HANDING_ROUNDS; round++) {
    std::fill(handed.begin(), handed.end(), Matrix6{});
    for (int i = 0; i < body.nowned; i++)
      if (body.bonded(i)) {
        stencils[i].apply(body, i, layer);
        hand_over(body, surfaces, i, stencils[i].wanted, handed);
      }
    body.reverse(handed);
    for (int i = 0; i < body.nowned; i++) add(stencils[i].wanted, 1.0, handed[i]);
  }
  body.reverse(layer);
  return layer;
}
