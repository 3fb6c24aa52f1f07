/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Softening of a truss that a crack opens. From the strain at which the crack began to the one at which its faces are free, its
   stress falls in proportion to the strain, and unloading goes straight to the origin:

     stress/E = (1 - D) eps                 in tension; in compression eps, as without damage
     (1 - D) eps = onset (end - eps)/(end - onset)    while eps is the largest there was, onset <= eps <= end

   eps = (q - 1)/2 with q = (r/re)^2 is the strain of the truss (truss.h). What is lost depends on D alone, so that nothing has to be
   summed up over steps. Energies over E A re. */

#ifndef POTDEM_SOFTENING_H
#define POTDEM_SOFTENING_H

#include <algorithm>
#include <cmath>

namespace POTDEM {

struct Softening {
  double onset = 0.0, end = 0.0;    // strains, 0 < onset < end; end = 0: no crack has reached it
  double damage = 0.0;              // 0 to 1

  bool begun() const { return end > 0.0; }
  bool spent() const { return damage >= 1.0; }

  // its damage after this strain
  double after(double strain) const
  {
    if (strain >= end) return 1.0;
    if (strain <= onset) return damage;
    return std::max(damage, 1.0 - onset * (end - strain) / ((end - onset) * strain));
  }

  // strain at which the damage was reached
  double largest_strain() const { return onset * end / (onset + (1.0 - damage) * (end - onset)); }

  // fracture energy up to now
  double lost() const
  {
    const double from = stretch(onset), to = stretch(largest_strain());
    const double falling = onset / (end - onset) *
        (end * (to - from) - 0.5 * (to * to - from * from) -
         (to * to * to - from * from * from) / 6.0);
    return elastic(from) + falling - (1.0 - damage) * elastic(to);
  }

 private:
  // r/re - 1, and the integral of the strain from 0 to it
  static double stretch(double strain) { return 2.0 * strain / (1.0 + sqrt(1.0 + 2.0 * strain)); }
  static double elastic(double y) { return y * y * (y + 3.0) / 6.0; }
};

}    // namespace POTDEM

#endif
