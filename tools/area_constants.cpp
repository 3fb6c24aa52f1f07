/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

// areas of one body by `area body`, without LAMMPS, for tools/area_constants.py. The argument: Poisson's ratio.
// in: particles, bonds, "x y z d v" of each particle, "i j" of each bond; out: of each bond the area and its weight in the dilatation of its
// low and of its high end, then the volume of each particle; nothing where refused

#include "body_area.h"

#include <cstdio>
#include <cstdlib>

int main(int argc, char **argv)
{
  int n, count;
  if (std::scanf("%d %d", &n, &count) != 2) return 1;
  POTDEM::BodyHalo alone;
  POTDEM::BondedBody body(alone);
  if (argc > 1) body.elasticity.poisson = std::atof(argv[1]);
  body.nowned = body.nall = n;
  std::vector<POTDEM::Vector3> at(n);
  body.diameter.resize(n);
  body.volume.resize(n);
  for (int i = 0; i < n; i++) {
    if (std::scanf("%lf %lf %lf %lf %lf", &at[i][0], &at[i][1], &at[i][2], &body.diameter[i],
                   &body.volume[i]) != 5)
      return 1;
    body.id.push_back(i + 1);
  }
  for (int k = 0; k < count; k++) {
    POTDEM::BondedBody::Bond bond{};
    if (std::scanf("%d %d", &bond.low, &bond.high) != 2) return 1;
    for (int c = 0; c < 3; c++) bond.n[c] = at[bond.high][c] - at[bond.low][c];
    bond.length = std::sqrt(POTDEM::dot(bond.n, bond.n));
    for (auto &component : bond.n) component /= bond.length;
    bond.counted = true;
    body.bonds.push_back(bond);
  }
  if (POTDEM::find_body_areas(body).outcome != POTDEM::BodyAreaReport::DONE) return 0;
  for (const auto &bond : body.bonds)
    std::printf("%.17g %.17g %.17g\n", bond.area, bond.dilatation[0], bond.dilatation[1]);
  for (const double volume : body.volume) std::printf("%.17g\n", volume);
  return 0;
}
