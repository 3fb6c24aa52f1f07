/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The isotropic solid of modulus E and any Poisson's ratio nu, as bonds and an energy of the change of volume make it. Bonds alone have
   nu = 1/4. Bonds and solid have the same shear modulus G, so that the modulus of the bonds alone is

     E' = 5/2 G = E 5/4 / (1 + nu),    and    kappa = lambda - G

   is the modulus of the energy of the volume, 1/2 kappa theta^2 (dilatation.h). Domain: -1 < nu < 1/2. */

#ifndef POTDEM_AREAS_ELASTICITY_H
#define POTDEM_AREAS_ELASTICITY_H

#include "constants.h"
#include "mandel.h"

namespace POTDEM {

struct Elasticity {
  double poisson = areas::POISSON;

  bool has_volume_term() const { return poisson != areas::POISSON; }
  double bonds_modulus() const { return 1.25 / (1.0 + poisson); }    // E'/E
  double volume_modulus() const                                      // kappa/E'
  {
    return (4.0 * poisson - 1.0) / (2.5 * (1.0 - 2.0 * poisson));
  }

  // of the whole, over E', and its inverse
  Matrix6 stiffness() const
  {
    Matrix6 c = isotropic_stiffness(areas::POISSON);
    for (int i = 0; i < 3; i++)
      for (int j = 0; j < 3; j++) c[i][j] += volume_modulus();
    return c;
  }
  Matrix6 compliance() const
  {
    Matrix6 s{};
    add(s, bonds_modulus(), isotropic_compliance(poisson));
    return s;
  }
};

}    // namespace POTDEM

#endif
