/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/bond/potdem_bond_strengths.h"

#include <algorithm>

using namespace LAMMPS_NS;

void BondStrengths::begin(const std::vector<double> &moduli)
{
  E = moduli;
  strengths.assign(E.size(), POTDEM::Strength());
  scatter.assign(E.size(), POTDEM::StrengthScatter());
  worst = NONE;
  softens = false;
}

void BondStrengths::set(int type, double ft, double fc, const POTDEM::StrengthScatter &spread,
                        bool may_soften)
{
  if (E[type] == 0.0) return;
  strengths[type] = POTDEM::Strength::of_stresses(ft, fc, E[type]);
  scatter[type] = spread;
  softens = softens || may_soften;
  worst = std::max(worst, spread.active() ? BY_BOND : BY_TYPE);
}
