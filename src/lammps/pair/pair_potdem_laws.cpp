/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The pair styles, one for each row of CONTACT_LAWS. */

#include "lammps/pair/pair_potdem_coeff.h"
#include "lammps/pair/pair_potdem_contact.h"
#include "lammps/pair/pair_potdem_loop.h"

namespace LAMMPS_NS {

#define POTDEM_STYLE_OF_LAW(name, Law) template class PairPotdem<POTDEM::Law>;
CONTACT_LAWS(POTDEM_STYLE_OF_LAW)

}    // namespace LAMMPS_NS
