/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "pair_potdem_granular.h"

#include "potdem_input.h"
#include "potdem_pair_loop.h"

using namespace LAMMPS_NS;

/* ----------------------------------------------------------------------
   I J  K0 n alpha  [cut x] [friction mu eta|auto]
------------------------------------------------------------------------- */

void PairPotdemGranular::coeff(int narg, char **arg)
{
  if (!allocated) allocate();
  PotdemInput input(lmp, "pair_coeff potdem/granular", narg, arg);
  int ilo, ihi, jlo, jhi;
  input.type_ranges(ilo, ihi, jlo, jhi);
  POTDEM::RegularisedGranular law{};
  POTDEM::Friction slide;
  law.K0 = input.positive("K0");
  law.n = input.above("n", 2.0);
  law.alpha = input.fraction("alpha");
  if (law.alpha == 0.0) input.fail("alpha = 0 is out of range, it must be > 0 and < 1");
  law.cut = POTDEM::RegularisedGranular::default_cut(law.n);
  while (!input.done()) {
    if (input.next_is("cut")) {
      law.cut = input.above("cut x", 1.0);
    } else if (input.next_is("friction")) {
      slide = input.friction();
    } else {
      input.word();
      input.unknown("cut or friction");
    }
  }
  set_laws(ilo, ihi, jlo, jhi, law, slide);
}

// springs in series, mean co-penetration; exponents must agree
void PairPotdemGranular::mix(int i, int j)
{
  const auto &a = laws[at(i, i)], &b = laws[at(j, j)];
  if (a.n != b.n)
    error->all(FLERR,
               "pair_style potdem/granular: types {} and {} have different n, which cannot be "
               "mixed; give pair_coeff {} "
               "{} explicitly",
               i, j, i, j);
  laws[at(i, j)] = {POTDEM::series_modulus(a.K0, b.K0), a.n, 0.5 * (a.alpha + b.alpha),
                    MAX(a.cut, b.cut)};
}

std::string PairPotdemGranular::coeff_text(int pair) const
{
  const auto &law = laws[pair];
  return fmt::format("{:.17g} {:.17g} {:.17g} cut {:.17g}", law.K0, law.n, law.alpha, law.cut);
}
