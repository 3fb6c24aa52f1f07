/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/glue/potdem_input.h"

#include "lammps/glue/potdem_restart_block.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix.h"
#include "modify.h"
#include "update.h"

#include <cmath>
#include <stdexcept>

using namespace LAMMPS_NS;

void LAMMPS_NS::potdem_refuse_respa(LAMMPS *lmp, const std::string &command)
{
  if (utils::strmatch(lmp->update->integrate_style, "^respa"))
    lmp->error->all(FLERR, "{} works with run_style verlet only, not with respa", command);
}

void LAMMPS_NS::potdem_needs_setup(LAMMPS *lmp)
{
  if (lmp->update) lmp->update->first_update = 0;
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

// "PTDM", the form, the length, the checksum; then the text
struct TextHead {
  int mark, form, length;
  unsigned sum;
};
static constexpr int TEXT_MARK = 0x4d445450, TEXT_FORM = 2, LONGEST_TEXT = 100000;

static unsigned sum_of(const std::string &text)
{
  return static_cast<unsigned>(potdem_checksum(text.data(), text.size()));
}

void LAMMPS_NS::potdem_write_text(FILE *fp, const std::string &text)
{
  const TextHead head = {TEXT_MARK, TEXT_FORM, static_cast<int>(text.size()), sum_of(text)};
  fwrite(&head, sizeof(head), 1, fp);
  fwrite(text.data(), 1, text.size(), fp);
}

std::string LAMMPS_NS::potdem_read_text(LAMMPS *lmp, FILE *fp, const std::string &who)
{
  TextHead head{};
  const bool reads = lmp->comm->me == 0;
  if (reads) utils::sfread(FLERR, &head, sizeof(head), 1, fp, nullptr, lmp->error);
  MPI_Bcast(&head, sizeof(head), MPI_BYTE, 0, lmp->world);
  if (head.mark != TEXT_MARK || head.form != TEXT_FORM || head.length < 0 ||
      head.length > LONGEST_TEXT)
    potdem_refuse_version(lmp, who);
  std::string text(head.length, ' ');
  if (reads && head.length > 0)
    utils::sfread(FLERR, &text[0], 1, head.length, fp, nullptr, lmp->error);
  MPI_Bcast(&text[0], head.length, MPI_CHAR, 0, lmp->world);
  if (head.sum != sum_of(text)) potdem_refuse_damaged(lmp, who);
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

bool PotdemInput::next_matches(bool (*rule)(const std::string &)) const
{
  return !done() && rule(arg[at]);
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

static std::string words_for(const POTDEM::Range &range)
{
  if (range.whole) return fmt::format("a whole number from {} to {}", range.low, range.high);
  const auto low = fmt::format("{} {}", range.low_open ? ">" : ">=", range.low);
  if (!range.bounded()) return low;
  return fmt::format("{} and {} {}", low, range.high_open ? "<" : "<=", range.high);
}

double PotdemInput::in_range(const std::string &name, const POTDEM::Range &range)
{
  const double value = number(name);
  if (!range.has(value))
    fail(fmt::format("{} = {} is out of range, it must be {}", name, value, words_for(range)));
  return value;
}

int PotdemInput::whole(const std::string &name, int most)
{
  return static_cast<int>(in_range(name, POTDEM::whole(most)));
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
