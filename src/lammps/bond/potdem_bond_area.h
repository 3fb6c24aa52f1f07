/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The section of the bonds of a type, `area factor a | area lattice | area body [density rho]`: read, written, found for
   new bonds, and looked up for one of them. */

#ifndef LMP_POTDEM_BOND_AREA_H
#define LMP_POTDEM_BOND_AREA_H

#include <string>

namespace LAMMPS_NS {

class FixPotdemBondHistory;

class PotdemBondArea {
 public:
  static PotdemBondArea read(class PotdemMaterialInput &, int dimension);
  std::string text() const;                      // as bond_coeff takes it
  void prepare(FixPotdemBondHistory *) const;    // what it will need of it, before Comm::init

  // style: for messages and errors, e.g. "bond_style potdem/truss"
  void find(class LAMMPS *, FixPotdemBondHistory *, const std::string &style, int type) const;
  // of a bond of owned atom i between particles of mean diameter dbar
  double section(const FixPotdemBondHistory &, int i, int slot, double dbar) const;

 private:
  enum { FACTOR, LATTICE, BODY } mode = FACTOR;
  double value = 0.0;    // FACTOR: a; BODY: density or 0
};

}    // namespace LAMMPS_NS

#endif
