/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Where a body's free surfaces are, as its particles see them. The second moment of the directions that are open tells how many
   directions carry no traction. A step of a rough or curved surface looks like an edge to the particle on it; it is told from one by
   the particles around, whose open directions have nearly the same mean there and two different ones around an edge. */

#ifndef POTDEM_AREAS_SURFACES_H
#define POTDEM_AREAS_SURFACES_H

#include "cells.h"

namespace POTDEM {

struct Surfaces {
  std::vector<double>
      open;    // of nall particles: share of the directions that meet no neighbour, 0 to 1
  std::vector<Vector3>
      outward;    // of nall particles: mean of all directions, those that meet a neighbour as 0
  std::vector<Vector3>
      normal;    // of nall particles: outward unit vector of those on a face, else 0
  std::vector<Matrix3>
      blocked;    // of nowned: projector on the directions without traction: one on a face, two at an
                  // edge, three in a corner

  Surfaces(const BondedBody &, const Cells &);    // collective
  template <class Given>
  Surfaces(const Surfaces &others, Given given) :
      open(given(others.open)), outward(given(others.outward)), normal(given(others.normal)),
      blocked(given(others.blocked))
  {
  }
  bool inside(const BondedBody &body, int i) const { return open[i] == 0.0 && body.bonded(i); }
};

}    // namespace POTDEM

#endif
