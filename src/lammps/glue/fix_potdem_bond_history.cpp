/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/glue/fix_potdem_bond_history.h"

#include "core/laws/truss.h"
#include "lammps/glue/find_styles.h"
#include "lammps/glue/lammps_compat.h"
#include "lammps/glue/potdem_gather.h"
#include "lammps/glue/potdem_restart_block.h"

#include "atom.h"
#include "atom_vec.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "math_extra.h"
#include "modify.h"
#include "neighbor.h"
#include "output.h"
#include "thermo.h"
#include "update.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

using namespace LAMMPS_NS;
using namespace FixConst;

static constexpr char STORE_ID[] = "POTDEM_BONDS", AREAS_ID[] = "POTDEM_BONDS_AREAS",
                      DILATATIONS_ID[] = "POTDEM_BONDS_DILATATIONS",
                      SOFTENING_ID[] = "POTDEM_BONDS_SOFTENING";
// of the longest bond, so that not each rebuild begins twice; and what is less than this of the reach there is counts as
// shorter
static constexpr double SPARE_REACH = 1.05, LEAST_CHANGE = 0.9;

/* ---------------------------------------------------------------------- */

FixPotdemBondHistory *FixPotdemBondHistory::find(LAMMPS *lmp)
{
  return dynamic_cast<FixPotdemBondHistory *>(lmp->modify->get_fix_by_id(STORE_ID));
}

// LAMMPS fixes the number of bonds per atom when the box is created, perhaps at none
FixPotdemBondHistory *FixPotdemBondHistory::create(LAMMPS *lmp)
{
  if (lmp->atom->bond_per_atom == 0) {
    lmp->atom->bond_per_atom = 1;
    lmp->atom->avec->grow(lmp->atom->nmax);
  }
  return dynamic_cast<FixPotdemBondHistory *>(
      lmp->modify->add_fix(fmt::format("{} all POTDEM_BOND_HISTORY 0 {}", STORE_ID, NDATA)));
}

FixPotdemBondHistory *FixPotdemBondHistory::ensure(LAMMPS *lmp, const std::string &who)
{
  bool lost = false;
  for (const auto *bond : potdem_find<BondMemory>(lmp)) lost = lost || bond->lost_memory();
  if (find(lmp) || lost) return get(lmp, who);
  return create(lmp);
}

FixPotdemBondHistory *FixPotdemBondHistory::get(LAMMPS *lmp, const std::string &who)
{
  auto *const store = find(lmp);
  const std::string gone = store ? store->gone() : STORE_ID;
  if (!gone.empty())
    lmp->error->all(FLERR,
                    "{}: fix {}, in which the bonds remember their reference lengths and areas, "
                    "was removed with "
                    "unfix: keep it, or start again from the undeformed body",
                    who, gone);
  return store;
}

// the values themselves are kept by a fix property/atom
std::string FixPotdemBondValues::gone() const
{
  int is_double, columns;
  return atom->find_custom(&id_array[3], is_double, columns) == index ? "" : id_fix;
}

std::string FixPotdemBondHistory::gone() const
{
  const std::string mine = FixPotdemBondValues::gone();
  if (!mine.empty()) return mine;
  for (const auto &[one, id_of_fix] :
       {std::pair(areas, AREAS_ID), std::pair(dilatations, DILATATIONS_ID),
        std::pair(softenings, SOFTENING_ID)}) {
    if (!one) continue;
    const std::string lost = modify->get_fix_by_id(id_of_fix) == one ? one->gone() : id_of_fix;
    if (!lost.empty()) return lost;
  }
  return "";
}

/* ---------------------------------------------------------------------- */

FixPotdemBondHistory::FixPotdemBondHistory(LAMMPS *lmp, int narg, char **arg) :
    FixPotdemBondValues(lmp, narg, arg), parted(lmp), generation(0), ghost_cutoff(-1.0),
    widest(0.0), areas(nullptr), dilatations(nullptr), softenings(nullptr),
    all_types(atom->nbondtypes + 1, 1), exchanged(nullptr), exchanged_width(0),
    natoms_then(atom->natoms)
{
  setflag = all_types.data();
}

