/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The loop over pairs, once for every law. */

#ifndef LMP_PAIR_POTDEM_LOOP_H
#define LMP_PAIR_POTDEM_LOOP_H

#include "core/contact/contact_batch.h"
#include "lammps/pair/fix_potdem_contacts.h"
#include "lammps/pair/pair_potdem.h"

#include "atom.h"
#include "error.h"
#include "force.h"
#include "neigh_list.h"
#include "update.h"

#include <algorithm>
#include <array>
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
  for (const auto &one : shares) {
    report(one);
    eng_vdwl += one.energy;
  }
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

// contacts in the order of the list, gathered in batches of one or several
template <class Law>
template <class Tangential, class Rate, bool SPIN, bool EV>
void PairPotdem<Law>::loop(ThreadShare &share, const Tangential *rough, const Rate *rate_laws)
{
  constexpr bool SLIDE = !std::is_same_v<Tangential, POTDEM::Frictionless>;
  constexpr int LANES = POTDEM::is_wide<Law>(0) && SLIDE ? WIDE : 1;
  using Batch = POTDEM::ContactBatch<Kernel, Rate, Tangential, SPIN, LANES>;
  const POTDEM::PairLaws<Kernel, Rate, Tangential> all{kernels.data(), rate_laws, rough};
  const Particles at_hand(atom, share, force->newton_pair);
  const double *const special = force->special_lj, *const nearest = alarm.data();
  const Law *const law = laws.data();
  const bool remembering = contacts && contacts->any(), advance = !update->setupflag;
  const double dt = update->dt, step = dt / force->mvv2e;
  Batch batch;
  if constexpr (LANES > 1) batch = {};
  Lanes<LANES> lanes;

  for (int ii = share.from; ii < share.to; ii++) {
    const int i = list->ilist[ii], jnum = list->numneigh[i];
    const int pairs = at(at_hand.type[i], 0), *const jlist = list->firstneigh[i];
    const auto &xi = at_hand.x[i];
    const double ri = at_hand.radius[i];
    const auto kept = remembering ? contacts->row(i) : FixPotdemContacts::Row();
    for (int jj = 0; jj < jnum; jj++) {
      const int j = jlist[jj] & NEIGHMASK, pair = pairs + at_hand.type[j];
      const double weight = special[sbmask(jlist[jj])], rj = at_hand.radius[j];
      const auto &xj = at_hand.x[j];
      const double del[3] = {xi[0] - xj[0], xi[1] - xj[1], xi[2] - xj[2]};
      const double r2 = del[0] * del[0] + del[1] * del[1] + del[2] * del[2];
      const double reach = law[pair].reach(ri + rj), near = nearest[pair] * (ri + rj);
      if (r2 >= reach * reach || weight == 0.0) {
        if constexpr (Tangential::STATE > 0) kept.part(jj);
        continue;
      }
      const double begins = remembering ? kept.begins(jj) : 0.0;
      const auto partners = begins != 0.0 ? geometry(i, j, begins)
                                          : POTDEM::ContactGeometry{ri, rj, ri + rj};
      if (!(r2 > near * near) && is_collapsed(share, i, j, sqrt(r2), partners)) return;

      const int l = lanes.n++;
      lanes.i[l] = i;
      lanes.j[l] = j;
      batch.pair[l] = pair;
      for (int k = 0; k < 3; k++) batch.del[k][l] = del[k];
      batch.r2[l] = r2;
      batch.ri[l] = ri;
      batch.rj[l] = rj;
      batch.contact[l] = partners.contact;
      batch.weight[l] = weight;
      gather_motion(batch, at_hand, i, j, l);
      if constexpr (Tangential::STATE > 0) {
        double *const state = lanes.state[l] = kept.touch(jj);
        for (int k = 0; k < Tangential::STATE; k++) batch.state[k][l] = state[k];
      }
      if (lanes.n < LANES) continue;
      batch.find_all(width, all, advance, step, dt);
      take<EV>(share, at_hand, batch, lanes);
    }
  }
  if (LANES > 1 && lanes.n > 0) {
    batch.find_all(width, all, advance, step, dt);
    take<EV>(share, at_hand, batch, lanes);
  }
  lanes.add_force(at_hand.f);
}

template <class Law>
PairPotdem<Law>::Particles::Particles(const Atom *atom, const ThreadShare &share, int newton_pair) :
    radius(atom->radius), rmass(atom->rmass), type(atom->type), nlocal(atom->nlocal),
    newton(newton_pair)
{
  const auto first = [](double **array) {
    return array ? (double(*)[3]) array[0] : nullptr;
  };
  x = first(atom->x);
  v = first(atom->v);
  omega = first(atom->omega);
  f = first(share.f);
  torque = first(share.torque);
}

