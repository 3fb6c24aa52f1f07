/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/pair/pair_potdem_lj.h"

#include "lammps/glue/potdem_law_input.h"
#include "lammps/pair/potdem_pair_loop.h"

using namespace LAMMPS_NS;

// springs in series, mean distances; exponents must agree
void PairPotdemLJ::mix(int i, int j)
{
  const auto &a = laws[at(i, i)], &b = laws[at(j, j)];
  if (a.n != b.n) cannot_mix(i, j, "n");
  // both must be bounded
  const double least = a.least > 0.0 && b.least > 0.0 ? 0.5 * (a.least + b.least) : 0.0;
  laws[at(i, j)] = {POTDEM::series_modulus(a.K0, b.K0), 0.5 * (a.R + b.R),     a.n,
                    0.5 * (a.alpha + b.alpha),          0.5 * (a.cut + b.cut), least};
}
