/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "cells.h"

#include "constants.h"

using namespace POTDEM;

std::vector<Vector3> POTDEM::spiral_directions(int n)
{
  std::vector<Vector3> directions(n);
  for (int k = 0; k < n; k++) {
    const double z = 1.0 - (2.0 * k + 1.0) / n, s = std::sqrt(1.0 - z * z);
    directions[k] = {s * std::cos(areas::GOLDEN_ANGLE * k), s * std::sin(areas::GOLDEN_ANGLE * k),
                     z};
  }
  return directions;
}

Cells::Cells(const BondedBody &bonded) :
    body(bonded), scale(diameter_scale()),
    largest_diameter(
        body.diameter.empty() ? 0.0 : *std::max_element(body.diameter.begin(), body.diameter.end()))
{
}

// spacing over diameter: mean over one of the shortest bonds of each particle, so that only the ratios of the diameters matter
double Cells::diameter_scale() const
{
  double total[2] = {0.0, 0.0};
  for (int i = 0; i < body.nowned; i++) {
    const auto neighbours = body.neighbours(i);
    if (neighbours.size() <= areas::SHORTEST) continue;
    const auto &chosen = neighbours[areas::SHORTEST];
    total[0] += body.alike[i] * 2.0 * body.bonds[chosen.bond].length /
        (body.diameter[i] + body.diameter[chosen.particle]);
    total[1] += body.alike[i];
  }
  body.halo.sum(total, 2);
  return total[1] > 0.0 ? total[0] / total[1] : 1.0;
}

Cell Cells::of(int i) const
{
  Cell cell;
  const double di = diameter(i), largest = scale * largest_diameter;
  for (const auto &to : body.neighbours(i)) {
    const auto &bond = body.bonds[to.bond];
    const auto nearness = [&bond, di](double d) {
      const double plane = 0.5 * bond.length + 0.125 * (di * di - d * d) / bond.length;
      return 1.0 / std::max(plane, areas::AT_CENTRE * bond.length);
    };
    const double over_plane = to.sign * nearness(diameter(to.particle));
    cell.sides.push_back({{over_plane * bond.n[0], over_plane * bond.n[1], over_plane * bond.n[2]},
                          nearness(largest)});
  }
  return cell;
}

double Cell::reach(const Vector3 &direction, double enough) const
{
  double nearness = 0.0;
  for (const auto &side : sides) {
    if (side.most < nearness || nearness * enough > 1.0) break;
    nearness = std::max(nearness, dot(direction, side.normal));
  }
  return nearness > 0.0 ? 1.0 / nearness : HUGE_VAL;
}

double Cell::volume(const std::vector<Vector3> &rays) const
{
  return volume_by_rays(rays, [this](const Vector3 &ray) {
    return reach(ray);
  });
}
