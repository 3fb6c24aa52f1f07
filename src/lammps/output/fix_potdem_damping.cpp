/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/output/fix_potdem_damping.h"

#include "lammps/glue/potdem_input.h"
#include "lammps/output/fix_potdem_ledger.h"

#include "atom.h"

using namespace LAMMPS_NS;
using namespace FixConst;

/* ---------------------------------------------------------------------- */

FixPotdemDamping::FixPotdemDamping(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), damping{0.0, false}, ledger(nullptr)
{
  dynamic_group_allow = 1;
  PotdemInput input(lmp, "fix potdem/damping", narg - 3, arg + 3);
  damping.lambda = input.in_range("lambda", POTDEM::fraction());
  while (!input.done()) {
    if (!input.next_is("form")) {
      input.word();
      input.unknown("form");
    }
    if (input.next_is("vector"))
      damping.by_component = false;
    else if (input.next_is("component"))
      damping.by_component = true;
    else {
      input.word();
      input.unknown("vector or component");
    }
  }
}

int FixPotdemDamping::setmask()
{
  return POST_FORCE;
}

void FixPotdemDamping::init()
{
  potdem_refuse_respa(lmp, "fix potdem/damping");
  ledger = FixPotdemLedger::find(lmp);
  potdem_require_last(lmp, this, "acts on the total force", "");
}

bool FixPotdemDamping::amplifies(int i) const
{
  return atom->mask[i] & groupbit;
}

void FixPotdemDamping::setup(int vflag)
{
  post_force(vflag);
}

void FixPotdemDamping::post_force(int /*vflag*/)
{
  double **v = atom->v, **f = atom->f;
  for (int i = 0; i < atom->nlocal; i++) {
    if (!amplifies(i)) continue;
    double drag[3];
    damping.force(f[i], v[i], drag);
    for (int k = 0; k < 3; k++) f[i][k] += drag[k];
    if (ledger) ledger->add(FixPotdemLedger::DAMPING, i, drag[0], drag[1], drag[2]);
  }
}
