/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/output/fix_potdem_ledger.h"

#include "lammps/glue/find_styles.h"
#include "lammps/glue/fix_potdem_resume.h"
#include "lammps/glue/interfaces.h"
#include "lammps/glue/potdem_input.h"
#include "lammps/glue/potdem_restart_block.h"

#include "atom.h"
#include "comm.h"
#include "force.h"
#include "modify.h"
#include "update.h"

#include <algorithm>

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
    Fix(lmp, narg, arg), noted(), threads(false), wall_power(0.0), slip_power(), step(0.0),
    booked(), rate(), begun(false), springs(0.0)
{
  comm_reverse = 3 * NFORCES;
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
  const std::size_t count = atom->nlocal + atom->nghost;    // LAMMPS has room for many more
  for (int which = 0; which < NFORCES; which++) {
    auto &rows = forces[which];
    if (noted[which] || rows.size() != count) rows.assign(count, {});
    noted[which] = false;
  }
  step = update->dt;
  wall_power = 0.0;
  for (double &power : slip_power) power = 0.0;
}

// also asked by fixes that note forces and come later
void FixPotdemLedger::setup(int /*vflag*/)
{
  if (!begun) {
    springs = potdem_energies(lmp).springs;
    begun = true;
  }
  if (!FixPotdemResume::resumes(lmp)) rate = powers();
}

void FixPotdemLedger::end_of_step()
{
  const auto now = powers();
  for (std::size_t k = 0; k < now.size(); k++) booked[k] += 0.5 * step * (rate[k] + now[k]);
  rate = now;
}

// of what is noted on the particles that this rank owns, with their velocities
double FixPotdemLedger::power(int which, double **v) const
{
  double sum = 0.0;
  if (!noted[which]) return sum;
  for (int i = 0; i < atom->nlocal; i++) {
    const auto &f = forces[which][i];
    sum += f[0] * v[i][0] + f[1] * v[i][1] + f[2] * v[i][2];
  }
  return sum;
}

// heat of each kind, and work of the walls, per time
std::array<double, FixPotdemLedger::NKINDS + 1> FixPotdemLedger::powers()
{
  if (force->newton_pair) bring_back();
  std::array<double, NKINDS + 1> mine{}, all{};
  for (int kind = 0; kind < NKINDS; kind++) mine[kind] = slip_power[kind] - power(kind, atom->v);
  if (atom->omega_flag) mine[FRICTION] -= power(TORQUE, atom->omega);
  mine[NKINDS] = wall_power;
  MPI_Allreduce(mine.data(), all.data(), NKINDS + 1, MPI_DOUBLE, MPI_SUM, world);
  return all;
}

/* ---------------------------------------------------------------------- */

// once: what ghosts had is then with their particles
void FixPotdemLedger::bring_back()
{
  comm->reverse_comm(this);
  for (int which = 0; which < NFORCES; which++)
    if (noted[which])
      std::fill(forces[which].begin() + atom->nlocal, forces[which].end(), std::array<double, 3>{});
}

int FixPotdemLedger::pack_reverse_comm(int n, int first, double *buf)
{
  int m = 0;
  for (int i = first; i < first + n; i++)
    for (const auto &rows : forces)
      for (const double value : rows[i]) buf[m++] = value;
  return m;
}

void FixPotdemLedger::unpack_reverse_comm(int n, int *list, double *buf)
{
  for (int k = 0; k < n; k++)
    for (int which = 0; which < NFORCES; which++, buf += 3) {
      if (buf[0] == 0.0 && buf[1] == 0.0 && buf[2] == 0.0) continue;
      auto &sum = begin(which)[list[k]];
      for (int c = 0; c < 3; c++) sum[c] += buf[c];
    }
}

double FixPotdemLedger::memory_usage()
{
  double bytes = 0.0;
  for (const auto &rows : forces) bytes += static_cast<double>(rows.capacity() * sizeof(rows[0]));
  return bytes;
}

void FixPotdemLedger::write_restart(FILE *fp)
{
  if (comm->me != 0) return;
  std::vector<double> values{springs};
  values.insert(values.end(), booked.begin(), booked.end());
  values.insert(values.end(), rate.begin(), rate.end());
  potdem_write_block(fp, values);
}

void FixPotdemLedger::restart(char *buf)
{
  const auto n = booked.size();
  const auto values = potdem_read_block(lmp, "Compute potdem/energy", buf, 1 + 2 * n);
  springs = values[0];
  std::copy_n(values.begin() + 1, n, booked.begin());
  std::copy_n(values.begin() + 1 + n, n, rate.begin());
  begun = true;
}
