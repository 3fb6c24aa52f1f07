/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* What the bonds of each type bear, as a bond style asks the failure criteria for it. */

#ifndef LMP_POTDEM_BOND_STRENGTHS_H
#define LMP_POTDEM_BOND_STRENGTHS_H

#include "core/laws/strength.h"
#include "core/laws/strength_scatter.h"

#include "lmptype.h"

#include <vector>

namespace LAMMPS_NS {

class BondStrengths {
 public:
  // what the loop over bonds must look at
  enum Kind { NONE, BY_TYPE, BY_BOND };

  // Where a principal stress decides, bonds are looked at from this fraction of the strength on: in equal tension from all sides all
  // have (1 - 2 nu) = 1/2 of the stress; a tenth less for the directions that there are
  static constexpr double LOADED = 0.45;

  // for these moduli, one a bond type; 0: not a type of this style. All bonds are unbreakable
  void begin(const std::vector<double> &moduli);
  // stresses, not > 0: none. What reaches them may soften before it fails
  void set(int type, double ft, double fc, const POTDEM::StrengthScatter &, bool may_soften);

  Kind kind() const { return worst; }
  bool any_softens() const { return softens; }
  const POTDEM::Strength *of_types() const { return strengths.data(); }
  // strength of one bond over that of its type
  double of_bond(int type, tagint a, tagint b) const { return scatter[type].factor(a, b); }

 private:
  std::vector<double> E;
  std::vector<POTDEM::Strength> strengths;
  std::vector<POTDEM::StrengthScatter> scatter;
  Kind worst = NONE;
  bool softens = false;
};

}    // namespace LAMMPS_NS

#endif
