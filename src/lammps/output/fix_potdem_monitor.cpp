/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/output/fix_potdem_monitor.h"

#include "lammps/glue/find_styles.h"
#include "lammps/glue/interfaces.h"
#include "lammps/glue/potdem_input.h"
#include "lammps/output/compute_potdem_timestep.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "min.h"
#include "modify.h"
#include "neighbor.h"
#include "output.h"
#include "thermo.h"
#include "update.h"

#include <cmath>
#include <vector>

using namespace LAMMPS_NS;
using namespace FixConst;

static constexpr char MONITOR_ID[] = "POTDEM_MONITOR";
static constexpr int EVERY = 1000;    // steps between two checks of the critical step
static constexpr double ROUNDING = 1e-9;
// in half a period of one spring: the energy then errs by up to about (pi/6)^2/4 of what it exchanges
static constexpr double FEWEST_STEPS = 6.0;
// over the smallest diameter: a larger skin is worth a word, and what to write instead
static constexpr double LARGEST_SKIN = 0.5, GOOD_SKIN = 0.2;

/* ---------------------------------------------------------------------- */

FixPotdemMonitor *FixPotdemMonitor::ensure(LAMMPS *lmp)
{
  auto *found = lmp->modify->get_fix_by_id(MONITOR_ID);
  if (!found) found = lmp->modify->add_fix(fmt::format("{} all POTDEM_MONITOR", MONITOR_ID));
  const bool integrates = lmp->update->whichflag == 1 && lmp->update->nsteps > 0;
  return integrates ? dynamic_cast<FixPotdemMonitor *>(found) : nullptr;
}

FixPotdemMonitor::FixPotdemMonitor(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), moving(0)
{
  nevery = EVERY;
  comm_reverse =
      PotdemStiffness::WIDTH;    // LAMMPS does not know the compute, and makes room for this fix
  PotdemWords words(fmt::format("{} all potdem/timestep", MONITOR_ID));
  critical = std::make_unique<ComputePotdemTimestep>(lmp, words.narg(), words.arg());
}

// the command timestep asks the pair styles for their alarms anew. Not when LAMMPS ends
FixPotdemMonitor::~FixPotdemMonitor()
{
  if (!force) return;
  for (auto *const user : potdem_find<MonitorUser>(lmp)) user->lose_monitor();
}

int FixPotdemMonitor::setmask()
{
  return PRE_EXCHANGE | MIN_PRE_EXCHANGE | POST_NEIGHBOR | END_OF_STEP;
}

void FixPotdemMonitor::init()
{
  for (auto &text : said) text.clear();
  check_integration();
  moving = find_moving();
  if (!atom->rmass_flag) return;
  critical->groupbit = moving;
  critical->find_styles();
}

// rigid bodies are heavier than their particles, and the others are moved whatever the forces
int FixPotdemMonitor::find_moving() const
{
  int bits = 0;
  for (const auto &fix : modify->get_fix_list())
    if (fix->time_integrate && !fix->rigid_flag && !utils::strmatch(fix->style, "^move") &&
        !utils::strmatch(fix->style, "^nve/noforce"))
      bits |= fix->groupbit;
  return bits;
}

// do two fixes that integrate spoil each other's work? Of two fixes move the last one sets the places, and nve/noforce adds nothing that
// fix move would not set
static bool move_twice(const Fix *one, const Fix *other)
{
  const auto is = [](const Fix *fix, const char *style) {
    return utils::strmatch(fix->style, style);
  };
  const bool sets_one = is(one, "^move"), sets_other = is(other, "^move");
  if (sets_one && sets_other) return false;
  return !(sets_one && is(other, "^nve/noforce")) && !(sets_other && is(one, "^nve/noforce"));
}

// LAMMPS runs with any step, and of a particle that two fixes move it warns, but does so
void FixPotdemMonitor::check_integration() const
{
  if (update->whichflag != 1 || update->nsteps == 0) return;
  if (!(update->dt > 0.0))
    error->all(
        FLERR,
        "The timestep is {:g}, with which nothing moves, or time runs backwards and dashpots "
        "and friction add energy; it must be > 0: use the command 'timestep'",
        update->dt);
  std::vector<const Fix *> movers;
  for (const auto *fix : modify->get_fix_list())
    if (fix->time_integrate) movers.push_back(fix);
  for (int i = 0; movers.size() > 1 && i < atom->nlocal; i++) {
    const Fix *first = nullptr;
    for (const auto *fix : movers) {
      if (!(atom->mask[i] & fix->groupbit)) continue;
      if (first && move_twice(first, fix))
        error->one(FLERR,
                   "Atom {} is moved twice in each step, by fix {} ({}) and by fix {} ({}): remove "
                   "one of them with unfix, or give them groups that share no particle",
                   atom->tag[i], first->id, first->style, fix->id, fix->style);
      first = fix;
    }
  }
}

