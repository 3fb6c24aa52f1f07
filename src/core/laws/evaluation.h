/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Signs, for every law in this folder.

   A law gives the energy Phi(r) of two particles (or of a particle and a wall) as a function of
   one distance, the force that goes with it and the tangent stiffness:

     force     = -dPhi/dr      positive repels (LAMMPS's sign; the thesis counts repulsion negative)
     stiffness =  d2Phi/dr2    positive is stable

   A law is a plain struct of numbers in one consistent system of units; no constant in it has a
   dimension. Nothing here includes LAMMPS. */

#ifndef POTDEM_EVALUATION_H
#define POTDEM_EVALUATION_H

namespace POTDEM {

struct Evaluation {
  double energy;
  double force;
  double stiffness;
};

}    // namespace POTDEM

#endif
