/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#ifndef LMP_PAIR_POTDEM_LJ_H
#define LMP_PAIR_POTDEM_LJ_H

#include "core/laws/shifted_lj.h"
#include "lammps/pair/pair_potdem.h"

namespace LAMMPS_NS {

class PairPotdemLJ : public PairPotdem<POTDEM::ShiftedLJ> {
 public:
  using PairPotdem::PairPotdem;

 protected:
  const char *name() const override { return "potdem/lj"; }
  void mix(int i, int j) override;
};

}    // namespace LAMMPS_NS

#endif
