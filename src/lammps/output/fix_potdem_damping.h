/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#ifndef LMP_FIX_POTDEM_DAMPING_H
#define LMP_FIX_POTDEM_DAMPING_H

#include "lammps/glue/interfaces.h"

#include "fix.h"

namespace LAMMPS_NS {

class FixPotdemDamping : public Fix, public ForceAmplifier {
 public:
  FixPotdemDamping(class LAMMPS *, int, char **);
  int setmask() override;
  double amplification() const override { return 1.0 + lambda; }
  bool amplifies(int i) const override;
  void init() override;
  void setup(int) override;
  void post_force(int) override;

 private:
  double lambda;
  bool by_component;
  class FixPotdemLedger *ledger;    // null: no compute potdem/energy
};

}    // namespace LAMMPS_NS

#endif
