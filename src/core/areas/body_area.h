/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* One area per bond of a body of any packing and shape (`area body`), such that the network is an
   isotropic solid of modulus E (Poisson's ratio 1/4, the only one of central forces) up to its free surfaces.

   Bonds A, L, n; m = n (x) n; particle i of volume V_i. In the strain eps the bond pulls with A E m:eps. Two conditions for
   every particle, seen through the strains of the stress states that are admissible at it (K_i):

     energy   sum_j A L m (x) m / 2 = V_i T_i
     balance  sum_j A m (x) n       = 0

   The energy decides the stiffness to first order, the imbalance to second (what the body gains by giving way). Least
   squares over both; T_i, the solid's stiffness, is corrected near surfaces once areas are known, and then what the energy
   still lacks is asked for again. docs/area.md tells what the areas are worth.

   cells -> surfaces -> volumes -> uniform areas -> admissible states -> least squares <-> targets */

#ifndef POTDEM_BODY_AREA_H
#define POTDEM_BODY_AREA_H

#include "bonded_body.h"

namespace POTDEM {

struct BodyAreaReport {
  enum Outcome {
    DONE,
    NO_INSIDE,    // no particle has neighbours on all sides
    MECHANISM     // the bonds leave some strain without resistance
  };
  Outcome outcome;    // the same on all ranks; unless DONE no areas are given and the rest is 0
  int iterations;
  double misfit;         // root mean square over the inner particles, energy and balance; of 1
  double least, most;    // area over A0, of this rank's bonds
  double volume;         // of all particles
  double factor;         // a in A0 = a d^2
};

// gives each bond its area > 0 and each particle its volume; collective
BodyAreaReport find_body_areas(BondedBody &);

}    // namespace POTDEM

#endif
