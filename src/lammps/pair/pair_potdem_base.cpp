/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/pair/pair_potdem_base.h"

#include "lammps/glue/find_styles.h"
#include "lammps/glue/fix_potdem_refresh.h"
#include "lammps/glue/lammps_compat.h"
#include "lammps/glue/potdem_input.h"
#include "lammps/output/fix_potdem_monitor.h"
#include "lammps/pair/fix_potdem_contacts.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix.h"
#include "force.h"
#include "math_extra.h"
#include "memory.h"
#include "modify.h"
#include "neigh_list.h"
#include "neigh_request.h"
#include "neighbor.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

PairPotdemBase::PairPotdemBase(LAMMPS *lmp) :
    PairWithCutoffsBySize(lmp), rotation(0), ledger(nullptr), contacts(nullptr), monitor(nullptr),
    atom_types(0), contacts_id(FixPotdemContacts::reserve(lmp)), lost_contacts(false)
{
  potdem_needs_setup(lmp);
}

PairPotdemBase::~PairPotdemBase()
{
  potdem_needs_setup(lmp);
  FixPotdemContacts::release(lmp, contacts_id);
}

// what they need of LAMMPS; sliding, viscous: forces that depend on velocities
void PairPotdemBase::require_particles(bool contact_only, bool sliding, bool viscous)
{
  potdem_refuse_respa(lmp, fmt::format("pair_style {}", name()));
  if (!atom->radius_flag || !atom->rmass_flag)
    error->all(FLERR,
               "pair_style {} needs particle diameters, e.g. atom_style sphere or bpm/sphere",
               name());
  ledger = FixPotdemLedger::find(lmp);
  monitor = FixPotdemMonitor::ensure(lmp);
  FixPotdemRefresh::ensure(lmp);
  find_sizes();
  if (contact_only) PotdemCompat::has_cutoffs_by_size(this, 0);
  if (rotation && !(atom->omega_flag && atom->torque_flag))
    error->all(FLERR,
               "pair_style {}: rotation needs an atom style with spin, e.g. atom_style sphere",
               name());
  if (rotation && sliding && monitor && atom->nbonds > 0)
    potdem_warn_of_rolling_bodies(lmp, fmt::format("pair_style {}", name()));
  if (sliding || viscous) comm->ghost_velocity = 1;
  neighbor->add_request(this, contact_only ? NeighConst::REQ_SIZE : NeighConst::REQ_DEFAULT);
}

// where bonds can fail, or friction remembers; or where a restart file has brought what contacts remember
void PairPotdemBase::find_contacts(int state)
{
  if (lost_contacts)
    error->all(FLERR,
               "pair_style {}: fix {}, in which contacts remember where they begin, was removed "
               "with unfix: "
               "keep it, or start the simulation again",
               name(), contacts_id);
  const bool bonds = !potdem_find<BondMemory>(lmp).empty();
  if (state > 0 || bonds || modify->get_fix_by_id(contacts_id))
    contacts = FixPotdemContacts::ensure(lmp, contacts_id, this, state);
}

void PairPotdemBase::expect_contacts(const std::vector<PotdemNewContact> &announced)
{
  if (contacts) contacts->expect(announced);
}

void PairPotdemBase::lose_contacts()
{
  contacts = nullptr;
  lost_contacts = true;
}

// for neighbor multi with collections by size
double PairPotdemBase::atom2cut(int i)
{
  return 2.0 * atom->radius[i];
}

double PairPotdemBase::radii2cut(double ri, double rj)
{
  return ri + rj;
}

void PairPotdemBase::find_sizes()
{
  const double none = std::numeric_limits<double>::infinity();
  const int ntypes = atom->ntypes;
  std::vector<double> mine(ntypes + 1, 0.0), radius(ntypes + 1, none), mass(ntypes + 1, none);
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->radius[i] > 0.0))
      error->one(FLERR,
                 "pair_style {}: atom {} has diameter {}, it must be > 0; use set ... diameter",
                 name(), atom->tag[i], 2.0 * atom->radius[i]);
    const int type = atom->type[i];
    mine[type] = MAX(mine[type], atom->radius[i]);
    radius[type] = MIN(radius[type], atom->radius[i]);
    mass[type] = MIN(mass[type], atom->rmass[i]);
  }
  add_announced_radii(mine);
  const auto over_ranks = [this](const std::vector<double> &values, std::vector<double> &all,
                                 MPI_Op op) {
    all.resize(values.size());
    MPI_Allreduce(values.data(), all.data(), values.size(), MPI_DOUBLE, op, world);
  };
  over_ranks(mine, largest_radius, MPI_MAX);
  over_ranks(radius, least_radius, MPI_MIN);
  over_ranks(mass, least_mass, MPI_MIN);
}