// a pair nearer than any that can be passed over without a look (true for NaN, too): collapsed, or only doubtful
template <class Law>
bool PairPotdem<Law>::is_collapsed(ThreadShare &share, int i, int j, double r,
                                   POTDEM::ContactGeometry partners) const
{
  if (!(r > kernels[at(atom->type[i], atom->type[j])].hard_core(partners))) {
    share.i = i;
    share.j = j;
    return true;
  }
  if (monitor) suspect(share, i, j, r, partners);
  return false;
}

template <class Law>
template <class Batch>
inline void PairPotdem<Law>::gather_motion(Batch &batch, const Particles &all, int i, int j, int l)
{
  if (!Batch::SLIDE && !Batch::RATE) return;
  for (int k = 0; k < 3; k++) batch.v[k][l] = all.v[i][k] - all.v[j][k];
  batch.mi[l] = all.rmass[i];
  batch.mj[l] = all.rmass[j];
  if (!Batch::SPINS) return;
  for (int k = 0; k < 3; k++) {
    batch.wi[k][l] = all.omega[i][k];
    batch.wj[k][l] = all.omega[j][k];
  }
}

// what a batch has found, contact by contact; the force on the first particle of several contacts is summed up before it is added
template <class Law>
template <bool EV, class Batch, class Owners>
inline void PairPotdem<Law>::take(ThreadShare &share, const Particles &all, const Batch &batch,
                                  Owners &lanes)
{
  const bool only_energy = eflag_global && !eflag_atom && !vflag_either;
  for (int l = 0; l < lanes.n; l++) {
    const int i = lanes.i[l], j = lanes.j[l];
    for (int k = 0; k < Batch::STATE; k++) lanes.state[l][k] = batch.state[k][l];
    if (i != lanes.current) {
      lanes.add_force(all.f);
      lanes.current = i;
    }
    const double push[3] = {batch.push[0][l], batch.push[1][l], batch.push[2][l]};
    for (int k = 0; k < 3; k++) lanes.force[k] += push[k];
    const bool to_both = all.newton || j < all.nlocal;
    if (to_both)
      for (int k = 0; k < 3; k++) all.f[j][k] -= push[k];
    if (Batch::SPINS && batch.pressing[l] > 0.0) take_torques(all, batch, i, j, to_both, l);
    if (ledger) book(batch, i, j, l);
    if (EV) {
      const double energy = batch.weight[l] * batch.energy[l];
      const double del[3] = {batch.del[0][l], batch.del[1][l], batch.del[2][l]};
      if (only_energy)
        share.energy += to_both ? energy : 0.5 * energy;
      else
        tally(share, i, j, del, energy, push);
    }
  }
  lanes.n = 0;
}

template <class Law>
template <class Batch>
inline void PairPotdem<Law>::take_torques(const Particles &all, const Batch &batch, int i, int j,
                                          bool to_both, int l)
{
  const double ri = batch.ri[l], rj = batch.rj[l];
  for (int k = 0; k < 3; k++) all.torque[i][k] += ri * batch.turn[k][l];
  if (to_both)
    for (int k = 0; k < 3; k++) all.torque[j][k] += rj * batch.turn[k][l];
  if (!Batch::ROLL) return;
  for (int k = 0; k < 3; k++) all.torque[i][k] += batch.rolling[k][l];
  if (to_both)
    for (int k = 0; k < 3; k++) all.torque[j][k] -= batch.rolling[k][l];
}

// in the ledger
template <class Law>
template <class Batch>
void PairPotdem<Law>::book(const Batch &batch, int i, int j, int l) const
{
  const auto of = [l](const double(&of_lanes)[3][Batch::LANES]) {
    return std::array<double, 3>{of_lanes[0][l], of_lanes[1][l], of_lanes[2][l]};
  };
  if (Batch::RATE && batch.r[l] < batch.contact[l]) {
    const double viscous = batch.viscous[l] / batch.r[l];
    const auto del = of(batch.del);
    const double drag[3] = {viscous * del[0], viscous * del[1], viscous * del[2]};
    note(FixPotdemLedger::VISCOUS, i, j, drag);
  }
  if (!Batch::SLIDE || !(batch.pressing[l] > 0.0)) return;
  note(FixPotdemLedger::FRICTION, i, j, of(batch.friction).data());
  if (Batch::SPINS) note_torque(i, j, batch.ri[l], batch.rj[l], of(batch.turn).data());
  if (Batch::ROLL) note_torque(i, j, 1.0, -1.0, of(batch.rolling).data());
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
