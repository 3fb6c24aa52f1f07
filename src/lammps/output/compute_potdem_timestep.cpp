/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The critical step (thesis eq. 5.34) from the present stiffness of bonds, contacts and walls; see potdem_stiffness.h */

#include "lammps/output/compute_potdem_timestep.h"

#include "lammps/glue/find_styles.h"
#include "lammps/glue/interfaces.h"
#include "lammps/glue/potdem_input.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "force.h"
#include "modify.h"
#include "update.h"

#include <cmath>
#include <limits>
#include <string>

using namespace LAMMPS_NS;

// particles whose steps differ by less set it together: the one of lowest ID is named, on any number of ranks
static constexpr double SAME_STEP = 1.0 + 1e-10;

/* ---------------------------------------------------------------------- */

ComputePotdemTimestep::ComputePotdemTimestep(LAMMPS *lmp, int narg, char **arg) :
    Compute(lmp, narg, arg), ahead(0.0), step(0.0)
{
  PotdemInput input(lmp, "compute potdem/timestep", narg - 3, arg + 3);
  while (!input.done()) {
    if (!input.next_is("ahead")) {
      input.word();
      input.unknown("ahead");
    }
    ahead = input.in_range("ahead", POTDEM::nonnegative());
  }
  scalar_flag = vector_flag = 1;
  size_vector = NVALUES;
  extscalar = extvector = 0;
  comm_reverse = PotdemStiffness::WIDTH;
  vector = new double[NVALUES];
}

ComputePotdemTimestep::~ComputePotdemTimestep()
{
  delete[] vector;
}

void ComputePotdemTimestep::init()
{
  if (!atom->rmass_flag)
    error->all(FLERR,
               "compute potdem/timestep {} needs a mass per particle, e.g. atom_style sphere or "
               "bpm/sphere",
               id);
  if (ahead > 0.0) comm->ghost_velocity = 1;
  find_styles();
  warn_of_others();
}

void ComputePotdemTimestep::find_styles()
{
  sources = potdem_find<StiffnessSource>(lmp);
  amplifiers = potdem_find<ForceAmplifier>(lmp);
}

void ComputePotdemTimestep::warn_of_others() const
{
  for (const auto &part : potdem_bond_parts(force))
    if (atom->nbonds > 0 && !dynamic_cast<StiffnessSource *>(part.first))
      warn_of("bond_style " + part.second);
  for (const auto &part : potdem_pair_parts(force))
    if (!dynamic_cast<StiffnessSource *>(part.first) && part.second != "zero")
      warn_of("pair_style " + part.second);
}

void ComputePotdemTimestep::warn_of(const std::string &style) const
{
  if (comm->me == 0)
    error->warning(FLERR, "compute potdem/timestep {} does not know the stiffness of {}", id,
                   style);
}

/* ---------------------------------------------------------------------- */

double ComputePotdemTimestep::compute_scalar()
{
  invoked_scalar = update->ntimestep;
  if (invoked_vector != invoked_scalar) compute_vector();
  return scalar = step;
}

void ComputePotdemTimestep::compute_vector()
{
  invoked_vector = update->ntimestep;
  gather();
  const double never = std::numeric_limits<double>::infinity();
  double mine[3] = {never, never, never}, all[3];
  tagint lowest = MAXTAGINT, first;
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    const auto least = stiffness.short_of_steps(i);
    mine[2] = MIN(mine[2], least.stiffest);
    if (least.stable > mine[0] * SAME_STEP && least.elastic > mine[1]) continue;
    const auto steps = stiffness.steps(i);
    if (steps.stable * SAME_STEP < mine[0]) lowest = MAXTAGINT;
    if (steps.stable <= mine[0] * SAME_STEP) lowest = MIN(lowest, atom->tag[i]);
    mine[0] = MIN(mine[0], steps.stable);
    mine[1] = MIN(mine[1], steps.elastic);
  }
  MPI_Allreduce(mine, all, 3, MPI_DOUBLE, MPI_MIN, world);
  if (mine[0] > all[0] * SAME_STEP) lowest = MAXTAGINT;
  MPI_Allreduce(&lowest, &first, 1, MPI_LMP_TAGINT, MPI_MIN, world);
  step = all[0];
  vector[ELASTIC] = all[1];
  vector[STIFFEST] = all[2];
  vector[PARTICLE] = step < never ? first : 0;
}

void ComputePotdemTimestep::gather()
{
  stiffness.reset(inverse_root_masses());
  for (auto *const source : sources) source->add_stiffness_to(stiffness, ahead);
  if (force->newton_pair) comm->reverse_comm(this);
}

std::vector<double> ComputePotdemTimestep::inverse_root_masses() const
{
  std::vector<double> values(atom->nlocal + atom->nghost);
  for (std::size_t i = 0; i < values.size(); i++) {
    double mass = force->mvv2e * atom->rmass[i];
    for (const auto *amplifier : amplifiers)
      if (amplifier->amplifies(i)) mass /= amplifier->amplification();
    values[i] = 1.0 / sqrt(mass);
  }
  return values;
}

/* ---------------------------------------------------------------------- */

int ComputePotdemTimestep::pack_reverse_comm(int n, int first, double *buf)
{
  for (int k = 0; k < n; k++) stiffness.pack(first + k, buf + k * PotdemStiffness::WIDTH);
  return n * PotdemStiffness::WIDTH;
}

void ComputePotdemTimestep::unpack_reverse_comm(int n, int *list, double *buf)
{
  for (int k = 0; k < n; k++) stiffness.unpack(list[k], buf + k * PotdemStiffness::WIDTH);
}

double ComputePotdemTimestep::memory_usage()
{
  return stiffness.memory_usage();
}
