/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The energy ledger: what the system has, what it has lost, and what moving walls have put in. The scalar,
     kinetic + gravity + bonds + contacts + walls + fracture + friction + viscous + damping - work of walls,
   is constant up to the integration error: the method's check of itself. Energies. */

#include "lammps/output/compute_potdem_energy.h"

#include "core/laws/slide.h"
#include "lammps/glue/find_styles.h"
#include "lammps/glue/interfaces.h"
#include "lammps/glue/potdem_input.h"
#include "lammps/output/fix_potdem_ledger.h"

#include "atom.h"
#include "bond.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "modify.h"
#include "pair.h"
#include "update.h"

using namespace LAMMPS_NS;

static constexpr char LEDGER_ID[] = "POTDEM_LEDGER";

/* ---------------------------------------------------------------------- */

ComputePotdemEnergy::ComputePotdemEnergy(LAMMPS *lmp, int narg, char **arg) :
    Compute(lmp, narg, arg), inertia(POTDEM::SPHERE_INERTIA)
{
  PotdemInput input(lmp, "compute potdem/energy", narg - 3, arg + 3);
  while (!input.done()) {
    if (!input.next_is("disc")) {
      input.word();
      input.unknown("disc");
    }
    if (domain->dimension != 2) input.fail("disc is for two dimensions");
    inertia = POTDEM::DISC_INERTIA;
  }
  if (igroup != 0) error->all(FLERR, "compute potdem/energy {}: the ledger is for group all", id);
  if (modify->get_fix_by_id(LEDGER_ID))
    error->all(FLERR, "compute potdem/energy {}: there is a ledger already, use that one", id);
  scalar_flag = vector_flag = 1;
  size_vector = NTERMS;
  extscalar = extvector = 1;
  peflag = 1;    // the pair and bond styles tally their energies on the steps of this compute
  timeflag = 1;
  vector = new double[NTERMS];
  modify->add_fix(fmt::format("{} all POTDEM_LEDGER", LEDGER_ID));
}

ComputePotdemEnergy::~ComputePotdemEnergy()
{
  if (modify->get_fix_by_id(LEDGER_ID)) modify->delete_fix(LEDGER_ID);
  delete[] vector;
}

void ComputePotdemEnergy::init()
{
  ledger();
}

FixPotdemLedger *ComputePotdemEnergy::ledger() const
{
  auto *const found = dynamic_cast<FixPotdemLedger *>(modify->get_fix_by_id(LEDGER_ID));
  if (!found)
    error->all(
        FLERR,
        "compute potdem/energy {}: its fix {}, which sums up what is lost, was removed with unfix; "
        "define the compute again, for a sum that begins there",
        id, LEDGER_ID);
  return found;
}

/* ---------------------------------------------------------------------- */

double ComputePotdemEnergy::compute_scalar()
{
  invoked_scalar = update->ntimestep;
  if (invoked_vector != invoked_scalar) compute_vector();
  scalar = -2.0 * vector[WALL_WORK];
  for (int term = 0; term < NTERMS; term++) scalar += vector[term];
  return scalar;
}

void ComputePotdemEnergy::compute_vector()
{
  invoked_vector = update->ntimestep;
  if (update->eflag_global != update->ntimestep)
    error->all(FLERR,
               "compute potdem/energy {}: energies were not tallied on step {}; use it with "
               "thermo_style or "
               "with fixes that announce their steps",
               id, update->ntimestep);
  const double mine[3] = {kinetic(), force->bond ? force->bond->energy : 0.0,
                          force->pair ? force->pair->eng_vdwl + force->pair->eng_coul : 0.0};
  double all[3];
  MPI_Allreduce(mine, all, 3, MPI_DOUBLE, MPI_SUM, world);
  vector[KINETIC] = all[0];
  vector[BONDS] = all[1];
  vector[CONTACTS] = all[2];
  vector[GRAVITY] = of_gravity();
  const auto kept = potdem_energies(lmp);
  vector[WALLS] = kept.walls;
  vector[FRACTURE] = kept.fracture;
  vector[SPRINGS] = kept.springs;
  // what friction took, less what its springs have of it
  vector[FRICTION] =
      ledger()->heat(FixPotdemLedger::FRICTION) - (kept.springs - ledger()->springs_then());
  vector[VISCOUS] = ledger()->heat(FixPotdemLedger::VISCOUS);
  vector[DAMPING] = ledger()->heat(FixPotdemLedger::DAMPING);
  vector[WALL_WORK] = ledger()->wall_work();
}

// of this rank; spin included where particles have it
double ComputePotdemEnergy::kinetic() const
{
  double sum = 0.0;
  for (int i = 0; i < atom->nlocal; i++) {
    const double *v = atom->v[i];
    const double mass = atom->rmass ? atom->rmass[i] : atom->mass[atom->type[i]];
    sum += 0.5 * mass * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    if (!atom->omega_flag) continue;
    const double *spin = atom->omega[i], r = atom->radius[i];
    sum +=
        0.5 * inertia * mass * r * r * (spin[0] * spin[0] + spin[1] * spin[1] + spin[2] * spin[2]);
  }
  return sum * force->mvv2e;
}

double ComputePotdemEnergy::of_gravity() const
{
  double sum = 0.0;
  for (const auto &fix : modify->get_fix_by_style("^gravity")) sum += fix->compute_scalar();
  return sum;
}
