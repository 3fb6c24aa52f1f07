/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The loop over pairs, once for every law. */

#ifndef LMP_POTDEM_PAIR_LOOP_H
#define LMP_POTDEM_PAIR_LOOP_H

#include "pair_potdem.h"
#include "potdem_law_input.h"
#include "potdem_ledger.h"

#include "atom.h"
#include "error.h"
#include "force.h"
#include "neigh_list.h"

#include <cmath>

namespace LAMMPS_NS {

template <class Law> void PairPotdem<Law>::allocate()
{
  PairPotdemBase::allocate();
  laws.assign(friction.size(), Law{});
  kernels.resize(laws.size());
}

/* ----------------------------------------------------------------------
   I J  the law's coefficients and keywords  [friction mu eta|auto]
------------------------------------------------------------------------- */

template <class Law> void PairPotdem<Law>::coeff(int narg, char **arg)
{
  if (!allocated) allocate();
  PotdemInput input(lmp, fmt::format("pair_coeff {}", name()), narg, arg);
  int ilo, ihi, jlo, jhi;
  input.type_ranges(ilo, ihi, jlo, jhi);
  Law law{};
  POTDEM::Friction slide;
  read_law(input, law);
  prepare(law);
  while (!input.done()) {
    if (input.next_is("friction")) {
      slide = input.friction();
    } else if (!read_option(input, law)) {
      input.word();
      input.unknown(fmt::format("{} or friction", option_names(law)));
    }
  }
  for (int i = ilo; i <= ihi; i++)
    for (int j = MAX(jlo, i); j <= jhi; j++) laws[at(i, j)] = laws[at(j, i)] = law;
  set_coeff(ilo, ihi, jlo, jhi, slide);
}

template <class Law> std::string PairPotdem<Law>::coeff_text(int pair) const
{
  return law_text(laws[pair]);
}

template <class Law> double PairPotdem<Law>::init_one(int i, int j)
{
  const double cutoff = PairPotdemBase::init_one(i, j);
  laws[at(j, i)] = laws[at(i, j)];
  kernels[at(i, j)] = kernels[at(j, i)] = laws[at(i, j)].kernel(offset_flag != 0);
  return cutoff;
}

template <class Law> bool PairPotdem<Law>::needs_velocity() const
{
  if constexpr (Law::rated)
    for (const auto &law : laws)
      if (law.H > 0.0) return true;
  return sliding;
}

template <class Law> void PairPotdem<Law>::compute(int eflag, int vflag)
{
  ev_init(eflag, vflag);
  evflag ? choose<true>() : choose<false>();
  if (vflag_fdotr) virial_fdotr_compute();
}

// the smallest kernel that the coefficients need
template <class Law> template <bool EV> void PairPotdem<Law>::choose()
{
  const bool rated = Law::rated && needs_velocity();
  if (sliding)
    rated ? loop<true, Law::rated, EV>() : loop<true, false, EV>();
  else
    rated ? loop<false, Law::rated, EV>() : loop<false, false, EV>();
}

template <class Law> template <bool SLIDE, bool RATE, bool EV> void PairPotdem<Law>::loop()
{
  const auto *const x = (const double(*)[3]) atom->x[0];
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
      const double del[3] = {x[i][0] - x[j][0], x[i][1] - x[j][1], x[i][2] - x[j][2]};
      const double r2 = del[0] * del[0] + del[1] * del[1] + del[2] * del[2];
      const double reach = laws[pair].reach(radius[i] + radius[j]);
      if (r2 >= reach * reach || weight == 0.0) continue;

      const double r = sqrt(r2);
      const auto partners = pairing(i, j);
      const double core = kernels[pair].core(partners);
      if (!(r > core)) collapsed(i, j, r, core);    // true for NaN as well
      const auto law = kernels[pair].evaluate(r, partners);
      const Touch touch{i, j, del, r};
      double normal = law.force;
      if constexpr (RATE)
        if (r < partners.contact) {
          normal = kernels[pair].with_rate(law.force, r, partners, rate(touch));
          const double viscous = weight * (normal - law.force) / r;
          note(PotdemLedger::VISCOUS, touch, viscous * del[0], viscous * del[1], viscous * del[2]);
        }
      normal *= weight;

      double push[3] = {normal / r * del[0], normal / r * del[1], normal / r * del[2]};
      if (SLIDE && friction[pair].mu > 0.0 && normal > 0.0)
        slide(touch, friction[pair], normal, push);

      for (int k = 0; k < 3; k++) f[i][k] += push[k];
      if (newton || j < nlocal)
        for (int k = 0; k < 3; k++) f[j][k] -= push[k];
      if (EV)
        ev_tally_xyz(i, j, nlocal, newton, weight * law.energy, 0.0, push[0], push[1], push[2],
                     del[0], del[1], del[2]);
    }
  }
}

}    // namespace LAMMPS_NS

#endif
