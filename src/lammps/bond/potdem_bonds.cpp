/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/bond/potdem_bonds.h"

#include "lammps/glue/fix_potdem_bond_history.h"
#include "lammps/glue/potdem_gather.h"
#include "lammps/glue/potdem_input.h"

#include "atom.h"
#include "atom_vec.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "group.h"
#include "math_extra.h"
#include "memory.h"
#include "modify.h"
#include "neigh_list.h"
#include "neigh_request.h"
#include "neighbor.h"
#include "pair.h"
#include "region.h"
#include "special.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

// a shell at r_infl belongs to the body, whatever the rounding of its positions, those of a file with few
// digits included; the shells of a lattice are more than a hundredth apart
static constexpr double SHELL_TOLERANCE = 1e-4;
// a crack must be thicker than a bond's length divided by this
static constexpr int CRACK_SAMPLES = 64;
// over the mean diameter: nearer centres are a slip in the diameters, which LAMMPS makes 1 whatever the units
static constexpr double LEAST_SPACING = 0.1;

/* ---------------------------------------------------------------------- */

PotdemBonds::PotdemBonds(LAMMPS *lmp) :
    Command(lmp), igroup(0), btype(0), reach(0.0), in_diameters(false), region(nullptr)
{
}

void PotdemBonds::command(int narg, char **arg)
{
  if (!domain->box_exist)
    error->all(FLERR, "potdem_bonds needs a simulation box: use create_box first");
  check_style();
  read(narg, arg);
  check_atoms();
  take_over_settings();

  double largest = 0.0, all;
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & group->bitmask[igroup]) largest = MAX(largest, 2.0 * atom->radius[i]);
  MPI_Allreduce(&largest, &all, 1, MPI_DOUBLE, MPI_MAX, world);
  const double cutoff = (in_diameters ? reach * all : reach) * (1.0 + 2.0 * SHELL_TOLERANCE);
  for (int k = 0; k < domain->dimension; k++)
    if (domain->periodicity[k] && 2.0 * cutoff > domain->prd[k])
      error->all(
          FLERR,
          "potdem_bonds: r_infl {} is more than half the periodic box length {}; make the box "
          "larger or r_infl smaller",
          cutoff, domain->prd[k]);
  check_reach(cutoff);

  auto *const list = neighbours(cutoff);
  const bigint count = keep_bonds(list);
  if (count == 0) found_none(cutoff);
  make_room(list);
  add(list);
  report(count);
}

// most likely a number of diameters without the word; a box that shrinks to the particles says nothing
void PotdemBonds::check_reach(double cutoff) const
{
  double diagonal2 = 0.0;
  for (int k = 0; k < domain->dimension; k++) diagonal2 += domain->prd[k] * domain->prd[k];
  if (domain->nonperiodic != 2 && cutoff > sqrt(diagonal2))
    error->all(FLERR,
               "potdem_bonds: r_infl {:g} is longer than the diagonal {:g} of the box, so each "
               "particle would be bonded to all others; for multiples of the diameter put "
               "'diameters' after it",
               cutoff, sqrt(diagonal2));
}

/* ---------------------------------------------------------------------- */

void PotdemBonds::read(int narg, char **arg)
{
  PotdemInput input(lmp, "potdem_bonds", narg, arg);
  const std::string name = input.word();
  igroup = group->find(name);
  if (igroup < 0) input.fail(fmt::format("there is no group '{}'", name));
  btype = input.bond_type();
  reach = input.in_range("r_infl", POTDEM::positive());
  while (!input.done()) {
    if (input.next_is("diameters"))
      in_diameters = true;
    else if (input.next_is("crack")) {
      crack = input.word();
      region = domain->get_region_by_id(crack);
      if (!region) input.fail(fmt::format("there is no region '{}'", crack));
    } else {
      input.word();
      input.unknown("diameters or crack");
    }
  }
  if (region) {
    region->init();
    region->prematch();
  }
}

/* ---------------------------------------------------------------------- */

void PotdemBonds::check_style()
{
  if (!atom->tag_enable || atom->molecular != Atom::MOLECULAR)
    error->all(FLERR,
               "potdem_bonds needs an atom style with bonds and IDs, e.g. atom_style bpm/sphere");
  if (!atom->radius_flag)
    error->all(FLERR, "potdem_bonds needs particle diameters, e.g. atom_style bpm/sphere");
}

