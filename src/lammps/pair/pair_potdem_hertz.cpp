/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/pair/pair_potdem_hertz.h"

#include "lammps/glue/potdem_law_input.h"
#include "lammps/pair/potdem_pair_loop.h"

using namespace LAMMPS_NS;

bool PairPotdemHertz::read_setting(PotdemInput &input)
{
  if (!input.next_is("attract")) return false;
  attract = input.logical("attract");
  return true;
}

// 5.15b for the elastic part, the mean for the viscous one; kept as two equal materials with that contact modulus
void PairPotdemHertz::mix(int i, int j)
{
  const auto &a = laws[at(i, i)], &b = laws[at(j, j)];
  const double modulus = POTDEM::contact_modulus(a.E, a.nu, b.E, b.nu);
  laws[at(i, j)] = {2.0 * modulus, 0.0, modulus, 0.5 * (a.H + b.H), a.attract || b.attract};
}
