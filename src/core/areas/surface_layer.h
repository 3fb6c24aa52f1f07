/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Discrete second derivatives, summed over the body: inside they cancel, along the surface a layer is left.

   For every particle k there are weights w_j on its neighbours with sum w dx = 0 and sum w dx dx = V_k I: then
   sum w_j (g_j - g_k) is V_k times half of the second derivatives of g, on surfaces too. Close neighbours are preferred
   (r^-4). What a particle without depth cannot form it hands to neighbours that are deeper inside. */

#ifndef POTDEM_AREAS_SURFACE_LAYER_H
#define POTDEM_AREAS_SURFACE_LAYER_H

#include "surfaces.h"

namespace POTDEM {

// per owned particle and component of the tensor: all weights that it receives minus those it gives, in units of
// volume / length^2. Collective
std::vector<Vector6> surface_layer(const BondedBody &, const Surfaces &);

}    // namespace POTDEM

#endif
