/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Two particles, or a particle and a wall, as a contact law sees them. Lengths.

   A flat wall is a particle without extent on the surface (thesis 5.3: "the particle-boundary phenomenon can be described by
   the same potentials"): the mean diameter is the sphere's radius ri and contact begins at the distance ri of its centre
   from the surface. Lengths of a law (R, the cut) are measured as between particles; alpha and x are fractions of ri. */

#ifndef POTDEM_CONTACT_GEOMETRY_H
#define POTDEM_CONTACT_GEOMETRY_H

#include "device.h"

namespace POTDEM {

struct ContactGeometry {
  static constexpr bool flat = false;

  double ri, rj;    // radii
  double
      contact;    // distance of first contact: dbar, or less for a pair whose bond failed within reach

  POTDEM_FUNCTION double dbar() const { return ri + rj; }    // mean diameter
  POTDEM_FUNCTION double effective_radius() const
  {
    return ri * rj * (1.0 / (ri + rj));
  }    // d*/2 of eq. 5.15
};

struct WallGeometry {
  static constexpr bool flat = true;    // to slide along it changes no distance

  double ri;         // radius
  double contact;    // distance of first contact, of the centre from the surface

  POTDEM_FUNCTION double dbar() const { return ri; }
  POTDEM_FUNCTION double effective_radius() const { return ri; }
  // Hertz's force goes on where the centre has passed the surface, until the whole sphere has
  POTDEM_FUNCTION constexpr double deepest() const { return -ri; }
};

// stiffness of two different springs, or modulus of two half trusses, in series (eq. 3.8)
POTDEM_FUNCTION inline double series_modulus(double Ei, double Ej)
{
  return 2.0 * Ei * Ej / (Ei + Ej);
}

}    // namespace POTDEM

#endif