/* ----------------------------------------------------------------------
   LAMMPS is about to remove what has left the box, and says later only how many that were, or that one end of a bond is
   missing. In the coordinates of a box that may be tilted
------------------------------------------------------------------------- */

void FixPotdemMonitor::pre_exchange()
{
  const auto *const thermo = output->thermo;
  const bool none_may_go = thermo->lostflag == Thermo::ERROR;
  const bool no_bond_may_go = atom->num_bond && thermo->lostbond == Thermo::ERROR;
  const double *const lo = domain->triclinic ? domain->boxlo_lamda : domain->boxlo;
  const double *const hi = domain->triclinic ? domain->boxhi_lamda : domain->boxhi;
  for (int i = 0; i < atom->nlocal; i++) {
    double at[3] = {atom->x[i][0], atom->x[i][1], atom->x[i][2]};
    if (domain->triclinic) domain->x2lamda(atom->x[i], at);
    bool inside = true;
    for (int k = 0; k < 3; k++) {
      const int *const kind = domain->boundary[k];    // 1: fixed
      inside = inside && std::isfinite(at[k]) && !(kind[0] == 1 && at[k] < lo[k]) &&
          !(kind[1] == 1 && at[k] >= hi[k]);
    }
    if (inside) continue;
    if (none_may_go || (no_bond_may_go && atom->num_bond[i] > 0)) refuse_lost(i);
  }
}

void FixPotdemMonitor::setup_pre_exchange()
{
  pre_exchange();
}

void FixPotdemMonitor::min_pre_exchange()
{
  pre_exchange();
}

void FixPotdemMonitor::refuse_lost(int i) const
{
  const double *const x = atom->x[i];
  const auto where = fmt::format("Atom {} is at ({:g}, {:g}, {:g}) on step {}", atom->tag[i], x[0],
                                 x[1], x[2], update->ntimestep);
  if (!std::isfinite(x[0] + x[1] + x[2]))
    error->one(
        FLERR,
        "{}, which is not finite: use a smaller timestep, and look for a force, a velocity or "
        "a stiffness that is far too large",
        where);
  error->one(
      FLERR,
      "{}, outside the box, whose side there is fixed (boundary f): make the box larger, use "
      "a smaller timestep if it is too fast, or let particles go with 'thermo_modify lost "
      "ignore lost/bond ignore'",
      where);
}

void FixPotdemMonitor::setup(int /*vflag*/)
{
  check_critical();
  check_skin();
}

// infinite where there are no particles with a diameter
double FixPotdemMonitor::least_diameter() const
{
  double mine = HUGE_VAL, all;
  if (atom->radius_flag)
    for (int i = 0; i < atom->nlocal; i++) mine = MIN(mine, 2.0 * atom->radius[i]);
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_MIN, world);
  return all;
}

// LAMMPS's default of 1 mm in SI units knows nothing of the particles
void FixPotdemMonitor::check_skin() const
{
  if (update->nsteps == 0) return;
  const double least = least_diameter();
  if (!(neighbor->skin > LARGEST_SKIN * least)) return;
  if (comm->me == 0)
    error->warning(FLERR,
                   "The neighbour skin {:g} is large for particles of diameter {:g}: most pairs in "
                   "the neighbour "
                   "lists are far from contact, and cost time; write 'neighbor {:.2g} bin'",
                   neighbor->skin, least, GOOD_SKIN * least);
}

// LAMMPS keeps it from all but the minimisers
struct MinStep : public Min {
  using Min::dmax;
};

// likewise its default of 0.1 m
void FixPotdemMonitor::min_setup(int /*vflag*/)
{
  const double least = least_diameter(), most = update->minimize->*&MinStep::dmax;
  if (!(most > 0.5 * least)) return;
  if (comm->me == 0)
    error->warning(FLERR,
                   "A particle may move {:g} in one step of this minimisation, further than the "
                   "radius of one of "
                   "diameter {:g}: bonds may be torn from their ends; write 'min_modify dmax "
                   "{:.2g}' after min_style",
                   most, least, GOOD_SKIN * least);
}

void FixPotdemMonitor::end_of_step()
{
  check_critical();
}

void FixPotdemMonitor::check_critical()
{
  if (!said[CRITICAL].empty() || moving == 0 || update->nsteps == 0 || !atom->rmass_flag) return;
  const double longest = critical->compute_scalar();
  if (!(update->dt > longest * (1.0 + ROUNDING))) return;
  const auto text = fmt::format(
      "The timestep {:g} is longer than the critical step {:g} of the bonds, contacts and walls on "
      "step {} (a bound; atom {} sets it), the run may be unstable; use a shorter timestep, or fix "
      "potdem/timestep",
      update->dt, longest, update->ntimestep, critical->particle());
  said[CRITICAL] = text;
  if (comm->me == 0) error->warning(FLERR, text);
}