FixPotdemBondHistory::~FixPotdemBondHistory()
{
  for (const auto *const id_of_fix : {AREAS_ID, DILATATIONS_ID, SOFTENING_ID})
    if (modify->get_fix_by_id(id_of_fix)) modify->delete_fix(id_of_fix);
  if (!force) return;    // LAMMPS ends
  for (auto *const bond : potdem_find<BondMemory>(lmp)) bond->lose_memory();
}

int FixPotdemBondHistory::setmask()
{
  const int lists = PRE_NEIGHBOR | MIN_PRE_NEIGHBOR | POST_NEIGHBOR | MIN_POST_NEIGHBOR;
  return NSTATE > 0 ? lists | PRE_EXCHANGE | MIN_PRE_EXCHANGE : lists;
}

// the order of fixes as LAMMPS has it for the memory of its pair styles
void FixPotdemBondHistory::init()
{
  check_values();
  look_after_removals();
  if (NSTATE == 0) return;
  for (const auto *fix : modify->get_fix_list()) {
    if (fix == this) return;
    if (fix->pre_exchange_migrate)
      error->all(
          FLERR,
          "Fix {} {} moves particles to other ranks before the bonds' memory {} is up to date: "
          "define it after potdem_bonds",
          fix->id, fix->style, id);
  }
}

/* ----------------------------------------------------------------------
   the bond styles have what laws keep of each bond in the order of their loop
------------------------------------------------------------------------- */

void FixPotdemBondHistory::pre_exchange()
{
  for (auto *const bond : potdem_find<BondMemory>(lmp)) bond->return_state();
}

void FixPotdemBondHistory::min_pre_exchange()
{
  pre_exchange();
}

void FixPotdemBondHistory::post_run()
{
  pre_exchange();
}

/* ----------------------------------------------------------------------
   Ghosts reach the far end of the longest bond as it is now, no further: what a step costs in communication. They were
   acquired with the cutoff of the last time; where that was too short, or longer than it need be, they are acquired anew
------------------------------------------------------------------------- */

void FixPotdemBondHistory::setup_pre_neighbor()
{
  if (force->pair && !force->bond && atom->nbonds > 0)
    error->all(
        FLERR,
        "There are {} bonds but no bond_style, so they would do nothing, and bonded particles "
        "do not touch each other either: use bond_style potdem/truss and bond_coeff",
        atom->nbonds);
  pre_neighbor();
}

void FixPotdemBondHistory::pre_neighbor()
{
  look_after_removals();
  if (comm->nprocs == 1 && !is_periodic()) return;
  if (!follows_bonds()) {
    if (longest_now() == HUGE_VAL) refuse_lost_ends(true);
    return;
  }
  // a far end that is not here has an unknown distance: once more, with the widest reach first
  for (double most = HUGE_VAL; most == HUGE_VAL;) {
    const double now = MAX(ghost_cutoff, neighbor->cutneighmax);
    most = longest_now();
    if (most <= now && SPARE_REACH * most > LEAST_CHANGE * ghost_cutoff) return;
    const double wanted = MAX(MIN(SPARE_REACH * most, widest), neighbor->cutneighmax);
    if (wanted == now) {
      if (most == HUGE_VAL) refuse_lost_ends(true);
      return;
    }
    comm->cutghostuser = ghost_cutoff = wanted;
    acquire_ghosts();
  }
}

void FixPotdemBondHistory::min_pre_neighbor()
{
  pre_neighbor();
}

// at set-up, where nobody knows yet how long the bonds are
void FixPotdemBondHistory::reach_at_most(double cutoff)
{
  comm->cutghostuser = ghost_cutoff = widest = cutoff;
}

bool FixPotdemBondHistory::follows_bonds() const
{
  return comm->cutghostuser == ghost_cutoff;
}

bool FixPotdemBondHistory::is_periodic() const
{
  return domain->xperiodic || domain->yperiodic || domain->zperiodic;
}

// of those to ghosts; infinite if the far end of a bond is not here. What lies beyond a periodic boundary is a ghost, too
double FixPotdemBondHistory::longest_now() const
{
  const bool periodic = is_periodic();
  double most2 = 0.0, all;
  for (int i = 0; i < atom->nlocal; i++)
    for (int m = 0; m < atom->num_bond[i]; m++) {
      const int j = atom->map(atom->bond_atom[i][m]);
      if (j < 0) most2 = HUGE_VAL;
      if (j < 0 || (j < atom->nlocal && !periodic)) continue;
      double del[3];
      MathExtra::sub3(atom->x[j], atom->x[i], del);
      PotdemCompat::minimum_image(domain, del);
      most2 = MAX(most2, MathExtra::lensq3(del));
    }
  MPI_Allreduce(&most2, &all, 1, MPI_DOUBLE, MPI_MAX, world);
  return sqrt(all);
}

