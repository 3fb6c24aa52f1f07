/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "surfaces.h"

#include "constants.h"

using namespace POTDEM;

namespace {

struct OpenRays {
  double share = 0.0;    // of all rays
  Vector3 mean{};
  Matrix3 second{};    // moment, over all rays
};

OpenRays open_rays(const Cells &cells, int i, const std::vector<Vector3> &rays)
{
  const double gap = areas::OPEN_FROM * cells.diameter(i), one = 1.0 / rays.size();
  const Cell cell = cells.of(i);
  OpenRays found;
  int count = 0;
  for (const auto &ray : rays)
    if (cell.reach(ray, gap) > gap) {
      add_dyad(found.second, one, ray, ray);
      for (int k = 0; k < 3; k++) found.mean[k] += one * ray[k];
      count++;
    }
  if (count < areas::PORE) return {};
  found.share = count * one;
  return found;
}

// the first n are the directions that carry no traction
struct Blocked {
  int n = 0;
  std::array<Vector3, 3> along;
};

Blocked principal(const Matrix3 &moment, double least)
{
  Vector3 value;
  Matrix3 axis;
  eigen3(moment, value, axis);
  Blocked found;
  for (int k = 2; k >= 0; k--) {
    found.along[2 - k] = axis[k];
    if (value[k] > least) found.n++;
  }
  return found;
}

// the directions of the surface around a particle, by the means of the open rays of it and its neighbours
Blocked around(const BondedBody &body, const std::vector<Vector3> &outward, int i)
{
  Matrix3 moment{};
  double total = 0.0;
  const auto take = [&](const Vector3 &mean) {
    const double size = std::sqrt(dot(mean, mean));
    if (size == 0.0) return;
    add_dyad(moment, 1.0 / size, mean, mean);
    total += size;
  };
  take(outward[i]);
  for (const auto &to : body.neighbours(i)) take(outward[to.particle]);
  return principal(moment, areas::EDGE_SPREAD * total);
}

}    // namespace

/* ----------------------------------------------------------------------
   One direction is blocked, and the rays go to one side of it: the particle is on a face
------------------------------------------------------------------------- */

Surfaces::Surfaces(const BondedBody &body, const Cells &cells) :
    open(body.nall, 0.0), outward(body.nall, Vector3{}), normal(body.nall, Vector3{}),
    blocked(body.nowned, Matrix3{})
{
  const auto rays = spiral_directions(areas::SURFACE_RAYS);
  std::vector<Matrix3> second(body.nowned);
  for (int i = 0; i < body.nowned; i++) {
    const OpenRays found = open_rays(cells, i, rays);
    open[i] = found.share;
    outward[i] = found.mean;
    second[i] = found.second;
  }
  body.forward(open);
  body.forward(outward);
  for (int i = 0; i < body.nowned; i++) {
    if (open[i] == 0.0) continue;
    Blocked found = principal(second[i], areas::BLOCKED_SHARE * open[i]);
    if (found.n > 1) {
      const Blocked wider = around(body, outward, i);
      if (wider.n > 0 && wider.n < found.n) found = wider;
    }
    for (int k = 0; k < found.n; k++) add_dyad(blocked[i], 1.0, found.along[k], found.along[k]);
    const double out = dot(outward[i], found.along[0]);
    if (found.n > 1 || std::fabs(out) < areas::ONE_SIDE * open[i]) continue;
    for (int k = 0; k < 3; k++) normal[i][k] = out > 0.0 ? found.along[0][k] : -found.along[0][k];
  }
  body.forward(normal);
}
