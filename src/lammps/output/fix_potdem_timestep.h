/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#ifndef LMP_FIX_POTDEM_TIMESTEP_H
#define LMP_FIX_POTDEM_TIMESTEP_H

#include "fix.h"

#include <string>

namespace LAMMPS_NS {

class FixPotdemTimestep : public Fix {
 public:
  FixPotdemTimestep(class LAMMPS *, int, char **);
  ~FixPotdemTimestep() override;
  int setmask() override;
  void init() override;
  void setup_pre_force(int) override;
  void end_of_step() override;
  double compute_scalar() override;
  void write_restart(FILE *) override;
  void restart(char *) override;

 private:
  double fraction, longest;
  std::string critical_id;
  bool started;    // the step has been this fix's before

  class Compute *critical() const;
  double target();
  void change_to(double step);
};

}    // namespace LAMMPS_NS

#endif
