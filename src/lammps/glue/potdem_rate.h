/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Any of the rate laws (core/laws/law_list.h), or none. */

#ifndef LMP_POTDEM_RATE_H
#define LMP_POTDEM_RATE_H

#include "core/laws/law_list.h"
#include "core/laws/none.h"
#include "lammps/glue/potdem_any_law.h"

#include <string>
#include <variant>
#include <vector>

namespace LAMMPS_NS {

#define POTDEM_ALTERNATIVE(Law) , POTDEM::Law
#define POTDEM_VECTOR(Law) , std::vector<POTDEM::Law>
using PotdemRate = std::variant<POTDEM::Elastic RATE_LAWS(POTDEM_ALTERNATIVE)>;
// those of all pairs of types, where one law serves all; nothing: none
using PotdemRates = std::variant<std::monostate RATE_LAWS(POTDEM_VECTOR)>;
#undef POTDEM_ALTERNATIVE
#undef POTDEM_VECTOR

std::string potdem_rate_text(PotdemRate);    // as the command takes it; nothing if none was given
double *potdem_rate_coefficient(PotdemRate &, const std::string &name);    // null: no such one
bool potdem_rate_is_active(const PotdemRate &);
// of two materials. One without goes with any law; different laws cannot be mixed: false
bool potdem_mix_rates(const PotdemRate &, const PotdemRate &, PotdemRate &mixed);
bool potdem_same_rate(const std::vector<PotdemRate> &, PotdemRates &);    // false: they differ

template <class Law, class Action> void potdem_for_each_rate_law(Action &&act)
{
#define POTDEM_ACT(RateLaw) \
  if constexpr (POTDEM::RateLaw::serves<Law>()) act(POTDEM::RateLaw());
  RATE_LAWS(POTDEM_ACT)
#undef POTDEM_ACT
}

// of the normal law Law before anything is given: the rate law that has settings of pair_style, if there is one
template <class Law> PotdemRate potdem_default_rate()
{
  PotdemRate found;
  potdem_for_each_rate_law<Law>([&found](auto rate) {
    if (!potdem_setting_names(potdem_rows(rate)).empty()) found = rate;
  });
  return found;
}

template <class Law> std::string potdem_rate_names()
{
  std::string names;
  potdem_for_each_rate_law<Law>([&names](auto rate) {
    names += (names.empty() ? "" : ", ") + potdem_option_names(potdem_rows(rate));
  });
  return names;
}

// options of a normal law, of_law, and of the rate laws that serve it, each with a comma after it
template <class Law> std::string potdem_law_names(const PotdemLawRows &of_law)
{
  std::string names;
  for (const auto &more : {potdem_option_names(of_law), potdem_rate_names<Law>()})
    if (!more.empty()) names += more + ", ";
  return names;
}

// the next option, if it is one of a rate law. rate: what has been given so far
template <class Law>
bool potdem_read_rate(PotdemMaterialInput &input, const PotdemRate &of_style, PotdemRate &rate)
{
  bool found = false;
  potdem_for_each_rate_law<Law>([&](auto fresh) {
    if (found) return;
    if (const auto *const set = std::get_if<decltype(fresh)>(&of_style)) fresh = *set;
    if (!potdem_read_option(input, potdem_rows(fresh))) return;
    found = true;
    if (rate.index() != PotdemRate(fresh).index() && !potdem_rate_text(rate).empty())
      input.fail("give one of " + potdem_rate_names<Law>());
    potdem_complete(fresh);
    rate = fresh;
  });
  return found;
}

}    // namespace LAMMPS_NS

#endif
