/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The loop over bonds: one atom at a time, its force kept in registers, four of its bonds at once where the law can. Four bonds of
   which something is to be said (they fail, or collapse) are done again one by one. */

#ifndef LMP_BOND_POTDEM_LOOP_H
#define LMP_BOND_POTDEM_LOOP_H

#include "core/laws/four.h"
#include "core/laws/truss.h"
#include "lammps/bond/bond_potdem.h"
#include "lammps/output/fix_potdem_ledger.h"
#include "lammps/output/fix_potdem_monitor.h"

#include "atom.h"

#include <cmath>

namespace LAMMPS_NS {

// PENETRATION: some bond type has the factor that some laws know
template <bool PENETRATION, class Law, class Number>
POTDEM_FUNCTION inline Number potdem_bond_load(const typename Law::Kernel &kernel, const Number &q,
                                               double *state)
{
  if constexpr (Law::optional_penetration)
    return kernel.template load<PENETRATION>(q, state);
  else
    return kernel.load(q, state);
}

// q = (r/re)^2
template <class Law, class Number>
POTDEM_FUNCTION inline Number potdem_bond_energy(const typename Law::Kernel &kernel,
                                                 const Number &r, const Number &q,
                                                 const Number &half_modulus, const double *state)
{
  const Number x = POTDEM::square_root(q), re = r / x;
  if constexpr (POTDEM::is_wide<Law>(0))
    return kernel.energy(x, 2.0 * half_modulus * re);
  else
    return kernel.evaluate(r, re, 2.0 * half_modulus, state).energy;
}

// owned: the share of owned ends
template <class Law>
template <class Number>
POTDEM_FUNCTION inline void
BondPotdem<Law>::Sums<Number>::add(const Inputs &in, const Number &owned, const Number &of_bond,
                                   const Number &pull, const Number *del)
{
  if (in.energy) energy += owned * of_bond;
  if (!in.virial) return;
  const Number push = -owned * pull;
  for (int k = 0; k < 3; k++) virial[k] += push * del[k] * del[k];
  virial[3] += push * del[0] * del[1];
  virial[4] += push * del[0] * del[2];
  virial[5] += push * del[1] * del[2];
}

template <class Law>
template <class Number>
POTDEM_FUNCTION inline void BondPotdem<Law>::Sums<Number>::add_to(ThreadShare &share) const
{
  share.energy += POTDEM::sum(energy);
  for (int k = 0; k < 6; k++) share.virial[k] += POTDEM::sum(virial[k]);
}

template <class Law>
BondPotdem<Law>::Inputs::Inputs(BondPotdem &style, double **forces) :
    x((const double (*)[3]) style.atom->x[0]), v((const double (*)[3]) style.atom->v[0]),
    partner(style.bonds.partner.data()), type(style.bonds.type.data()),
    inverse_length2(style.bonds.inverse_length2.data()),
    half_modulus(style.bonds.half_modulus.data()), dashpot(style.bonds.dashpot.data()),
    scale(style.bonds.strength.data()), strength(style.strengths.of_types()),
    kernel(style.kernels.data()), roots(style.volume.roots()),
    weight_here(style.volume.weights_here()), weight_there(style.volume.weights_there()),
    f((double (*)[3]) forces[0]), energy(style.eflag_either), virial(style.vflag_either),
    of_atoms(style.eflag_atom || style.vflag_atom)
{
}

template <class Law>
template <bool EV, int FAIL, bool PENETRATION, bool DAMP>
void BondPotdem<Law>::loop(ThreadShare &share)
{
  loop_over<EV, FAIL, PENETRATION, DAMP>(share);
}

#ifdef POTDEM_WIDE_CODE
template <class Law>
template <bool EV, int FAIL, bool PENETRATION, bool DAMP>
POTDEM_AVX2 void BondPotdem<Law>::loop_avx2(ThreadShare &share)
{
  loop_over<EV, FAIL, PENETRATION, DAMP>(share);
}
#endif

template <class Law>
template <bool EV, int FAIL, bool PENETRATION, bool DAMP>
POTDEM_FUNCTION inline void BondPotdem<Law>::loop_over(ThreadShare &share)
{
  const Inputs in(*this, share.f);
  Sums<double> sums;
#ifdef POTDEM_HAS_FOUR
  Sums<POTDEM::Four> sums_of_four;
#endif
  for (int i = share.from; i < share.to; i++) {
    const int end = bonds.first[i + 1], ghosts = bonds.ghosts[i];
    int n = bonds.first[i];
    if (n == end) continue;
    double force[3] = {0.0, 0.0, 0.0};
#ifdef POTDEM_HAS_FOUR
    if constexpr (Law::STATE == 0 && POTDEM::is_wide<Law>(0)) {
      POTDEM::Four3 pulls{};
      for (; n + 4 <= end; n += 4) {
        if (take_four<EV, FAIL, PENETRATION, DAMP>(in, share, i, n, ghosts, pulls, sums_of_four))
          continue;
        for (int m = n; m < n + 4; m++)
          if (!take<EV, FAIL, PENETRATION, DAMP>(in, share, i, m, ghosts, force, sums)) return;
      }
      force[0] += POTDEM::sum(pulls.x);
      force[1] += POTDEM::sum(pulls.y);
      force[2] += POTDEM::sum(pulls.z);
    }
#endif
    for (; n < end; n++)
      if (!take<EV, FAIL, PENETRATION, DAMP>(in, share, i, n, ghosts, force, sums)) return;
    for (int k = 0; k < 3; k++) in.f[i][k] += force[k];
  }
  if constexpr (EV) {
    sums.add_to(share);
#ifdef POTDEM_HAS_FOUR
    sums_of_four.add_to(share);
#endif
  }
}

// bond n of atom i; ghosts: its first one to a ghost. false: it has no length
template <class Law>
template <bool EV, int FAIL, bool PENETRATION, bool DAMP>
POTDEM_FUNCTION inline bool BondPotdem<Law>::take(const Inputs &in, ThreadShare &share, int i,
                                                  int n, int ghosts, double *force,
                                                  Sums<double> &sums)
{
  const int j = in.partner[n], type = in.type[n];
  const double *const xi = in.x[i], *const xj = in.x[j];
  const double del[3] = {xj[0] - xi[0], xj[1] - xi[1], xj[2] - xi[2]};
  const double r2 = del[0] * del[0] + del[1] * del[1] + del[2] * del[2];
  const double q = r2 * in.inverse_length2[n];
  if (!(q > CRUSHED)) {    // true for NaN as well
    if (!(r2 > 0.0)) {
      share.note_collapsed(i, j);
      return false;
    }
    share.note_crushed(i, n);
  }

  // tension over distance
  const double r = sqrt(r2), inverse_r = 1.0 / r;
  double *const state = Law::STATE > 0 ? bonds.state_of(n) : nullptr;
  const double load = potdem_bond_load<PENETRATION, Law>(in.kernel[type], q, state);
  const double scale = FAIL == BondStrengths::BY_BOND ? in.scale[n] : 1.0;
  if (FAIL && in.strength[type].reached_by(load, scale))
    share.over.push_back({i, j, type, n, load > 0.0});
  double pull = in.half_modulus[n] * load * inverse_r, of_volume = 0.0;
  if (in.roots)
    if (const double *const root = in.roots[type]) {
      const double of_ends = root[i] * in.weight_here[n] + root[j] * in.weight_there[n];
      pull += of_ends * in.inverse_length2[n];
      of_volume = 0.5 * POTDEM::truss_strain(q) * of_ends;
    }
  if (EV) {
    const double energy = in.energy
        ? potdem_bond_energy<Law>(in.kernel[type], r, q, in.half_modulus[n], state) + of_volume
        : 0.0;
    if (in.of_atoms)
      tally(share, i, j, energy, pull, del);
    else
      sums.add(in, n < ghosts ? 1.0 : 0.5, energy, pull, del);
  }
  if (DAMP) {
    const double *const vi = in.v[i], *const vj = in.v[j];
    const double damp = in.dashpot[n] * inverse_r * inverse_r *
        ((vj[0] - vi[0]) * del[0] + (vj[1] - vi[1]) * del[1] + (vj[2] - vi[2]) * del[2]);
    if (ledger) note(i, j, damp * del[0], damp * del[1], damp * del[2]);
    pull += damp;
  }
  for (int k = 0; k < 3; k++) force[k] += pull * del[k];
  if (n < ghosts)
    for (int k = 0; k < 3; k++) in.f[j][k] -= pull * del[k];
  return true;
}

#ifdef POTDEM_HAS_FOUR
// bonds n to n + 3, of one type; false: nothing is done yet, and each needs a look
template <class Law>
template <bool EV, int FAIL, bool PENETRATION, bool DAMP>
POTDEM_FUNCTION inline bool BondPotdem<Law>::take_four(const Inputs &in, const ThreadShare &share,
                                                       int i, int n, int ghosts, POTDEM::Four3 &sum,
                                                       Sums<POTDEM::Four> &sums)
{
  using POTDEM::Four;
  const int *const partner = in.partner + n;
  const auto *const types = in.type + n;
  const int type = types[0];
  if ((types[1] ^ type) | (types[2] ^ type) | (types[3] ^ type)) return false;
  const POTDEM::Four3 del(in.x, partner, in.x[i]);
  const Four r2 = del.dot(del), q = r2 * POTDEM::read_vector<Four>(in.inverse_length2 + n);
  const Four load = potdem_bond_load<PENETRATION, Law>(in.kernel[type], q, nullptr);
  auto doubtful = !(q > CRUSHED);
  if constexpr (FAIL == BondStrengths::BY_BOND)
    doubtful |= in.strength[type].reached_by(load, POTDEM::read_vector<Four>(in.scale + n));
  else if constexpr (FAIL != BondStrengths::NONE)
    doubtful |= in.strength[type].reached_by(load, 1.0);
  if (POTDEM::any(doubtful)) return false;

  const Four r = POTDEM::square_root(r2), inverse_r = 1.0 / r;
  const Four half_modulus = POTDEM::read_vector<Four>(in.half_modulus + n);
  Four pull = half_modulus * load * inverse_r, of_volume{};
  if (in.roots)
    if (const double *const root = in.roots[type]) {
      const Four there = {root[partner[0]], root[partner[1]], root[partner[2]], root[partner[3]]};
      const Four of_ends = root[i] * POTDEM::read_vector<Four>(in.weight_here + n) +
          there * POTDEM::read_vector<Four>(in.weight_there + n);
      pull += of_ends * POTDEM::read_vector<Four>(in.inverse_length2 + n);
      of_volume = 0.5 * POTDEM::truss_strain(q) * of_ends;
    }
  if constexpr (EV) {
    const Four energy = in.energy
        ? potdem_bond_energy<Law>(in.kernel[type], r, q, half_modulus, nullptr) + of_volume
        : Four{};
    if (in.of_atoms)
      for (int m = 0; m < 4; m++) {
        const double apart[3] = {del.x[m], del.y[m], del.z[m]};
        tally(share, i, partner[m], energy[m], pull[m], apart);
      }
    else {
      Four owned;
      for (int m = 0; m < 4; m++) owned[m] = n + m < ghosts ? 1.0 : 0.5;
      const Four to[3] = {del.x, del.y, del.z};
      sums.add(in, owned, energy, pull, to);
    }
  }
  if constexpr (DAMP) {
    const POTDEM::Four3 apart(in.v, partner, in.v[i]);
    const Four damp =
        POTDEM::read_vector<Four>(in.dashpot + n) * inverse_r * inverse_r * apart.dot(del);
    if (ledger)
      for (int m = 0; m < 4; m++)
        note(i, partner[m], damp[m] * del.x[m], damp[m] * del.y[m], damp[m] * del.z[m]);
    pull += damp;
  }
  POTDEM::Four3 force = del;
  force *= pull;
  sum += force;
  for (int m = 0; m < 4 && n + m < ghosts; m++) {
    double *const f = in.f[partner[m]];
    f[0] -= force.x[m];
    f[1] -= force.y[m];
    f[2] -= force.z[m];
  }
  return true;
}
#endif

}    // namespace LAMMPS_NS

#endif
