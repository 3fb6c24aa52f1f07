/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Where the particles of compute potdem/strain/atom were in the reference state: LAMMPS's fix property/atom, which carries the
   places through exchange, sorting and restart, and gives a particle that comes later the place where it is bonded. */

#ifndef LMP_FIX_POTDEM_REFERENCE_H
#define LMP_FIX_POTDEM_REFERENCE_H

#include "fix_property_atom.h"

namespace LAMMPS_NS {

class FixPotdemReference : public FixPropertyAtom {
 public:
  // columns: the place, and whether it is to be taken again when the next run begins
  enum { X, Y, Z, FRESH, COLUMNS };

  FixPotdemReference(LAMMPS *, int, char **);
  int setmask() override;
  void set_arrays(int) override;
  void setup_pre_exchange() override;
  void take_all();
  double **places() const;

 private:
  void take(int i, bool fresh);
};

}    // namespace LAMMPS_NS

#endif
