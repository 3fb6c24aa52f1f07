/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/pair/fix_potdem_contacts.h"

#include "lammps/glue/potdem_restart_block.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "force.h"
#include "modify.h"
#include "my_page.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "pair.h"

#include <algorithm>

using namespace LAMMPS_NS;

static constexpr char CONTACTS_ID[] = "POTDEM_CONTACTS_";

/* ---------------------------------------------------------------------- */

static std::string place_of(const std::string &id)
{
  return id + "_PLACE";
}

// numbers follow the order of the styles in pair_style hybrid, and so are the same after a restart
std::string FixPotdemContacts::reserve(LAMMPS *lmp)
{
  auto *const modify = lmp->modify;
  for (int n = 1;; n++) {
    const std::string id = CONTACTS_ID + std::to_string(n);
    const auto *const kept = dynamic_cast<FixPotdemContacts *>(modify->get_fix_by_id(id));
    if (kept && !kept->pair) return id;
    if (kept || modify->get_fix_by_id(place_of(id))) continue;
    modify->add_fix(place_of(id) + " all DUMMY");
    return id;
  }
}

void FixPotdemContacts::release(LAMMPS *lmp, const std::string &id)
{
  auto *const modify = lmp->modify;
  if (!modify) return;
  if (modify->get_fix_by_id(place_of(id))) modify->delete_fix(place_of(id));
  auto *const kept = dynamic_cast<FixPotdemContacts *>(modify->get_fix_by_id(id));
  if (kept) kept->pair = nullptr;
}

FixPotdemContacts *FixPotdemContacts::ensure(LAMMPS *lmp, const std::string &id, Pair *pair,
                                             int state)
{
  auto *const modify = lmp->modify;
  const auto made = fmt::format("{} all POTDEM_CONTACTS {}", id, 1 + state);
  auto *contacts = dynamic_cast<FixPotdemContacts *>(modify->get_fix_by_id(id));
  std::vector<Kept> kept;
  if (contacts && contacts->dnum != 1 + state) {
    // of another law: its fix is the place of a new one
    kept = contacts->all_kept();
    contacts->pair = nullptr;
    delete[] contacts->id;
    contacts->id = utils::strdup(place_of(id));
    contacts = nullptr;
  }
  if (!contacts) {
    const bool placed = modify->get_fix_by_id(place_of(id));
    contacts = dynamic_cast<FixPotdemContacts *>(placed ? modify->replace_fix(place_of(id), made)
                                                        : modify->add_fix(made));
    if (!kept.empty()) contacts->allocate_pages();
    contacts->add_kept(kept);
  }
  contacts->pair = pair;
  return contacts;
}

FixPotdemContacts::FixPotdemContacts(LAMMPS *lmp, int narg, char **arg) :
    FixNeighHistory(lmp, narg, arg), stored(true), remembering(0)
{
}

// by the user; or by its pair style, which has said so
FixPotdemContacts::~FixPotdemContacts()
{
  if (auto *const whose = dynamic_cast<ContactMemory *>(pair)) whose->lose_contacts();
}

void FixPotdemContacts::init()
{
  check_kept();
  if (!pair) return;
  if (dnum > 1 && force->newton_pair && comm->style != Comm::BRICK)
    error->all(FLERR,
               "Fix {}: friction that remembers needs 'newton off' with comm_style tiled, where "
               "LAMMPS cannot bring back what other ranks remember",
               id);
  // LAMMPS forgets what the pages hold when neigh_modify changes their size
  const bool changed = pages_will_change();
  const auto kept = changed ? all_kept() : std::vector<Kept>();
  FixNeighHistory::init();
  if (changed) std::fill_n(npartner, atom->nlocal, 0);
  add_kept(kept);
  // a distance is the same seen from either particle
  pair->nondefault_history_transfer = 1;
  // neighbour lists mark what touches by diameters only, and not in all of their kinds
  pair->beyond_contact = 1;
}

std::vector<FixPotdemContacts::Kept> FixPotdemContacts::all_kept() const
{
  std::vector<Kept> kept;
  for (int i = 0; i < atom->nlocal; i++)
    for (int k = 0; k < npartner[i]; k++) {
      const double *const values = valuepartner[i] + dnum * static_cast<bigint>(k);
      kept.push_back({i, partner[i][k], std::vector<double>(values, values + dnum)});
    }
  return kept;
}