/* ----------------------------------------------------------------------
   LAMMPS says of a bond whose far end is not here that it is missing, not why
------------------------------------------------------------------------- */

void FixPotdemBondHistory::look_after_removals()
{
  if (atom->natoms < natoms_then) refuse_lost_ends(false);
  natoms_then = atom->natoms;
}

// all_reached: there are the ghosts that bonds need, and an end that is not among them is too far away
void FixPotdemBondHistory::refuse_lost_ends(bool all_reached) const
{
  if (output->thermo->lostbond != Thermo::ERROR) return;
  struct Severed {
    tagint tag, partner;
    double x[3], length;
  };
  std::vector<Severed> mine;
  for (int i = 0; i < atom->nlocal; i++)
    for (int m = 0; m < atom->num_bond[i]; m++) {
      if (atom->bond_type[i][m] <= 0 || atom->map(atom->bond_atom[i][m]) >= 0) continue;
      const double *const x = atom->x[i];
      mine.push_back({atom->tag[i], atom->bond_atom[i][m], {x[0], x[1], x[2]}, length(i, m)});
    }
  const auto all = potdem_gather(lmp, mine, "bonds with an end that is missing");
  // of each far end how often it is there, once or never, and where
  std::vector<std::array<double, 4>> here(all.size()), found(all.size());
  for (std::size_t k = 0; k < all.size(); k++) {
    const int j = atom->map(all[k].partner);
    if (j >= 0 && j < atom->nlocal) here[k] = {1.0, atom->x[j][0], atom->x[j][1], atom->x[j][2]};
  }
  MPI_Allreduce(here.data(), found.data(), static_cast<int>(4 * all.size()), MPI_DOUBLE, MPI_SUM,
                world);
  for (std::size_t k = 0; k < all.size(); k++)
    if (found[k][0] == 0.0)
      error->all(FLERR,
                 "Atom {} is bonded to atom {}, which is no longer in the simulation on step {}: "
                 "remove particles that have bonds with 'delete_atoms ... bond yes', and let none "
                 "leave the box",
                 all[k].tag, all[k].partner, update->ntimestep);
  if (all.empty() || !all_reached) return;
  double del[3];
  MathExtra::sub3(&found[0][1], all[0].x, del);
  PotdemCompat::minimum_image(domain, del);
  error->all(
      FLERR,
      "Bond between atoms {} and {} is {:g} long (reference {:g}) on step {}: it is beyond "
      "the communication cutoff {:g}; use a smaller timestep if it was torn apart, let bonds "
      "fail with fix potdem/failure, or increase the cutoff with comm_modify cutoff",
      all[0].tag, all[0].partner, MathExtra::len3(del), all[0].length, update->ntimestep,
      MAX(comm->cutghostuser, neighbor->cutneighmax));
}

void FixPotdemBondHistory::acquire_ghosts()
{
  if (domain->triclinic) domain->x2lamda(atom->nlocal);
  comm->setup();
  if (neighbor->style) neighbor->setup_bins();
  comm->exchange();
  comm->borders();
  if (domain->triclinic) domain->lamda2x(atom->nlocal + atom->nghost);
}

/* ---------------------------------------------------------------------- */

void FixPotdemBondHistory::setup_post_neighbor()
{
  post_neighbor();
}

// the readers take what they need from the per-atom data themselves, in the order they need it
void FixPotdemBondHistory::post_neighbor()
{
  generation++;
  parted.forget();
}

void FixPotdemBondHistory::min_post_neighbor()
{
  post_neighbor();
}

double **FixPotdemBondHistory::values() const
{
  return atom->darray[index];
}

void FixPotdemBondHistory::store(int i, int m, double length)
{
  update_atom_value(i, m, LENGTH, length);
  std::fill_n(state(i, m), NSTATE, 0.0);
  if (areas) store_area(i, m, 0.0);
  if (dilatations) store_dilatation(i, m, {});
  if (softenings) store_softening(i, m, {});
}

