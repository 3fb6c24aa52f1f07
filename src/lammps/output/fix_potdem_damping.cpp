/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/output/fix_potdem_damping.h"

#include "lammps/glue/potdem_input.h"
#include "lammps/output/fix_potdem_ledger.h"

#include "atom.h"
#include "modify.h"

using namespace LAMMPS_NS;
using namespace FixConst;

/* ---------------------------------------------------------------------- */

FixPotdemDamping::FixPotdemDamping(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), damping{0.0, false}, damps_weight(true), ledger(nullptr)
{
  potdem_needs_setup(lmp);
  dynamic_group_allow = 1;
  PotdemInput input(lmp, "fix potdem/damping", narg - 3, arg + 3);
  damping.lambda = input.in_range("lambda", POTDEM::fraction());
  while (!input.done()) {
    if (input.next_is("weight")) {
      damps_weight = input.logical("weight");
      continue;
    }
    if (!input.next_is("form")) {
      input.word();
      input.unknown("form or weight");
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

FixPotdemDamping::~FixPotdemDamping()
{
  potdem_needs_setup(lmp);
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
  find_weights();
}

void FixPotdemDamping::find_weights()
{
  weights.clear();
  if (damps_weight) return;
  for (auto *fix : modify->get_fix_by_style("^gravity")) {
    int dim;
    weights.push_back({fix->groupbit, static_cast<double *>(fix->extract("gvec", dim))});
  }
}

void FixPotdemDamping::without_weight(int i, double *force) const
{
  for (int k = 0; k < 3; k++) force[k] = atom->f[i][k];
  for (const auto &weight : weights) {
    if (!(atom->mask[i] & weight.groupbit)) continue;
    const double mass = atom->rmass ? atom->rmass[i] : atom->mass[atom->type[i]];
    for (int k = 0; k < 3; k++) force[k] -= mass * weight.acceleration[k];
  }
}

bool FixPotdemDamping::amplifies(int i) const
{
  return atom->mask[i] & groupbit;
}

void FixPotdemDamping::setup(int vflag)
{
  post_force(vflag);
  if (ledger) ledger->setup(vflag);
}

void FixPotdemDamping::post_force(int /*vflag*/)
{
  double **v = atom->v, **f = atom->f;
  const int nlocal = atom->nlocal, nthreads = threads();
#pragma omp parallel for num_threads(nthreads) schedule(static) if (nthreads > 1)
  for (int i = 0; i < nlocal; i++) {
    if (!amplifies(i)) continue;
    double rest[3], drag[3];
    if (!weights.empty()) without_weight(i, rest);
    damping.force(weights.empty() ? f[i] : rest, v[i], drag);
    for (int k = 0; k < 3; k++) f[i][k] += drag[k];
    if (ledger) ledger->add(FixPotdemLedger::DAMPING, i, drag[0], drag[1], drag[2]);
  }
}
