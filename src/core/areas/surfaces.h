/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Where a body's free surfaces are, as its particles see them. */

#ifndef POTDEM_AREAS_SURFACES_H
#define POTDEM_AREAS_SURFACES_H

#include "cells.h"

namespace POTDEM {

struct Surfaces {
  std::vector<double>
      open;    // of nall particles: share of the directions that meet no neighbour, 0 to 1
  std::vector<Vector3>
      normal;    // of nall particles: outward unit vector of those on a face, else 0
  std::vector<Matrix3>
      blocked;    // of nowned: projector on the directions without traction: one on a face, two at an
                  // edge, three in a corner

  Surfaces(const BondedBody &, const Cells &);    // collective
  template <class Given>
  Surfaces(const Surfaces &others, Given given) :
      open(given(others.open)), normal(given(others.normal)), blocked(given(others.blocked))
  {
  }
  bool inside(const BondedBody &body, int i) const { return open[i] == 0.0 && body.bonded(i); }
};

}    // namespace POTDEM

#endif
