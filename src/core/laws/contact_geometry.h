/* Two particles as a contact law sees them. Lengths. */

#ifndef POTDEM_CONTACT_GEOMETRY_H
#define POTDEM_CONTACT_GEOMETRY_H

namespace POTDEM {

struct ContactGeometry {
  double ri, rj;    // radii
  double
      contact;    // distance of first contact: dbar, or less for a pair whose bond failed within reach

  double dbar() const { return ri + rj; }                            // mean diameter
  double effective_radius() const { return ri * rj / (ri + rj); }    // d*/2 of eq. 5.15
};

// stiffness of two different springs, or modulus of two half trusses, in series (eq. 3.8)
inline double series_modulus(double Ei, double Ej)
{
  return 2.0 * Ei * Ej / (Ei + Ej);
}

}    // namespace POTDEM

#endif
