/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The only table of laws: a law is its file and its row here (docs/developer.md). */

#ifndef POTDEM_LAW_LIST_H
#define POTDEM_LAW_LIST_H

#include "dmt.h"
#include "hertz.h"
#include "mindlin.h"
#include "regularised_granular.h"
#include "restitution.h"
#include "shifted_lj.h"
#include "sliding.h"
#include "tangential_spring.h"
#include "truss.h"
#include "truss_contact.h"
#include "viscous.h"

// clang-format off

// X(name, Law): pair_style potdem/NAME, and 'law NAME' of fix potdem/wall/region
#define CONTACT_LAWS(X) \
  X(dmt, Dmt) \
  X(granular, RegularisedGranular) \
  X(hertz, Hertz) \
  X(lj, ShiftedLJ) \
  X(truss, TrussContact)

// X(name, Law): bond_style potdem/NAME
#define BOND_LAWS(X) \
  X(truss, Truss)

// X(Law): a keyword of both, for the normal laws that it serves
#define RATE_LAWS(X) \
  X(Viscous) \
  X(Restitution)

// X(Law): 'friction mu KEYWORD ...' of both; the first has no keyword
#define TANGENTIAL_LAWS(X) \
  X(Sliding) \
  X(Mindlin) \
  X(TangentialSpring)

// clang-format on

namespace POTDEM {

template <class Law> constexpr const char *law_name();

#define POTDEM_NAME_OF_LAW(name, Law)               \
  template <> constexpr const char *law_name<Law>() \
  {                                                 \
    return #name;                                   \
  }
CONTACT_LAWS(POTDEM_NAME_OF_LAW)
BOND_LAWS(POTDEM_NAME_OF_LAW)
#undef POTDEM_NAME_OF_LAW

// numbers that a bond keeps: those of the law with most
constexpr int most_bond_state()
{
  int most = 0;
#define POTDEM_STATE_OF_LAW(name, Law) most = Law::STATE > most ? Law::STATE : most;
  BOND_LAWS(POTDEM_STATE_OF_LAW)
#undef POTDEM_STATE_OF_LAW
  return most;
}

}    // namespace POTDEM

#endif
