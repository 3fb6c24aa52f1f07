/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/bond/potdem_body_area.h"

#include "lammps/glue/fix_potdem_bond_history.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "neighbor.h"
#include "platform.h"
#include "update.h"

#include <cmath>

using namespace LAMMPS_NS;

// misfit inside from which the modulus along some direction is off by more than a tenth or two
static constexpr double UNEVEN = 0.6;

/* ---------------------------------------------------------------------- */

PotdemBodyArea::PotdemBodyArea(LAMMPS *lmp, FixPotdemBondHistory *store, const std::string &style) :
    Pointers(lmp), history(store), style(style), body(halo)
{
  halo.store = store;
  halo.world = world;
}

void PotdemBodyArea::Halo::forward(double *values, int width)
{
  store->forward(values, width);
}

void PotdemBodyArea::Halo::sum(double *values, int n)
{
  MPI_Allreduce(MPI_IN_PLACE, values, n, MPI_DOUBLE, MPI_SUM, world);
}

/* ---------------------------------------------------------------------- */

void PotdemBodyArea::solve(int type, double density, const POTDEM::Elasticity &elasticity)
{
  body.elasticity = elasticity;
  const double began = platform::walltime();
  bigint counts[2] = {collect(type) ? 1 : 0, 0}, all[2];
  for (const auto &bond : body.bonds) counts[1] += bond.low < body.nowned;
  MPI_Allreduce(counts, all, 2, MPI_LMP_BIGINT, MPI_SUM, world);
  if (all[0] == 0) return;
  if (density > 0.0) give_volumes(density);
  const auto found = POTDEM::find_body_areas(body);
  switch (found.outcome) {
    case POTDEM::BodyAreaReport::NO_INSIDE:
      error->all(FLERR,
                 "{}: area body for bond type {}: no particle has neighbours on "
                 "all sides, the body is too thin or r_infl too short; use area factor",
                 style, type);
    case POTDEM::BodyAreaReport::MECHANISM:
      error->all(FLERR,
                 "{}: area body for bond type {}: the bonds are too few to be "
                 "stiff in every direction; increase r_infl in potdem_bonds",
                 style, type);
    case POTDEM::BodyAreaReport::DONE:
      break;
  }
  keep();
  report(found, type, all[1], platform::walltime() - began);
}

/* ----------------------------------------------------------------------
   the bonds of this type that have no area yet; false: none on this rank
------------------------------------------------------------------------- */

bool PotdemBodyArea::collect(int type)
{
  const int nall = atom->nlocal + atom->nghost;
  body.nowned = atom->nlocal;
  body.nall = nall;
  body.diameter.resize(nall);
  for (int i = 0; i < nall; i++) body.diameter[i] = 2.0 * atom->radius[i];
  body.id.assign(atom->tag, atom->tag + nall);
  body.bonds.reserve(neighbor->nbondlist);
  for (int k = 0; k < neighbor->nbondlist; k++) {
    const int *entry = neighbor->bondlist[k];
    const int i = entry[0], j = entry[1];
    if (entry[2] != type) continue;
    const int slot = history->slot(i, atom->tag[j]);
    if (history->area(i, slot) > 0.0) continue;
    POTDEM::BondedBody::Bond bond{};
    bond.low = atom->tag[i] < atom->tag[j] ? i : j;
    bond.high = bond.low == i ? j : i;
    bond.length = history->length(i, slot);
    double r2 = 0.0;
    for (int c = 0; c < 3; c++) {
      bond.n[c] = atom->x[bond.high][c] - atom->x[bond.low][c];
      r2 += bond.n[c] * bond.n[c];
    }
    for (int c = 0; c < 3; c++) bond.n[c] /= sqrt(r2);
    body.bonds.push_back(bond);
  }
  return !body.bonds.empty();
}

void PotdemBodyArea::give_volumes(double density)
{
  body.volume.resize(body.nall);
  for (int i = 0; i < body.nall; i++) body.volume[i] = atom->rmass[i] / density;
}

void PotdemBodyArea::keep() const
{
  for (const auto &bond : body.bonds)
    for (int end = 0; end < 2; end++) keep(bond, end);
}

void PotdemBodyArea::keep(const POTDEM::BondedBody::Bond &bond, int end) const
{
  const int i = end == 0 ? bond.low : bond.high, j = end == 0 ? bond.high : bond.low;
  if (i >= atom->nlocal) return;
  const int slot = history->slot(i, atom->tag[j]);
  history->store_area(i, slot, bond.area);
  if (!body.elasticity.has_volume_term()) return;
  history->store_dilatation(i, slot,
                            {sqrt(body.volume[i]) * bond.dilatation[end],
                             sqrt(body.volume[j]) * bond.dilatation[1 - end],
                             1.0 + body.elasticity.poisson});
}

void PotdemBodyArea::report(const POTDEM::BodyAreaReport &found, int type, bigint count,
                            double seconds) const
{
  double least = body.bonds.empty() ? HUGE_VAL : found.least, all_least;
  double most = body.bonds.empty() ? 0.0 : found.most, all_most;
  MPI_Allreduce(&least, &all_least, 1, MPI_DOUBLE, MPI_MIN, world);
  MPI_Allreduce(&most, &all_most, 1, MPI_DOUBLE, MPI_MAX, world);
  if (comm->me != 0) return;
  if (found.misfit > UNEVEN)
    error->warning(FLERR,
                   "area body for bond type {}: these bonds cannot make an isotropic solid of this "
                   "body, its stiffness depends on the direction (misfit {:.2g}); increase r_infl",
                   type, found.misfit);
  if (!update->setupflag) return;    // bodies that come during a run may be many
  utils::logmesg(lmp,
                 "{}: bond type {}: area body of {} bonds, volume {:.6g}, "
                 "areas {:.3g} to {:.3g} of the uniform one (a = {:.4g}), misfit inside {:.2g}, "
                 "{} iterations, {:.2f} s\n",
                 style, type, count, found.volume, all_least, all_most,
                 found.factor / (0.25 * M_PI), found.misfit, found.iterations, seconds);
}
