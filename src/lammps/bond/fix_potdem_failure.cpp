/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Failure of trusses (thesis 5.2.4): a bond whose axial stress reached its strength at one step is gone
   from the next step on, for good.

   The bond loop notes which bonds are overstretched while it computes their force. At the end of the
   step the rank that owns the end with the lower ID reports them to all ranks, and before the forces of
   the next step each rank removes them where it holds them: no two ranks can disagree by rounding.
   Velocity Verlet thus applies the bond's force for the first half of the step in between and not for
   the second: its fracture energy is the mean of its elastic energies at both ends of that step, which
   closes the energy balance to second order. Set-up removes nothing. */

#include "lammps/bond/fix_potdem_failure.h"

#include "core/laws/truss.h"
#include "lammps/bond/potdem_bond_strengths.h"
#include "lammps/glue/find_styles.h"
#include "lammps/glue/fix_potdem_bond_history.h"
#include "lammps/glue/lammps_compat.h"
#include "lammps/glue/potdem_gather.h"
#include "lammps/glue/potdem_material_input.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "group.h"
#include "memory.h"
#include "modify.h"
#include "neighbor.h"
#include "pair.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

using namespace LAMMPS_NS;
using namespace FixConst;

static constexpr int FAILURE_WIDTH = 10;    // columns of the local output

/* ---------------------------------------------------------------------- */

FixPotdemFailure::FixPotdemFailure(LAMMPS *lmp, int narg, char **arg) :
    FixUpdateSpecialBonds(lmp, MIN(narg, 3), arg), btype(0), tension(-1.0), compression(-1.0),
    ntension(0.0), ncompression(0.0), lost_energy(0.0), bonds(nullptr), history(nullptr), maxrows(0)
{
  PotdemMaterialInput input(lmp, "fix potdem/failure", narg - 3, arg + 3);
  static_assert(offsetof(Failure, gap) == FAILURE_WIDTH * sizeof(double),
                "Failure begins with a row");
  btype = input.bond_type();
  while (!input.done()) {
    if (input.next_is("tension"))
      tension = input.property("tension");
    else if (input.next_is("compression"))
      compression = input.property("compression");
    else if (input.next_is("scatter"))
      scatter = read_scatter(input);
    else {
      input.word();
      input.unknown("tension, compression or scatter");
    }
  }
  if (tension < 0.0 && compression < 0.0)
    input.fail("give a strength: tension ft, compression fc, or both");

  scalar_flag = vector_flag = 1;
  size_vector = 3;
  global_freq = 1;
  extscalar = extvector = 0;
  local_flag = 1;
  local_freq = 1;
  size_local_cols = FAILURE_WIDTH;
  size_local_rows = 0;
  restart_global = 1;
  force_reneighbor = 1;
  next_reneighbor = -1;
}

FixPotdemFailure::~FixPotdemFailure()
{
  memory->destroy(array_local);
}

// weibull k SEED | normal cov SEED
POTDEM::StrengthScatter FixPotdemFailure::read_scatter(PotdemInput &input)
{
  if (input.next_is("weibull")) {
    const double k = input.in_range("scatter weibull k", POTDEM::positive());
    return POTDEM::StrengthScatter::weibull(k, input.whole("scatter seed", MAXSMALLINT));
  }
  if (!input.next_is("normal")) {
    input.word();
    input.unknown("weibull or normal after scatter");
  }
  const double cov = input.in_range("scatter normal cov", POTDEM::positive());
  if (cov > POTDEM::StrengthScatter::LARGEST_COV)
    input.fail(fmt::format("scatter normal cov = {} is out of range, it must be > 0 and <= {}; "
                           "use scatter weibull for a larger spread",
                           cov, POTDEM::StrengthScatter::LARGEST_COV));
  return POTDEM::StrengthScatter::normal(cov, input.whole("scatter seed", MAXSMALLINT));
}

int FixPotdemFailure::setmask()
{
  return PRE_EXCHANGE | PRE_FORCE | END_OF_STEP;
}

/* ---------------------------------------------------------------------- */

void FixPotdemFailure::init()
{
  find_bonds();
  for (const auto &other : modify->get_fix_by_style("^potdem/failure$"))
    if (other != this && dynamic_cast<FixPotdemFailure *>(other)->btype == btype)
      error->all(FLERR,
                 "Fixes potdem/failure {} and {} are for the same bond type {}: one bond type has "
                 "one strength, "
                 "use another bond type or one fix",
                 id, other->id, btype);
  history = FixPotdemBondHistory::find(lmp);
}

