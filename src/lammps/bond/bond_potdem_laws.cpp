/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* BondPotdem<Law> for the laws of BOND_LAWS: reading their coefficients, and choosing the loop. */

#include "lammps/bond/bond_potdem.h"

#include "lammps/bond/bond_potdem_loop.h"
#include "lammps/glue/potdem_width.h"

#include "domain.h"

using namespace LAMMPS_NS;

template <class Law>
BondPotdem<Law>::BondPotdem(LAMMPS *lmp) :
    BondPotdemBase(lmp, std::string("potdem/") + POTDEM::law_name<Law>(), Law::STATE),
    quiet(nullptr), tallied(nullptr)
{
}

template <class Law> void BondPotdem<Law>::make_laws(int ntypes)
{
  laws.assign(ntypes + 1, Law{});
  kernels.assign(ntypes + 1, typename Law::Kernel{});
}

template <class Law> bool BondPotdem<Law>::has_penetration(int type) const
{
  if constexpr (Law::optional_penetration) return kernels[type].has_penetration;
  return false;
}

/* ----------------------------------------------------------------------
   N  values of the law  area ...  [keywords of the law and damping xi, in any order]
------------------------------------------------------------------------- */

template <class Law> void BondPotdem<Law>::read(PotdemMaterialInput &input, int lo, int hi)
{
  Law law{};
  const auto table = potdem_rows(law);
  potdem_read_required(input, table);
  BesideLaw more{PotdemBondArea::read(input, domain->dimension)};
  while (!input.done()) {
    if (potdem_read_option(input, table) || read_beside(input, more)) continue;
    const std::string options = potdem_option_names(table);
    input.word();
    input.unknown(options.empty() ? "damping" : options + " or damping");
  }
  potdem_complete(law);
  for (int type = lo; type <= hi; type++) {
    laws[type] = law;
    beside[type] = more;
  }
}

template <class Law> PotdemLawRows BondPotdem<Law>::rows(int type)
{
  return potdem_rows(laws[type]);
}

/* ---------------------------------------------------------------------- */

template <class Law> void BondPotdem<Law>::choose_loop()
{
  if constexpr (Law::optional_penetration)
    if (any_penetration) return choose<true>();
  choose<false>();
}

template <class Law> template <bool PENETRATION> void BondPotdem<Law>::choose()
{
  damped ? choose<PENETRATION, true>() : choose<PENETRATION, false>();
}

template <class Law> template <bool PENETRATION, bool DAMP> void BondPotdem<Law>::choose()
{
  switch (strengths.kind()) {
    case BondStrengths::NONE:
      return choose<BondStrengths::NONE, PENETRATION, DAMP>();
    case BondStrengths::BY_TYPE:
      return choose<BondStrengths::BY_TYPE, PENETRATION, DAMP>();
    case BondStrengths::BY_BOND:
      return choose<BondStrengths::BY_BOND, PENETRATION, DAMP>();
  }
}

template <class Law> template <int FAIL, bool PENETRATION, bool DAMP> void BondPotdem<Law>::choose()
{
  quiet = loop_for_machine<false, FAIL, PENETRATION, DAMP>();
  tallied = loop_for_machine<true, FAIL, PENETRATION, DAMP>();
}

template <class Law>
template <bool EV, int FAIL, bool PENETRATION, bool DAMP>
typename BondPotdem<Law>::Loop BondPotdem<Law>::loop_for_machine()
{
#ifdef POTDEM_WIDE_CODE
  if (potdem_width(lmp) != POTDEM::Width::PLAIN)
    return &BondPotdem::template loop_avx2<EV, FAIL, PENETRATION, DAMP>;
#endif
  return &BondPotdem::template loop<EV, FAIL, PENETRATION, DAMP>;
}

#define POTDEM_INSTANTIATE(name, Law) template class LAMMPS_NS::BondPotdem<POTDEM::Law>;
BOND_LAWS(POTDEM_INSTANTIATE)
