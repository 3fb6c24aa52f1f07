/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Every difference between LAMMPS versions that concerns this package is settled here. */

#ifndef LMP_POTDEM_LAMMPS_COMPAT_H
#define LMP_POTDEM_LAMMPS_COMPAT_H

#include "domain.h"
#include "error.h"    // IWYU pragma: keep
#include "lammps.h"
#include "pair.h"

#include <cstring>
#include <utility>

namespace LAMMPS_NS {
namespace PotdemCompat {

  // minimum_image takes the call's place in the source first since 2025
  template <class D>
  auto minimum_image(D *domain, double *del, int) -> decltype(domain->minimum_image(FLERR, del))
  {
    return domain->minimum_image(FLERR, del);
  }

  template <class D>
  auto minimum_image(D *domain, double *del, long) -> decltype(domain->minimum_image(del))
  {
    return domain->minimum_image(del);
  }

  inline void minimum_image(Domain *domain, double *del)
  {
    minimum_image(domain, del, 0);
  }

  // LAMMPS of 2025 asks a pair style for cutoffs by size if it says that it has them; that of 2026 does not
  // know them. Declared here, they can be overridden under both.
  class PairWithCutoffsBySize : public Pair {
   public:
    using Pair::Pair;
    virtual double atom2cut(int) = 0;
    virtual double radii2cut(double, double) = 0;
  };

  template <class P> auto has_cutoffs_by_size(P *pair, int) -> decltype(pair->finitecutflag, void())
  {
    pair->finitecutflag = 1;
  }

  template <class P> void has_cutoffs_by_size(P *, long) {}

  // For a style that is being made, and the style that it will be part of, if any: may single() have columns of its
  // own? Up to 2025 'hybrid' reads them without end; hybrid/overlay does not.
  inline bool columns_in_single(const LAMMPS *lmp, const char *whole)
  {
    return !whole || strcmp(whole, "hybrid") != 0 || lmp->num_ver >= 20260101;
  }

}    // namespace PotdemCompat
}    // namespace LAMMPS_NS

#endif
