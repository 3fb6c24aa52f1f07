/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/pair/pair_potdem_truss.h"

#include "lammps/glue/potdem_law_input.h"
#include "lammps/pair/potdem_pair_loop.h"

using namespace LAMMPS_NS;

// two half trusses in series; the factors of the two halves must agree to have one
void PairPotdemTruss::mix(int i, int j)
{
  const auto &a = laws[at(i, i)], &b = laws[at(j, j)];
  if (a.m != b.m || a.normalized != b.normalized) cannot_mix(i, j, "penetration");
  laws[at(i, j)] = {POTDEM::series_modulus(a.E, b.E), 0.5 * (a.a + b.a), a.m, a.normalized};
}
