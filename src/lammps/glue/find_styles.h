/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The styles in use that offer an interface (interfaces.h): pair styles and bond styles, those of hybrid too, then fixes. */

#ifndef LMP_POTDEM_FIND_STYLES_H
#define LMP_POTDEM_FIND_STYLES_H

#include "bond.h"
#include "fix.h"
#include "force.h"
#include "lammps.h"
#include "modify.h"
#include "pair.h"

#include <string>
#include <utility>
#include <vector>

namespace LAMMPS_NS {

// the styles of hybrid, or the one that there is: (style, name)
std::vector<std::pair<Pair *, std::string>> potdem_pair_parts(const Force *);
std::vector<std::pair<Bond *, std::string>> potdem_bond_parts(const Force *);

// whether hybrid, if there is one, gives this style the bonds of this type
bool potdem_serves(const Force *, const Bond *style, int bond_type);

template <class Offered, class Style>
void potdem_add_if_offered(std::vector<Offered *> &found, Style *style)
{
  if (auto *const one = dynamic_cast<Offered *>(style)) found.push_back(one);
}

template <class Offered> std::vector<Offered *> potdem_find(LAMMPS *lmp)
{
  std::vector<Offered *> found;
  for (const auto &part : potdem_pair_parts(lmp->force)) potdem_add_if_offered(found, part.first);
  for (const auto &part : potdem_bond_parts(lmp->force)) potdem_add_if_offered(found, part.first);
  for (auto *const fix : lmp->modify->get_fix_list()) potdem_add_if_offered(found, fix);
  return found;
}

struct PotdemEnergies potdem_energies(LAMMPS *);    // of all EnergySources

}    // namespace LAMMPS_NS

#endif
