/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The section of the bonds of a type, `area factor a | area lattice | [nu x] area body [density rho]`: read, written, found for
   new bonds, and looked up for one of them. */

#ifndef LMP_POTDEM_BOND_AREA_H
#define LMP_POTDEM_BOND_AREA_H

#include "core/areas/elasticity.h"

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

  bool has_volume_term() const { return elasticity.has_volume_term(); }
  // kappa of the energy of the change of volume, of a solid of modulus E
  double volume_modulus(double E) const
  {
    return E * elasticity.bonds_modulus() * elasticity.volume_modulus();
  }
  double poisson() const { return elasticity.poisson; }

 private:
  enum { FACTOR, LATTICE, BODY } mode = FACTOR;
  double value = 0.0;               // FACTOR: a; BODY: density or 0
  POTDEM::Elasticity elasticity;    // another than that of bonds alone: BODY
};

}    // namespace LAMMPS_NS

#endif
