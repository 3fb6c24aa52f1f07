/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/glue/potdem_material_input.h"

#include "lammps/glue/potdem_material_file.h"

#include <algorithm>

using namespace LAMMPS_NS;

std::vector<double> PotdemMaterialInput::properties(const std::vector<const char *> &names,
                                                    const std::string &owner)
{
  if (next_matches(PotdemMaterialFile::is)) return of_material(names);
  std::vector<double> values;
  for (const auto *name : names) {
    const auto *const property = PotdemProperty::find(name);
    values.push_back(in_range(property->label + owner, property->range));
  }
  return values;
}

std::vector<double> PotdemMaterialInput::of_material(const std::vector<const char *> &names)
{
  const auto file = std::make_shared<PotdemMaterialFile>(lmp, *this, word());
  const std::string material = word();
  materials.emplace_back(file, material);
  std::vector<double> values;
  std::string text;
  for (const auto *name : names) {
    values.push_back(file->value(*this, material, name));
    text += fmt::format("{} {} = {:g}", text.empty() ? "" : ",", name, values.back());
  }
  utils::logmesg(lmp, "{}: {} in {}:{}\n", command, material, file->title(), text);
  return values;
}

double PotdemMaterialInput::stiffness(const std::string &name)
{
  if (!next_matches(PotdemMaterialFile::is)) return in_range(name, POTDEM::positive());
  const double E = property("E");
  if (!next_is("length"))
    fail(fmt::format(
        "a material has no stiffness {0} of its own: put 'length L' after it, for {0} = E L",
        name));
  return E * in_range("length L", POTDEM::positive());
}

double PotdemMaterialInput::friction_mu()
{
  return next_is("file") ? friction_of_materials() : property("friction");
}

// the more slippery of the materials in this command decides, as in mixing
double PotdemMaterialInput::friction_of_materials()
{
  if (materials.empty())
    fail("'friction file' takes mu from the materials of this command, but it has none; give a "
         "number, or FILE.potdem MATERIAL in place of the elastic constants");
  std::vector<double> mu;
  for (const auto &one : materials) mu.push_back(one.first->value(*this, one.second, "friction"));
  const double least = *std::min_element(mu.begin(), mu.end());
  utils::logmesg(lmp, "{}: friction mu = {:g} by material file\n", command, least);
  return least;
}
