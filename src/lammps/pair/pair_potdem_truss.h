/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#ifndef LMP_PAIR_POTDEM_TRUSS_H
#define LMP_PAIR_POTDEM_TRUSS_H

#include "core/laws/truss_contact.h"
#include "lammps/pair/pair_potdem.h"

namespace LAMMPS_NS {

class PairPotdemTruss : public PairPotdem<POTDEM::TrussContact> {
 public:
  using PairPotdem::PairPotdem;

 protected:
  const char *name() const override { return "potdem/truss"; }
  void mix(int i, int j) override;
};

}    // namespace LAMMPS_NS

#endif
