/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "potdem_material_file.h"

#include "atom.h"
#include "comm.h"
#include "text_file_reader.h"
#include "update.h"

#include <algorithm>
#include <cstdlib>

using namespace LAMMPS_NS;

static const PotdemProperty PROPERTIES[] = {
    {"E", "E", PotdemProperty::STRESS, &PotdemInput::positive},
    {"nu", "nu", PotdemProperty::NONE, &PotdemInput::poisson},
    {"density", "density", PotdemProperty::DENSITY, &PotdemInput::positive},
    {"tension", "tension strength", PotdemProperty::STRESS, &PotdemInput::positive},
    {"compression", "compression strength", PotdemProperty::STRESS, &PotdemInput::positive},
    {"friction", "friction mu", PotdemProperty::NONE, &PotdemInput::nonnegative},
};

// LAMMPS's unit systems in which a stress is force over area, and their units in Pa and kg/m^3
struct MechanicalUnits {
  const char *name;
  double stress, density;
};
static constexpr MechanicalUnits MECHANICAL[] = {
    {"si", 1.0, 1.0}, {"cgs", 0.1, 1e3}, {"micro", 1e3, 1e3}, {"nano", 1e6, 1e6}};

static const MechanicalUnits *mechanical(const std::string &name)
{
  for (const auto &units : MECHANICAL)
    if (name == units.name) return &units;
  return nullptr;
}

template <class Names> static std::string listed(const Names &names)
{
  std::string text;
  for (const auto &name : names) text += (text.empty() ? "" : ", ") + std::string(name);
  return text;
}

/* ---------------------------------------------------------------------- */

const PotdemProperty *PotdemProperty::find(const std::string &name)
{
  for (const auto &property : PROPERTIES)
    if (name == property.name) return &property;
  return nullptr;
}

std::string PotdemProperty::names()
{
  std::vector<std::string> all;
  for (const auto &property : PROPERTIES) all.emplace_back(property.name);
  return listed(all);
}

/* ---------------------------------------------------------------------- */

bool PotdemMaterialFile::is(const std::string &word)
{
  return utils::strmatch(word, "\\.potdem$");
}

PotdemMaterialFile::PotdemMaterialFile(LAMMPS *lmp, PotdemInput &asking, const std::string &_name) :
    Pointers(lmp), name(_name)
{
  auto lines = read(asking);
  const std::string units = utils::trim(lines[0]);
  date = utils::trim(lines[1]);
  std::string current;
  for (std::size_t k = 2; k < lines.size(); k++) parse(lines[k], current);
  convert(asking, units);
}

// its units, its date, and its lines without comments, on all ranks
std::vector<std::string> PotdemMaterialFile::read(PotdemInput &asking)
{
  const std::string kind = "material";
  std::string text;
  if (comm->me == 0) {
    const std::string path = utils::get_potential_file_path(name);
    if (!path.empty()) {
      // blanks keep the first two from being taken for empty lines
      text = " " + utils::get_potential_units(path, kind) + "\n " +
          utils::get_potential_date(path, kind);
      TextFileReader reader(path, kind);
      while (const char *line = reader.next_line()) text += "\n" + utils::trim(line);
    }
  }
  int length = static_cast<int>(text.size());
  MPI_Bcast(&length, 1, MPI_INT, 0, world);
  text.resize(length);
  MPI_Bcast(&text[0], length, MPI_CHAR, 0, world);
  if (text.empty()) {
    const char *folders = getenv("LAMMPS_POTENTIALS");
    asking.fail(fmt::format("there is no material file '{}' that can be read, neither here nor in "
                            "the folders of LAMMPS_POTENTIALS ({}); give its path, or set "
                            "LAMMPS_POTENTIALS to POTDEM's folder potentials",
                            name, folders && *folders ? folders : "which is not set"));
  }
  return Tokenizer(text, "\n").as_vector();
}

