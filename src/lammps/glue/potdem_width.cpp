/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/glue/potdem_width.h"

#include "error.h"

#include <algorithm>
#include <cstdlib>
#include <string>

using namespace LAMMPS_NS;

POTDEM::Width LAMMPS_NS::potdem_width(LAMMPS *lmp)
{
  static const std::string names[] = {"plain", "avx2", "avx512"};    // in the order of Width
  const char *const wanted = std::getenv("POTDEM_WIDTH");
  if (!wanted) return POTDEM::widest();
  const auto *const found = std::find(std::begin(names), std::end(names), wanted);
  if (found == std::end(names))
    lmp->error->all(FLERR, "The environment variable POTDEM_WIDTH is '{}', and may be {}, {} or {}",
                    wanted, names[0], names[1], names[2]);
  return std::min(POTDEM::widest(), static_cast<POTDEM::Width>(found - names));
}
