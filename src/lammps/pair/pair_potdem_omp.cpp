/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/pair/pair_potdem_omp.h"

#define POTDEM_INSTANTIATE(name, Law) template class LAMMPS_NS::PairPotdemOMP<POTDEM::Law>;
CONTACT_LAWS(POTDEM_INSTANTIATE)
