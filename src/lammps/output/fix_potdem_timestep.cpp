/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Keeps the step at a fraction of the critical one (compute potdem/timestep), and below a longest one. It falls at
   once and grows slowly: velocity Verlet with a step that changes smoothly keeps its second order and drifts little. */

#include "lammps/output/fix_potdem_timestep.h"

#include "lammps/glue/fix_potdem_resume.h"
#include "lammps/glue/potdem_input.h"
#include "lammps/glue/potdem_restart_block.h"

#include "comm.h"
#include "compute.h"
#include "error.h"
#include "force.h"
#include "group.h"
#include "modify.h"
#include "output.h"
#include "pair.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace FixConst;

static constexpr double GROWTH = 1.05;    // from one evaluation to the next
static constexpr int AHEAD = 10;    // longest steps for which collisions are foreseen, at least

/* ---------------------------------------------------------------------- */

FixPotdemTimestep::FixPotdemTimestep(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), started(false)
{
  potdem_needs_setup(lmp);
  PotdemInput input(lmp, "fix potdem/timestep", narg - 3, arg + 3);
  nevery = input.whole("N", MAXSMALLINT);
  fraction = input.in_range("fraction", POTDEM::positive());
  if (fraction > 1.0)
    input.fail(fmt::format("fraction = {} is out of range, it must be <= 1", fraction));
  if (!input.next_is("max")) {
    input.word();
    input.unknown("max");
  }
  longest = input.in_range("max dt", POTDEM::positive());
  if (!input.done()) input.fail(fmt::format("unknown keyword '{}' after max dt", input.word()));
  dynamic_group_allow = 1;
  time_depend = 1;
  scalar_flag = 1;
  extscalar = 0;
  global_freq = 1;
  restart_global = 1;
  critical_id = std::string(id) + "_CRITICAL";
  modify->add_compute(fmt::format("{} {} potdem/timestep ahead {:.17g}", critical_id,
                                  group->names[igroup], MAX(nevery, AHEAD) * longest));
}

FixPotdemTimestep::~FixPotdemTimestep()
{
  potdem_needs_setup(lmp);
  if (modify->get_compute_by_id(critical_id)) modify->delete_compute(critical_id);
}

int FixPotdemTimestep::setmask()
{
  return PRE_FORCE | END_OF_STEP;
}

void FixPotdemTimestep::init()
{
  potdem_refuse_respa(lmp, "fix potdem/timestep");
  for (const char *style : {"^potdem/timestep$", "^dt/reset"})
    for (const auto &other : modify->get_fix_by_style(style))
      if (other != this)
        error->all(FLERR, "Fixes {} and {} both set the timestep: keep one of them", id, other->id);
  critical();
}

Compute *FixPotdemTimestep::critical() const
{
  auto *const found = modify->get_compute_by_id(critical_id);
  if (!found)
    error->all(
        FLERR,
        "Fix potdem/timestep {}: its compute {} was removed with uncompute; define the fix again",
        id, critical_id);
  return found;
}

/* ---------------------------------------------------------------------- */

// before the forces of the first step, some of which depend on it. A run in pieces goes on with its step, and one that
// continues from a file written within a run has the step of that run already
void FixPotdemTimestep::setup_pre_force(int /*vflag*/)
{
  if (update->whichflag != 1 || FixPotdemResume::resumes(lmp)) return;
  change_to(started ? MIN(update->dt, target()) : target());
  started = true;
}

void FixPotdemTimestep::end_of_step()
{
  change_to(MIN(GROWTH * update->dt, target()));
}

double FixPotdemTimestep::target()
{
  return MIN(longest, fraction * critical()->compute_scalar());
}

// all that LAMMPS has to be told
void FixPotdemTimestep::change_to(double step)
{
  if (step == update->dt) return;
  update->update_time();
  update->dt = step;
  update->dt_default = 0;
  if (force->pair) force->pair->reset_dt();
  for (const auto &fix : modify->get_fix_list()) fix->reset_dt();
  output->reset_dt();
}

double FixPotdemTimestep::compute_scalar()
{
  return critical()->scalar;
}

/* ---------------------------------------------------------------------- */

void FixPotdemTimestep::write_restart(FILE *fp)
{
  if (comm->me == 0) potdem_write_block(fp, {update->dt, critical()->scalar});
}

void FixPotdemTimestep::restart(char *buf)
{
  update->update_time();
  const auto values = potdem_read_block(lmp, fmt::format("Fix potdem/timestep {}", id), buf, 2);
  update->dt = values[0];
  critical()->scalar = values[1];
  started = true;
}
