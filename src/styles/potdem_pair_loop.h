/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The loop over pairs, once for every law. */

#ifndef LMP_POTDEM_PAIR_LOOP_H
#define LMP_POTDEM_PAIR_LOOP_H

#include "pair_potdem.h"

#include "atom.h"
#include "error.h"
#include "force.h"
#include "neigh_list.h"
#include "update.h"

#include <cmath>

namespace LAMMPS_NS {

template <class Law> void PairPotdem<Law>::allocate()
{
  PairPotdemBase::allocate();
  laws.assign(friction.size(), Law{});
}

template <class Law>
void PairPotdem<Law>::set_laws(int ilo, int ihi, int jlo, int jhi, const Law &law,
                               const POTDEM::Friction &slide)
{
  for (int i = ilo; i <= ihi; i++)
    for (int j = MAX(jlo, i); j <= jhi; j++) laws[at(i, j)] = laws[at(j, i)] = law;
  set_coeff(ilo, ihi, jlo, jhi, slide);
}

template <class Law> void PairPotdem<Law>::init_style()
{
  PairPotdemBase::init_style();
  kernels.resize(laws.size());
}

template <class Law> double PairPotdem<Law>::init_one(int i, int j)
{
  const double cutoff = PairPotdemBase::init_one(i, j);
  laws[at(j, i)] = laws[at(i, j)];
  kernels[at(i, j)] = kernels[at(j, i)] = laws[at(i, j)].kernel();
  return cutoff;
}

template <class Law> void PairPotdem<Law>::compute(int eflag, int vflag)
{
  ev_init(eflag, vflag);
  if (sliding)
    evflag ? loop<true, true>() : loop<true, false>();
  else
    evflag ? loop<false, true>() : loop<false, false>();
}

template <class Law> template <bool SLIDE, bool EV> void PairPotdem<Law>::loop()
{
  const auto *const x = (const double(*)[3]) atom->x[0];
  const auto *const v = (const double(*)[3]) atom->v[0];
  auto *const f = (double(*)[3]) atom->f[0];
  const double *const radius = atom->radius;
  const int *const type = atom->type;
  const int nlocal = atom->nlocal, newton = force->newton_pair;

  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii], itype = type[i];
    const int *const jlist = list->firstneigh[i];
    for (int jj = 0; jj < list->numneigh[i]; jj++) {
      const int j = jlist[jj] & NEIGHMASK, pair = at(itype, type[j]);
      const double weight = force->special_lj[sbmask(jlist[jj])];
      const double dx = x[i][0] - x[j][0], dy = x[i][1] - x[j][1], dz = x[i][2] - x[j][2];
      const double r2 = dx * dx + dy * dy + dz * dz;
      const double dbar = radius[i] + radius[j], reach = laws[pair].reach(dbar);
      if (r2 >= reach * reach || weight == 0.0) continue;

      if (!(r2 > 0.0)) collapsed(i, j, r2);    // true for NaN as well
      const double r = sqrt(r2);
      const auto law = kernels[pair].evaluate(r, dbar, contact_distance(i, j, dbar));
      const double push = weight * law.force / r;
      double px = push * dx, py = push * dy, pz = push * dz;
      if (SLIDE && friction[pair].mu > 0.0 && law.force > 0.0) {
        const double del[3] = {dx, dy, dz};
        double drag[3];
        slide(i, j, friction[pair], weight * law.force, del, r2, drag);
        px += drag[0];
        py += drag[1];
        pz += drag[2];
      }

      f[i][0] += px;
      f[i][1] += py;
      f[i][2] += pz;
      if (newton || j < nlocal) {
        f[j][0] -= px;
        f[j][1] -= py;
        f[j][2] -= pz;
      }
      if (EV) ev_tally_xyz(i, j, nlocal, newton, weight * law.energy, 0.0, px, py, pz, dx, dy, dz);
    }
  }
  if (vflag_fdotr) virial_fdotr_compute();
}

}    // namespace LAMMPS_NS

#endif
