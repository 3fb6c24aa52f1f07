/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "pair_potdem_truss.h"

#include "potdem_input.h"
#include "potdem_pair_loop.h"

using namespace LAMMPS_NS;

/* ----------------------------------------------------------------------
   I J  E a  [penetration m [normalized]] [friction mu eta|auto]
------------------------------------------------------------------------- */

void PairPotdemTruss::coeff(int narg, char **arg)
{
  if (!allocated) allocate();
  PotdemInput input(lmp, "pair_coeff potdem/truss", narg, arg);
  int ilo, ihi, jlo, jhi;
  input.type_ranges(ilo, ihi, jlo, jhi);
  POTDEM::TrussContact law{};
  POTDEM::Friction slide;
  law.E = input.positive("E");
  law.a = input.positive("a");
  while (!input.done()) {
    if (input.next_is("penetration")) {
      input.penetration(law.m, law.normalized);
    } else if (input.next_is("friction")) {
      slide = input.friction();
    } else {
      input.word();
      input.unknown("penetration or friction");
    }
  }
  set_laws(ilo, ihi, jlo, jhi, law, slide);
}

// two half trusses in series; the factors of the two halves must agree to have one
void PairPotdemTruss::mix(int i, int j)
{
  const auto &a = laws[at(i, i)], &b = laws[at(j, j)];
  if (a.m != b.m || a.normalized != b.normalized)
    error->all(FLERR,
               "pair_style potdem/truss: types {} and {} have different 'penetration', which "
               "cannot be mixed; give "
               "pair_coeff {} {} explicitly",
               i, j, i, j);
  laws[at(i, j)] = {POTDEM::series_modulus(a.E, b.E), 0.5 * (a.a + b.a), a.m, a.normalized};
}

std::string PairPotdemTruss::coeff_text(int pair) const
{
  const auto &law = laws[pair];
  std::string text = fmt::format("{:.17g} {:.17g}", law.E, law.a);
  if (law.m > 0)
    text += fmt::format(" penetration {}{}", law.m, law.normalized ? " normalized" : "");
  return text;
}
