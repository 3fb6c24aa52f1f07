/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* One of several laws, as a std::variant: its coefficients by its table, and many of them that turn out to be of one law. */

#ifndef LMP_POTDEM_ANY_LAW_H
#define LMP_POTDEM_ANY_LAW_H

#include "lammps/glue/potdem_law_io.h"

#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace LAMMPS_NS {

template <class Any> PotdemLawRows potdem_any_rows(Any &law)
{
  return std::visit(
      [](auto &one) {
        return potdem_rows(one);
      },
      law);
}

// of two of the same law
template <class Any> Any potdem_any_mixed(const Any &a, const Any &b)
{
  return std::visit(
      [&b](const auto &one) -> Any {
        using Law = std::decay_t<decltype(one)>;
        return Law::mixed(one, std::get<Law>(b));
      },
      a);
}

// those that matter are of one law: make(law) with the first of them, nothing() if none matters. False: they are of different laws
template <class Item, class Matters, class LawOf, class Nothing, class Make>
bool potdem_one_law(const std::vector<Item> &all, Matters &&matters, LawOf &&law_of,
                    Nothing &&nothing, Make &&make)
{
  const Item *first = nullptr;
  for (const auto &one : all) {
    if (!matters(one)) continue;
    if (!first) first = &one;
    if (law_of(*first).index() != law_of(one).index()) return false;
  }
  if (first)
    std::visit(make, law_of(*first));
  else
    nothing();
  return true;
}

}    // namespace LAMMPS_NS

#endif
