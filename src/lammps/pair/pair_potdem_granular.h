/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#ifndef LMP_PAIR_POTDEM_GRANULAR_H
#define LMP_PAIR_POTDEM_GRANULAR_H

#include "core/laws/regularised_granular.h"
#include "lammps/pair/pair_potdem.h"

namespace LAMMPS_NS {

class PairPotdemGranular : public PairPotdem<POTDEM::RegularisedGranular> {
 public:
  using PairPotdem::PairPotdem;

 protected:
  const char *name() const override { return "potdem/granular"; }
  void mix(int i, int j) override;
};

}    // namespace LAMMPS_NS

#endif
