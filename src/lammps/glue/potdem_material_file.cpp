/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/glue/potdem_material_file.h"

#include "atom.h"
#include "comm.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>

using namespace LAMMPS_NS;

static const PotdemProperty PROPERTIES[] = {
    {"E", "E", PotdemProperty::STRESS, POTDEM::positive()},
    {"nu", "nu", PotdemProperty::NONE, POTDEM::poisson_ratio()},
    {"density", "density", PotdemProperty::DENSITY, POTDEM::positive()},
    {"tension", "tension strength", PotdemProperty::STRESS, POTDEM::positive()},
    {"compression", "compression strength", PotdemProperty::STRESS, POTDEM::positive()},
    {"friction", "friction mu", PotdemProperty::NONE, POTDEM::nonnegative()},
};

// bytes; the larger one that is bundled has 4000
static constexpr std::size_t LARGEST_FILE = 1000000;
// without its comment, for messages that quote it
static constexpr std::size_t LONGEST_LINE = 200;
// that some editors put before UTF-8
static const std::string BYTE_ORDER_MARK = "\xef\xbb\xbf";

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

static std::vector<std::string> words_of(const std::string &line)
{
  std::istringstream in(line);
  return {std::istream_iterator<std::string>(in), {}};
}

// in the first line, which is a comment and may have anything: nothing if it is no plain word
static std::string word_after(const std::string &key, const std::string &line)
{
  const auto words = words_of(line);
  const auto found = std::find(words.begin(), words.end(), key);
  if (found == words.end() || found + 1 == words.end()) return "";
  const auto &word = *(found + 1);
  const bool plain =
      word.size() <= LONGEST_LINE && std::all_of(word.begin(), word.end(), [](char c) {
        return c > ' ' && c <= '~';
      });
  return plain ? word : "";
}

// what is wrong with a character outside comments
static std::string misread(unsigned char c)
{
  if (c == '\'' || c == '"') return "a quote: write names and values without quotes";
  if (c == '\r')
    return "a carriage return in its middle: end lines with a newline, as on Unix or Windows";
  if (c > '~' || (c < ' ' && !isspace(c)))
    return fmt::format(
        "the byte 0x{:02x}, which is not printable ASCII (perhaps a special blank or "
        "sign, or an accent): only comments may have such",
        static_cast<unsigned>(c));
  return "";
}

// false: it cannot be read. One byte too many is enough to know that a file is too large
static bool read_bytes(const std::string &path, std::string &text)
{
  std::ifstream file(path, std::ios::binary);
  if (path.empty() || !file) return false;
  text.resize(LARGEST_FILE + 1);
  file.read(&text[0], LARGEST_FILE + 1);
  text.resize(file.gcount());
  return !file.bad();
}

/* ---------------------------------------------------------------------- */

bool PotdemMaterialFile::is(const std::string &word)
{
  return utils::strmatch(word, "\\.potdem$");
}

PotdemMaterialFile::PotdemMaterialFile(LAMMPS *lmp, PotdemInput &asking, const std::string &_name) :
    Pointers(lmp), name(_name)
{
  std::istringstream text(read(asking));
  std::string line, units, current;
  bool first = true;
  for (int number = 1; std::getline(text, line); number++) {
    if (first && !words_of(line).empty()) {
      units = word_after("UNITS:", line);
      date = word_after("DATE:", line);
      first = false;
    }
    const auto words = words_of(checked(line, number));
    if (!words.empty()) parse(words, number, current);
  }
  convert(asking, units);
}

// its text, on all ranks
std::string PotdemMaterialFile::read(PotdemInput &asking)
{
  std::string text, path;
  int length = -1;
  if (comm->me == 0) {
    path = utils::get_potential_file_path(name);
    if (read_bytes(path, text)) length = static_cast<int>(text.size());
  }
  MPI_Bcast(&length, 1, MPI_INT, 0, world);
  if (length < 0) {
    const char *folders = getenv("LAMMPS_POTENTIALS");
    asking.fail(fmt::format("there is no material file '{}' that can be read, neither here nor in "
                            "the folders of LAMMPS_POTENTIALS ({}); give its path, or set "
                            "LAMMPS_POTENTIALS to POTDEM's folder potentials",
                            name, folders && *folders ? folders : "which is not set"));
  }
  text.resize(length);
  MPI_Bcast(&text[0], length, MPI_CHAR, 0, world);
  if (text.compare(0, BYTE_ORDER_MARK.size(), BYTE_ORDER_MARK) == 0)
    text.erase(0, BYTE_ORDER_MARK.size());
  check_whole(asking, text);
  return text;
}

// a number that is cut off is still a number, so that the last newline must tell
void PotdemMaterialFile::check_whole(PotdemInput &asking, const std::string &text) const
{
  if (text.size() > LARGEST_FILE)
    asking.fail(fmt::format("{} has more than {} bytes, which no material file has; give another "
                            "file",
                            name, LARGEST_FILE));
  if (text.find('\0') != std::string::npos)
    asking.fail(fmt::format("material file {} has bytes of zero, so it is not plain text (perhaps "
                            "UTF-16, or a binary file): save it as plain text, in ASCII or UTF-8",
                            name));
  if (!text.empty() && text.back() != '\n')
    asking.fail(fmt::format("material file {} seems to be cut off in line {}, which has no newline "
                            "at its end: copy the file again, or end its last line with a newline "
                            "if it is complete",
                            name, 1 + std::count(text.begin(), text.end(), '\n')));
}

// a line without its comment, if there is nothing in it that would be misread; comments may have any bytes
std::string PotdemMaterialFile::checked(std::string line, int number) const
{
  if (!line.empty() && line.back() == '\r') line.pop_back();
  line.erase(std::min(line.find('#'), line.size()));
  for (const unsigned char c : line) {
    const auto reason = misread(c);
    if (reason.empty()) continue;
    PotdemWords none("");
    at(number, "", none).fail("the line has " + reason);
  }
  return line;
}

// for errors in a line
PotdemInput PotdemMaterialFile::at(int number, const std::string &current, PotdemWords &words) const
{
  const auto place = current.empty() ? "material file " + name
                                     : fmt::format("material '{}' in {}", current, name);
  return {lmp, fmt::format("{}, line {}", place, number), words.narg(), words.arg()};
}

void PotdemMaterialFile::parse(const std::vector<std::string> &line, int number,
                               std::string &current)
{
  PotdemWords words(line);
  auto input = at(number, current, words);
  const std::string text = utils::join_words(line, " ");
  if (text.size() > LONGEST_LINE)
    input.fail(
        fmt::format("'{} ...' is too long for a name and one value", text.substr(0, LONGEST_LINE)));
  if (words.narg() != 2) input.fail(fmt::format("'{}' is not a name and one value", text));
  const std::string key = input.word();
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
    input.fail(fmt::format("'{}' belongs to no material, put 'material NAME' before it", text));
  if (materials[current].count(key)) input.fail(fmt::format("{} is given twice", key));
  materials[current][key] = input.in_range(property->label, property->range);
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
    for (auto &one : material.second) {
      const auto dimension = PotdemProperty::find(one.first)->dimension;
      if (dimension == PotdemProperty::NONE) continue;
      const double value = one.second;
      one.second *= factor[dimension];
      if (!std::isnormal(one.second))
        asking.fail(fmt::format("{} of material '{}' in {} is {:g} in {} units, which is too {} "
                                "for a number in {} units: correct the value, or use {} units",
                                one.first, material.first, name, value, units,
                                std::isinf(one.second) ? "large" : "small", wanted, units));
    }
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
