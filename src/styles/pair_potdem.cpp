/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "pair_potdem.h"

#include "potdem_bond_store.h"
#include "potdem_input.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "force.h"
#include "memory.h"
#include "neigh_request.h"
#include "neighbor.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

PairPotdemBase::PairPotdemBase(LAMMPS *lmp) :
    Pair(lmp), sliding(false), bond_store(nullptr), atom_types(0)
{
  writedata = 0;
  single_enable = 1;
}

PairPotdemBase::~PairPotdemBase()
{
  if (!allocated) return;
  memory->destroy(setflag);
  memory->destroy(cutsq);
}

void PairPotdemBase::allocate()
{
  allocated = 1;
  atom_types = atom->ntypes;
  const int n = atom_types + 1;
  memory->create(setflag, n, n, "pair:setflag");
  memory->create(cutsq, n, n, "pair:cutsq");
  std::fill(&setflag[0][0], &setflag[0][0] + n * n, 0);
  std::fill(&cutsq[0][0], &cutsq[0][0] + n * n, 0.0);
  friction.assign(n * n, POTDEM::Friction());
}

void PairPotdemBase::settings(int narg, char **arg)
{
  if (narg > 0)
    error->all(FLERR, "pair_style {}: unknown keyword '{}', it takes none", name(), arg[0]);
}

void PairPotdemBase::set_coeff(int ilo, int ihi, int jlo, int jhi, const POTDEM::Friction &slide)
{
  int count = 0;
  for (int i = ilo; i <= ihi; i++)
    for (int j = MAX(jlo, i); j <= jhi; j++) {
      friction[at(i, j)] = friction[at(j, i)] = slide;
      setflag[i][j] = 1;
      count++;
    }
  if (count == 0)
    error->all(FLERR, "pair_coeff {}: no pair of types I <= J in the range given", name());
}

/* ---------------------------------------------------------------------- */

void PairPotdemBase::init_style()
{
  potdem_refuse_respa(lmp, fmt::format("pair_style {}", name()));
  if (!atom->radius_flag || !atom->rmass_flag)
    error->all(FLERR,
               "pair_style {} needs particle diameters, e.g. atom_style sphere or bpm/sphere",
               name());
  // after a restart the pair style is the first to ask for it
  bond_store = force->bond_match("potdem/truss") ? PotdemBondStore::ensure(lmp) : nullptr;
  find_diameters();
  sliding = false;
  for (const auto &slide : friction) sliding = sliding || slide.mu > 0.0;
  if (sliding) comm->ghost_velocity = 1;
  neighbor->add_request(this, NeighConst::REQ_SIZE);
}

void PairPotdemBase::find_diameters()
{
  std::vector<double> mine(atom->ntypes + 1, 0.0);
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->radius[i] > 0.0))
      error->one(FLERR,
                 "pair_style {}: atom {} has diameter {}, it must be > 0; use set ... diameter",
                 name(), atom->tag[i], 2.0 * atom->radius[i]);
    mine[atom->type[i]] = MAX(mine[atom->type[i]], atom->radius[i]);
  }
  largest_radius.resize(mine.size());
  MPI_Allreduce(mine.data(), largest_radius.data(), mine.size(), MPI_DOUBLE, MPI_MAX, world);
}

// types without particles have no contacts
double PairPotdemBase::init_one(int i, int j)
{
  if (setflag[i][j] == 0) {
    if (!setflag[i][i] || !setflag[j][j])
      error->all(FLERR,
                 "pair_style {}: coefficients for types {} and {} are not set; use pair_coeff",
                 name(), i, j);
    mix(i, j);
    mix_friction(i, j);
  }
  const double dbar = largest_radius[i] + largest_radius[j];
  return reach(i, j, dbar);
}

// the more slippery material decides; a viscosity is in parallel with the limit, so the larger one
void PairPotdemBase::mix_friction(int i, int j)
{
  const auto &a = friction[at(i, i)], &b = friction[at(j, j)];
  POTDEM::Friction mixed;
  mixed.mu = MIN(a.mu, b.mu);
  mixed.eta = MAX(a.eta, b.eta);
  mixed.automatic = a.automatic || b.automatic;
  friction[at(i, j)] = friction[at(j, i)] = mixed;
  sliding = sliding || mixed.mu > 0.0;
}

double PairPotdemBase::contact_distance(int i, int j, double dbar) const
{
  if (!bond_store || !bond_store->overlapping()) return dbar;
  return bond_store->contact_distance(i, atom->tag[j], dbar);
}

// friction on i from the relative velocity of the centres across del = x_i - x_j
void PairPotdemBase::slide(int i, int j, const POTDEM::Friction &friction, double normal,
                           const double *del, double r2, double *drag) const
{
  const double *vi = atom->v[i], *vj = atom->v[j];
  const double u[3] = {vi[0] - vj[0], vi[1] - vj[1], vi[2] - vj[2]};
  const double along = (u[0] * del[0] + u[1] * del[1] + u[2] * del[2]) / r2;
  const double t[3] = {u[0] - along * del[0], u[1] - along * del[1], u[2] - along * del[2]};
  const double speed = sqrt(t[0] * t[0] + t[1] * t[1] + t[2] * t[2]);
  const double mi = atom->rmass[i], mj = atom->rmass[j];
  const double eta = friction.viscosity(mi * mj / (mi + mj), update->dt);
  const double b = speed > 0.0 ? friction.factor(speed, normal, eta) : 0.0;
  for (int k = 0; k < 3; k++) drag[k] = -b * t[k];
}

void PairPotdemBase::collapsed(int i, int j, double r2) const
{
  error->one(
      FLERR,
      "pair_style {}: atoms {} and {} are {} apart on step {}: they are at the same place or their "
      "positions are "
      "not finite; use a smaller timestep, or keep them apart with 'penetration' in pair_coeff",
      name(), atom->tag[i], atom->tag[j], sqrt(r2), update->ntimestep);
}

/* ---------------------------------------------------------------------- */

double PairPotdemBase::single(int i, int j, int itype, int jtype, double rsq,
                              double /*factor_coul*/, double factor_lj, double &fforce)
{
  fforce = 0.0;
  const double dbar = atom->radius[i] + atom->radius[j], r = sqrt(rsq);
  if (r >= reach(itype, jtype, dbar)) return 0.0;
  const double dref = i < atom->nlocal ? contact_distance(i, j, dbar)
                                       : contact_distance(j, i, dbar);
  const auto law = evaluate(at(itype, jtype), r, dbar, dref);
  fforce = factor_lj * law.force / r;
  return factor_lj * law.energy;
}

/* ---------------------------------------------------------------------- */

template <class Action> void PairPotdemBase::for_each_coeff(Action action)
{
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) {
      action(&setflag[i][j], sizeof(int));
      action(&friction[at(i, j)], sizeof(POTDEM::Friction));
      action(coeff_data(at(i, j)), coeff_size());
    }
}

void PairPotdemBase::write_restart(FILE *fp)
{
  for_each_coeff([&](void *data, std::size_t size) {
    fwrite(data, size, 1, fp);
  });
}

void PairPotdemBase::read_restart(FILE *fp)
{
  allocate();
  for_each_coeff([&](void *data, std::size_t size) {
    if (comm->me == 0) utils::sfread(FLERR, data, size, 1, fp, nullptr, error);
    MPI_Bcast(data, size, MPI_BYTE, 0, world);
  });
}
