/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Failure of trusses (thesis 5.2.4): a bond whose axial stress reached its strength at one step is gone
   from the next step on, for good.

   The bond loop notes which bonds are overstretched while it computes their force. At the end of the
   step the rank that owns the end with the lower ID decides, and tells the rank of the other end: no two
   ranks can disagree by rounding. When the particles have moved in the next step both remove the bond,
   before its forces, and the pair comes into the neighbour lists at once. Velocity Verlet thus applies
   the bond's force for the first half of the step in between and not for the second: its fracture energy
   is the mean of its elastic energies at both ends of that step, which closes the energy balance to
   second order. Set-up removes nothing.

   With `criterion principal` the bond loop notes which bonds are loaded, and at the end of the step the stress of their particles
   decides (potdem_crack_onset.h); with an energy bonds then soften (potdem_softening.h) over an opening that depends on their angle to the
   largest stress: a crack of the normal n and the opening w stretches a bond of the direction m by w n.m, so that all bonds that cross
   it end at the same opening w_c = 2 Gf/s, whatever their lengths and directions. When it begins their forces balance the stress s over
   any cut, and so the energy of the cut is s w_c/2 = Gf, whatever its shape. Damage is found from where the particles are, on
   each rank for its own ends.

   Ranks that share no bonds hear nothing of each other, and sums
   over all of them are made when somebody asks. */

#include "lammps/bond/fix_potdem_failure.h"

#include "core/laws/truss.h"
#include "lammps/bond/potdem_bond_strengths.h"
#include "lammps/glue/find_styles.h"
#include "lammps/glue/fix_potdem_bond_history.h"
#include "lammps/glue/lammps_compat.h"
#include "lammps/glue/potdem_input.h"
#include "lammps/glue/potdem_material_input.h"
#include "lammps/glue/potdem_restart_block.h"
#include "lammps/glue/potdem_swap.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "group.h"
#include "math_extra.h"
#include "memory.h"
#include "modify.h"
#include "neighbor.h"
#include "output.h"
#include "pair.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace FixConst;

static constexpr int FAILURE_WIDTH = 10;    // columns of the local output
// steps from one look at the stress of the solid to the next: a wave comes no further than about one particle in between
static constexpr int PERIOD = 4;
// of bonds that soften: no flatter to the crack than this, nor shorter than this times the elongation at which they began
static constexpr double LEAST_COSINE = 0.2, LEAST_RANGE = 1.05;

/* ---------------------------------------------------------------------- */

FixPotdemFailure::FixPotdemFailure(LAMMPS *lmp, int narg, char **arg) :
    FixUpdateSpecialBonds(lmp, MIN(narg, 3), arg), btype(0), tension(-1.0), compression(-1.0),
    toughness(0.0), principal(false), lost{}, uncounted(0), bonds(nullptr), history(nullptr),
    maxrows(0), generation(-1)
{
  potdem_needs_setup(lmp);
  PotdemMaterialInput input(lmp, "fix potdem/failure", narg - 3, arg + 3);
  static_assert(sizeof(Failure) == FAILURE_WIDTH * sizeof(double), "a failure is a row");
  btype = input.bond_type();
  bool has_criterion = false;
  while (!input.done()) {
    if (input.next_is("tension"))
      tension = input.property("tension");
    else if (input.next_is("compression"))
      compression = input.property("compression");
    else if (input.next_is("scatter"))
      scatter = read_scatter(input);
    else if (input.next_is("energy"))
      toughness = input.in_range("energy Gf", POTDEM::positive());
    else if (input.next_is("criterion")) {
      has_criterion = true;
      principal = read_criterion(input);
    } else {
      input.word();
      input.unknown("tension, compression, energy, criterion or scatter");
    }
  }
  if (tension < 0.0 && compression < 0.0)
    input.fail("give a strength: tension ft, compression fc, or both");
  if (toughness > 0.0 && has_criterion && !principal)
    input.fail("energy Gf needs the direction of the largest stress: leave out criterion bond");
  principal = principal || toughness > 0.0;
  if (principal && tension < 0.0)
    input.fail("energy Gf and criterion principal are for failure in tension: give tension ft");

  scalar_flag = vector_flag = 1;
  size_vector = 4;
  global_freq = 1;
  extscalar = extvector = 0;
  local_flag = 1;
  local_freq = 1;
  size_local_cols = FAILURE_WIDTH;
  size_local_rows = 0;
  restart_global = 1;
}

