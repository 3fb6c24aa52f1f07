/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/bond/bond_potdem_omp.h"

#define POTDEM_INSTANTIATE(name, Law) template class LAMMPS_NS::BondPotdemOMP<POTDEM::Law>;
BOND_LAWS(POTDEM_INSTANTIATE)