// LAMMPS's way to learn of particles that fix pour and fix deposit are going to insert
void PairPotdemBase::add_announced_radii(std::vector<double> &largest) const
{
  for (const auto &fix : modify->get_fix_list())
    for (int type = 1; type <= atom->ntypes; type++) {
      int asked = type;
      const auto *const radius = static_cast<const double *>(fix->extract("radius", asked));
      if (radius) largest[type] = MAX(largest[type], *radius);
    }
}

bool PairPotdemBase::outgrown() const
{
  for (int i = 0; i < atom->nlocal; i++) {
    const int type = atom->type[i];
    const double radius = atom->radius[i];
    if (radius > largest_radius[type] || radius < least_radius[type] ||
        atom->rmass[i] < least_mass[type])
      return true;
  }
  return false;
}

double PairPotdemBase::reach_per_size() const
{
  double most = 0.0;
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) most = MAX(most, reach(i, j, 1.0) - reach(i, j, 0.0));
  return most;
}

void PairPotdemBase::cannot_mix(int i, int j, const std::string &coefficient) const
{
  error->all(FLERR,
             "pair_style {}: types {} and {} have different {}, which cannot be mixed; give "
             "pair_coeff {} {} explicitly",
             name(), i, j, coefficient, i, j);
}

// a pair whose bond failed within reach of this law has the law moved inwards, so that it begins where the bond
// ended: failure creates no energy. 0: it begins where particles of this size touch
POTDEM::ContactGeometry PairPotdemBase::geometry(int i, int j, double begins) const
{
  const double ri = atom->radius[i], rj = atom->radius[j], dbar = ri + rj;
  if (begins == 0.0) return {ri, rj, dbar};
  return {ri, rj, dbar - MAX(0.0, reach(atom->type[i], atom->type[j], dbar) - begins)};
}

POTDEM::ContactGeometry PairPotdemBase::geometry(int i, int j) const
{
  bool turned;
  const double *const memory = remembered(i, j, turned);
  return geometry(i, j, memory ? *memory : 0.0);
}

// what a pair remembers, whichever of the two has it in its list (turned: j). Null: nothing
const double *PairPotdemBase::remembered(int i, int j, bool &turned) const
{
  turned = false;
  if (!contacts || !contacts->any()) return nullptr;
  for (int turn = 0; turn < 2; turn++, std::swap(i, j)) {
    if (i >= atom->nlocal) continue;
    turned = turn == 1;
    const int *const first = list->firstneigh[i], *const last = first + list->numneigh[i];
    const int *const found = std::find_if(first, last, [j](int listed) {
      return (listed & NEIGHMASK) == j;
    });
    if (found != last) return contacts->memory(i, static_cast<int>(found - first));
  }
  return nullptr;
}

/* ---------------------------------------------------------------------- */

double PairPotdemBase::distance(int i, int j) const
{
  double del[3];
  MathExtra::sub3(atom->x[i], atom->x[j], del);
  return MathExtra::len3(del);
}

void PairPotdemBase::collapsed(int i, int j, double hard_core) const
{
  error->one(FLERR,
             "pair_style {}: atoms {} and {} are {} apart on step {}, which is not beyond the "
             "smallest distance {} of this "
             "law (or their positions are not finite); use a smaller timestep, or a law that "
             "pushes harder",
             name(), atom->tag[i], atom->tag[j], distance(i, j), update->ntimestep, hard_core);
}

// dissipative force f on i, and its reaction on j
void PairPotdemBase::note(FixPotdemLedger::Kind kind, int i, int j, const double *f) const
{
  ledger->add(kind, i, f[0], f[1], f[2]);
  if (force->newton_pair || j < atom->nlocal) ledger->add(kind, j, -f[0], -f[1], -f[2]);
}

void PairPotdemBase::note_torque(int i, int j, double lever_i, double lever_j,
                                 const double *turn) const
{
  ledger->add_torque(i, lever_i, turn);
  if (force->newton_pair || j < atom->nlocal) ledger->add_torque(j, lever_j, turn);
}

void PairPotdemBase::tally(const ThreadShare &, int i, int j, const double *del, double energy,
                           const double *f)
{
  ev_tally_xyz(i, j, atom->nlocal, force->newton_pair, energy, 0.0, f[0], f[1], f[2], del[0],
               del[1], del[2]);
}

// pair_write asks every rank for the pair of its first two particles, and prints what the first rank says
double PairPotdemBase::without_particles() const
{
  if (comm->me == 0)
    error->one(FLERR,
               "pair_style {}: pair_write needs the diameters of two particles on the first "
               "processor; create two of the diameters in question, and run it on one",
               name());
  return 0.0;
}
