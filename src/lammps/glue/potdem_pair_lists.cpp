/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/glue/potdem_pair_lists.h"

#include "atom.h"
#include "domain.h"
#include "fix_neigh_history.h"
#include "force.h"
#include "modify.h"
#include "neigh_list.h"
#include "neigh_request.h"
#include "neighbor.h"
#include "npair.h"
#include "pair.h"

#include <algorithm>
#include <set>

using namespace LAMMPS_NS;

// LAMMPS keeps these to itself and its heirs
struct RequestParts : public NeighRequest {
  using NeighRequest::full;
  using NeighRequest::newton;
};

struct BuilderParts : public NPair {
  using NPair::exclusion;
};

/* ---------------------------------------------------------------------- */

void PotdemPairLists::add(tagint first, tagint second)
{
  std::set<int **> done;    // lists that are copies share their rows
  for (int n = 0; n < neighbor->nlist; n++) {
    auto *const list = neighbor->lists[n];
    if (list->requestor_type != NeighList::PAIR || list->occasional) continue;
    if (done.insert(list->firstneigh).second) add_to(list, first, second);
  }
}

// a full list has the pair in the rows of both, a half one once: if the second particle is a ghost, only with newton on
void PotdemPairLists::add_to(NeighList *list, tagint first, tagint second)
{
  const auto *const request = neighbor->old_requests[list->index];
  const int own_newton = request->*&RequestParts::newton;
  const bool full = request->*&RequestParts::full;
  const bool newton = own_newton == 0 ? force->newton_pair : own_newton == 1;
  const int i = atom->map(first), j = atom->map(second);
  if (i >= 0 && i < atom->nlocal) append(list, i, domain->closest_image(i, j));
  if (j < 0 || j >= atom->nlocal || (newton && !full)) return;
  const int image = domain->closest_image(j, i);
  if (full || image >= atom->nlocal) append(list, j, image);
}

/* ---------------------------------------------------------------------- */

bool PotdemPairLists::leaves_out(const NeighList *list, int i, int j) const
{
  const int itype = atom->type[i], jtype = atom->type[j];
  if (list->iskip && (list->iskip[itype] || list->iskip[jtype] || list->ijskip[itype][jtype]))
    return true;
  if (list->molskip &&
      (list->molskip == NeighRequest::INTRA) != (atom->molecule[i] == atom->molecule[j]))
    return true;
  return neighbor->exclude &&
      (list->np->*&BuilderParts::exclusion)(i, j, itype, jtype, atom->mask, atom->molecule);
}

// rows move to where they can grow
void PotdemPairLists::append(NeighList *list, int i, int j)
{
  if (leaves_out(list, i, j)) return;
  int &n = list->numneigh[i], *&neighbours = list->firstneigh[i];
  const bool listed = std::any_of(neighbours, neighbours + n, [this, j](int other) {
    return atom->tag[other & NEIGHMASK] == atom->tag[j];
  });
  if (listed) return;
  for (const auto &fix : modify->get_fix_list()) {
    auto *const history = dynamic_cast<FixNeighHistory *>(fix);
    if (history && history->pair && history->pair->list &&
        history->pair->list->firstneigh == list->firstneigh)
      grow_memory(history, i, n);
  }
  auto &row = rows[{list, i}];
  if (row.empty()) row.assign(neighbours, neighbours + n);
  row.push_back(j);
  neighbours = row.data();
  n++;
}

// n: pairs that it has of this particle
void PotdemPairLists::grow_memory(FixNeighHistory *history, int i, int n)
{
  int *&flags = history->firstflag[i];
  double *&values = history->firstvalue[i];
  const int width = history->get_dnum();
  const auto [place, is_new] = memories.try_emplace({history, i});
  auto &memory = place->second;
  if (is_new) {
    memory.flags.assign(flags, flags + n);
    memory.values.assign(values, values + static_cast<bigint>(width) * n);
  }
  memory.flags.push_back(0);
  memory.values.insert(memory.values.end(), width, 0.0);
  flags = memory.flags.data();
  values = memory.values.data();
}

void PotdemPairLists::forget()
{
  rows.clear();
  memories.clear();
}
