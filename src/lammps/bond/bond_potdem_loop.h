/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The loop over bonds: one atom at a time, its force kept in registers, four of its bonds at once where the law can. Four bonds of
   which something is to be said (they fail, or collapse) are done again one by one. */

#ifndef LMP_BOND_POTDEM_LOOP_H
#define LMP_BOND_POTDEM_LOOP_H

#include "core/laws/four.h"
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

template <class Law> double BondPotdem<Law>::energy_at(int n, double q, const double *state) const
{
  const double re = bonds.length(n);
  return kernels[bonds.type[n]].evaluate(sqrt(q) * re, re, bonds.modulus(n), state).energy;
}

template <class Law>
BondPotdem<Law>::Inputs::Inputs(BondPotdem &style, double **forces) :
    x((const double (*)[3]) style.atom->x[0]), v((const double (*)[3]) style.atom->v[0]),
    partner(style.bonds.partner.data()), type(style.bonds.type.data()),
    inverse_length2(style.bonds.inverse_length2.data()),
    half_modulus(style.bonds.half_modulus.data()), dashpot(style.bonds.dashpot.data()),
    scale(style.bonds.strength.data()), strength(style.strengths.of_types()),
    kernel(style.kernels.data()), f((double (*)[3]) forces[0])
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
  for (int i = share.from; i < share.to; i++) {
    const int end = bonds.first[i + 1], ghosts = bonds.ghosts[i];
    int n = bonds.first[i];
    if (n == end) continue;
    double force[3] = {0.0, 0.0, 0.0};
#ifdef POTDEM_HAS_FOUR
    if constexpr (Law::STATE == 0 && POTDEM::is_wide<Law>(0)) {
      POTDEM::Four3 pulls{};
      for (; n + 4 <= end; n += 4) {
        if (take_four<EV, FAIL, PENETRATION, DAMP>(in, share, i, n, ghosts, pulls)) continue;
        for (int m = n; m < n + 4; m++)
          if (!take<EV, FAIL, PENETRATION, DAMP>(in, share, i, m, ghosts, force)) return;
      }
      force[0] += POTDEM::sum(pulls.x);
      force[1] += POTDEM::sum(pulls.y);
      force[2] += POTDEM::sum(pulls.z);
    }
#endif
    for (; n < end; n++)
      if (!take<EV, FAIL, PENETRATION, DAMP>(in, share, i, n, ghosts, force)) return;
    for (int k = 0; k < 3; k++) in.f[i][k] += force[k];
  }
}

// bond n of atom i; ghosts: its first one to a ghost. false: it has no length
template <class Law>
template <bool EV, int FAIL, bool PENETRATION, bool DAMP>
POTDEM_FUNCTION inline bool BondPotdem<Law>::take(const Inputs &in, ThreadShare &share, int i,
                                                  int n, int ghosts, double *force)
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
  const double inverse_r = 1.0 / sqrt(r2);
  double *const state = Law::STATE > 0 ? bonds.state_of(n) : nullptr;
  const double load = potdem_bond_load<PENETRATION, Law>(in.kernel[type], q, state);
  const double scale = FAIL == BondStrengths::BY_BOND ? in.scale[n] : 1.0;
  if (FAIL && in.strength[type].reached_by(load, scale)) share.over.push_back({i, j, type});
  double pull = in.half_modulus[n] * load * inverse_r;
  if (EV) {
    const double apart[3] = {-del[0], -del[1], -del[2]};
    const double energy = eflag_either ? energy_at(n, q, state) : 0.0;
    tally(share, i, j, energy, -pull, apart);
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
                                                       int i, int n, int ghosts, POTDEM::Four3 &sum)
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

  const Four inverse_r = 1.0 / POTDEM::square_root(r2);
  Four pull = POTDEM::read_vector<Four>(in.half_modulus + n) * load * inverse_r;
  if constexpr (EV)
    for (int m = 0; m < 4; m++) {
      const double apart[3] = {-del.x[m], -del.y[m], -del.z[m]};
      const double energy = eflag_either ? energy_at(n + m, q[m], nullptr) : 0.0;
      tally(share, i, partner[m], energy, -pull[m], apart);
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
