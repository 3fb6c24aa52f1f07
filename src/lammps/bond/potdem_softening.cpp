/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/bond/potdem_softening.h"

#include "core/laws/truss.h"
#include "lammps/glue/fix_potdem_bond_history.h"

#include "atom.h"
#include "math_extra.h"

#include <algorithm>

using namespace LAMMPS_NS;

PotdemSoftening::PotdemSoftening(LAMMPS *lmp, const PotdemBondNetwork &network) :
    Pointers(lmp), network(network)
{
}

void PotdemSoftening::make_room(const FixPotdemBondHistory &history)
{
  bonds.clear();
  ended.clear();
  among.assign(history.keeps_softening() ? network.size() : 0, 0);
}

void PotdemSoftening::take(int i, int n, const POTDEM::Softening &law)
{
  if (!law.begun()) return;
  bonds.push_back({i, n, law, 1.0});
  among[n] = 1;
}

std::vector<PotdemSoftening::Bond>::const_iterator PotdemSoftening::place(int n) const
{
  return std::lower_bound(bonds.begin(), bonds.end(), n, [](const Bond &one, int packed) {
    return one.n < packed;
  });
}

/* ---------------------------------------------------------------------- */

void PotdemSoftening::add(FixPotdemBondHistory &history, int i, int j, const POTDEM::Softening &law)
{
  const int n = network.find(i, j);
  if (n < 0 || among[n]) return;
  const Bond bond{network.row_of(n), n, law, 1.0};
  bonds.insert(place(n), bond);
  among[n] = 1;
  remember(history, bond);
}

void PotdemSoftening::remove(int i, tagint partner)
{
  const int n = network.find(i, atom->map(partner));
  if (n < 0 || !is_among(n)) return;
  bonds.erase(place(n));
  among[n] = 0;
}

void PotdemSoftening::follow(FixPotdemBondHistory &history, bool grows)
{
  ended.clear();
  for (auto &bond : bonds) {
    double del[3];
    MathExtra::sub3(atom->x[network.partner[bond.n]], atom->x[bond.i], del);
    bond.q = MathExtra::lensq3(del) * network.inverse_length2[bond.n];
    if (!grows) continue;
    const double damage = bond.law.after(POTDEM::truss_strain(bond.q));
    if (damage > bond.law.damage) {
      bond.law.damage = damage;
      remember(history, bond);
    }
    if (bond.law.spent())
      ended.push_back({bond.i, network.partner[bond.n], network.type[bond.n], bond.n, true});
  }
}

// at each end that this rank owns
void PotdemSoftening::remember(FixPotdemBondHistory &history, const Bond &bond) const
{
  const int i = bond.i, j = network.partner[bond.n];
  history.store_softening(i, history.slot(i, atom->tag[j]), bond.law);
  if (j < atom->nlocal) history.store_softening(j, history.slot(j, atom->tag[i]), bond.law);
}

/* ---------------------------------------------------------------------- */

const PotdemSoftening::Bond *PotdemSoftening::begin(int from) const
{
  return std::lower_bound(bonds.data(), bonds.data() + bonds.size(), from,
                          [](const Bond &one, int atom_wanted) {
                            return one.i < atom_wanted;
                          });
}

bool PotdemSoftening::counts(const Bond &bond) const
{
  const int j = network.partner[bond.n];
  return j < atom->nlocal || atom->tag[bond.i] < atom->tag[j];
}

double PotdemSoftening::lost_energy(int type) const
{
  double sum = 0.0;
  for (const auto &bond : bonds)
    if (network.type[bond.n] == type && counts(bond))
      sum += bond.law.lost() * network.modulus(bond.n) * network.length(bond.n);
  return sum;
}

int PotdemSoftening::count(int type) const
{
  return static_cast<int>(std::count_if(bonds.begin(), bonds.end(), [&](const Bond &bond) {
    return network.type[bond.n] == type && counts(bond);
  }));
}