FixPotdemFailure::~FixPotdemFailure()
{
  potdem_needs_setup(lmp);
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

// bond | principal: whether it is principal
bool FixPotdemFailure::read_criterion(PotdemInput &input)
{
  if (input.next_is("principal")) return true;
  if (!input.next_is("bond")) {
    input.word();
    input.unknown("bond or principal after criterion");
  }
  return false;
}

int FixPotdemFailure::setmask()
{
  return POST_INTEGRATE | END_OF_STEP | POST_RUN;
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
  const char *const other = principal ? bonds->cannot_soften(btype) : nullptr;
  if (other)
    error->all(FLERR,
               "Fix potdem/failure {}: energy Gf and criterion principal do not go with '{}' in "
               "bond_coeff {}: leave one of them out",
               id, other, btype);
}

void FixPotdemFailure::give_strengths_to(BondStrengths &strengths) const
{
  const double noted = principal ? BondStrengths::LOADED * tension : tension;
  strengths.set(btype, noted, compression, scatter, toughness > 0.0);
}

// unlike its base class, it works with bonded pairs left out of the neighbour list altogether (the bond
// style checks the weights), and a bond that set-up finds overstretched fails before the first step
void FixPotdemFailure::setup(int /*vflag*/)
{
  warn_if_idle();
  if (toughness > 0.0) check_softening();
  decide();
}

// a longer bond would have more elastic energy at its strength than its part of the crack costs
void FixPotdemFailure::check_softening()
{
  for (int n = 0; n < neighbor->nbondlist; n++) {
    const int *const listed = neighbor->bondlist[n];
    if (listed[2] != btype || listed[0] >= atom->nlocal) continue;
    const tagint tags[2] = {atom->tag[listed[0]], atom->tag[listed[1]]};
    const double ft = tension * scatter.factor(tags[0], tags[1]);
    const double re = history->length(listed[0], history->slot(listed[0], tags[1]));
    const double most = 2.0 * bonds->youngs_modulus(btype) * toughness / (ft * ft);
    if (re >= most)
      error->one(
          FLERR,
          "Fix potdem/failure {}: the bond of atoms {} and {} is {:g} long, and with E, ft and "
          "Gf = {:g} a crack takes only bonds shorter than 2 E Gf/ft^2 = {:g}, else it snaps: "
          "use particles smaller by the factor {:.2g}, or leave out energy",
          id, tags[0], tags[1], re, toughness, most, most / re);
  }
}

// most likely a wrong bond type or group; but bonds may still come, or all have failed
void FixPotdemFailure::warn_if_idle()
{
  if (update->nsteps == 0 || totals().count() > 0.0) return;
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
  decide();
  if (update->ntimestep == output->next) count_bonds();
}

void FixPotdemFailure::post_run()
{
  count_bonds();
}

void FixPotdemFailure::decide()
{
  if (generation != history->generation) follow_lists();
  pending.clear();
  lost.energy += bonds->freed_energy(btype);
  if (principal) find_onsets();
  for (const auto &over : bonds->overstretched())
    if (over.type == btype && !(principal && over.tension)) doom(over.i, over.j);
  for (const auto &spent : bonds->spent())
    if (spent.type == btype) doom(spent.i, spent.j);
  if (!told.empty()) tell();
  for (const auto &doomed : pending) {
    if (owns(doomed.low)) bonds->expect_cut(atom->map(doomed.low), doomed.high);
    if (owns(doomed.high)) bonds->expect_cut(atom->map(doomed.high), doomed.low);
  }
}

// that of the end with the lower ID decides
void FixPotdemFailure::doom(int i, int j)
{
  const tagint *tag = atom->tag;
  const int nlocal = atom->nlocal;
  if (!(atom->mask[i] & atom->mask[j] & groupbit) || (j >= nlocal && tag[j] < tag[i])) return;
  double del[3];
  MathExtra::sub3(atom->x[j], atom->x[i], del);
  pending.push_back({MIN(tag[i], tag[j]), MAX(tag[i], tag[j]),
                     bond_energy(i, tag[j], MathExtra::lensq3(del)),
                     j < nlocal ? comm->me : owner[j - nlocal]});
}

// bonds that a crack reaches
void FixPotdemFailure::find_onsets()
{
  if (update->ntimestep % PERIOD) return;
  BreakableBonds::CrackQuestion question{btype, groupbit, tension, scatter, owner, {}};
  for (const auto &[rank, pairs] : told) question.sharing.push_back(rank);
  for (const auto &one : bonds->reached_by_cracks(question)) {
    const double re = history->length(one.i, history->slot(one.i, atom->tag[one.j]));
    if (toughness > 0.0)
      bonds->soften(one.i, one.j, softening_of(one, re));
    else
      doom(one.i, one.j);
  }
}

// A bond across the crack ends at the crack's last opening. One that lies nearly in its plane says little of it, and has an end of its own
POTDEM::Softening FixPotdemFailure::softening_of(const BreakableBonds::Reached &one,
                                                 double re) const
{
  const double opening = 2.0 * toughness / one.stress;
  const double elongation =
      MAX(opening * MAX(one.cosine, LEAST_COSINE), LEAST_RANGE * re * one.strain);
  const double x = 1.0 + elongation / re;
  return {one.strain, POTDEM::truss_strain(x * x), 0.0};
}

// the ranks that this one shares bonds of the type with
void FixPotdemFailure::follow_lists()
{
  generation = history->generation;
  told.clear();
  if (comm->nprocs == 1) {
    owner.assign(atom->nghost, comm->me);
    return;
  }
  std::vector<double> rank(atom->nlocal + atom->nghost, comm->me);
  history->forward(rank.data(), 1);
  owner.assign(rank.begin() + atom->nlocal, rank.end());
  for (int n = 0; n < neighbor->nbondlist; n++) {
    const int *const listed = neighbor->bondlist[n];
    if (listed[2] != btype || listed[1] < atom->nlocal) continue;
    const int other = owner[listed[1] - atom->nlocal];
    if (other != comm->me) told[other];
  }
}

// afterwards both ranks have the bonds that they share in the same order
void FixPotdemFailure::tell()
{
  for (const auto &doomed : pending)
    if (doomed.other != comm->me) told[doomed.other].push_back({doomed.low, doomed.high});
  potdem_swap(world, told);
  for (auto &[rank, pairs] : told) {
    for (const auto &pair : pairs) pending.push_back({pair.low, pair.high, 0.0, rank});
    pairs.clear();
  }
  std::sort(pending.begin(), pending.end(), [](const Doomed &a, const Doomed &b) {
    return a.low != b.low ? a.low < b.low : a.high < b.high;
  });
}

bool FixPotdemFailure::owns(tagint tag) const
{
  const int i = atom->map(tag);
  return i >= 0 && i < atom->nlocal;
}

/* ----------------------------------------------------------------------
   A failed pair must be in the neighbour list before it can touch. Until the next regular rebuild no particle is
   further than half a skin from its place at the last one, and none is now: two particles approach each other by
   two skins at most.
------------------------------------------------------------------------- */

void FixPotdemFailure::post_integrate()
{
  if (pending.empty()) return;
  const auto apart = distances();
  std::vector<PotdemNewContact> begun;
  for (std::size_t k = 0; k < pending.size(); k++) {
    const auto &doomed = pending[k];
    const double r = sqrt(apart[k].r2);
    const double gap = r - contact_reach(atom->map(doomed.low), atom->map(doomed.high));
    // a pair within reach of its contact law remembers the distance, at which the law will begin
    const double contact = gap < 0.0 ? r : 0.0;
    if (owns(doomed.low)) record(describe(doomed, apart[k], contact));
    remove(doomed, apart[k].r2);
    if (gap < 2.0 * neighbor->skin) history->parted.add(doomed.low, doomed.high);
    begun.push_back({doomed.low, doomed.high, contact});
  }
  pre_exchange();    // LAMMPS's special lists know it at once
  for (auto *const contacts : potdem_find<ContactMemory>(lmp)) contacts->expect_contacts(begun);
  pending.clear();
}

// where the particles are now; those of other ranks have moved since they were communicated
std::vector<FixPotdemFailure::Apart> FixPotdemFailure::distances() const
{
  struct Place {
    double x[3];
  };
  const auto place = [this](tagint tag) {
    Place at;
    std::copy_n(atom->x[atom->map(tag)], 3, at.x);
    return at;
  };
  std::map<int, std::vector<Place>> places;
  for (const auto &doomed : pending)
    if (doomed.other != comm->me)
      places[doomed.other].push_back(place(owns(doomed.low) ? doomed.low : doomed.high));
  if (!places.empty()) potdem_swap(world, places);
  std::map<int, std::size_t> taken;
  std::vector<Apart> apart;
  for (const auto &doomed : pending) {
    const bool here = doomed.other == comm->me, own_low = owns(doomed.low);
    const Place mine = place(own_low ? doomed.low : doomed.high);
    const Place theirs = here ? place(doomed.high) : places[doomed.other][taken[doomed.other]++];
    Apart one;
    MathExtra::sub3(theirs.x, mine.x, one.del);
    PotdemCompat::minimum_image(domain, one.del);
    one.r2 = MathExtra::lensq3(one.del);
    apart.push_back(one);
  }
  return apart;
}

FixPotdemFailure::Failure FixPotdemFailure::describe(const Doomed &doomed, const Apart &apart,
                                                     double contact) const
{
  const int i = atom->map(doomed.low);
  const double *const x = atom->x[i], *const del = apart.del;
  const double re = history->length(i, history->slot(i, doomed.high));
  return {static_cast<double>(update->ntimestep),
          update->atime + (update->ntimestep - update->atimestep) * update->dt,
          static_cast<double>(doomed.low),
          static_cast<double>(doomed.high),
          x[0] + 0.5 * del[0],
          x[1] + 0.5 * del[1],
          x[2] + 0.5 * del[2],
          POTDEM::truss_strain(apart.r2 / (re * re)),
          0.5 * (doomed.energy + bond_energy(i, doomed.high, apart.r2)),
          contact};
}

// within which the pair style may act on particles of these types
double FixPotdemFailure::contact_reach(int i, int j) const
{
  return force->pair ? sqrt(force->pair->cutsq[atom->type[i]][atom->type[j]]) : 0.0;
}

double FixPotdemFailure::bond_energy(int i, tagint partner, double r2) const
{
  return bonds->energy_of_bond(btype, r2, i, atom->map(partner));
}

// counted where it was decided
void FixPotdemFailure::record(const Failure &failure)
{
  if (size_local_rows == MAXSMALLINT)
    error->one(FLERR,
               "Fix potdem/failure {}: {} failed bonds on one rank are too many for its local "
               "output",
               id, size_local_rows);
  if (size_local_rows == maxrows) {
    // growth costs a constant time a row
    maxrows = static_cast<int>(MIN(2 * static_cast<bigint>(maxrows) + 64, MAXSMALLINT));
    memory->grow(array_local, maxrows, FAILURE_WIDTH, "potdem/failure:array_local");
  }
  std::copy_n(&failure.step, FAILURE_WIDTH, array_local[size_local_rows++]);
  (failure.strain > 0.0 ? lost.tension : lost.compression) += 1.0;
  lost.energy += failure.energy;
  uncounted++;
}

/* ----------------------------------------------------------------------
   wherever this rank holds the bond, for good
------------------------------------------------------------------------- */

void FixPotdemFailure::remove(const Doomed &doomed, double r2)
{
  const tagint tags[2] = {doomed.low, doomed.high};
  for (int end = 0; end < 2; end++) {
    if (!owns(tags[end])) continue;
    const int i = atom->map(tags[end]);
    bonds->cut(i, tags[1 - end], r2);
    history->remove(i, history->slot(i, tags[1 - end]));
  }
  add_broken_bond(atom->map(tags[0]), atom->map(tags[1]));
  new_broken_pairs.clear();    // the base class's list for pairs that are in the neighbour list
}

/* ----------------------------------------------------------------------
   over all ranks
------------------------------------------------------------------------- */

FixPotdemFailure::Totals FixPotdemFailure::over_all_ranks(const Totals &mine) const
{
  Totals all;
  MPI_Allreduce(&mine, &all, sizeof(Totals) / sizeof(double), MPI_DOUBLE, MPI_SUM, world);
  return all;
}

// with the bonds that soften
FixPotdemFailure::Totals FixPotdemFailure::totals() const
{
  Totals mine = lost;
  for (const auto *const one : potdem_find<BreakableBonds>(lmp))
    if (one->owns(btype)) {
      mine.energy += one->softening_energy(btype);
      mine.softening += one->softening_bonds(btype);
    }
  return over_all_ranks(mine);
}

// LAMMPS's number of bonds is one number, the same everywhere
void FixPotdemFailure::count_bonds()
{
  bigint all;
  MPI_Allreduce(&uncounted, &all, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  atom->nbonds -= all;
  uncounted = 0;
}

double FixPotdemFailure::compute_scalar()
{
  return totals().count();
}

double FixPotdemFailure::compute_vector(int n)
{
  const auto all = totals();
  const double values[4] = {all.energy, all.tension, all.compression, all.softening};
  return values[n];
}

double FixPotdemFailure::memory_usage()
{
  return static_cast<double>(maxrows) * (FAILURE_WIDTH * sizeof(double) + sizeof(double *)) +
      static_cast<double>(owner.capacity()) * sizeof(int);
}

/* ---------------------------------------------------------------------- */

// the run that writes goes on from one sum, too, like the one that will read it
void FixPotdemFailure::write_restart(FILE *fp)
{
  const auto all = over_all_ranks(lost);
  lost = comm->me == 0 ? all : Totals();
  if (comm->me == 0) potdem_write_block(fp, {all.energy, all.tension, all.compression});
}

void FixPotdemFailure::restart(char *buf)
{
  const auto state = potdem_read_block(lmp, fmt::format("Fix potdem/failure {}", id), buf, 3);
  if (comm->me == 0) lost = {state[0], state[1], state[2], 0.0};
}
