/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* What a rate law sees of two bodies that are pressed together.

   A rate law is a struct of coefficients (coefficients.h) that adds to the normal force what depends on the speed of
   approach, with
     serves<Law>()            is it for this normal law?
     active()                 does it do anything?
     total(approach)          the whole normal force, the elastic part included
     viscosity(approach)      its slope over the speed, for the critical step */

#ifndef POTDEM_APPROACH_H
#define POTDEM_APPROACH_H

namespace POTDEM {

struct Approach {
  double force, energy;    // of the elastic law; force > 0
  double overlap;          // > 0
  double rate;             // of the distance, so that -rate is that of the overlap
  // m1 m2 over m1 + m2, that the normal force accelerates, in units of force over acceleration
  double product, sum;
};

}    // namespace POTDEM

#endif