// of another width: a state of another law is none
void FixPotdemContacts::add_kept(const std::vector<Kept> &kept)
{
  for (const auto &one : kept) {
    const bool whole = static_cast<int>(one.values.size()) == dnum;
    if (!whole && one.values[0] == 0.0) continue;
    std::copy_n(one.values.begin(), whole ? dnum : 1, add_partner(one.i, one.partner));
  }
}

bool FixPotdemContacts::pages_will_change() const
{
  return ipage_atom && (pgsize != neighbor->pgsize || oneatom != neighbor->oneatom);
}

/* ----------------------------------------------------------------------
   the values go from the neighbour list to the particles before they move, and back into the new list
------------------------------------------------------------------------- */

void FixPotdemContacts::pre_exchange()
{
  if (!pair) return;
  give_to_particles();
  stored = true;
}

void FixPotdemContacts::give_to_particles()
{
  FixNeighHistory::pre_exchange();
  add_aside();
}

void FixPotdemContacts::post_neighbor()
{
  if (!pair) return;
  FixNeighHistory::post_neighbor();
  set_aside();
  stored = false;
}

void FixPotdemContacts::post_run()
{
  if (!stored) pre_exchange();
}

// with newton on LAMMPS asks the rank that has the pair in its list for what the other's owner is to keep, in a way that
// comm_style tiled does not know. Of a distance both owners know from the beginning, and it does not change
void FixPotdemContacts::pre_exchange_newton()
{
  if (dnum > 1)
    FixNeighHistory::pre_exchange_newton();
  else
    pre_exchange_no_newton();
}

// at what distance pairs begin that are not in the list of this particle; their state is that of the other's list
void FixPotdemContacts::set_aside()
{
  aside.clear();
  remembering = 0;
  std::vector<tagint> listed;
  const auto *const list = pair->list;
  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii];
    listed.clear();
    for (int jj = 0; npartner[i] > 0 && jj < list->numneigh[i]; jj++)
      if (firstflag[i][jj]) listed.push_back(atom->tag[list->firstneigh[i][jj] & NEIGHMASK]);
    remembering += static_cast<bigint>(listed.size());
    for (int k = 0; k < npartner[i]; k++)
      if (std::find(listed.begin(), listed.end(), partner[i][k]) == listed.end())
        keep_aside(i, partner[i][k], valuepartner[i][dnum * static_cast<bigint>(k)]);
  }
}

// the list of the other particle may have had the pair
void FixPotdemContacts::add_aside()
{
  for (const auto &[pair, distance] : aside)
    if (place_of_partner(pair.first, pair.second) < 0)
      *add_partner(pair.first, pair.second) = distance;
}

// between runs the particles have moved on already, unlike those of the last neighbour list
void FixPotdemContacts::write_restart(FILE *fp)
{
  if (pair && !stored) give_to_particles();
  const auto all = sum_kept();
  if (comm->me == 0) potdem_write_block(fp, all);
}

void FixPotdemContacts::restart(char *buf)
{
  in_file = potdem_read_block(lmp, fmt::format("Contacts {}", id), buf, 3);
}

std::vector<double> FixPotdemContacts::sum_kept() const
{
  PotdemSum mine;
  for (const auto &one : all_kept()) mine.add(one.values.data(), one.values.size());
  return {static_cast<double>(mine.count(world)), static_cast<double>(dnum), mine.value(world)};
}

// once, before contacts are computed. Where they are of another law, or the user has taken particles away, nothing can be said
void FixPotdemContacts::check_kept()
{
  if (in_file.empty()) return;
  if (potdem_is_damaged(in_file, sum_kept()))
    error->all(FLERR,
               "The restart file is damaged: what contacts remember in {} is not what was written; "
               "continue from another file",
               id);
  in_file.clear();
}

/* ---------------------------------------------------------------------- */

