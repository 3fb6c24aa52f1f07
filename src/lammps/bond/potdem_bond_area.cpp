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

PotdemBondArea PotdemBondArea::read(PotdemMaterialInput &input, int dimension)
{
  PotdemBondArea area;
  if (!input.next_is("area")) {
    input.word();
    input.unknown("area");
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
  if (area.mode != FACTOR && dimension == 2)
    input.fail("area lattice and area body are for solids in three dimensions; in two use area "
               "factor a, for a plate the a of its thickness (see the page of the style)");
  return area;
}

std::string PotdemBondArea::text() const
{
  if (mode == FACTOR) return fmt::format("area factor {:.17g}", value);
  if (mode == LATTICE) return "area lattice";
  return value > 0.0 ? fmt::format("area body density {:.17g}", value) : "area body";
}

void PotdemBondArea::prepare(FixPotdemBondHistory *history) const
{
  if (mode != FACTOR) history->keep_areas();
  if (mode == BODY) history->allow_exchange(POTDEM::BodyHalo::WIDEST);
}

void PotdemBondArea::find(LAMMPS *lmp, FixPotdemBondHistory *history, const std::string &style,
                          int type) const
{
  if (mode == LATTICE) PotdemLatticeArea(lmp, history, style).solve(type);
  if (mode == BODY) PotdemBodyArea(lmp, history, style).solve(type, value);
}

double PotdemBondArea::section(const FixPotdemBondHistory &history, int i, int slot,
                               double dbar) const
{
  if (mode == FACTOR) return value * POTDEM::truss_section(dbar);
  return std::fabs(history.area(i, slot));
}
