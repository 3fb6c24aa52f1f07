/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "uniform_areas.h"

#include "constants.h"

using namespace POTDEM;

namespace {

std::vector<double> squares(const BondedBody &body, double factor)
{
  std::vector<double> area;
  area.reserve(body.bonds.size());
  for (const auto &bond : body.bonds) {
    const double d = 0.5 * (body.diameter[bond.low] + body.diameter[bond.high]);
    area.push_back(factor * d * d);
  }
  return area;
}

}    // namespace

UniformAreas::UniformAreas(const BondedBody &body, const UniformAreas &like) :
    area(squares(body, like.factor)), factor(like.factor), volume(like.volume)
{
}

UniformAreas::UniformAreas(const BondedBody &body, const Surfaces &surfaces) :
    area(squares(body, 1.0)), factor(0.0)
{
  double total[3] = {0.0, 0.0, 0.0};
  for (int i = 0; i < body.nowned; i++) {
    if (!body.bonded(i)) continue;
    const double n = body.alike[i];
    total[2] += n * body.volume[i];
    if (!surfaces.inside(body, i)) continue;
    total[0] += n * areas::SOLID_TRACE * body.volume[i];
    for (const auto &to : body.neighbours(i))
      total[1] += n * 0.5 * area[to.bond] * body.bonds[to.bond].length;
  }
  body.halo.sum(total, 3);
  volume = total[2];
  if (!(total[1] > 0.0)) return;
  factor = total[0] / total[1];
  for (auto &value : area) value *= factor;
}