// the style must not have the name of this one in its own: when a plugin goes, LAMMPS deletes its fixes by patterns of their styles
FixPotdemBondValues *FixPotdemBondHistory::values_of(const char *id_of_fix, int columns)
{
  return dynamic_cast<FixPotdemBondValues *>(
      modify->add_fix(fmt::format("{} all POTDEM_AREA_BOND_HISTORY 0 {}", id_of_fix, columns)));
}

// these before any bond of a type for which they are found is computed
void FixPotdemBondHistory::keep_areas()
{
  if (!areas) areas = values_of(AREAS_ID, 1);
}

void FixPotdemBondHistory::keep_dilatations()
{
  if (!dilatations) dilatations = values_of(DILATATIONS_ID, 3);
}

void FixPotdemBondHistory::keep_softening()
{
  if (!softenings) softenings = values_of(SOFTENING_ID, 3);
}

/* ---------------------------------------------------------------------- */

bool FixPotdemBondHistory::is_new(int i, int m) const
{
  return length(i, m) == 0.0 && atom->bond_type[i][m] > 0;
}

bool FixPotdemBondHistory::has_new_bonds() const
{
  for (int i = 0; i < atom->nlocal; i++)
    for (int m = 0; m < atom->num_bond[i]; m++)
      if (is_new(i, m)) return true;
  return false;
}

double FixPotdemBondHistory::longest() const
{
  double mine = longest_new_bond(), all;
  for (int i = 0; i < atom->nlocal; i++)
    for (int m = 0; m < atom->num_bond[i]; m++) mine = MAX(mine, length(i, m));
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_MAX, world);
  return all;
}

/* ----------------------------------------------------------------------
   before there are ghosts that reach far enough: the partner may be a particle of any rank
------------------------------------------------------------------------- */

double FixPotdemBondHistory::longest_new_bond() const
{
  struct Place {
    tagint tag;
    double x[3];
  };
  const auto here = [this](tagint partner) {
    const int j = atom->map(partner);
    return j < atom->nlocal ? j : -1;
  };
  std::vector<Place> mine;
  for (int i = 0; i < atom->nlocal; i++)
    for (int m = 0; m < atom->num_bond[i]; m++)
      if (is_new(i, m) && here(atom->bond_atom[i][m]) < 0) {
        mine.push_back({atom->tag[i], {atom->x[i][0], atom->x[i][1], atom->x[i][2]}});
        break;
      }
  std::unordered_map<tagint, const double *> places;
  const auto all = potdem_gather(lmp, mine);
  for (const auto &place : all) places[place.tag] = place.x;

  double most = 0.0;
  for (int i = 0; i < atom->nlocal; i++)
    for (int m = 0; m < atom->num_bond[i]; m++) {
      if (!is_new(i, m)) continue;
      const int j = here(atom->bond_atom[i][m]);
      const auto elsewhere = places.find(atom->bond_atom[i][m]);
      if (j < 0 && elsewhere == places.end()) continue;
      double del[3];
      MathExtra::sub3(j >= 0 ? atom->x[j] : elsewhere->second, atom->x[i], del);
      PotdemCompat::minimum_image(domain, del);
      most = MAX(most, MathExtra::len3(del));
    }
  return most;
}

int FixPotdemBondHistory::slot(int i, tagint partner) const
{
  for (int m = 0; m < atom->num_bond[i]; m++)
    if (atom->bond_atom[i][m] == partner) return m;
  return -1;
}

/* ----------------------------------------------------------------------
   bonds that did not come from potdem_bonds (create_bonds, data file, fix deposit) start from where they are;
   both ends take the two positions in order of the IDs
------------------------------------------------------------------------- */

bigint FixPotdemBondHistory::measure_new_bonds()
{
  double **x = atom->x;
  bigint ends = 0;
  for (int i = 0; i < atom->nlocal; i++)
    for (int m = 0; m < atom->num_bond[i]; m++) {
      if (!is_new(i, m)) continue;
      if (slot(i, atom->bond_atom[i][m]) != m)
        error->one(FLERR,
                   "Atoms {} and {} are bonded twice: a pair has one truss, make each bond once",
                   atom->tag[i], atom->bond_atom[i][m]);
      const int k = atom->map(atom->bond_atom[i][m]);
      if (k < 0)
        error->one(
            FLERR,
            "Bond partner {} of atom {} is beyond the communication cutoff; increase it with "
            "comm_modify cutoff",
            atom->bond_atom[i][m], atom->tag[i]);
      const int j = domain->closest_image(i, k);
      const int low = atom->tag[i] < atom->tag[j] ? i : j, high = low == i ? j : i;
      const double del[3] = {x[high][0] - x[low][0], x[high][1] - x[low][1],
                             x[high][2] - x[low][2]};
      store(i, m, sqrt(del[0] * del[0] + del[1] * del[1] + del[2] * del[2]));
      ends++;
    }
  return ends;
}

