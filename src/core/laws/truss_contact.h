/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Unilateral truss contact (thesis eq. 5.20 with r_infl <= d, see 5.2.3): two particles that are not
   bonded repel like a truss of reference length dref as soon as r < dref, and never attract.

   dref is the mean diameter, except for a pair whose bond failed while it was shorter than that: then
   it is the distance at which the bond failed, so that contact starts from zero force and zero energy
   and the failure of a bond cannot create energy.
   Coefficients: E stress, a dimensionless (area = a * pi/4 * dbar^2), m exponent of the
   non-penetration factor (0: none). Domain 0 < r. */

#ifndef POTDEM_TRUSS_CONTACT_H
#define POTDEM_TRUSS_CONTACT_H

#include "coefficients.h"
#include "contact_geometry.h"
#include "device.h"
#include "truss.h"

namespace POTDEM {

struct TrussContact {
  static constexpr bool contact_only = true, rate_dependent = false;

  double E, a, m, normalized;

  static constexpr auto coefficients()
  {
    return std::array{
        required("E", &TrussContact::E, positive(), "stress").from(FROM_MATERIAL),
        required("a", &TrussContact::a, positive(), "1"),
        option("penetration", "m", &TrussContact::m, whole(MAX_PENETRATION), "1").must_agree(),
        flag("normalized", &TrussContact::normalized).must_agree()};
  }

  // two half trusses in series; the factors of the two halves must agree to have one
  static TrussContact mixed(const TrussContact &one, const TrussContact &other)
  {
    return {series_modulus(one.E, other.E), 0.5 * (one.a + other.a), one.m, one.normalized};
  }

  struct Kernel {
    double stress;    // E a
    Truss::Kernel truss;

    template <class Geometry> POTDEM_FUNCTION static constexpr double hard_core(const Geometry &)
    {
      return 0.0;
    }

    template <class Geometry>
    POTDEM_FUNCTION Evaluation evaluate(double r, const Geometry &at) const
    {
      if (r >= at.contact) return {0.0, 0.0, 0.0};
      return truss.evaluate(r, at.contact, stress * truss_section(at.dbar()));
    }
  };

  Kernel kernel(bool /*shift*/) const { return {E * a, Truss{E, m, normalized}.kernel()}; }

  // distance below which two particles of mean diameter dbar can interact
  POTDEM_FUNCTION static double reach(double dbar) { return dbar; }
};

}    // namespace POTDEM

#endif