void FixPotdemFailure::find_bonds()
{
  bonds = nullptr;
  const auto offered = potdem_find<BreakableBonds>(lmp);
  for (auto *const one : offered)
    if (one->owns(btype)) bonds = one;
  if (offered.empty()) error->all(FLERR, "Fix potdem/failure {} needs bond_style potdem/truss", id);
  if (!bonds)
    error->all(FLERR,
               "Fix potdem/failure {}: bonds of type {} are of another bond style: give the fix a "
               "bond type of bond_style potdem/truss",
               id, btype);
}

void FixPotdemFailure::give_strengths_to(BondStrengths &strengths) const
{
  strengths.set(btype, tension, compression, scatter);
}

// unlike its base class, it works with bonded pairs left out of the neighbour list altogether (the bond
// style checks the weights), and a bond that set-up finds overstretched fails before the first step
void FixPotdemFailure::setup(int /*vflag*/)
{
  warn_if_idle();
  agree();
}

// most likely a wrong bond type or group; but bonds may still come, or all have failed
void FixPotdemFailure::warn_if_idle() const
{
  if (update->nsteps == 0 || ntension + ncompression > 0.0) return;
  // per bond type whether there is a bond, and first whether there is one for this fix
  std::vector<int> mine(atom->nbondtypes + 1, 0), there(atom->nbondtypes + 1);
  for (int n = 0; n < neighbor->nbondlist; n++) {
    const int *const listed = neighbor->bondlist[n];
    mine[listed[2]] = 1;
    if (listed[2] == btype && (atom->mask[listed[0]] & atom->mask[listed[1]] & groupbit))
      mine[0] = 1;
  }
  MPI_Allreduce(mine.data(), there.data(), atom->nbondtypes + 1, MPI_INT, MPI_MAX, world);
  if (there[0] || comm->me != 0) return;
  std::string types;
  for (int type = 1; type <= atom->nbondtypes; type++)
    if (there[type]) types += (types.empty() ? "" : ", ") + std::to_string(type);
  error->warning(FLERR,
                 "Fix potdem/failure {}: no bond of type {} has both ends in group {}, so nothing "
                 "can fail until one comes; there are {}; give the fix a bond type and a group "
                 "that have bonds, or make them with potdem_bonds",
                 id, btype, group->names[igroup],
                 types.empty() ? "no bonds at all" : "bonds of type " + types);
}

/* ---------------------------------------------------------------------- */

void FixPotdemFailure::end_of_step()
{
  agree();
}

void FixPotdemFailure::agree()
{
  std::vector<Pending> mine;
  const tagint *tag = atom->tag;
  for (const auto &over : bonds->overstretched()) {
    const int i = over.i, j = over.j;
    if (over.type != btype || !(atom->mask[i] & atom->mask[j] & groupbit)) continue;
    if (j >= atom->nlocal && tag[j] < tag[i]) continue;
    mine.push_back({MIN(tag[i], tag[j]), MAX(tag[i], tag[j]), bond_energy(i, j)});
  }
  pending = potdem_gather(lmp, mine, "failing bonds");
}

/* ----------------------------------------------------------------------
   A failed pair must come into the neighbour list before it can touch. Until the next regular rebuild no particle is
   further than half a skin from its place at the last one, and none is now: two particles approach each other by
   two skins at most.
------------------------------------------------------------------------- */

void FixPotdemFailure::pre_force(int /*vflag*/)
{
  if (pending.empty()) return;
  bonds->follow_lists();
  const auto failed = describe_pending();
  pending.clear();
  bool near = false;
  std::vector<PotdemNewContact> begun;
  for (const auto &failure : failed) {
    remove(failure);
    begun.push_back(
        {static_cast<tagint>(failure.tag1), static_cast<tagint>(failure.tag2), failure.contact});
    near = near || failure.gap < 2.0 * neighbor->skin;
    (failure.strain > 0.0 ? ntension : ncompression) += 1.0;
    lost_energy += failure.energy;
    atom->nbonds--;
  }
  pre_exchange();    // LAMMPS's special lists know it at once
  // a pair within reach of its contact law remembers the distance, at which the law will begin
  for (auto *const contacts : potdem_find<ContactMemory>(lmp)) contacts->expect_contacts(begun);
  if (near) next_reneighbor = update->ntimestep + 1;
}

std::vector<FixPotdemFailure::Failure> FixPotdemFailure::describe_pending()
{
  std::vector<Failure> mine;
  for (const auto &doomed : pending) {
    const int i = atom->map(doomed.low);
    if (atom->map(doomed.high) >= 0 && i >= 0 && i < atom->nlocal)
      mine.push_back(describe(i, doomed));
  }
  record(mine);
  return potdem_gather(lmp, mine, "failing bonds");
}

