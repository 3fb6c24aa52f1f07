/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "targets.h"

#include "constants.h"
#include "surface_layer.h"

using namespace POTDEM;

BulkMoments::BulkMoments(const BondedBody &body, const Surfaces &surfaces,
                         const LeastSquares &squares, int ends_inside) :
    stiff(false),
    sixth{}
{
  std::array<Matrix6, 7> total{};    // the last one: fourth moments
  for (std::size_t b = 0; b < body.bonds.size(); b++) {
    const auto &bond = body.bonds[b];
    const int ends = (surfaces.open[bond.low] == 0.0) + (surfaces.open[bond.high] == 0.0);
    if (ends < ends_inside) continue;
    const Vector6 m = mandel(bond.n, bond.n);
    const double work = bond.counted * 0.5 * squares.area(b) * bond.length;
    for (int l = 0; l < 6; l++)
      add_dyad(total[l], 0.25 * work * bond.length * bond.length * m[l], m, m);
    add_dyad(total[6], work, m, m);
  }
  body.halo.sum(&total[0][0][0], 7 * 36);
  const Matrix6 stiffness = isotropic_stiffness(areas::POISSON);
  double trace = 0.0, wanted = 0.0;
  for (int k = 0; k < 6; k++) {
    trace += total[6][k][k];
    wanted += stiffness[k][k];
  }
  if (!(trace > 0.0)) return;
  for (auto &matrix : total)
    for (auto &row : matrix)
      for (auto &value : row) value *= wanted / trace;
  std::copy_n(total.begin(), 6, sixth.begin());
  for (int k = 0; k < 6; k++) total[6][k][k] -= areas::SOFT;
  stiff = cholesky(total[6], 6);
}

namespace {

/* ----------------------------------------------------------------------
   the energy that the surface layer asks for, in the states without traction along the layer's principal directions, as far as
   it has a share in them
------------------------------------------------------------------------- */

Matrix6 without_traction(const Vector6 &layer)
{
  Vector3 value, kept;
  Matrix3 axis;
  eigen3(tensor(layer), value, axis);
  const double largest = std::max(std::fabs(value[0]), std::fabs(value[2]));
  for (int k = 0; k < 3; k++) kept[k] = 1.0 - value[k] * value[k] / (largest * largest);
  Matrix6 left{};
  for (int k = 0; k < 3; k++)
    for (int l = k; l < 3; l++) {
      const Vector6 state = mandel(axis[k], axis[l]);
      add_dyad(left, kept[k] * kept[l] / dot(state, state), state, state);
    }
  return left;
}

Matrix6 layer_energy(const Vector6 &layer, double cell, const std::array<Matrix6, 6> &sixth,
                     const Elasticity &elasticity)
{
  const Matrix6 stiffness = elasticity.stiffness(), compliance = elasticity.compliance();
  Matrix6 change{};
  for (int a = 0; a < 6; a++)
    for (int b = 0; b < 6; b++) {
      change[a][b] = (layer[0] + layer[1] + layer[2]) * cell * stiffness[a][b];
      for (int c = 0; c < 6; c++) change[a][b] += layer[c] * sixth[c][a][b];
    }
  // strain -> strain of the stress that is left
  const Matrix6 left = product(compliance, product(without_traction(layer), stiffness));
  return product(transposed(left), product(change, left));
}

}    // namespace

Targets::Targets(const BondedBody &bonded, const Surfaces &free_surfaces) :
    body(bonded), surfaces(free_surfaces),
    energy(bonded.nowned, isotropic_stiffness(areas::POISSON)), request(energy)
{
}

// along any direction, mean of the inner cells
double Targets::cell_variance() const
{
  double mean[2] = {0.0, 0.0};
  for (int i = 0; i < body.nowned; i++)
    if (surfaces.inside(body, i)) {
      mean[0] += body.alike[i] * std::cbrt(body.volume[i] * body.volume[i]);
      mean[1] += body.alike[i];
    }
  body.halo.sum(mean, 2);
  return mean[0] / mean[1] / areas::SQUARE_OVER_VARIANCE;
}

bool Targets::correct(const LeastSquares &squares, const std::vector<Matrix6> &admissible)
{
  BulkMoments bulk(body, surfaces, squares, 2);
  // three particles through the depth: no bond has both ends inside
  if (!bulk.stiff) bulk = BulkMoments(body, surfaces, squares, 1);
  if (!bulk.stiff) return false;
  const double cell = cell_variance();
  const auto layers = surface_layer(body, surfaces);
  for (int i = 0; i < body.nowned; i++) {
    if (!body.bonded(i)) continue;
    Vector6 layer;
    for (int c = 0; c < 6; c++) layer[c] = layers[i][c] / body.volume[i];
    if (dot(layer, layer) * cell * cell < areas::NO_LAYER * areas::NO_LAYER) continue;
    const Matrix6 change = layer_energy(layer, cell, bulk.sixth, body.elasticity);
    const Matrix6 seen = product(admissible[i], change);
    const double size2 = trace_of_product(seen, seen), limit = areas::LARGEST_CHANGE;
    add(energy[i], size2 > limit * limit ? limit / std::sqrt(size2) : 1.0, change);
  }
  request = energy;
  return true;
}

void Targets::ask_for_missing(LeastSquares &squares)
{
  const auto missing = squares.misfits(&energy);
  for (int i = 0; i < body.nowned; i++)
    if (body.bonded(i)) add(request[i], -1.0, missing[i].energy);
}
