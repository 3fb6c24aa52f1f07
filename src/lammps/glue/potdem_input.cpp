/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/glue/potdem_input.h"

#include "lammps/glue/potdem_material_file.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix.h"
#include "modify.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

using namespace LAMMPS_NS;

static constexpr int MAX_EXPONENT = 64;

void LAMMPS_NS::potdem_refuse_respa(LAMMPS *lmp, const std::string &command)
{
  if (utils::strmatch(lmp->update->integrate_style, "^respa"))
    lmp->error->all(FLERR, "{} works with run_style verlet only, not with respa", command);
}

bool LAMMPS_NS::potdem_minimizes(LAMMPS *lmp)
{
  return lmp->update->whichflag == 2;
}

void LAMMPS_NS::potdem_warn_of_rolling_bodies(LAMMPS *lmp, const std::string &who)
{
  if (lmp->comm->me == 0)
    lmp->error->warning(FLERR,
                        "{}: rotation lets bonded particles spin freely, because trusses carry no "
                        "moments: a body rolls "
                        "away on the particles on which it rests, whatever their friction; use "
                        "rotation no where bodies "
                        "touch",
                        who);
}

void LAMMPS_NS::potdem_require_last(LAMMPS *lmp, Fix *fix, const std::string &reason,
                                    const std::string &may_follow)
{
  bool after = false;
  for (const auto &other : lmp->modify->get_fix_list()) {
    const bool harmless = isupper(other->style[0]) ||
        (!may_follow.empty() && utils::strmatch(other->style, may_follow));
    if (other == fix)
      after = true;
    else if (after && (other->setmask() & FixConst::POST_FORCE) && !harmless)
      lmp->error->all(FLERR,
                      "Fix {} {} {}, but fix {} ({}) comes after it and may change the force; "
                      "define fix {} last",
                      fix->style, fix->id, reason, other->id, other->style, fix->id);
  }
}

/* ---------------------------------------------------------------------- */

// "PTDM", the version, the length, the text
struct TextHead {
  int mark, version, length;
};
static constexpr int TEXT_MARK = 0x4d445450, TEXT_VERSION = 1;

void LAMMPS_NS::potdem_write_text(FILE *fp, const std::string &text)
{
  const TextHead head = {TEXT_MARK, TEXT_VERSION, static_cast<int>(text.size())};
  fwrite(&head, sizeof(head), 1, fp);
  fwrite(text.data(), 1, text.size(), fp);
}

std::string LAMMPS_NS::potdem_read_text(LAMMPS *lmp, FILE *fp, const std::string &who)
{
  TextHead head{};
  const bool reads = lmp->comm->me == 0;
  if (reads) utils::sfread(FLERR, &head, sizeof(head), 1, fp, nullptr, lmp->error);
  MPI_Bcast(&head, sizeof(head), MPI_BYTE, 0, lmp->world);
  if (head.mark != TEXT_MARK)
    lmp->error->all(FLERR,
                    "{}: the restart file was written by a version of POTDEM that did not keep its "
                    "coefficients "
                    "as text yet; read it with that version, or begin anew",
                    who);
  if (head.version > TEXT_VERSION)
    lmp->error->all(
        FLERR,
        "{}: the restart file was written by a newer version of POTDEM (form {}, this one reads "
        "up to {}); read it with that version",
        who, head.version, TEXT_VERSION);
  std::string text(head.length, ' ');
  if (reads && head.length > 0)
    utils::sfread(FLERR, &text[0], 1, head.length, fp, nullptr, lmp->error);
  MPI_Bcast(&text[0], head.length, MPI_CHAR, 0, lmp->world);
  return text;
}

/* ---------------------------------------------------------------------- */

PotdemWords::PotdemWords(const std::string &text) : PotdemWords(utils::split_words(text)) {}

PotdemWords::PotdemWords(std::vector<std::string> _words) : words(std::move(_words))
{
  for (auto &word : words) pointers.push_back(&word[0]);
}

PotdemInput::PotdemInput(LAMMPS *lmp, std::string _command, int _narg, char **_arg) :
    Pointers(lmp), command(std::move(_command)), narg(_narg), at(0), arg(_arg)
{
}

void PotdemInput::fail(const std::string &text)
{
  error->all(FLERR, "{}: {}", command, text);
}