void PotdemBonds::check_atoms()
{
  if (group->count(igroup) == 0)
    error->all(FLERR, "potdem_bonds: group '{}' is empty", group->names[igroup]);
  for (int i = 0; i < atom->nlocal; i++)
    if ((atom->mask[i] & group->bitmask[igroup]) && !(atom->radius[i] > 0.0))
      error->one(FLERR,
                 "potdem_bonds: atom {} has diameter {}, it must be > 0; use set ... diameter",
                 atom->tag[i], 2.0 * atom->radius[i]);
}

/* ----------------------------------------------------------------------
   what a truss network asks of LAMMPS, so that the user need not know: each rank must hold all bonds
   of its atoms (newton off for bonds) and the neighbour list must leave bonded pairs out
------------------------------------------------------------------------- */

void PotdemBonds::take_over_settings()
{
  if (force->newton_bond) {
    if (atom->nbonds > 0)
      error->all(
          FLERR,
          "potdem_bonds: the bonds that exist were made with newton on for bonds; put 'newton "
          "on off' before the box is created");
    force->newton_bond = 0;
    force->newton = force->newton_pair;
    if (comm->me == 0) utils::logmesg(lmp, "potdem_bonds: newton off for bonds\n");
  }
  const double weights[4] = {1.0, 0.0, 1.0, 1.0};
  for (int k = 1; k < 4; k++) force->special_lj[k] = force->special_coul[k] = weights[k];
}

/* ----------------------------------------------------------------------
   An occasional LAMMPS neighbour list of this cutoff. The user's pair and bond styles stay out of it, so that they may
   be defined before or after this command: while it lives, a pair style that gives the list its cutoff stands in. They
   come back whatever is thrown meanwhile, which the user of a library may catch
------------------------------------------------------------------------- */

namespace {
// gives lists and ghosts their cutoff, and asks for the one list
class Reach : public Pair {
 public:
  Reach(LAMMPS *lmp, double reach) : Pair(lmp), reach(reach)
  {
    const int n = atom->ntypes + 1;
    memory->create(setflag, n, n, "potdem_bonds:setflag");
    memory->create(cutsq, n, n, "potdem_bonds:cutsq");
    std::fill_n(&setflag[0][0], n * n, 1);
    allocated = 1;
  }
  ~Reach() override
  {
    memory->destroy(setflag);
    memory->destroy(cutsq);
  }
  Reach(const Reach &) = delete;
  Reach &operator=(const Reach &) = delete;

  void compute(int, int) override {}
  void settings(int, char **) override {}
  void coeff(int, char **) override {}
  void init_style() override
  {
    neighbor->add_request(this, NeighConst::REQ_FULL | NeighConst::REQ_OCCASIONAL);
  }
  double init_one(int, int) override { return reach; }

 private:
  double reach;
};

class StandIn {
 public:
  StandIn(LAMMPS *lmp, double cutoff) :
      force(lmp->force), pair(force->pair), bond(force->bond), pair_style(force->pair_style),
      bond_style(force->bond_style), own(lmp, cutoff)
  {
    own.init();
    force->pair = &own;
    force->bond = nullptr;
    force->pair_style = force->bond_style = none;
  }

  ~StandIn()
  {
    force->pair = pair;
    force->bond = bond;
    force->pair_style = pair_style;
    force->bond_style = bond_style;
  }

  NeighList *list() const { return own.list; }

  StandIn(const StandIn &) = delete;
  StandIn &operator=(const StandIn &) = delete;

 private:
  Force *force;
  Pair *pair;
  Bond *bond;
  char *pair_style, *bond_style;
  char none[5] = "none";
  Reach own;
};
}    // namespace

NeighList *PotdemBonds::neighbours(double cutoff)
{
  const StandIn stand_in(lmp, cutoff);
  domain->init();
  atom->init();
  neighbor->init();
  comm->init();
  if (domain->triclinic) domain->x2lamda(atom->nlocal);
  domain->pbc();
  domain->reset_box();
  comm->setup();
  neighbor->setup_bins();
  comm->exchange();
  comm->borders();
  if (domain->triclinic) domain->lamda2x(atom->nlocal + atom->nghost);
  neighbor->build(0);
  neighbor->build_one(stand_in.list());
  return stand_in.list();
}

