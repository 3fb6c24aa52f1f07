/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "bonded_body.h"

using namespace POTDEM;

void BondedBody::list_neighbours()
{
  if (alike.empty()) alike.assign(nowned, 1.0);
  first.assign(nowned + 1, 0);
  for (const auto &bond : bonds)
    for (const int i : {bond.low, bond.high})
      if (i < nowned) first[i + 1]++;
  for (int i = 0; i < nowned; i++) first[i + 1] += first[i];
  list.resize(first[nowned]);
  std::vector<int> at(first.begin(), first.end() - 1);
  for (std::size_t b = 0; b < bonds.size(); b++) {
    const auto &bond = bonds[b];
    if (bond.low < nowned) list[at[bond.low]++] = {static_cast<int>(b), bond.high, 1.0};
    if (bond.high < nowned) list[at[bond.high]++] = {static_cast<int>(b), bond.low, -1.0};
  }
  // the nearest first: they end most rays
  for (int i = 0; i < nowned; i++)
    std::sort(list.begin() + first[i], list.begin() + first[i + 1],
              [this](const Neighbour &a, const Neighbour &b) {
                return bonds[a.bond].length != bonds[b.bond].length
                    ? bonds[a.bond].length < bonds[b.bond].length
                    : id[a.particle] < id[b.particle];
              });
}
