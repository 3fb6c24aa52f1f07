/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/glue/fix_potdem_refresh.h"

#include "lammps/glue/find_styles.h"
#include "lammps/glue/fix_potdem_resume.h"
#include "lammps/glue/interfaces.h"

#include "atom.h"
#include "atom_vec.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "modify.h"
#include "neigh_request.h"
#include "neighbor.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace FixConst;

static constexpr char REFRESH_ID[] = "POTDEM_REFRESH";

/* ---------------------------------------------------------------------- */

// fixes act in the order in which they were defined, and this one must see what the others insert
void FixPotdemRefresh::ensure(LAMMPS *lmp)
{
  auto *const modify = lmp->modify;
  auto *const found = modify->get_fix_by_id(REFRESH_ID);
  // within a run the order is settled: there fix adapt has styles of bond_style hybrid initialised again
  const auto *const update = lmp->update;
  const bool begun = update->setupflag || update->ntimestep > update->firststep;
  if (!begun) FixPotdemResume::ensure(lmp);
  if (found && (begun || found == modify->get_fix_by_index(modify->nfix - 1))) return;
  if (found) modify->delete_fix(REFRESH_ID);
  modify->add_fix(fmt::format("{} all POTDEM_REFRESH", REFRESH_ID));
}

FixPotdemRefresh::FixPotdemRefresh(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), box_then(), growth(0.0), largest_jump(0.0), moved(0.0), warned(false)
{
  force_reneighbor = 1;
  next_reneighbor = -1;
}

// LAMMPS sends the diameters of ghosts at each step if, and only if, the atom style lets them vary
int FixPotdemRefresh::setmask()
{
  const bool radii_vary = atom->radius_flag && !atom->avec->comm_x_only;
  return radii_vary ? POST_INTEGRATE | PRE_EXCHANGE | POST_NEIGHBOR | PRE_FORCE : PRE_EXCHANGE;
}

void FixPotdemRefresh::init()
{
  sized = potdem_find<SizedReach>(lmp);
  bonds = potdem_find<BondMemory>(lmp);
  largest_jump = 0.0;
  warned = false;
}

/* ----------------------------------------------------------------------
   particles and bonds are those of the coming lists
------------------------------------------------------------------------- */

void FixPotdemRefresh::pre_exchange()
{
  enum { SIZES, BONDS, NCHANGES };
  int mine[NCHANGES] = {0, 0}, all[NCHANGES];
  for (const auto *style : sized) mine[SIZES] = mine[SIZES] || style->outgrown();
  for (const auto *bond : bonds) mine[BONDS] = mine[BONDS] || bond->has_new_bonds();
  MPI_Allreduce(mine, all, NCHANGES, MPI_INT, MPI_MAX, world);
  if (!all[SIZES] && !all[BONDS]) return;
  if (all[SIZES]) renew_cutoffs();
  for (auto *bond : bonds)
    if (all[BONDS]) bond->expect_new_bonds();
  comm->setup();
  if (neighbor->style) neighbor->setup_bins();
}

/* ----------------------------------------------------------------------
   as Pair::init() and Neighbor::init() find them. Neighbor keeps its lists if it is asked for the same ones
   as at set-up; what it counts is that of the run
------------------------------------------------------------------------- */

void FixPotdemRefresh::renew_cutoffs()
{
  for (int k = 0; k < neighbor->old_nrequest; k++) {
    const int n = neighbor->request(nullptr);
    neighbor->requests[n]->copy_request(neighbor->old_requests[k], 1);
  }
  for (auto *style : sized) style->find_sizes();
  Pair *const whole = force->pair;
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) {
      const double cut = whole->init_one(i, j);
      whole->cutsq[i][j] = whole->cutsq[j][i] = cut * cut;
      whole->cutforce = MAX(whole->cutforce, cut);
    }
  const bigint ncalls = neighbor->ncalls, ndanger = neighbor->ndanger;
  neighbor->init();
  neighbor->ncalls = ncalls;
  neighbor->ndanger = ndanger;
}

