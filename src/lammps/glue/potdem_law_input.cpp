/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/glue/potdem_law_input.h"

#include <initializer_list>

namespace LAMMPS_NS {

namespace {
  struct Named {
    const char *name;
    double *value;
  };

  double *find(std::initializer_list<Named> coefficients, const std::string &name)
  {
    for (const auto &one : coefficients)
      if (name == one.name) return one.value;
    return nullptr;
  }

  std::string linear_text(double least)
  {
    return least > 0.0 ? fmt::format(" linear {:.17g}", least) : "";
  }
}    // namespace

/* ---------------------------------------------------------------------- */

void read_law(PotdemInput &input, POTDEM::TrussContact &law)
{
  law.E = input.property("E");
  law.a = input.positive("a");
}

bool read_option(PotdemInput &input, POTDEM::TrussContact &law)
{
  if (!input.next_is("penetration")) return false;
  input.penetration(law.m, law.normalized);
  return true;
}

std::string law_text(const POTDEM::TrussContact &law)
{
  std::string text = fmt::format("{:.17g} {:.17g}", law.E, law.a);
  if (law.m > 0)
    text += fmt::format(" penetration {}{}", law.m, law.normalized ? " normalized" : "");
  return text;
}

double *law_coefficient(POTDEM::TrussContact &law, const std::string &name)
{
  return find({{"E", &law.E}, {"a", &law.a}}, name);
}

/* ---------------------------------------------------------------------- */

void read_law(PotdemInput &input, POTDEM::ShiftedLJ &law)
{
  law.K0 = input.stiffness();
  law.R = input.positive("R");
  law.n = input.positive("n");
  law.alpha = input.fraction("alpha");
  law.cut = POTDEM::ShiftedLJ::default_cut(law.R, law.n);
}

bool read_option(PotdemInput &input, POTDEM::ShiftedLJ &law)
{
  if (input.next_is("linear"))
    law.least = input.between("linear s_min", 0.0, law.R);
  else if (input.next_is("cut"))
    law.cut = input.positive("cut s_c");
  else
    return false;
  return true;
}

std::string law_text(const POTDEM::ShiftedLJ &law)
{
  return fmt::format("{:.17g} {:.17g} {:.17g} {:.17g} cut {:.17g}{}", law.K0, law.R, law.n,
                     law.alpha, law.cut, linear_text(law.least));
}

double *law_coefficient(POTDEM::ShiftedLJ &law, const std::string &name)
{
  return find(
      {{"K0", &law.K0}, {"R", &law.R}, {"n", &law.n}, {"alpha", &law.alpha}, {"cut", &law.cut}},
      name);
}

/* ---------------------------------------------------------------------- */

void read_law(PotdemInput &input, POTDEM::RegularisedGranular &law)
{
  law.K0 = input.stiffness();
  law.n = input.above("n", 2.0);
  law.alpha = input.fraction("alpha");
  if (law.alpha == 0.0) input.fail("alpha = 0 is out of range, it must be > 0 and < 1");
  law.cut = POTDEM::RegularisedGranular::default_cut(law.n);
}

bool read_option(PotdemInput &input, POTDEM::RegularisedGranular &law)
{
  if (input.next_is("linear"))
    law.least = input.between("linear x_min", 0.0, 1.0);
  else if (input.next_is("cut"))
    law.cut = input.above("cut x", 1.0);
  else
    return false;
  return true;
}

std::string law_text(const POTDEM::RegularisedGranular &law)
{
  return fmt::format("{:.17g} {:.17g} {:.17g} cut {:.17g}{}", law.K0, law.n, law.alpha, law.cut,
                     linear_text(law.least));
}

double *law_coefficient(POTDEM::RegularisedGranular &law, const std::string &name)
{
  return find({{"K0", &law.K0}, {"n", &law.n}, {"alpha", &law.alpha}, {"cut", &law.cut}}, name);
}

/* ---------------------------------------------------------------------- */

void read_law(PotdemInput &input, POTDEM::Hertz &law)
{
  const auto solid = input.properties({"E", "nu"});
  law = POTDEM::Hertz::of(solid[0], solid[1]);
}

bool read_option(PotdemInput &input, POTDEM::Hertz &law)
{
  if (!input.next_is("viscous")) return false;
  law.H = input.nonnegative("viscous H");
  return true;
}

std::string law_text(const POTDEM::Hertz &law)
{
  return fmt::format("{:.17g} {:.17g} viscous {:.17g}", law.E, law.nu, law.H);
}

double *law_coefficient(POTDEM::Hertz &law, const std::string &name)
{
  return find({{"E", &law.E}, {"nu", &law.nu}, {"viscous", &law.H}}, name);
}

}    // namespace LAMMPS_NS
