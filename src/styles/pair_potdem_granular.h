/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#ifndef LMP_PAIR_POTDEM_GRANULAR_H
#define LMP_PAIR_POTDEM_GRANULAR_H

#include "laws/regularised_granular.h"
#include "pair_potdem.h"

namespace LAMMPS_NS {

class PairPotdemGranular : public PairPotdem<POTDEM::RegularisedGranular> {
 public:
  using PairPotdem::PairPotdem;
  void coeff(int, char **) override;

 protected:
  const char *name() const override { return "potdem/granular"; }
  void mix(int i, int j) override;
  std::string coeff_text(int pair) const override;
};

}    // namespace LAMMPS_NS

#endif