void PotdemInput::unknown(const std::string &choices)
{
  fail(fmt::format("unknown keyword '{}', expected {}", arg[at - 1], choices));
}

void PotdemInput::range(const std::string &name, double value, const std::string &allowed)
{
  fail(fmt::format("{} = {} is out of range, it must be {}", name, value, allowed));
}

std::string PotdemInput::word()
{
  if (done()) utils::missing_cmd_args(FLERR, command, error);
  return arg[at++];
}

bool PotdemInput::next_is(const std::string &expected)
{
  if (done() || expected != arg[at]) return false;
  at++;
  return true;
}

double PotdemInput::number(const std::string &name)
{
  const std::string text = word();
  if (!utils::is_double(text)) fail(fmt::format("{} must be a number, not '{}'", name, text));
  try {
    return std::stod(text);
  } catch (const std::out_of_range &) {
    fail(fmt::format(
        "{} = {} is out of range: too large or too small for a number in double precision", name,
        text));
  }
}

double PotdemInput::positive(const std::string &name)
{
  return above(name, 0.0);
}

double PotdemInput::nonnegative(const std::string &name)
{
  const double value = number(name);
  if (value < 0.0) range(name, value, ">= 0");
  return value;
}

double PotdemInput::above(const std::string &name, double bound)
{
  const double value = number(name);
  if (value <= bound) range(name, value, fmt::format("> {}", bound));
  return value;
}

double PotdemInput::between(const std::string &name, double low, double high)
{
  const double value = number(name);
  if (value <= low || value >= high) range(name, value, fmt::format("> {} and < {}", low, high));
  return value;
}

double PotdemInput::fraction(const std::string &name)
{
  const double value = number(name);
  if (value < 0.0 || value >= 1.0) range(name, value, ">= 0 and < 1");
  return value;
}

double PotdemInput::poisson(const std::string &name)
{
  const double value = number(name);
  if (value <= -1.0 || value > 0.5) range(name, value, "> -1 and <= 0.5");
  return value;
}

int PotdemInput::whole(const std::string &name, int most)
{
  const double value = number(name);
  if (value != std::floor(value) || value < 1 || value > most)
    range(name, value, fmt::format("a whole number from 1 to {}", most));
  return static_cast<int>(value);
}

bool PotdemInput::logical(const std::string &name)
{
  const std::string text = word();
  if (text != "yes" && text != "no")
    fail(fmt::format("{} must be yes or no, not '{}'", name, text));
  return text == "yes";
}

void PotdemInput::type_ranges(int &ilo, int &ihi, int &jlo, int &jhi)
{
  utils::bounds(FLERR, word(), 1, atom->ntypes, ilo, ihi, error);
  utils::bounds(FLERR, word(), 1, atom->ntypes, jlo, jhi, error);
}

int PotdemInput::bond_type()
{
  if (atom->nbondtypes == 0)
    fail("there are no bond types; give create_box some with 'bond/types N'");
  return whole("bond type", atom->nbondtypes);
}

void PotdemInput::penetration(int &m, int &normalized)
{
  m = whole("penetration m", MAX_EXPONENT);
  normalized = next_is("normalized");
}

std::vector<double> PotdemInput::properties(std::initializer_list<const char *> names,
                                            const std::string &owner)
{
  if (!done() && PotdemMaterialFile::is(arg[at])) return of_material(names);
  std::vector<double> values;
  for (const auto *name : names) {
    const auto *const property = PotdemProperty::find(name);
    values.push_back((this->*property->read)(property->label + owner));
  }
  return values;
}

std::vector<double> PotdemInput::of_material(std::initializer_list<const char *> names)
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

double PotdemInput::stiffness()
{
  if (done() || !PotdemMaterialFile::is(arg[at])) return positive("K0");
  const double E = property("E");
  if (!next_is("length"))
    fail("a material has no stiffness K0 of its own: put 'length L' after it, for K0 = E L");
  return E * positive("length L");
}

POTDEM::Friction PotdemInput::friction()
{
  POTDEM::Friction friction;
  friction.mu = next_is("file") ? friction_of_materials() : property("friction");
  friction.automatic = next_is("auto");
  if (!friction.automatic) friction.eta = nonnegative("friction eta");
  return friction;
}

// the more slippery of the materials in this command decides, as in mixing
double PotdemInput::friction_of_materials()
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
