/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Any of the tangential laws (core/laws/law_list.h), as the keyword 'friction' gives it: mu, the keyword of the law and its
   other coefficients; and the resistance to rolling and twisting beside it. */

#ifndef LMP_POTDEM_FRICTION_H
#define LMP_POTDEM_FRICTION_H

#include "core/laws/law_list.h"
#include "core/laws/rolling.h"
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
    using Vectors =
        std::variant<std::monostate, std::vector<Laws>..., std::vector<POTDEM::Rolls<Laws>>...>;
  };
  using Laws = List<None TANGENTIAL_LAWS(POTDEM_ALTERNATIVE)>;
#undef POTDEM_ALTERNATIVE
}    // namespace PotdemTangential

struct PotdemFriction {
  PotdemTangential::Laws::Any law;
  POTDEM::RollingResistance resistance{};
};

// those of all pairs of types, where one law serves all; nothing: no friction
using PotdemFrictions = PotdemTangential::Laws::Vectors;

// act(law), or act(Rolls<law>) where there is a resistance to rolling
template <class Action> auto potdem_visit(const PotdemFriction &friction, Action &&act)
{
  return std::visit(
      [&friction, &act](const auto &law) {
        if (friction.resistance.active())
          return act(POTDEM::Rolls<std::decay_t<decltype(law)>>{law, friction.resistance});
        return act(law);
      },
      friction.law);
}

bool potdem_read_friction(PotdemMaterialInput &,
                          PotdemFriction &);    // the next option, if it is one of these
extern const char
    *const POTDEM_FRICTION_NAMES;    // of these options, but for the last one, twisting
std::string potdem_friction_text(
    const PotdemFriction &);    // as they are given, each after a blank, or nothing
double potdem_friction_mu(const PotdemFriction &);
double *potdem_friction_coefficient(PotdemFriction &,
                                    const std::string &name);    // null: no such one
bool potdem_friction_is_auto(const PotdemFriction &);
bool potdem_friction_acts(const PotdemFriction &);    // by rolling or twisting, too
int potdem_friction_state(const PotdemFriction &);    // numbers that it keeps per contact

bool potdem_friction_needs_shear_ratio(const PotdemFriction &);
double potdem_friction_energy(const PotdemFriction &, const double *state);

// error if it needs what this normal law does not know, or spin that there is not
template <class Law>
void potdem_check_friction(PotdemInput &input, const PotdemFriction &friction, bool rotation)
{
  using Kernel = typename Law::Kernel;
  constexpr bool knows =
      std::is_same_v<decltype(POTDEM::knows_shear_ratio<Kernel>(0)), std::true_type>;
  if (!knows && potdem_friction_needs_shear_ratio(friction))
    input.fail("friction mindlin is for Hertz, whose materials have a Poisson's ratio; use "
               "friction mu spring ratio");
  if (friction.resistance.active() && !rotation)
    input.fail("rolling and twisting are for particles that spin; use rotation yes");
}

// of two materials. A law without friction goes with any other; different laws cannot be mixed: false
bool potdem_mix_friction(const PotdemFriction &, const PotdemFriction &, PotdemFriction &mixed);

// those without friction become ones of the law of the others, so that all keep the same numbers per contact
void potdem_align_friction(std::vector<PotdemFriction> &);

// of aligned ones; false: they are of different laws
bool potdem_same_law(const std::vector<PotdemFriction> &, PotdemFrictions &);

}    // namespace LAMMPS_NS

#endif