template <typename Words> void FixPotdemMonitor::say(Reason reason, const Words &words)
{
  if (!said[reason].empty()) return;
  said[reason] = words();
  error->warning(FLERR, said[reason]);
}

// a particle that passes its own radius in a step may pass others unseen. Lists are rebuilt when particles have
// moved far, so this is the place to look
void FixPotdemMonitor::post_neighbor()
{
  if (!said[JUMP].empty() || moving == 0 || !atom->radius_flag) return;
  const double step2 = update->dt * update->dt;
  for (int i = 0; i < atom->nlocal; i++) {
    const double *v = atom->v[i], r = atom->radius[i];
    const double moved2 = step2 * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    if (!(moved2 > r * r) || !(atom->mask[i] & moving)) continue;
    say(JUMP, [&] {
      return fmt::format(
          "Atom {} moves {:.3g} times its radius in one timestep on step {}, contacts "
          "may be missed; use "
          "a shorter timestep, or find out what makes it so fast",
          atom->tag[i], std::sqrt(moved2) / r, update->ntimestep);
    });
    return;
  }
}

/* ---------------------------------------------------------------------- */

double FixPotdemMonitor::inverse_mass(int i) const
{
  return atom->mask[i] & moving ? 1.0 / (force->mvv2e * atom->rmass[i]) : 0.0;
}

// in half a period
double FixPotdemMonitor::steps_of(double stiffness, double inverse_masses) const
{
  return M_PI / (update->dt * std::sqrt(stiffness * inverse_masses));
}

double FixPotdemMonitor::stiffest_over_mass() const
{
  const double frequency = M_PI / (FEWEST_STEPS * update->dt);
  return force->mvv2e * frequency * frequency;
}

bool FixPotdemMonitor::too_stiff_for_step(double stiffness, double inverse_masses) const
{
  return force->mvv2e * stiffness * inverse_masses > stiffest_over_mass();
}

void FixPotdemMonitor::warn_of_stiff_pair(const std::string &what, int i, int j, double stiffness)
{
  say(STIFF, [&] {
    return fmt::format("{} atoms {} and {} on step {} is so stiff that half a period takes {:.2g} "
                       "timesteps, too few for "
                       "its energy; use a shorter timestep, or fix potdem/timestep",
                       what, atom->tag[i], atom->tag[j], update->ntimestep,
                       steps_of(stiffness, inverse_mass(i) + inverse_mass(j)));
  });
}

void FixPotdemMonitor::warn_of_stiff_wall(const std::string &wall, int i, double stiffness)
{
  say(STIFF, [&] {
    return fmt::format(
        "The contact of atom {} with {} on step {} is so stiff that half a period takes "
        "{:.2g} timesteps, "
        "too few for its energy; use a shorter timestep, or fix potdem/timestep",
        atom->tag[i], wall, update->ntimestep, steps_of(stiffness, inverse_mass(i)));
  });
}

void FixPotdemMonitor::warn_of_deep_pair(int i, int j, double fraction)
{
  say(DEPTH, [&] {
    return fmt::format(
        "Atoms {} and {} are {:.2g} of their mean diameter apart on step {}, too deep in "
        "each other for a law "
        "of contact; use a shorter timestep, a law that pushes harder, or start them "
        "further apart",
        atom->tag[i], atom->tag[j], fraction, update->ntimestep);
  });
}

void FixPotdemMonitor::warn_of_deep_wall(const std::string &wall, int i, double fraction)
{
  say(DEPTH, [&] {
    return fmt::format(
        "The centre of atom {} is {:.2g} of its radius from {} on step {}, too deep for "
        "a law of contact; use "
        "a shorter timestep, a stiffer wall, or start it further away",
        atom->tag[i], fraction, wall, update->ntimestep);
  });
}

void FixPotdemMonitor::warn_of_crushed_bond(int i, int j, double fraction)
{
  say(CRUSH, [&] {
    return fmt::format(
        "The bond between atoms {} and {} is crushed to {:.2g} of its length on step {}, "
        "where a truss has "
        "lost its stiffness; use 'penetration' in bond_coeff, a compressive strength, or "
        "a shorter timestep",
        atom->tag[i], atom->tag[j], fraction, update->ntimestep);
  });
}

// the first rank writes the log: it repeats what only others have seen
void FixPotdemMonitor::post_run()
{
  for (auto &text : said) {
    int rank = text.empty() ? comm->nprocs : comm->me, first;
    MPI_Allreduce(&rank, &first, 1, MPI_INT, MPI_MIN, world);
    if (first == 0 || first == comm->nprocs) continue;
    int length = static_cast<int>(text.size());
    MPI_Bcast(&length, 1, MPI_INT, first, world);
    std::string copy(text);
    copy.resize(length);
    MPI_Bcast(&copy[0], length, MPI_CHAR, first, world);
    if (comm->me == 0) error->warning(FLERR, copy);
  }
}
