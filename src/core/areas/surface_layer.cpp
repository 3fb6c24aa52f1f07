/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "surface_layer.h"

#include "constants.h"

using namespace POTDEM;

namespace {

double closeness(const BondedBody &body, const BondedBody::Neighbour &to)
{
  const double q = body.bonds[to.bond].length * body.bonds[to.bond].length;
  return 1.0 / (q * q);
}

// the weights that a particle gives are closeness (found m - along dx)
struct Weights {
  Matrix6 found;
  std::array<Vector3, 6> along;
};

class Stencil {
 public:
  Matrix6 wanted{};    // one row for each component that is asked for

  Stencil() = default;
  Stencil(const BondedBody &, int i);
  void solve();    // for what is still wanted
  Weights weights() const;

 private:
  std::array<Vector3, 6> slope{};    // takes the first derivatives out of dx dx
  Matrix6 matrix{}, factor{}, found{};
};

Stencil::Stencil(const BondedBody &body, int i)
{
  Matrix3 gradient{};
  for (const auto &to : body.neighbours(i)) {
    const Vector3 dx = body.separation(to);
    const Vector6 m = mandel(dx, dx);
    const double g = closeness(body, to);
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

void Stencil::solve()
{
  Matrix6 answer = wanted;
  for (auto &row : answer) solve_cholesky(factor, row, 6);
  add(found, 1.0, answer);
  add(wanted, -1.0, product(answer, matrix));
}

Weights Stencil::weights() const
{
  Weights weights{found, {}};
  for (int c = 0; c < 6; c++)
    for (int e = 0; e < 6; e++)
      for (int k = 0; k < 3; k++) weights.along[c][k] += found[c][e] * slope[e][k];
  return weights;
}

// what is still wanted goes to neighbours that are deeper inside
class Handing {
 public:
  Handing(const BondedBody &, const Surfaces &);
  void hand_over(std::vector<Stencil> &);

 private:
  struct Parcel {
    Matrix6 wanted;
    double depths;    // of all receivers; 0: there are none
  };

  const BondedBody &body;
  const Surfaces &surfaces;
  std::vector<Parcel> parcels;

  double depth(int from, int to, const BondedBody::Neighbour &bond) const
  {
    const double gain = surfaces.open[from] - surfaces.open[to];
    return gain > areas::DEEPER ? closeness(body, bond) * gain : 0.0;
  }
};

Handing::Handing(const BondedBody &bonded, const Surfaces &free_surfaces) :
    body(bonded), surfaces(free_surfaces), parcels(bonded.nall)
{
  for (int i = 0; i < body.nowned; i++)
    for (const auto &to : body.neighbours(i)) parcels[i].depths += depth(i, to.particle, to);
}

void Handing::hand_over(std::vector<Stencil> &stencils)
{
  for (int i = 0; i < body.nowned; i++) {
    if (parcels[i].depths == 0.0) continue;
    parcels[i].wanted = stencils[i].wanted;
    stencils[i].wanted = Matrix6{};
  }
  body.forward(parcels);
  for (int i = 0; i < body.nowned; i++)
    for (const auto &to : body.neighbours(i)) {
      const double share = depth(to.particle, i, to);
      if (share == 0.0) continue;
      const Parcel &parcel = parcels[to.particle];
      add(stencils[i].wanted, share / parcel.depths, parcel.wanted);
    }
}

Vector6 received_less_given(const BondedBody &body, const std::vector<Weights> &weights, int i)
{
  Vector6 layer{};
  for (const auto &to : body.neighbours(i)) {
    const Vector3 dx = body.separation(to);
    const Vector6 m = mandel(dx, dx);
    const double g = closeness(body, to);
    const Weights &mine = weights[i], &others = weights[to.particle];
    for (int c = 0; c < 6; c++) {
      const double given = dot(mine.found[c], m) - dot(mine.along[c], dx);
      const double received = dot(others.found[c], m) + dot(others.along[c], dx);
      layer[c] += g * (received - given);
    }
  }
  return layer;
}

}    // namespace

std::vector<Vector6> POTDEM::surface_layer(const BondedBody &body, const Surfaces &surfaces)
{
  std::vector<Stencil> stencils(body.nowned);
  for (int i = 0; i < body.nowned; i++)
    if (body.bonded(i)) stencils[i] = Stencil(body, i);

  Handing handing(body, surfaces);
  for (int round = 0; round < areas::HANDING_ROUNDS; round++) {
    for (int i = 0; i < body.nowned; i++)
      if (body.bonded(i)) stencils[i].solve();
    handing.hand_over(stencils);
  }

  std::vector<Weights> weights(body.nall);
  for (int i = 0; i < body.nowned; i++) weights[i] = stencils[i].weights();
  body.forward(weights);
  std::vector<Vector6> layer(body.nowned);
  for (int i = 0; i < body.nowned; i++) layer[i] = received_less_given(body, weights, i);
  return layer;
}
