/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The volume that each particle stands for: that of its own cell, which ends at a surface at the planes of the faces
   nearby, lambda times the radius outside the faces' particles. lambda is such that the volumes given add up; without any,
   such that all together have c d^3, c the mean of the closed cells. Where no lambda does that, V is as given, or c d^3.

   So the second moment of the volumes, and with it bending, is that of the body, for random packings too. */

#ifndef POTDEM_AREAS_VOLUMES_H
#define POTDEM_AREAS_VOLUMES_H

#include "surfaces.h"

namespace POTDEM {

// puts body.volume right; collective. False: no particle has neighbours on all sides
bool find_volumes(BondedBody &, const Cells &, const Surfaces &);

// volume of a cell at a surface: c0 + c1 lambda + c2 lambda^2, > 0 for lambda from 0.5 to 1.2
Vector3 volume_at_surface(const BondedBody &, const Cells &, const Surfaces &, int i,
                          const std::vector<Vector3> &rays);

}    // namespace POTDEM

#endif
