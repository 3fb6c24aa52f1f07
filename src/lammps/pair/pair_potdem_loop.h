/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The loop over pairs, once for every law. */

#ifndef LMP_PAIR_POTDEM_LOOP_H
#define LMP_PAIR_POTDEM_LOOP_H

#include "lammps/pair/fix_potdem_contacts.h"
#include "lammps/pair/pair_potdem.h"

#include "atom.h"
#include "error.h"
#include "force.h"
#include "neigh_list.h"
#include "update.h"

#include <algorithm>
#include <cmath>

namespace LAMMPS_NS {

template <class Law> void PairPotdem<Law>::compute(int eflag, int vflag)
{
  ev_init(eflag, vflag);
  std::vector<ThreadShare> all{share(0, begin_work(), atom->f, atom->torque, nullptr)};
  work(all[0]);
  end_work(all);
  if (vflag_fdotr) virial_fdotr_compute();
}

// the particles whose pairs there are
template <class Law> int PairPotdem<Law>::begin_work()
{
  if (!kernel_known) find_kernel();
  return list->inum;
}

template <class Law> void PairPotdem<Law>::find_kernel()
{
  if (!potdem_same_rate(rates, dashpots))
    error->all(
        FLERR,
        "pair_style {}: its pair_coeff lose energy by different laws; give one of {} for all, "
        "or use pair_style hybrid",
        name(), potdem_rate_names<Law>());
  if (!viscous) dashpots = std::monostate();
  if (!potdem_same_law(friction, frictions))
    error->all(FLERR,
               "pair_style {}: its pair_coeff have different laws of friction; give all the same "
               "one, or use pair_style hybrid",
               name());
  if (!sliding) frictions = std::monostate();
  kernel_known = true;
}

template <class Law> void PairPotdem<Law>::end_work(const std::vector<ThreadShare> &shares)
{
  for (const auto &one : shares) report(one);
}

// the smallest kernel that the coefficients need
template <class Law> void PairPotdem<Law>::work(ThreadShare &share)
{
  std::visit(
      [this, &share](const auto &rough) {
        if constexpr (std::is_same_v<std::decay_t<decltype(rough)>, std::monostate>) {
          const POTDEM::Frictionless *const none = nullptr;
          evflag ? choose_rate<POTDEM::Frictionless, false, true>(share, none)
                 : choose_rate<POTDEM::Frictionless, false, false>(share, none);
        } else {
          choose(share, rough);
        }
      },
      frictions);
}

template <class Law>
template <class Tangential>
void PairPotdem<Law>::choose(ThreadShare &share, const std::vector<Tangential> &rough)
{
  if constexpr (!POTDEM::is_rolling<Tangential>)
    if (!rotation)
      return evflag ? choose_rate<Tangential, false, true>(share, rough.data())
                    : choose_rate<Tangential, false, false>(share, rough.data());
  evflag ? choose_rate<Tangential, true, true>(share, rough.data())
         : choose_rate<Tangential, true, false>(share, rough.data());
}

template <class Law>
template <class Tangential, bool SPIN, bool EV>
void PairPotdem<Law>::choose_rate(ThreadShare &share, const Tangential *rough)
{
  std::visit(
      [this, &share, rough](const auto &one) {
        if constexpr (!std::is_same_v<std::decay_t<decltype(one)>, std::monostate>) {
          using Rate = typename std::decay_t<decltype(one)>::value_type;
          if constexpr (Rate::template serves<Law>())
            loop<Tangential, Rate, SPIN, EV>(share, rough, one.data());
        } else {
          const POTDEM::Elastic *const none = nullptr;
          loop<Tangential, POTDEM::Elastic, SPIN, EV>(share, rough, none);
        }
      },
      dashpots);
}

// one particle i at a time, its force kept in registers
template <class Law>
template <class Tangential, class Rate, bool SPIN, bool EV>
void PairPotdem<Law>::loop(ThreadShare &share, const Tangential *rough, const Rate *rate_laws)
{
  constexpr bool RATE = !std::is_same_v<Rate, POTDEM::Elastic>;
  constexpr bool SLIDE = !std::is_same_v<Tangential, POTDEM::Frictionless>;
  constexpr bool ROLL = POTDEM::is_rolling<Tangential>;
  constexpr double spin_share = SPIN ? POTDEM::sliding_mass(1.0, POTDEM::SPHERE_INERTIA) : 1.0;
  constexpr Tangential frictionless{};
  const auto *const x = (const double(*)[3]) atom->x[0];
  const auto *const v = (const double(*)[3]) atom->v[0];
  const auto *const omega = SPIN ? (const double(*)[3]) atom->omega[0] : nullptr;
  auto *const f = (double(*)[3]) share.f[0];
  const double *const radius = atom->radius, *const rmass = atom->rmass;
  const double *const special = force->special_lj, *const nearest = alarm.data();
  const int *const type = atom->type;
  const int nlocal = atom->nlocal, newton = force->newton_pair;
  const bool remembering = contacts && contacts->any(), advance = !update->setupflag;
  const double dt = update->dt, step = dt / force->mvv2e;

  for (int ii = share.from; ii < share.to; ii++) {
    const int i = list->ilist[ii], pairs = at(type[i], 0), jnum = list->numneigh[i];
    const int *const jlist = list->firstneigh[i];
    const double xi = x[i][0], yi = x[i][1], zi = x[i][2], ri = radius[i];
    double fi[3] = {0.0, 0.0, 0.0};
    for (int jj = 0; jj < jnum; jj++) {
      const int j = jlist[jj] & NEIGHMASK, pair = pairs + type[j];
      const double weight = special[sbmask(jlist[jj])], rj = radius[j];
      const double del[3] = {xi - x[j][0], yi - x[j][1], zi - x[j][2]};
      const double r2 = del[0] * del[0] + del[1] * del[1] + del[2] * del[2];
      const double reach = laws[pair].reach(ri + rj);
      if (r2 >= reach * reach || weight == 0.0) {
        if constexpr (Tangential::STATE > 0) contacts->part(i, jj);
        continue;
      }

      const double r = sqrt(r2), near = nearest[pair] * (ri + rj);
      const double *const memory = remembering ? contacts->memory(i, jj) : nullptr;
      const auto partners = memory ? geometry(i, j, *memory)
                                   : POTDEM::ContactGeometry{ri, rj, ri + rj};
      if (!(r2 > near * near)) {    // true for NaN as well
        if (!(r > kernels[pair].hard_core(partners))) {
          share.i = i;
          share.j = j;
          return;
        }
        if (monitor) suspect(share, i, j);
      }

      const auto motion = [&] {
        POTDEM::ContactMotion m{{del[0], del[1], del[2]}, r, {}, {}, {}, {}};
        for (int k = 0; k < 3; k++) m.v[k] = v[i][k] - v[j][k];
        if constexpr (SPIN) POTDEM::spin_of(omega[i], omega[j], ri, rj, m);
        return m;
      };
      const auto masses = [&] {
        const double mi = rmass[i], mj = rmass[j];
        const POTDEM::ContactMasses both{spin_share * mi * mj, mi + mj, step, dt, spin_share};
        return ROLL ? POTDEM::with_rolling(both, mi, mj, ri, rj) : both;
      };
      double *state = nullptr;
      if constexpr (Tangential::STATE > 0) state = contacts->touch(i, jj);
      Rate rate{};
      if constexpr (RATE) rate = rate_laws[pair];
      const auto found = POTDEM::contact_forces<SPIN>(kernels[pair], r, partners, weight, rate,
                                                      SLIDE ? rough[pair] : frictionless, state,
                                                      advance, motion, masses);

      const double along = found.normal / r;
      double push[3] = {along * del[0], along * del[1], along * del[2]};
      if (RATE && ledger && r < partners.contact) {
        const double viscous = found.viscous / r;
        const double drag[3] = {viscous * del[0], viscous * del[1], viscous * del[2]};
        note(FixPotdemLedger::VISCOUS, i, j, drag);
      }
      if (SLIDE && found.normal > 0.0)
        add_surface<SPIN, ROLL>(share, i, j, del, found.surface, push);
      for (int k = 0; k < 3; k++) fi[k] += push[k];
      if (newton || j < nlocal)
        for (int k = 0; k < 3; k++) f[j][k] -= push[k];
      if (EV) tally(share, i, j, del, weight * found.elastic.energy, push);
    }
    for (int k = 0; k < 3; k++) f[i][k] += fi[k];
  }
}

// to the force on i, and to the torques
template <class Law>
template <bool SPIN, bool ROLL>
inline void PairPotdem<Law>::add_surface(const ThreadShare &share, int i, int j, const double *del,
                                         const POTDEM::SurfaceForces &found, double *push)
{
  const double *const friction = found.friction;
  for (int k = 0; k < 3; k++) push[k] += friction[k];
  if (ledger) note(FixPotdemLedger::FRICTION, i, j, friction);
  if (!SPIN) return;
  const double ri = atom->radius[i], rj = atom->radius[j], inverse = 1.0 / (ri + rj);
  double turn[3];
  POTDEM::torque_over_lever(del, friction, turn);
  for (int k = 0; k < 3; k++) turn[k] *= inverse;
  if (ledger) note_torque(i, j, ri, rj, turn);
  for (int k = 0; k < 3; k++) share.torque[i][k] += ri * turn[k];
  if (force->newton_pair || j < atom->nlocal)
    for (int k = 0; k < 3; k++) share.torque[j][k] += rj * turn[k];
  if (!ROLL) return;
  if (ledger) note_torque(i, j, 1.0, -1.0, found.torque);
  for (int k = 0; k < 3; k++) share.torque[i][k] += found.torque[k];
  if (force->newton_pair || j < atom->nlocal)
    for (int k = 0; k < 3; k++) share.torque[j][k] -= found.torque[k];
}

// what the second particle of a pair remembers, from what the first does
template <class Law>
void PairPotdem<Law>::transfer_history(double *from, double *to, int itype, int jtype)
{
  std::copy_n(from, contacts->get_dnum(), to);
  potdem_visit(friction[at(itype, jtype)], [to](const auto &rough) {
    if constexpr (std::decay_t<decltype(rough)>::STATE > 0) rough.turn(to + 1);
  });
}

}    // namespace LAMMPS_NS

#endif
