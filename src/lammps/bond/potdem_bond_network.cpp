/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/bond/potdem_bond_network.h"

#include "lammps/glue/fix_potdem_bond_history.h"

#include "atom.h"
#include "neighbor.h"

#include <algorithm>

using namespace LAMMPS_NS;

PotdemBondNetwork::PotdemBondNetwork(LAMMPS *lmp, int nstate) :
    Pointers(lmp), nstate(nstate), newer(false)
{
}

// LAMMPS lists the bonds by owned atom already; within one atom the ghosts go last. In bond_style hybrid its list may
// hold those of other styles
void PotdemBondNetwork::order(const std::vector<char> &ours, bool damped, bool scattered)
{
  int **list = neighbor->bondlist;
  const int nlist = neighbor->nbondlist, nlocal = atom->nlocal;
  first.assign(nlocal + 1, 0);
  ghosts.assign(nlocal, 0);
  for (int k = 0; k < nlist; k++) {
    if (list[k][2] <= 0 || !ours[list[k][2]]) continue;
    first[list[k][0] + 1]++;
    if (list[k][1] < nlocal) ghosts[list[k][0]]++;
  }
  for (int i = 0; i < nlocal; i++) {
    first[i + 1] += first[i];
    ghosts[i] += first[i];
  }
  const int n = first[nlocal];
  partner.resize(n);
  type.resize(n);
  std::vector<int> owned(first.begin(), first.end() - 1), ghost = ghosts;
  for (int k = 0; k < nlist; k++) {
    if (list[k][2] <= 0 || !ours[list[k][2]]) continue;
    const int i = list[k][0];
    const int at = list[k][1] < nlocal ? owned[i]++ : ghost[i]++;
    partner[at] = list[k][1];
    type[at] = list[k][2];
  }
  inverse_length2.resize(n);
  half_modulus.resize(n);
  dashpot.resize(damped ? n : 0);
  strength.resize(scattered ? n : 0);
  state.resize(n * static_cast<std::size_t>(nstate));
}

/* ---------------------------------------------------------------------- */

int PotdemBondNetwork::find_partner(int i, tagint tag) const
{
  for (int n = first[i]; n < first[i + 1]; n++)
    if (atom->tag[partner[n]] == tag) return n;
  return -1;
}

int PotdemBondNetwork::find(int i, int j) const
{
  const int n = find_partner(i, atom->tag[j]);
  return n >= 0 || j >= atom->nlocal ? n : find_partner(j, atom->tag[i]);
}

int PotdemBondNetwork::row_of(int n) const
{
  return static_cast<int>(std::upper_bound(first.begin(), first.end(), n) - first.begin()) - 1;
}

// a bond of zero stiffness and type 0 (which has no strength) until the list is rebuilt
void PotdemBondNetwork::cut(int i, tagint partner_tag, bool in_list)
{
  const int n = find_partner(i, partner_tag);
  if (n < 0) return;
  half_modulus[n] = 0.0;
  type[n] = 0;
  if (!dashpot.empty()) dashpot[n] = 0.0;
  if (in_list) listed(i, partner[n])[2] = 0;
}

// of LAMMPS's list, which is in the order of its first atoms, the row of this bond
int *PotdemBondNetwork::listed(int i, int j) const
{
  int **const begin = neighbor->bondlist, **const end = begin + neighbor->nbondlist;
  int **row = std::lower_bound(begin, end, i, [](const int *one, int first_atom) {
    return one[0] < first_atom;
  });
  while ((*row)[1] != j) row++;
  return *row;
}

/* ----------------------------------------------------------------------
   both ends of a bond remember it, each on the rank of its own
------------------------------------------------------------------------- */

void PotdemBondNetwork::take_state(const FixPotdemBondHistory &history)
{
  newer = false;
  if (nstate == 0) return;
  for (int i = 0; i < atom->nlocal; i++)
    for (int n = first[i]; n < first[i + 1]; n++)
      std::copy_n(history.state(i, history.slot(i, atom->tag[partner[n]])), nstate, state_of(n));
}

void PotdemBondNetwork::return_state(FixPotdemBondHistory &history)
{
  if (!newer) return;
  newer = false;
  const int nlocal = std::min(atom->nlocal, static_cast<int>(first.size()) - 1);
  for (int i = 0; i < nlocal; i++)
    for (int n = first[i]; n < first[i + 1]; n++) {
      if (type[n] == 0) continue;
      const int j = partner[n];
      const int ends[2] = {i, j}, others[2] = {j, i};
      for (int end = 0; end < 2; end++) {
        if (ends[end] >= atom->nlocal) continue;
        const int slot = history.slot(ends[end], atom->tag[others[end]]);
        if (slot >= 0) std::copy_n(state_of(n), nstate, history.state(ends[end], slot));
      }
    }
}

double PotdemBondNetwork::memory_usage() const
{
  const double doubles = inverse_length2.capacity() + half_modulus.capacity() + dashpot.capacity() +
      strength.capacity() + state.capacity();
  const double ints = first.capacity() + ghosts.capacity() + partner.capacity();
  return doubles * sizeof(double) + ints * sizeof(int) + type.capacity() * sizeof(Type);
}
