/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "pair_potdem_lj.h"

#include "potdem_input.h"
#include "potdem_pair_loop.h"

using namespace LAMMPS_NS;

/* ----------------------------------------------------------------------
   I J  K0 R n alpha  [cut s_c] [friction mu eta|auto]
------------------------------------------------------------------------- */

void PairPotdemLJ::coeff(int narg, char **arg)
{
  if (!allocated) allocate();
  PotdemInput input(lmp, "pair_coeff potdem/lj", narg, arg);
  int ilo, ihi, jlo, jhi;
  input.type_ranges(ilo, ihi, jlo, jhi);
  POTDEM::ShiftedLJ law{};
  POTDEM::Friction slide;
  law.K0 = input.positive("K0");
  law.R = input.positive("R");
  law.n = input.positive("n");
  law.alpha = input.fraction("alpha");
  law.cut = POTDEM::ShiftedLJ::default_cut(law.R, law.n);
  while (!input.done()) {
    if (input.next_is("cut")) {
      law.cut = input.positive("cut s_c");
    } else if (input.next_is("friction")) {
      slide = input.friction();
    } else {
      input.word();
      input.unknown("cut or friction");
    }
  }
  set_laws(ilo, ihi, jlo, jhi, law, slide);
}

// springs in series, mean distances; exponents must agree
void PairPotdemLJ::mix(int i, int j)
{
  const auto &a = laws[at(i, i)], &b = laws[at(j, j)];
  if (a.n != b.n)
    error->all(FLERR,
               "pair_style potdem/lj: types {} and {} have different n, which cannot be mixed; "
               "give pair_coeff {} {} "
               "explicitly",
               i, j, i, j);
  laws[at(i, j)] = {POTDEM::series_modulus(a.K0, b.K0), 0.5 * (a.R + b.R), a.n,
                    0.5 * (a.alpha + b.alpha), 0.5 * (a.cut + b.cut)};
}

std::string PairPotdemLJ::coeff_text(int pair) const
{
  const auto &law = laws[pair];
  return fmt::format("{:.17g} {:.17g} {:.17g} {:.17g} cut {:.17g}", law.K0, law.R, law.n, law.alpha,
                     law.cut);
}