void FixPotdemFailure::record(const std::vector<Failure> &failed)
{
  const bigint wanted = size_local_rows + static_cast<bigint>(failed.size());
  if (wanted > MAXSMALLINT)
    error->one(
        FLERR,
        "Fix potdem/failure {}: {} failed bonds on one rank are too many for its local output", id,
        wanted);
  if (wanted > maxrows) {
    maxrows =
        static_cast<int>(MIN(2 * wanted, MAXSMALLINT));    // growth costs a constant time a row
    memory->grow(array_local, maxrows, FAILURE_WIDTH, "potdem/failure:array_local");
  }
  for (const auto &failure : failed)
    std::copy_n(&failure.step, FAILURE_WIDTH, array_local[size_local_rows++]);
}

FixPotdemFailure::Failure FixPotdemFailure::describe(int i, const Pending &doomed) const
{
  const int j = domain->closest_image(i, atom->map(doomed.high));
  const double *xi = atom->x[i], *xj = atom->x[j];
  const double del[3] = {xj[0] - xi[0], xj[1] - xi[1], xj[2] - xi[2]};
  const double r2 = del[0] * del[0] + del[1] * del[1] + del[2] * del[2], r = sqrt(r2);
  const double gap = r - contact_reach(i, j),
               re = history->length(i, history->slot(i, doomed.high));
  return {static_cast<double>(update->ntimestep),
          update->atime + (update->ntimestep - update->atimestep) * update->dt,
          static_cast<double>(doomed.low),
          static_cast<double>(doomed.high),
          0.5 * (xi[0] + xj[0]),
          0.5 * (xi[1] + xj[1]),
          0.5 * (xi[2] + xj[2]),
          POTDEM::truss_strain(r2 / (re * re)),
          0.5 * (doomed.energy + bond_energy(i, j)),
          gap < 0.0 ? r : 0.0,
          gap};
}

// within which the pair style may act on particles of these types
double FixPotdemFailure::contact_reach(int i, int j) const
{
  return force->pair ? sqrt(force->pair->cutsq[atom->type[i]][atom->type[j]]) : 0.0;
}

double FixPotdemFailure::bond_energy(int i, int j) const
{
  const double *xi = atom->x[i], *xj = atom->x[j];
  const double del[3] = {xj[0] - xi[0], xj[1] - xi[1], xj[2] - xi[2]};
  return bonds->energy_of_bond(btype, del[0] * del[0] + del[1] * del[1] + del[2] * del[2], i, j);
}

/* ----------------------------------------------------------------------
   wherever this rank holds the bond, for good
------------------------------------------------------------------------- */

void FixPotdemFailure::remove(const Failure &failure)
{
  const tagint tags[2] = {static_cast<tagint>(failure.tag1), static_cast<tagint>(failure.tag2)};
  bool held = false;
  for (int end = 0; end < 2; end++) {
    const int i = atom->map(tags[end]);
    if (i < 0 || i >= atom->nlocal) continue;
    held = true;
    bonds->cut(i, tags[1 - end]);
    history->remove(i, history->slot(i, tags[1 - end]));
  }
  if (!held) return;
  add_broken_bond(atom->map(tags[0]), atom->map(tags[1]));
  new_broken_pairs.clear();    // the base class's list for pairs that are in the neighbour list
}

/* ---------------------------------------------------------------------- */

double FixPotdemFailure::compute_scalar()
{
  return ntension + ncompression;
}

double FixPotdemFailure::compute_vector(int n)
{
  const double values[3] = {lost_energy, ntension, ncompression};
  return values[n];
}

double FixPotdemFailure::memory_usage()
{
  return static_cast<double>(maxrows) * (FAILURE_WIDTH * sizeof(double) + sizeof(double *));
}

/* ---------------------------------------------------------------------- */

void FixPotdemFailure::write_restart(FILE *fp)
{
  pre_exchange();    // special lists as the restart file's reader must find them
  const double state[3] = {lost_energy, ntension, ncompression};
  const int size = sizeof(state);
  if (comm->me == 0) {
    fwrite(&size, sizeof(int), 1, fp);
    fwrite(state, size, 1, fp);
  }
}

void FixPotdemFailure::restart(char *buf)
{
  const auto state = reinterpret_cast<const double *>(buf);
  lost_energy = state[0];
  ntension = state[1];
  ncompression = state[2];
}
