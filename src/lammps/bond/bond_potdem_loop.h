/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The loop over bonds: one atom at a time, its force kept in registers. */

#ifndef LMP_BOND_POTDEM_LOOP_H
#define LMP_BOND_POTDEM_LOOP_H

#include "lammps/bond/bond_potdem.h"
#include "lammps/output/fix_potdem_ledger.h"
#include "lammps/output/fix_potdem_monitor.h"

#include "atom.h"

#include <cmath>

namespace LAMMPS_NS {

// PENETRATION: some bond type has the factor that some laws know
template <bool PENETRATION, class Law>
double potdem_bond_load(const typename Law::Kernel &kernel, double q, double *state)
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
template <bool EV, int FAIL, bool PENETRATION, bool DAMP>
void BondPotdem<Law>::loop(ThreadShare &share)
{
  const auto *const x = (const double(*)[3]) atom->x[0];
  const auto *const v = (const double(*)[3]) atom->v[0];
  auto *const f = (double(*)[3]) share.f[0];
  const int *const partner = bonds.partner.data();
  const int *const type = bonds.type.data();
  const double *const inverse_length2 = bonds.inverse_length2.data();
  const double *const half_modulus = bonds.half_modulus.data();
  const double *const dashpot = bonds.dashpot.data();
  const auto *const kernel = kernels.data();
  const auto *const strength = strengths.of_types();
  constexpr bool by_bond = FAIL == BondStrengths::BY_BOND;
  constexpr double crushed = FixPotdemMonitor::CRUSHED * FixPotdemMonitor::CRUSHED;

  for (int i = share.from; i < share.to; i++) {
    const int begin = bonds.first[i], end = bonds.first[i + 1], ghosts = bonds.ghosts[i];
    if (begin == end) continue;
    const double xi = x[i][0], yi = x[i][1], zi = x[i][2];
    double fx = 0.0, fy = 0.0, fz = 0.0;
    for (int n = begin; n < end; n++) {
      const int j = partner[n];
      const double dx = x[j][0] - xi, dy = x[j][1] - yi, dz = x[j][2] - zi;
      const double r2 = dx * dx + dy * dy + dz * dz;
      const double q = r2 * inverse_length2[n];
      if (!(q > crushed)) {    // true for NaN as well
        if (!(r2 > 0.0)) return share.note_collapsed(i, j);
        share.note_crushed(i, n);
      }

      // tension over distance
      const double inverse_r = 1.0 / sqrt(r2);
      double *const state = Law::STATE > 0 ? bonds.state_of(n) : nullptr;
      const double load = potdem_bond_load<PENETRATION, Law>(kernel[type[n]], q, state);
      if (FAIL && strength[type[n]].reached_by(load, by_bond ? bonds.strength[n] : 1.0))
        share.over.push_back({i, j, type[n]});
      double pull = half_modulus[n] * load * inverse_r;
      if (EV) {
        const double del[3] = {-dx, -dy, -dz};
        const double energy = eflag_either ? energy_at(n, q, state) : 0.0;
        tally(share, i, j, energy, -pull, del);
      }
      if (DAMP) {
        const double damp = dashpot[n] * inverse_r * inverse_r *
            ((v[j][0] - v[i][0]) * dx + (v[j][1] - v[i][1]) * dy + (v[j][2] - v[i][2]) * dz);
        if (ledger) note(i, j, damp * dx, damp * dy, damp * dz);
        pull += damp;
      }
      const double px = pull * dx, py = pull * dy, pz = pull * dz;
      fx += px;
      fy += py;
      fz += pz;
      if (n < ghosts) {
        f[j][0] -= px;
        f[j][1] -= py;
        f[j][2] -= pz;
      }
    }
    f[i][0] += fx;
    f[i][1] += fy;
    f[i][2] += fz;
  }
}

}    // namespace LAMMPS_NS

#endif
