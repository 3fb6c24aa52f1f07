/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/glue/potdem_material.h"

#include "lammps/glue/potdem_material_file.h"

#include "input.h"
#include "variable.h"

using namespace LAMMPS_NS;

void PotdemMaterial::command(int narg, char **arg)
{
  PotdemInput input(lmp, "potdem_material", narg, arg);
  const std::string name = input.word();
  if (!PotdemMaterialFile::is(name))
    input.fail(fmt::format("'{}' is not the name of a material file, which ends in .potdem", name));
  const PotdemMaterialFile file(lmp, input, name);
  const std::string material = input.word();
  do {
    const std::string property = input.word();
    if (!PotdemProperty::find(property)) input.unknown(PotdemProperty::names());
    const double value = file.value(input, material, property);
    const std::string variable = input.word();
    lmp->input->variable->set(fmt::format("{} equal {:.17g}", variable, value));
    utils::logmesg(lmp, "potdem_material: {} = {:g}, {} of {} in {}\n", variable, value, property,
                   material, file.title());
  } while (!input.done());
}