// on a rank that owns one of the two or both, when the pair is in the list, if it comes there at all before the next rebuild.
// The next list may have it in the row of the other particle
void FixPotdemContacts::expect(const std::vector<PotdemNewContact> &contacts)
{
  if (!ipage_atom) allocate_pages();
  for (const auto &contact : contacts) {
    const tagint tags[2] = {contact.first, contact.second};
    for (int end = 0; end < 2; end++) {
      const int i = atom->map(tags[end]);
      const tagint other = tags[1 - end];
      if (i < 0 || i >= atom->nlocal) continue;
      if (stored)
        set_partner(i, other, contact.distance);
      else
        keep_aside(i, other, set_listed(i, other, contact.distance) ? 0.0 : contact.distance);
    }
  }
}

// in the list of particle i; a pair that was bonded again and failed again begins anew. false: it is not there
bool FixPotdemContacts::set_listed(int i, tagint tag, double distance)
{
  const auto *const list = pair->list;
  if (list->iskip && list->iskip[atom->type[i]]) return false;
  for (int jj = 0; jj < list->numneigh[i]; jj++) {
    if (atom->tag[list->firstneigh[i][jj] & NEIGHMASK] != tag) continue;
    double *const values = firstvalue[i] + dnum * static_cast<bigint>(jj);
    std::fill_n(values, dnum, 0.0);
    *values = distance;
    firstflag[i][jj] = distance > 0.0;
    remembering++;
    return true;
  }
  return false;
}

void FixPotdemContacts::keep_aside(int i, tagint tag, double distance)
{
  if (distance > 0.0)
    aside[{i, tag}] = distance;
  else
    aside.erase({i, tag});
}

// -1: not there
int FixPotdemContacts::place_of_partner(int i, tagint tag) const
{
  for (int k = 0; k < npartner[i]; k++)
    if (partner[i][k] == tag) return k;
  return -1;
}

// a pair that was bonded again and failed again begins anew
void FixPotdemContacts::set_partner(int i, tagint tag, double distance)
{
  const int k = place_of_partner(i, tag);
  if (k < 0) {
    if (distance > 0.0) *add_partner(i, tag) = distance;
    return;
  }
  double *const values = valuepartner[i] + dnum * static_cast<bigint>(k);
  if (distance > 0.0) {
    *values = distance;
    return;
  }
  const int last = --npartner[i];
  partner[i][k] = partner[i][last];
  std::copy_n(valuepartner[i] + dnum * static_cast<bigint>(last), dnum, values);
}

double *FixPotdemContacts::add_partner(int i, tagint tag)
{
  const int n = npartner[i], all = dnum * (n + 1);
  tagint *const partners = ipage_atom->get(n + 1);
  double *const values = dpage_atom->get(all);
  if (!partners || !values)
    error->one(FLERR, "Atom {} has too many contacts to remember, increase neigh_modify one",
               atom->tag[i]);
  std::copy_n(partner[i], n, partners);
  std::copy_n(valuepartner[i], dnum * n, values);
  std::fill_n(values + dnum * n, dnum, 0.0);
  partners[n] = tag;
  partner[i] = partners;
  valuepartner[i] = values;
  npartner[i] = n + 1;
  maxpartner = MAX(maxpartner, npartner[i]);
  maxexchange = (dnum + 1) * maxpartner + 1;
  return values + dnum * n;
}

// the file may be of another law, which remembers more or less: of that the distances count. What it has of a particle: how
// many numbers this is, of how many partners, and the ID and the values of each
void FixPotdemContacts::unpack_restart(int nlocal, int nth)
{
  const double *from = atom->extra[nlocal];
  for (int k = 0; k < nth; k++) from += static_cast<int>(*from);
  const int size = static_cast<int>(from[0]), n = static_cast<int>(from[1]);
  const int width = n > 0 ? (size - 2) / n - 1 : dnum;
  if (!ipage_atom) allocate_pages();
  npartner[nlocal] = 0;
  from += 2;
  for (int k = 0; k < n; k++, from += width + 1)
    if (width == dnum || from[1] != 0.0)
      std::copy_n(from + 1, width == dnum ? dnum : 1,
                  add_partner(nlocal, static_cast<tagint>(ubuf(*from).i)));
}
