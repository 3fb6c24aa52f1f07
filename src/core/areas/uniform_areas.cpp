/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "uniform_areas.h"

#include "constants.h"

using namespace POTDEM;

UniformAreas::UniformAreas(const BondedBody &body, const Surfaces &surfaces) :
    area(body.bonds.size()), factor(0.0)
{
  for (std::size_t b = 0; b < body.bonds.size(); b++) {
    const auto &bond = body.bonds[b];
    const double d = 0.5 * (body.diameter[bond.low] + body.diameter[bond.high]);
    area[b] = d * d;
  }
  double total[3] = {0.0, 0.0, 0.0};
  for (int i = 0; i < body.nowned; i++) {
    if (!body.bonded(i)) continue;
    total[2] += body.volume[i];
    if (!surfaces.inside(body, i)) continue;
    total[0] += areas::SOLID_TRACE * body.volume[i];
    for (const auto &to : body.neighbours(i))
      total[1] += 0.5 * area[to.bond] * body.bonds[to.bond].length;
  }
  body.halo.sum(total, 3);
  volume = total[2];
  if (!(total[1] > 0.0)) return;
  factor = total[0] / total[1];
  for (auto &value : area) value *= factor;
}
