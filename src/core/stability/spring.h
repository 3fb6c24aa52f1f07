/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* What a bond or a contact is to small motions, for the critical step:
   H = max(0, along) n n + max(0, across) (1 - n n); what is negative helps. */

#ifndef POTDEM_SPRING_H
#define POTDEM_SPRING_H

namespace POTDEM {

struct Spring {
  double n[3];
  double along, across;          // force over length: Phi'' and Phi'/r
  double viscosity, friction;    // force over velocity, along and across n
};

}    // namespace POTDEM

#endif
