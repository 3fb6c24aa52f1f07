/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/glue/find_styles.h"

#include "lammps/glue/interfaces.h"

#include "bond_hybrid.h"
#include "pair_hybrid.h"

using namespace LAMMPS_NS;

// PairHybrid keeps its parts to itself and its heirs
struct HybridParts : public PairHybrid {
  using PairHybrid::keywords;
  using PairHybrid::nstyles;
  using PairHybrid::styles;
};

struct BondHybridParts : public BondHybrid {
  using BondHybrid::map;
};

std::vector<std::pair<Pair *, std::string>> LAMMPS_NS::potdem_pair_parts(const Force *force)
{
  if (!force->pair) return {};
  auto *const hybrid = dynamic_cast<PairHybrid *>(force->pair);
  if (!hybrid) return {{force->pair, force->pair_style}};
  std::vector<std::pair<Pair *, std::string>> found;
  for (int k = 0; k < hybrid->*&HybridParts::nstyles; k++)
    found.emplace_back((hybrid->*&HybridParts::styles)[k], (hybrid->*&HybridParts::keywords)[k]);
  return found;
}

std::vector<std::pair<Bond *, std::string>> LAMMPS_NS::potdem_bond_parts(const Force *force)
{
  if (!force->bond) return {};
  auto *const hybrid = dynamic_cast<BondHybrid *>(force->bond);
  if (!hybrid) return {{force->bond, force->bond_style}};
  std::vector<std::pair<Bond *, std::string>> found;
  for (int k = 0; k < hybrid->nstyles; k++)
    found.emplace_back(hybrid->styles[k], hybrid->keywords[k]);
  return found;
}

bool LAMMPS_NS::potdem_serves(const Force *force, const Bond *style, int bond_type)
{
  auto *const hybrid = dynamic_cast<BondHybrid *>(force->bond);
  if (!hybrid) return true;
  const int part = (hybrid->*&BondHybridParts::map)[bond_type];
  return part >= 0 && hybrid->styles[part] == style;
}

PotdemEnergies LAMMPS_NS::potdem_energies(LAMMPS *lmp)
{
  PotdemEnergies all;
  for (auto *const source : potdem_find<EnergySource>(lmp)) source->add_energy_to(all);
  return all;
}
