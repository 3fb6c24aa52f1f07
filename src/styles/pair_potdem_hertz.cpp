/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "pair_potdem_hertz.h"

#include "potdem_input.h"
#include "potdem_pair_loop.h"

using namespace LAMMPS_NS;

bool PairPotdemHertz::read_setting(PotdemInput &input)
{
  if (!input.next_is("attract")) return false;
  attract = input.logical("attract");
  return true;
}

/* ----------------------------------------------------------------------
   I J  E nu  [viscous H] [friction mu eta|auto]
------------------------------------------------------------------------- */

void PairPotdemHertz::coeff(int narg, char **arg)
{
  if (!allocated) allocate();
  PotdemInput input(lmp, "pair_coeff potdem/hertz", narg, arg);
  int ilo, ihi, jlo, jhi;
  input.type_ranges(ilo, ihi, jlo, jhi);
  const double E = input.positive("E"), nu = input.poisson("nu");
  auto law = POTDEM::Hertz::of(E, nu);
  law.attract = attract;
  POTDEM::Friction slide;
  while (!input.done()) {
    if (input.next_is("viscous")) {
      law.H = input.nonnegative("viscous H");
    } else if (input.next_is("friction")) {
      slide = input.friction();
    } else {
      input.word();
      input.unknown("viscous or friction");
    }
  }
  set_laws(ilo, ihi, jlo, jhi, law, slide);
}

// 5.15b for the elastic part, the mean for the viscous one
void PairPotdemHertz::mix(int i, int j)
{
  const auto &a = laws[at(i, i)], &b = laws[at(j, j)];
  laws[at(i, j)] = {0.0, 0.0, POTDEM::contact_modulus(a.E, a.nu, b.E, b.nu), 0.5 * (a.H + b.H),
                    a.attract || b.attract};
}

// a mixed pair is written as two equal materials that have its contact modulus
std::string PairPotdemHertz::coeff_text(int pair) const
{
  const auto &law = laws[pair];
  const double E = law.E > 0.0 ? law.E : 2.0 * law.modulus;
  return fmt::format("{:.17g} {:.17g} viscous {:.17g}", E, law.nu, law.H);
}
