/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The areas that all others are measured by: A0 = a dbar^2, dbar the mean diameter of the ends, with one a. In an isotropic
   solid of nu = 1/4 the sum of A L / 2 over the bonds of a particle is 6 V; a is such that this holds in the mean inside. */

#ifndef POTDEM_AREAS_UNIFORM_AREAS_H
#define POTDEM_AREAS_UNIFORM_AREAS_H

#include "surfaces.h"

namespace POTDEM {

struct UniformAreas {
  std::vector<double> area;    // of each bond
  double factor;               // a, 0: nothing is inside
  double volume;               // of all particles, of all ranks

  UniformAreas(const BondedBody &, const Surfaces &);    // collective; wants body.volume
  UniformAreas(const BondedBody &, const UniformAreas &like);
};

}    // namespace POTDEM

#endif
