/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The loop over pairs, once for every law. */

#ifndef LMP_POTDEM_PAIR_LOOP_H
#define LMP_POTDEM_PAIR_LOOP_H

#include "lammps/glue/potdem_law_input.h"
#include "lammps/pair/fix_potdem_contacts.h"
#include "lammps/pair/pair_potdem.h"

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
  if (lists_materials(narg, arg)) return coeff_by_material(narg, arg);
  PotdemInput input(lmp, fmt::format("pair_coeff {}", name()), narg, arg);
  int ilo, ihi, jlo, jhi;
  input.type_ranges(ilo, ihi, jlo, jhi);
  POTDEM::Friction slide;
  const Law law = read(input, slide);
  for (int i = ilo; i <= ihi; i++)
    for (int j = MAX(jlo, i); j <= jhi; j++) laws[at(i, j)] = laws[at(j, i)] = law;
  set_coeff(ilo, ihi, jlo, jhi, slide);
}

template <class Law> Law PairPotdem<Law>::read(PotdemInput &input, POTDEM::Friction &slide) const
{
  Law law{};
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
  return law;
}

template <class Law> void PairPotdem<Law>::reread(int pair, PotdemInput &input)
{
  laws[pair] = read(input, friction[pair]);
}

template <class Law> std::string PairPotdem<Law>::coeff_text(int pair) const
{
  return law_text(laws[pair]);
}

template <class Law> double *PairPotdem<Law>::coeff_of_law(int pair, const std::string &wanted)
{
  return law_coefficient(laws[pair], wanted);
}

template <class Law> double PairPotdem<Law>::init_one(int i, int j)
{
  const double cutoff = PairPotdemBase::init_one(i, j);
  laws[at(j, i)] = laws[at(i, j)];
  kernels[at(i, j)] = kernels[at(j, i)] = laws[at(i, j)].kernel(offset_flag != 0);
  find_alarm(i, j);
  return cutoff;
}

template <class Law> bool PairPotdem<Law>::any_viscous() const
{
  if constexpr (Law::rate_dependent)
    for (const auto &law : laws)
      if (law.H > 0.0) return true;
  return false;
}

template <class Law> void PairPotdem<Law>::compute(int eflag, int vflag)
{
  ev_init(eflag, vflag);
  ThreadShare all{0, list->inum, atom->f, atom->torque, nullptr};
  work(all);
  report(all);
  if (vflag_fdotr) virial_fdotr_compute();
}

// the smallest kernel that the coefficients need
template <class Law> void PairPotdem<Law>::work(ThreadShare &share_of_thread)
{
  evflag ? choose<true>(share_of_thread) : choose<false>(share_of_thread);
}

template <class Law> template <bool EV> void PairPotdem<Law>::choose(ThreadShare &share_of_thread)
{
  if (!sliding)
    choose_rate<false, false, EV>(share_of_thread);
  else
    rotation ? choose_rate<true, true, EV>(share_of_thread)
             : choose_rate<true, false, EV>(share_of_thread);
}

template <class Law>
template <bool SLIDE, bool SPIN, bool EV>
void PairPotdem<Law>::choose_rate(ThreadShare &share_of_thread)
{
  if constexpr (Law::rate_dependent)
    if (viscous) return loop<SLIDE, SPIN, true, EV>(share_of_thread);
  loop<SLIDE, SPIN, false, EV>(share_of_thread);
}

// one particle i at a time, its force kept in registers
template <class Law>
template <bool SLIDE, bool SPIN, bool RATE, bool EV>
void PairPotdem<Law>::loop(ThreadShare &share_of_thread)
{
  const auto *const x = (const double(*)[3]) atom->x[0];
  auto *const f = (double(*)[3]) share_of_thread.f[0];
  const double *const radius = atom->radius, *const special = force->special_lj;
  const double *const nearest = alarm.data();
  const int *const type = atom->type;
  const int nlocal = atom->nlocal, newton = force->newton_pair;
  const bool remembering = contacts && contacts->any();
  const PotdemMotion state = motion();

  for (int ii = share_of_thread.from; ii < share_of_thread.to; ii++) {
    const int i = list->ilist[ii], pairs = at(type[i], 0), jnum = list->numneigh[i];
    const int *const jlist = list->firstneigh[i];
    const double xi = x[i][0], yi = x[i][1], zi = x[i][2], ri = radius[i];
    double fi[3] = {0.0, 0.0, 0.0};
    for (int jj = 0; jj < jnum; jj++) {
      const int j = jlist[jj] & NEIGHMASK, pair = pairs + type[j];
      const double weight = special[sbmask(jlist[jj])], rj = radius[j];
      PotdemTouch touch{i, j, {xi - x[j][0], yi - x[j][1], zi - x[j][2]}, 0.0};
      const double *const del = touch.del;
      const double r2 = del[0] * del[0] + del[1] * del[1] + del[2] * del[2];
      const double reach = laws[pair].reach(ri + rj);
      if (r2 >= reach * reach || weight == 0.0) continue;

      const double r = touch.r = sqrt(r2), near = nearest[pair] * (ri + rj);
      const auto partners = remembering ? pairing(i, j, contacts->distance(i, jj))
                                        : POTDEM::ContactGeometry{ri, rj, ri + rj};
      if (!(r2 > near * near)) {    // true for NaN as well
        if (!(r > kernels[pair].hard_core(partners))) {
          share_of_thread.i = i;
          share_of_thread.j = j;
          return;
        }
        if (monitor) suspect(share_of_thread, i, j);
      }
      const auto law = kernels[pair].evaluate(r, partners);
      double normal = law.force;
      if constexpr (RATE)
        if (r < partners.contact) {
          normal = kernels[pair].with_rate(law.force, r, partners, potdem_rate(state, touch));
          if (ledger) note(FixPotdemLedger::VISCOUS, touch, weight * (normal - law.force) / r, del);
        }
      normal *= weight;

      const double along = normal / r;
      double push[3] = {along * del[0], along * del[1], along * del[2]};
      if (SLIDE && normal > 0.0 && friction[pair].mu > 0.0)
        add_friction<SPIN>(share_of_thread, state, touch, friction[pair], normal, push);
      for (int k = 0; k < 3; k++) fi[k] += push[k];
      if (newton || j < nlocal)
        for (int k = 0; k < 3; k++) f[j][k] -= push[k];
      if (EV) tally(share_of_thread, touch, weight * law.energy, push);
    }
    for (int k = 0; k < 3; k++) f[i][k] += fi[k];
  }
}

// adds friction on i to push, and its torques
template <class Law>
template <bool SPIN>
inline void PairPotdem<Law>::add_friction(const ThreadShare &share_of_thread,
                                          const PotdemMotion &state, const PotdemTouch &touch,
                                          const POTDEM::Friction &rough, double normal,
                                          double *push)
{
  double drag[3], turn[3];
  potdem_drag<SPIN>(state, touch, rough, normal, drag);
  for (int k = 0; k < 3; k++) push[k] += drag[k];
  if (ledger) note(FixPotdemLedger::FRICTION, touch, 1.0, drag);
  if (!SPIN) return;
  const int i = touch.i, j = touch.j;
  potdem_turn(state, touch, drag, turn);
  if (ledger) note_torque(touch, turn);
  for (int k = 0; k < 3; k++) share_of_thread.torque[i][k] += state.radius[i] * turn[k];
  if (force->newton_pair || j < atom->nlocal)
    for (int k = 0; k < 3; k++) share_of_thread.torque[j][k] += state.radius[j] * turn[k];
}

}    // namespace LAMMPS_NS

#endif
