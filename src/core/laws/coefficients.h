/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The table of a law's coefficients: all that reading, printing, restart files, extract and the pages of the styles know of
   them. A law has

     static constexpr auto coefficients()      std::array of Coefficient<Law>, in the order in which they are given
     void complete()                           (optional) what follows from them, defaults that depend on others included
     static Law mixed(const Law &, const Law &)   that of two materials, each of which has this law

   Coefficients are doubles; whole numbers and flags too, as LAMMPS's fix adapt has no others. An option that is not given is
   0, unless the law says otherwise. */

#ifndef POTDEM_COEFFICIENTS_H
#define POTDEM_COEFFICIENTS_H

#include <array>
#include <limits>

namespace POTDEM {

// low to high; an open end is not part of it
struct Range {
  double low, high;
  bool low_open, high_open;
  bool whole;

  constexpr bool has(double value) const
  {
    if (value < low || (low_open && value == low)) return false;
    if (value > high || (high_open && value == high)) return false;
    return !whole || value == static_cast<double>(static_cast<long long>(value));
  }
  constexpr bool bounded() const { return high < std::numeric_limits<double>::infinity(); }
};

constexpr Range above(double bound)
{
  return {bound, std::numeric_limits<double>::infinity(), true, true, false};
}
constexpr Range positive()
{
  return above(0.0);
}
constexpr Range at_least(double bound)
{
  return {bound, std::numeric_limits<double>::infinity(), false, true, false};
}
constexpr Range nonnegative()
{
  return at_least(0.0);
}
constexpr Range between(double low, double high)    // neither of them
{
  return {low, high, true, true, false};
}
constexpr Range fraction()
{
  return {0.0, 1.0, false, true, false};
}
constexpr Range up_to_one()    // not 0
{
  return {0.0, 1.0, true, false, false};
}
constexpr Range poisson_ratio()
{
  return {-1.0, 0.5, true, false, false};
}
constexpr Range whole(int most)    // 1 to most
{
  return {1.0, static_cast<double>(most), false, false, true};
}

// what does not depend on the law
struct CoefficientTraits {
  enum Kind {
    REQUIRED,     // a value
    OPTION,       // a keyword and a value
    CONTINUED,    // a further value of the option before it
    FLAG,         // a word that may follow the option before it
    SETTING       // a keyword of pair_style: yes or no
  };
  enum Source {
    NUMBER,
    MATERIAL,          // or the property of this name in a material file
    MATERIAL_LENGTH    // or E of a material file times a length that follows: a stiffness
  };

  Kind kind;
  const char *name;    // as extract() and fix adapt have it; the keyword
  const char *
      symbol;    // of the value of an option, as the page has it; of a required one, if it is not the name
  Range range;
  const char *unit;
  Source source;
  bool agree;           // two laws that differ in it cannot be mixed
  bool can_be_none;     // the word none gives 0, and no further values
  const char *owner;    // " of the wall"
  const char *after;    // the word that comes before it, or null; what to say if it is missing
  const char *missing;
  const char *word;    // that may stand for the value, or null
};

constexpr auto FROM_MATERIAL = CoefficientTraits::MATERIAL;
constexpr auto FROM_MATERIAL_LENGTH = CoefficientTraits::MATERIAL_LENGTH;

template <class Law> struct Coefficient : public CoefficientTraits {
  double Law::*value;
  double Law::*bound;         // must be less than this one, or null
  double Law::*word_given;    // 1 if the word stands for the value, or null

  constexpr Coefficient(Kind kind, const char *name, const char *symbol, double Law::*value,
                        Range range, const char *unit) :
      CoefficientTraits{kind,  name,  symbol, range,   unit,    NUMBER,
                        false, false, "",     nullptr, nullptr, nullptr},
      value(value), bound(nullptr), word_given(nullptr)
  {
  }

  constexpr Coefficient called(const char *other) const
  {
    auto changed = *this;
    changed.symbol = other;
    return changed;
  }
  constexpr Coefficient from(Source which) const
  {
    auto changed = *this;
    changed.source = which;
    return changed;
  }
  constexpr Coefficient below(double Law::*other) const
  {
    auto changed = *this;
    changed.bound = other;
    return changed;
  }
  constexpr Coefficient must_agree() const
  {
    auto changed = *this;
    changed.agree = true;
    return changed;
  }
  constexpr Coefficient of(const char *whose) const
  {
    auto changed = *this;
    changed.owner = whose;
    return changed;
  }
  constexpr Coefficient following(const char *word, const char *say) const
  {
    auto changed = *this;
    changed.after = word;
    changed.missing = say;
    return changed;
  }
  constexpr Coefficient or_word(const char *which, double Law::*given) const
  {
    auto changed = *this;
    changed.word = which;
    changed.word_given = given;
    return changed;
  }
  constexpr Coefficient or_none() const
  {
    auto changed = *this;
    changed.can_be_none = true;
    return changed;
  }
};

template <class Law>
constexpr Coefficient<Law> required(const char *name, double Law::*value, Range range,
                                    const char *unit)
{
  return {Coefficient<Law>::REQUIRED, name, "", value, range, unit};
}

template <class Law>
constexpr Coefficient<Law> option(const char *name, const char *symbol, double Law::*value,
                                  Range range, const char *unit)
{
  return {Coefficient<Law>::OPTION, name, symbol, value, range, unit};
}

template <class Law>
constexpr Coefficient<Law> continued_by(const char *name, const char *symbol, double Law::*value,
                                        Range range, const char *unit)
{
  return {Coefficient<Law>::CONTINUED, name, symbol, value, range, unit};
}

template <class Law> constexpr Coefficient<Law> flag(const char *name, double Law::*value)
{
  return {Coefficient<Law>::FLAG, name, "", value, between(-1.0, 2.0), "1"};
}

template <class Law> constexpr Coefficient<Law> setting(const char *name, double Law::*value)
{
  return {Coefficient<Law>::SETTING, name, "", value, between(-1.0, 2.0), "1"};
}

}    // namespace POTDEM

#endif
