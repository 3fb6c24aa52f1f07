/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#ifndef LMP_PAIR_POTDEM_LJ_H
#define LMP_PAIR_POTDEM_LJ_H

#include "laws/shifted_lj.h"
#include "pair_potdem.h"

namespace LAMMPS_NS {

class PairPotdemLJ : public PairPotdem<POTDEM::ShiftedLJ> {
 public:
  using PairPotdem::PairPotdem;
  void coeff(int, char **) override;

 protected:
  const char *name() const override { return "potdem/lj"; }
  void mix(int i, int j) override;
  std::string coeff_text(int pair) const override;
};

}    // namespace LAMMPS_NS

#endif