void PotdemMaterialFile::parse(const std::string &line, std::string &current)
{
  PotdemWords words(line);
  PotdemInput input(lmp,
                    current.empty() ? "material file " + name
                                    : fmt::format("material '{}' in {}", current, name),
                    words.narg(), words.arg());
  const std::string key = input.word();
  if (words.narg() != 2) input.fail(fmt::format("'{}' is not a name and one value", line));
  if (key == "material") {
    current = input.word();
    if (current == "NULL" || materials.count(current))
      input.fail(fmt::format("a material cannot be called '{}': the name is {}", current,
                             current == "NULL" ? "that of no material" : "taken"));
    materials[current] = {};
    return;
  }
  const auto *const property = PotdemProperty::find(key);
  if (!property) input.unknown("material, " + PotdemProperty::names());
  if (current.empty())
    input.fail(fmt::format("'{}' belongs to no material, put 'material NAME' before it", line));
  if (materials[current].count(key)) input.fail(fmt::format("{} is given twice", key));
  materials[current][key] = (input.*property->read)(property->label);
}

void PotdemMaterialFile::convert(PotdemInput &asking, const std::string &units)
{
  const std::string wanted = update->unit_style;
  if (units == wanted) return;
  if (units.empty())
    asking.fail(fmt::format("the first line of material file {} does not say its units; "
                            "write for example '# DATE: 2026-11-24 UNITS: si' there",
                            name));
  const auto *const from = mechanical(units), *const to = mechanical(wanted);
  if (!from || !to)
    asking.fail(fmt::format("material file {} has {} units, but the script has {} units; "
                            "only si, cgs, micro and nano are converted: put 'units {}' before "
                            "the box is created, or write a file with 'UNITS: {}'",
                            name, units, wanted, from ? "si" : units, wanted));
  const double factor[] = {1.0, from->stress / to->stress, from->density / to->density};
  for (auto &material : materials)
    for (auto &one : material.second)
      one.second *= factor[PotdemProperty::find(one.first)->dimension];
  converted = units;
}

/* ---------------------------------------------------------------------- */

std::string PotdemMaterialFile::no_material(const std::string &material) const
{
  std::vector<std::string> names;
  for (const auto &one : materials) names.push_back(one.first);
  return fmt::format("there is no material '{}' in {}, which has {}", material, name,
                     listed(names));
}

double PotdemMaterialFile::value(PotdemInput &asking, const std::string &material,
                                 const std::string &property) const
{
  const auto properties = materials.find(material);
  if (properties == materials.end()) asking.fail(no_material(material));
  const auto found = properties->second.find(property);
  if (found == properties->second.end())
    asking.fail(fmt::format("material '{}' in {} has no {}, which is needed here; add the line "
                            "'{} VALUE' to it, or give numbers instead of the material",
                            material, name, property, property));
  return found->second;
}

void PotdemMaterialFile::check_list(PotdemInput &asking,
                                    const std::vector<std::string> &words) const
{
  const std::size_t ntypes = atom->ntypes;
  const std::string rule =
      fmt::format("'* *' with a material file wants one material, or NULL, for each of the {} atom "
                  "types",
                  ntypes);
  const auto known = [this](const std::string &word) {
    return word == "NULL" || materials.count(word);
  };
  if (words.size() < ntypes)
    asking.fail(fmt::format("{}, but only {} words follow {}", rule, words.size(), name));
  for (std::size_t k = 0; k < ntypes; k++)
    if (!known(words[k])) asking.fail(no_material(words[k]) + "; " + rule);
  if (words.size() > ntypes && known(words[ntypes]))
    asking.fail(fmt::format("material '{}' is one too many: {}", words[ntypes], rule));
  if (std::all_of(words.begin(), words.begin() + ntypes, [](const std::string &word) {
        return word == "NULL";
      }))
    asking.fail("no atom type has a material, all are NULL");
}

std::string PotdemMaterialFile::title() const
{
  std::string text = name;
  if (!date.empty()) text += " of " + date;
  if (!converted.empty()) text += ", converted from " + converted;
  return text;
}