/* ----------------------------------------------------------------------
   growing diameters eat the neighbour skin as movement does
------------------------------------------------------------------------- */

void FixPotdemRefresh::setup_post_neighbor()
{
  post_neighbor();
}

void FixPotdemRefresh::post_neighbor()
{
  radius_then.assign(atom->radius, atom->radius + atom->nlocal);
  mass_then.assign(atom->rmass, atom->rmass + atom->nlocal);
  std::copy_n(neighbor->bboxlo, 3, box_then);
  std::copy_n(neighbor->bboxhi, 3, box_then + 3);
  growth = moved = 0.0;
}

// how far its corners have moved, as Neighbor::check_distance() has it for a box that is not tilted
double FixPotdemRefresh::box_change() const
{
  double low = 0.0, high = 0.0;
  for (int k = 0; k < 3; k++) {
    low += pow(neighbor->bboxlo[k] - box_then[k], 2.0);
    high += pow(neighbor->bboxhi[k] - box_then[3 + k], 2.0);
  }
  return sqrt(low) + sqrt(high);
}

// what movement and growth have taken of the skin, or would with that much growth of radii
double FixPotdemRefresh::of_skin(double how_much) const
{
  double reach_per_size = 0.0;
  for (const auto *style : sized) reach_per_size = MAX(reach_per_size, style->reach_per_size());
  return 2.0 * moved + 2.0 * reach_per_size * how_much + box_change();
}

// diameters change after it is settled whether a step has new lists: room for one more change like those seen
void FixPotdemRefresh::post_integrate()
{
  if (sized.empty() || !neighbor->dist_check) return;
  const auto *const x = (const double(*)[3]) atom->x[0];
  double **const held = neighbor->get_xhold();
  const int n = neighbor->includegroup ? atom->nfirst : atom->nlocal;
  double mine[2] = {0.0, 0.0}, all[2];
  for (int i = 0; i < n; i++) {
    mine[0] = MAX(mine[0], atom->radius[i] - radius_then[i]);
    double moved2 = 0.0;
    for (int k = 0; k < 3; k++) moved2 += (x[i][k] - held[i][k]) * (x[i][k] - held[i][k]);
    mine[1] = MAX(mine[1], moved2);
  }
  MPI_Allreduce(mine, all, 2, MPI_DOUBLE, MPI_MAX, world);
  largest_jump = MAX(largest_jump, all[0] - growth);
  growth = all[0];
  if (growth > 0.0 && of_skin(growth) > neighbor->skin) warn_of_jump();
  moved = sqrt(all[1]);
  if (growth > 0.0 && of_skin(growth + largest_jump) > neighbor->skin)
    next_reneighbor = update->ntimestep;
}

// the forces of the step before were those of lists for smaller particles
void FixPotdemRefresh::warn_of_jump()
{
  if (!warned && comm->me == 0)
    error->warning(FLERR,
                   "Diameters grew by {:g} in one step, more than the neighbour skin {:g} has room "
                   "for: contacts "
                   "may have been missed on step {}; let them grow in smaller steps, or increase "
                   "the skin with "
                   "'neighbor'",
                   2.0 * largest_jump, neighbor->skin, update->ntimestep - 1);
  warned = true;
}

// the dashpots of bonds depend on the masses, which change with the diameters
void FixPotdemRefresh::pre_force(int /*vflag*/)
{
  if (bonds.empty()) return;
  if (std::equal(mass_then.begin(), mass_then.end(), atom->rmass)) return;
  mass_then.assign(atom->rmass, atom->rmass + atom->nlocal);
  for (auto *bond : bonds) bond->masses_changed();
}

double FixPotdemRefresh::memory_usage()
{
  return static_cast<double>(radius_then.capacity() + mass_then.capacity()) * sizeof(double);
}
