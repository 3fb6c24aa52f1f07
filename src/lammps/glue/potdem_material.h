/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* potdem_material FILE.potdem MATERIAL  PROPERTY VARIABLE ...
   Properties of a material as equal-style variables, for what LAMMPS's own commands need: masses, steps. */

#ifndef LMP_POTDEM_MATERIAL_H
#define LMP_POTDEM_MATERIAL_H

#include "command.h"

namespace LAMMPS_NS {

class PotdemMaterial : public Command {
 public:
  using Command::Command;
  void command(int, char **) override;
};

}    // namespace LAMMPS_NS

#endif