/* ---------------------------------------------------------------------- */

bool PotdemBonds::may_bond(int i, int j) const
{
  return atom->mask[i] & atom->mask[j] & group->bitmask[igroup];
}

// the same two positions in the same order from both ends
double PotdemBonds::distance(int i, int j) const
{
  const int low = atom->tag[i] < atom->tag[j] ? i : j, high = low == i ? j : i;
  double del[3];
  MathExtra::sub3(atom->x[high], atom->x[low], del);
  return MathExtra::len3(del);
}

/* ----------------------------------------------------------------------
   the list keeps those neighbours that will be bonded; how many bonds that are, over all ranks. Of the pairs that a crack
   cuts, those that touch are known as contacts
------------------------------------------------------------------------- */

bigint PotdemBonds::keep_bonds(NeighList *list)
{
  contacts.clear();
  bigint ends = 0, all;
  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii];
    int *const neighbours = list->firstneigh[i];
    int kept = 0;
    for (int jj = 0; jj < list->numneigh[i]; jj++) {
      const int j = neighbours[jj] & NEIGHMASK;
      if (will_bond(i, j)) neighbours[kept++] = j;
    }
    list->numneigh[i] = kept;
    ends += kept;
  }
  MPI_Allreduce(&ends, &all, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  return all / 2;
}

bool PotdemBonds::will_bond(int i, int j)
{
  if (!may_bond(i, j)) return false;
  const double r = distance(i, j), dbar = atom->radius[i] + atom->radius[j];
  if (r > (in_diameters ? reach * dbar : reach) * (1.0 + SHELL_TOLERANCE)) return false;
  if (r == 0.0)
    error->one(FLERR, "potdem_bonds: atoms {} and {} are at the same place", atom->tag[i],
               atom->tag[j]);
  if (r < LEAST_SPACING * dbar)
    error->one(FLERR,
               "potdem_bonds: atoms {} and {} are {:g} apart, less than {} of their mean diameter "
               "{:g}; set the diameters before, with set ... diameter",
               atom->tag[i], atom->tag[j], r, LEAST_SPACING, dbar);
  if (!region || !crosses_crack(i, j)) return true;
  if (r < dbar && atom->tag[i] < atom->tag[j]) contacts.push_back({atom->tag[i], atom->tag[j], r});
  return false;
}

bool PotdemBonds::crosses_crack(int i, int j) const
{
  const int low = atom->tag[i] < atom->tag[j] ? i : j, high = low == i ? j : i;
  const double *from = atom->x[low], *to = atom->x[high];
  for (int k = 0; k <= CRACK_SAMPLES; k++) {
    const double t = static_cast<double>(k) / CRACK_SAMPLES;
    if (region->match(from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1]),
                      from[2] + t * (to[2] - from[2])))
      return true;
  }
  return false;
}

/* ---------------------------------------------------------------------- */

void PotdemBonds::make_room(const NeighList *list)
{
  int most = 0, all;
  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii];
    most = MAX(most, atom->num_bond[i] + list->numneigh[i]);
  }
  MPI_Allreduce(&most, &all, 1, MPI_INT, MPI_MAX, world);
  if (all > atom->bond_per_atom) grow_bonds_per_atom(all);
}

/* ----------------------------------------------------------------------
   LAMMPS fixes the number of bonds per atom when the box is created; growing its arrays moves their
   rows, so what they hold is taken out and put back
------------------------------------------------------------------------- */

