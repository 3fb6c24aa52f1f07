/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#ifndef LMP_FIX_POTDEM_DAMPING_H
#define LMP_FIX_POTDEM_DAMPING_H

#include "core/laws/cundall.h"
#include "lammps/glue/interfaces.h"

#include "fix.h"

#include <vector>

namespace LAMMPS_NS {

class FixPotdemDamping : public Fix, public ForceAmplifier {
 public:
  FixPotdemDamping(class LAMMPS *, int, char **);
  ~FixPotdemDamping() override;
  int setmask() override;
  double amplification() const override { return damping.amplification(); }
  bool amplifies(int i) const override;
  void init() override;
  void setup(int) override;
  void post_force(int) override;

 protected:
  virtual int threads() const { return 1; }

 private:
  POTDEM::Cundall damping;
  bool damps_weight;
  struct Weight {
    int groupbit;
    const double *acceleration;    // of a fix gravity, which it keeps up to date
  };
  std::vector<Weight> weights;      // that are not damped
  class FixPotdemLedger *ledger;    // null: no compute potdem/energy

  void find_weights();
  void without_weight(int i, double *force) const;
};

}    // namespace LAMMPS_NS

#endif
