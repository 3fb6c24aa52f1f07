/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/output/fix_potdem_ledger.h"

#include "lammps/glue/find_styles.h"
#include "lammps/glue/interfaces.h"
#include "lammps/glue/potdem_input.h"

#include "atom.h"
#include "comm.h"
#include "force.h"
#include "modify.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace FixConst;

/* ---------------------------------------------------------------------- */

FixPotdemLedger *FixPotdemLedger::find(LAMMPS *lmp)
{
  if (potdem_minimizes(lmp)) return nullptr;
  const auto found = lmp->modify->get_fix_by_style("^POTDEM_LEDGER$");
  return found.empty() ? nullptr : dynamic_cast<FixPotdemLedger *>(found[0]);
}

FixPotdemLedger::FixPotdemLedger(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), threads(false), wall_power(0.0), slip_power(), step(0.0), booked(), rate(),
    begun(false), springs(0.0)
{
  comm_reverse = WIDTH;
  restart_global = 1;
}

int FixPotdemLedger::setmask()
{
  return PRE_FORCE | END_OF_STEP;
}

void FixPotdemLedger::init()
{
  nevery = 1;
  threads = comm->nthreads > 1;
}

/* ---------------------------------------------------------------------- */

void FixPotdemLedger::setup_pre_force(int vflag)
{
  pre_force(vflag);
}

void FixPotdemLedger::pre_force(int /*vflag*/)
{
  forces.assign(atom->nmax, {});
  step = update->dt;
  wall_power = 0.0;
  for (double &power : slip_power) power = 0.0;
}

void FixPotdemLedger::setup(int /*vflag*/)
{
  if (!begun) {
    springs = potdem_energies(lmp).springs;
    begun = true;
  }
  rate = powers();
}

void FixPotdemLedger::end_of_step()
{
  const auto now = powers();
  for (std::size_t k = 0; k < now.size(); k++) booked[k] += 0.5 * step * (rate[k] + now[k]);
  rate = now;
}

// heat of each kind, and work of the walls, per time
std::array<double, FixPotdemLedger::NKINDS + 1> FixPotdemLedger::powers()
{
  if (force->newton_pair) comm->reverse_comm(this);
  std::array<double, NKINDS + 1> mine{}, all{};
  for (int i = 0; i < atom->nlocal; i++) {
    const auto &f = forces[i];
    const double *v = atom->v[i];
    for (int kind = 0; kind < NKINDS; kind++)
      mine[kind] -= f[3 * kind] * v[0] + f[3 * kind + 1] * v[1] + f[3 * kind + 2] * v[2];
    if (atom->omega_flag)
      for (int k = 0; k < 3; k++) mine[FRICTION] -= f[3 * NKINDS + k] * atom->omega[i][k];
  }
  for (int kind = 0; kind < NKINDS; kind++) mine[kind] += slip_power[kind];
  mine[NKINDS] = wall_power;
  MPI_Allreduce(mine.data(), all.data(), NKINDS + 1, MPI_DOUBLE, MPI_SUM, world);
  return all;
}

/* ---------------------------------------------------------------------- */

int FixPotdemLedger::pack_reverse_comm(int n, int first, double *buf)
{
  int m = 0;
  for (int i = first; i < first + n; i++)
    for (const double value : forces[i]) buf[m++] = value;
  return m;
}

void FixPotdemLedger::unpack_reverse_comm(int n, int *list, double *buf)
{
  for (int k = 0; k < n; k++)
    for (double &value : forces[list[k]]) value += *buf++;
}

double FixPotdemLedger::memory_usage()
{
  return static_cast<double>(forces.capacity() * sizeof(forces[0]));
}

// files from before there were springs begin with the heat of friction, which is not negative
static constexpr double RESTART_VERSION = -2.0;

void FixPotdemLedger::write_restart(FILE *fp)
{
  if (comm->me != 0) return;
  const double head[2] = {RESTART_VERSION, springs};
  const int size = sizeof(head) + sizeof(booked);
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(head, sizeof(head), 1, fp);
  fwrite(booked.data(), sizeof(booked), 1, fp);
}

void FixPotdemLedger::restart(char *buf)
{
  const double *values = reinterpret_cast<const double *>(buf);
  if (values[0] == RESTART_VERSION) {
    springs = values[1];
    values += 2;
  }
  std::copy(values, values + booked.size(), booked.begin());
  begun = true;
}
