/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* A fix that acts on each particle for itself, on several threads: it asks threads() how many there are. */

#ifndef LMP_FIX_POTDEM_OMP_H
#define LMP_FIX_POTDEM_OMP_H

#include "comm.h"

namespace LAMMPS_NS {

template <class Style> class FixPotdemOMP : public Style {
 public:
  using Style::Style;

 protected:
  int threads() const override { return this->comm->nthreads; }
};

}    // namespace LAMMPS_NS

#endif
