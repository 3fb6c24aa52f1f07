/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/bond/potdem_bond_area.h"

#include "core/laws/truss.h"
#include "lammps/bond/potdem_body_area.h"
#include "lammps/bond/potdem_lattice_area.h"
#include "lammps/glue/fix_potdem_bond_history.h"
#include "lammps/glue/potdem_material_input.h"

#include "fmt/format.h"

#include <cmath>

using namespace LAMMPS_NS;

// down to that of a solid that does not contract, below which sections are hard to find; up to nearly that of a fluid
static double read_poisson(PotdemMaterialInput &input)
{
  static constexpr double LEAST = 0.0, MOST = 0.49;
  const double nu = input.properties({"nu"}).front();
  if (nu < LEAST || nu > MOST)
    input.fail(fmt::format("nu = {:g} is outside {:g} to {:g}, for which area body is made", nu,
                           LEAST, MOST));
  return nu;
}

PotdemBondArea PotdemBondArea::read(PotdemMaterialInput &input, int dimension)
{
  PotdemBondArea area;
  const bool has_nu = input.next_is("nu");
  if (has_nu) area.elasticity.poisson = read_poisson(input);
  if (!input.next_is("area")) {
    input.word();
    input.unknown(has_nu ? "area" : "area or nu");
  }
  if (input.next_is("factor")) {
    area.value = input.in_range("area factor a", POTDEM::positive());
  } else if (input.next_is("lattice")) {
    area.mode = LATTICE;
  } else if (input.next_is("body")) {
    area.mode = BODY;
    if (input.next_is("density"))
      area.value = input.properties({"density"}, " of area body").front();
  } else {
    input.word();
    input.unknown("area factor, area lattice or area body");
  }
  if (has_nu && area.mode != BODY)
    input.fail("nu is for area body: with area factor and area lattice Poisson's ratio is what the "
               "arrangement of the bonds makes it (see the page of the style)");
  if (area.mode != FACTOR && dimension == 2)
    input.fail("area lattice and area body are for solids in three dimensions; in two use area "
               "factor a, for a plate the a of its thickness (see the page of the style)");
  return area;
}

std::string PotdemBondArea::text() const
{
  if (mode == FACTOR) return fmt::format("area factor {:.17g}", value);
  if (mode == LATTICE) return "area lattice";
  const std::string nu = has_volume_term() ? fmt::format("nu {:.17g} ", elasticity.poisson)
                                           : std::string();
  return nu + (value > 0.0 ? fmt::format("area body density {:.17g}", value) : "area body");
}

void PotdemBondArea::prepare(FixPotdemBondHistory *history) const
{
  if (mode != FACTOR) history->keep_areas();
  if (mode == BODY) history->allow_exchange(POTDEM::BodyHalo::WIDEST);
  if (has_volume_term()) history->keep_dilatations();
}

void PotdemBondArea::find(LAMMPS *lmp, FixPotdemBondHistory *history, const std::string &style,
                          int type) const
{
  if (mode == LATTICE) PotdemLatticeArea(lmp, history, style).solve(type);
  if (mode == BODY) PotdemBodyArea(lmp, history, style).solve(type, value, elasticity);
}

double PotdemBondArea::section(const FixPotdemBondHistory &history, int i, int slot,
                               double dbar) const
{
  if (mode == FACTOR) return value * POTDEM::truss_section(dbar);
  return elasticity.bonds_modulus() * std::fabs(history.area(i, slot));
}