/* ---------------------------------------------------------------------- */

// as LAMMPS's own commands do it: the last bond takes the place, in every memory that there is of bonds
void FixPotdemBondHistory::remove(int i, int m)
{
  const int last = --atom->num_bond[i];
  atom->bond_type[i][m] = atom->bond_type[i][last];
  atom->bond_atom[i][m] = atom->bond_atom[i][last];
  for (const auto &fix : modify->get_fix_by_style("BOND_HISTORY")) {
    auto *const history = dynamic_cast<FixBondHistory *>(fix);
    history->shift_history(i, m, last);
    history->delete_history(i, last);
  }
}

/* ----------------------------------------------------------------------
   LAMMPS's restart files keep the communication cutoff, but not whose it is. The values of the bonds are with their particles
------------------------------------------------------------------------- */

void FixPotdemBondHistory::write_restart(FILE *fp)
{
  pre_exchange();
  const auto all = ends_and_sum();
  const double softened = softened_ends();
  if (comm->me == 0) potdem_write_block(fp, {ghost_cutoff, all[0], all[1], softened});
}

void FixPotdemBondHistory::restart(char *buf)
{
  const auto state = potdem_read_block(lmp, "Bonds of bond_style potdem/truss", buf, 4);
  ghost_cutoff = state[0];
  in_file.assign(state.begin() + 1, state.end());
}

// of the values of all bonds, on any number of ranks and in any order
std::vector<double> FixPotdemBondHistory::ends_and_sum() const
{
  PotdemSum mine;
  for (int i = 0; i < atom->nlocal; i++)
    for (int m = 0; m < atom->num_bond[i]; m++) {
      mine.add(values()[i] + m * NDATA, NDATA);
      const double area_found = area(i, m);
      mine.add(&area_found, 1);
      const auto part = dilatation(i, m);
      if (dilatations) mine.add(&part.own, 3);
      const auto law = softening(i, m);
      if (softenings) mine.add(&law.onset, 3);
    }
  return {static_cast<double>(mine.count(world)), mine.value(world)};
}

double FixPotdemBondHistory::softened_ends() const
{
  double mine = 0.0, all;
  for (int i = 0; i < atom->nlocal; i++)
    for (int m = 0; m < atom->num_bond[i]; m++) mine += softening(i, m).begun();
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return all;
}

// once, before bonds are computed. Where the user has taken some away or added some since, nothing can be said
void FixPotdemBondHistory::check_values()
{
  if (in_file.empty()) return;
  if (in_file.back() > 0.0 && !softenings)
    error->all(FLERR,
               "Bonds of the restart file have softened, and without a fix potdem/failure with an "
               "energy they would be whole again: define that fix as it was, before the run");
  in_file.pop_back();
  if (potdem_is_damaged(in_file, ends_and_sum()))
    error->all(
        FLERR,
        "The restart file is damaged: reference lengths or areas of bonds are not those that "
        "were written; continue from another file");
  in_file.clear();
}

/* ---------------------------------------------------------------------- */

void FixPotdemBondHistory::allow_exchange(int width)
{
  comm_forward = width;
}

void FixPotdemBondHistory::forward(double *data, int width)
{
  exchanged = data;
  exchanged_width = width;
  comm->forward_comm(this, width);
}

int FixPotdemBondHistory::pack_forward_comm(int n, int *list, double *buf, int /*pbc_flag*/,
                                            int * /*pbc*/)
{
  const int w = exchanged_width;
  for (int k = 0; k < n; k++)
    std::copy_n(exchanged + w * static_cast<bigint>(list[k]), w, buf + w * k);
  return n * w;
}

void FixPotdemBondHistory::unpack_forward_comm(int n, int first, double *buf)
{
  const int w = exchanged_width;
  std::copy_n(buf, n * w, exchanged + w * static_cast<bigint>(first));
}
