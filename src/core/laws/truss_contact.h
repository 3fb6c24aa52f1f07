/* Unilateral truss contact (thesis eq. 5.20 with r_infl <= d, see 5.2.3): two particles that are not
   bonded repel like a truss of reference length dref as soon as r < dref, and never attract.

   dref is the mean diameter, except for a pair whose bond failed while it was shorter than that: then
   it is the distance at which the bond failed, so that contact starts from zero force and zero energy
   and the failure of a bond cannot create energy.
   Coefficients: E stress, a dimensionless (area = a * pi/4 * dbar^2), m exponent of the
   non-penetration factor (0: none). Domain 0 < r. */

#ifndef POTDEM_TRUSS_CONTACT_H
#define POTDEM_TRUSS_CONTACT_H

#include "core/laws/contact_geometry.h"
#include "truss.h"

namespace POTDEM {

struct TrussContact {
  static constexpr bool contact_only = true, rate_dependent = false;

  double E, a;
  int m;
  int normalized;

  struct Kernel {
    double stress;    // E a
    bool has_penetration;
    Penetration factor;

    static constexpr double hard_core(const ContactGeometry &) { return 0.0; }

    Evaluation evaluate(double r, const ContactGeometry &pair) const
    {
      if (r >= pair.contact) return {0.0, 0.0, 0.0};
      const double modulus = stress * truss_section(pair.dbar());
      return has_penetration ? truss(r, pair.contact, modulus, factor)
                             : truss(r, pair.contact, modulus);
    }
  };

  Kernel kernel(bool /*shift*/) const
  {
    return {E * a, m > 0, m > 0 ? Penetration(m, normalized) : Penetration()};
  }

  // distance below which two particles of mean diameter dbar can interact
  static double reach(double dbar) { return dbar; }
};

}    // namespace POTDEM

#endif
