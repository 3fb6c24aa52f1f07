/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* `area lattice`: the lattice is read off the bonds of the particle that has most of them, of those with bonds that have no
   section yet. A few bonds that join bodies make no lattice: they get the section of their type. */

#ifndef LMP_POTDEM_LATTICE_AREA_H
#define LMP_POTDEM_LATTICE_AREA_H

#include "pointers.h"

#include <string>

namespace LAMMPS_NS {

class PotdemLatticeArea : protected Pointers {
 public:
  PotdemLatticeArea(LAMMPS *, class FixPotdemBondHistory *, const std::string &style);
  void solve(int type);

 private:
  struct Found {
    double section;    // 0: not a lattice that we know
    double nearest, bonds;
  };

  class FixPotdemBondHistory *history;
  std::string style;

  bool lacks_section(int type, int i, int slot) const;
  int fullest(int type, int &count) const;
  Found read(int type, int i) const;
  bool centred(int type, int i, double spacing) const;
  double section_of_type(int type) const;
  bigint give_section(int type, double);
  void report(int type, const Found &, double section, bigint count) const;
};

}    // namespace LAMMPS_NS

#endif
