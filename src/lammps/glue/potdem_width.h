/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* For which registers loops are to run: the widest that the machine has, or narrower ones that the environment variable POTDEM_WIDTH
   names (plain, avx2, avx512), with which the results can be compared. */

#ifndef LMP_POTDEM_WIDTH_H
#define LMP_POTDEM_WIDTH_H

#include "core/laws/width.h"

namespace LAMMPS_NS {

POTDEM::Width potdem_width(class LAMMPS *);

}    // namespace LAMMPS_NS

#endif
