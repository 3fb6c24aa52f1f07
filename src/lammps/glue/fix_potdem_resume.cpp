/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/glue/fix_potdem_resume.h"

#include "lammps/glue/potdem_restart_block.h"

#include "atom.h"
#include "comm.h"
#include "modify.h"
#include "output.h"
#include "update.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace FixConst;

static constexpr char RESUME_ID[] = "POTDEM_RESUME";
// columns: 1 if the others hold something; velocities of the forces, of the end of the step
enum {
  HOLDS,
  FORCES_V,
  FORCES_OMEGA = FORCES_V + 3,
  END_V = FORCES_OMEGA + 3,
  END_OMEGA = END_V + 3,
  WIDTH = END_OMEGA + 3
};

/* ---------------------------------------------------------------------- */

void FixPotdemResume::ensure(LAMMPS *lmp)
{
  auto *const modify = lmp->modify;
  const bool there = modify->get_fix_by_id(RESUME_ID);
  const bool needed = lmp->output->restart_flag || modify->nfix_restart_peratom > 0;
  if (needed && !there)
    modify->add_fix(fmt::format("{} all POTDEM_RESUME {} 0 no yes", RESUME_ID, int(WIDTH)));
  if (there && !needed) modify->delete_fix(RESUME_ID);
}

bool FixPotdemResume::resumes(LAMMPS *lmp)
{
  const auto *const found = dynamic_cast<FixPotdemResume *>(lmp->modify->get_fix_by_id(RESUME_ID));
  return found && found->resuming;
}

FixPotdemResume::FixPotdemResume(LAMMPS *lmp, int narg, char **arg) :
    FixStoreAtom(lmp, narg, arg), resuming(false), written(-1), step(0.0), coming(0.0)
{
  restart_global = 1;
}

int FixPotdemResume::setmask()
{
  return PRE_EXCHANGE | PRE_FORCE | END_OF_STEP;
}

bool FixPotdemResume::writes_now() const
{
  return output->restart_flag && update->ntimestep == output->next_restart;
}

/* ----------------------------------------------------------------------
   the run that writes
------------------------------------------------------------------------- */

// LAMMPS has new lists on such a step
void FixPotdemResume::pre_exchange()
{
  if (writes_now() && atom->sortfreq > 0) atom->nextsort = update->ntimestep;
}

void FixPotdemResume::pre_force(int /*vflag*/)
{
  if (!writes_now()) return;
  step = update->dt;
  for (int i = 0; i < atom->nlocal; i++) {
    std::copy_n(atom->v[i], 3, astore[i] + FORCES_V);
    if (atom->omega_flag) std::copy_n(atom->omega[i], 3, astore[i] + FORCES_OMEGA);
  }
}

void FixPotdemResume::end_of_step()
{
  if (!writes_now()) return;
  for (int i = 0; i < atom->nlocal; i++) {
    astore[i][HOLDS] = 1.0;
    std::copy_n(atom->v[i], 3, astore[i] + END_V);
    if (atom->omega_flag) std::copy_n(atom->omega[i], 3, astore[i] + END_OMEGA);
  }
  written = update->ntimestep;
  update->update_time();    // time is counted on from the file
}

// a file that is written later is one from between two runs
void FixPotdemResume::post_run()
{
  for (int i = 0; i < atom->nlocal; i++) astore[i][HOLDS] = 0.0;
  written = -1;
}

void FixPotdemResume::write_restart(FILE *fp)
{
  if (comm->me == 0) potdem_write_block(fp, {static_cast<double>(written), step});
}

/* ----------------------------------------------------------------------
   the run that continues
------------------------------------------------------------------------- */

void FixPotdemResume::restart(char *buf)
{
  const auto values = potdem_read_block(lmp, "Fix POTDEM_RESUME", buf, 2);
  written = static_cast<bigint>(values[0]);
  step = values[1];
}

// before ghosts are made, which have the velocities of their particles
void FixPotdemResume::setup_pre_exchange()
{
  resuming = update->whichflag == 1 && written == update->ntimestep;
  if (!resuming) return;
  coming = update->dt;
  update->dt = step;
  const auto differ = [](const double *a, const double *b) {
    return !std::equal(a, a + 3, b);
  };
  for (int i = 0; i < atom->nlocal; i++) {
    double *const kept = astore[i];
    if (differ(atom->v[i], kept + END_V) ||
        (atom->omega_flag && differ(atom->omega[i], kept + END_OMEGA)))
      kept[HOLDS] = 0.0;
  }
  exchange_velocities();
}

// after the forces of all other fixes, which were there before this one
void FixPotdemResume::setup(int /*vflag*/)
{
  if (!resuming) return;
  exchange_velocities();
  update->dt = coming;
  resuming = false;
  post_run();
}

// between the particles and what is kept for them
void FixPotdemResume::exchange_velocities()
{
  for (int i = 0; i < atom->nlocal; i++) {
    double *const kept = astore[i];
    if (kept[HOLDS] == 0.0) continue;
    std::swap_ranges(atom->v[i], atom->v[i] + 3, kept + FORCES_V);
    if (atom->omega_flag) std::swap_ranges(atom->omega[i], atom->omega[i] + 3, kept + FORCES_OMEGA);
  }
}
