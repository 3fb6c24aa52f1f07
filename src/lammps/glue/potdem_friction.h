/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Any of the tangential laws (core/laws/law_list.h), as the keyword 'friction' gives it: mu, the keyword of the law and its
   other coefficients. */

#ifndef LMP_POTDEM_FRICTION_H
#define LMP_POTDEM_FRICTION_H

#include "core/laws/law_list.h"
#include "lammps/glue/potdem_law_io.h"

#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace LAMMPS_NS {

namespace PotdemTangential {
  struct None {};
#define POTDEM_ALTERNATIVE(Law) , POTDEM::Law
  template <class Nothing, class... Laws> struct List {
    using Any = std::variant<Laws...>;
    using Vectors = std::variant<std::monostate, std::vector<Laws>...>;
  };
  using Laws = List<None TANGENTIAL_LAWS(POTDEM_ALTERNATIVE)>;
#undef POTDEM_ALTERNATIVE
}    // namespace PotdemTangential

using PotdemFriction = PotdemTangential::Laws::Any;
// those of all pairs of types, where one law serves all; nothing: no friction
using PotdemFrictions = PotdemTangential::Laws::Vectors;

PotdemFriction potdem_read_friction(PotdemMaterialInput &);    // what follows 'friction'
std::string potdem_friction_text(
    const PotdemFriction &);    // with 'friction' and a blank before it, or nothing
double potdem_friction_mu(const PotdemFriction &);
double *potdem_friction_coefficient(PotdemFriction &,
                                    const std::string &name);    // null: no such one
bool potdem_friction_is_auto(const PotdemFriction &);
int potdem_friction_state(const PotdemFriction &);    // numbers that it keeps per contact

bool potdem_friction_needs_shear_ratio(const PotdemFriction &);
double potdem_friction_energy(const PotdemFriction &, const double *state);

// error if it needs what this normal law does not know
template <class Law> void potdem_check_friction(PotdemInput &input, const PotdemFriction &friction)
{
  using Kernel = typename Law::Kernel;
  constexpr bool knows =
      std::is_same_v<decltype(POTDEM::knows_shear_ratio<Kernel>(0)), std::true_type>;
  if (!knows && potdem_friction_needs_shear_ratio(friction))
    input.fail("friction mindlin is for Hertz, whose materials have a Poisson's ratio; use "
               "friction mu spring ratio");
}

// of two materials. A law without friction goes with any other; different laws cannot be mixed: false
bool potdem_mix_friction(const PotdemFriction &, const PotdemFriction &, PotdemFriction &mixed);

// false: they are of different laws
bool potdem_same_law(const std::vector<PotdemFriction> &, PotdemFrictions &);

}    // namespace LAMMPS_NS

#endif
