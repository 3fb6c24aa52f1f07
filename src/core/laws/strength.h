/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Failure of bonds (thesis 5.2.4): a bond fails when its axial stress reaches its tensile or its compressive strength.
   Strengths are kept as the loads that laws of bonds compute, stresses over E/2, tension positive. */

#ifndef POTDEM_STRENGTH_H
#define POTDEM_STRENGTH_H

#include "device.h"

namespace POTDEM {

struct Strength {
  static constexpr double UNBREAKABLE = 1e300;

  double tension = UNBREAKABLE, compression = -UNBREAKABLE;

  // of stresses; none if not > 0
  static Strength of_stresses(double ft, double fc, double E)
  {
    Strength strength;
    if (ft > 0.0) strength.tension = 2.0 * ft / E;
    if (fc > 0.0) strength.compression = -2.0 * fc / E;
    return strength;
  }

  // of one bond, or each of four; scale: the strength of this bond over the mean (strength_scatter.h)
  template <class Number, class Scale>
  POTDEM_FUNCTION auto reached_by(const Number &load, const Scale &scale) const
  {
    return (load >= scale * tension) | (load <= scale * compression);
  }
};

}    // namespace POTDEM

#endif