void PotdemBonds::grow_bonds_per_atom(int nbond)
{
  auto store = FixPotdemBondHistory::find(lmp);
  if (store) FixPotdemBondHistory::get(lmp, "potdem_bonds");
  struct OldBond {
    int i, type;
    tagint partner;
    double length, area;
    FixPotdemBondHistory::Dilatation dilatation;
    POTDEM::Softening softening;
  };
  std::vector<OldBond> old;
  for (int i = 0; i < atom->nlocal; i++)
    for (int m = 0; m < atom->num_bond[i]; m++)
      old.push_back({i, atom->bond_type[i][m], atom->bond_atom[i][m],
                     store ? store->length(i, m) : 0.0, store ? store->area(i, m) : 0.0,
                     store ? store->dilatation(i, m) : FixPotdemBondHistory::Dilatation{},
                     store ? store->softening(i, m) : POTDEM::Softening{}});
  const double ghost_cutoff = store ? store->ghost_cutoff : -1.0;
  const bool keeps_areas = store && store->keeps_areas();
  const bool keeps_dilatations = store && store->keeps_dilatations();
  const bool keeps_softening = store && store->keeps_softening();
  const auto known = store ? store->new_contacts : std::vector<PotdemNewContact>();
  if (store) modify->delete_fix(store->id);

  atom->bond_per_atom = nbond;
  atom->avec->grow(atom->nmax);

  store = FixPotdemBondHistory::create(lmp);
  if (keeps_areas) store->keep_areas();
  if (keeps_dilatations) store->keep_dilatations();
  if (keeps_softening) store->keep_softening();
  store->ghost_cutoff = ghost_cutoff;
  store->new_contacts = known;
  std::fill(atom->num_bond, atom->num_bond + atom->nlocal, 0);
  for (const auto &bond : old) {
    const int i = bond.i, m = atom->num_bond[i]++;
    atom->bond_type[i][m] = bond.type;
    atom->bond_atom[i][m] = bond.partner;
    store->store(i, m, bond.length);
    if (keeps_areas) store->store_area(i, m, bond.area);
    if (keeps_dilatations) store->store_dilatation(i, m, bond.dilatation);
    if (keeps_softening) store->store_softening(i, m, bond.softening);
  }
}

/* ---------------------------------------------------------------------- */

void PotdemBonds::add(const NeighList *list)
{
  auto store = FixPotdemBondHistory::ensure(lmp);
  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii];
    for (int jj = 0; jj < list->numneigh[i]; jj++) {
      const int j = list->firstneigh[i][jj], m = atom->num_bond[i]++;
      atom->bond_type[i][m] = btype;
      atom->bond_atom[i][m] = atom->tag[j];
      store->store(i, m, distance(i, j));
    }
  }
  Special special(lmp);
  special.build();
  // pairs that a crack cuts and that touch: their law of contact begins where they are
  const auto all = potdem_gather(lmp, contacts, "pairs that a crack cuts");
  store->new_contacts.insert(store->new_contacts.end(), all.begin(), all.end());
}

/* ---------------------------------------------------------------------- */

void PotdemBonds::report(bigint count)
{
  atom->nbonds += count;
  const double per_particle = 2.0 * static_cast<double>(count) / group->count(igroup);
  if (comm->me == 0)
    utils::logmesg(lmp, "potdem_bonds: {} bonds of type {} in group {}, {:.4g} per particle\n",
                   count, btype, group->names[igroup], per_particle);
}

/* ----------------------------------------------------------------------
   why there is no bond: the crack cuts every pair, or r_infl is below every distance
------------------------------------------------------------------------- */

void PotdemBonds::found_none(double cutoff)
{
  const auto within = fmt::format("r_infl = {}{}", reach, in_diameters ? " diameters" : "");
  if (region) {
    region = nullptr;
    if (keep_bonds(neighbours(cutoff)) > 0)
      error->all(FLERR,
                 "potdem_bonds: the crack, region {}, cuts every pair of group '{}' within {}: "
                 "make it thinner",
                 crack, group->names[igroup], within);
  }
  const double shortest = shortest_distance(cutoff);
  error->all(
      FLERR,
      "potdem_bonds: no two particles of group '{}' that are not bonded already are within {}; {}",
      group->names[igroup], within,
      shortest > 0.0 ? fmt::format("the shortest distance between two of them is {:.6g}", shortest)
                     : "there are no two of them near each other");
}

// beyond the cutoff; 0 if there is none within eight times of it
double PotdemBonds::shortest_distance(double cutoff)
{
  double mine = HUGE_VAL, all = HUGE_VAL;
  for (int doubled = 0; doubled < 3 && !std::isfinite(all); doubled++) {
    cutoff *= 2.0;
    const auto *const list = neighbours(cutoff);
    for (int ii = 0; ii < list->inum; ii++) {
      const int i = list->ilist[ii];
      for (int jj = 0; jj < list->numneigh[i]; jj++) {
        const int j = list->firstneigh[i][jj] & NEIGHMASK;
        if (may_bond(i, j)) mine = MIN(mine, distance(i, j));
      }
    }
    MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_MIN, world);
  }
  return std::isfinite(all) ? all : 0.0;
}
