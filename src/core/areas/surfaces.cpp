/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "surfaces.h"

#include "constants.h"

using namespace POTDEM;

namespace {

struct OpenRays {
  int count = 0;
  Vector3 sum{};
  Matrix3 second{};    // moment, over all rays
};

OpenRays open_rays(const Cells &cells, int i, const std::vector<Vector3> &rays)
{
  const double gap = areas::OPEN_FROM * cells.diameter(i);
  const Cell cell = cells.of(i);
  OpenRays found;
  for (const auto &ray : rays)
    if (cell.reach(ray, gap) > gap) {
      add_dyad(found.second, 1.0 / rays.size(), ray, ray);
      for (int k = 0; k < 3; k++) found.sum[k] += ray[k];
      found.count++;
    }
  return found;
}

}    // namespace

/* ----------------------------------------------------------------------
   The directions in which the open rays' second moment is large are blocked. One of them, and the rays go to one side of it:
   the particle is on a face
------------------------------------------------------------------------- */

Surfaces::Surfaces(const BondedBody &body, const Cells &cells) :
    open(body.nall, 0.0), normal(body.nall, Vector3{}), blocked(body.nowned, Matrix3{})
{
  const auto rays = spiral_directions(areas::SURFACE_RAYS);
  for (int i = 0; i < body.nowned; i++) {
    const OpenRays found = open_rays(cells, i, rays);
    if (found.count < areas::PORE) continue;
    open[i] = static_cast<double>(found.count) / areas::SURFACE_RAYS;
    Vector3 value;
    Matrix3 axis;
    eigen3(found.second, value, axis);
    for (int k = 0; k < 3; k++)
      if (value[k] > areas::BLOCKED_SHARE * open[i]) add_dyad(blocked[i], 1.0, axis[k], axis[k]);
    const double outward = dot(found.sum, axis[2]);
    if (value[1] > areas::BLOCKED_SHARE * open[i] ||
        std::fabs(outward) < areas::ONE_SIDE * found.count)
      continue;
    for (int k = 0; k < 3; k++) normal[i][k] = outward > 0.0 ? axis[2][k] : -axis[2][k];
  }
  body.forward(open);
  body.forward(normal);
}
