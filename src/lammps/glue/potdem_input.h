/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Reading the arguments that several styles share, each value checked against its range. */

#ifndef LMP_POTDEM_INPUT_H
#define LMP_POTDEM_INPUT_H

#include "core/laws/coefficients.h"

#include "pointers.h"

#include <cstdio>
#include <string>
#include <vector>

namespace LAMMPS_NS {

// run_style respa would leave these styles out of its levels, or out altogether
void potdem_refuse_respa(LAMMPS *lmp, const std::string &command);

// a style has come, or goes: the next run begins with a set-up, as the first one, even with 'pre no'
void potdem_needs_setup(LAMMPS *lmp);

// in a minimization velocities mean nothing: no friction, no viscous forces, no ledger
bool potdem_minimizes(LAMMPS *lmp);

// who: the style that lets particles spin that have bonds
void potdem_warn_of_rolling_bodies(LAMMPS *lmp, const std::string &who);

// error if a fix that is defined after this one may change forces, which this one must see: all but LAMMPS's
// own bookkeeping (upper case) and the styles that `may_follow` (a pattern) names
void potdem_require_last(LAMMPS *lmp, class Fix *fix, const std::string &reason,
                         const std::string &may_follow);

// what a restart file keeps of a style: a text as the style's own commands take it, so that a file from before a
// keyword reads, with a mark and the version of this form. The text comes back on all ranks; who: the style, for errors
void potdem_write_text(FILE *, const std::string &text);
std::string potdem_read_text(LAMMPS *lmp, FILE *, const std::string &who);

// a text as the arguments of a command
class PotdemWords {
 public:
  explicit PotdemWords(const std::string &text);
  explicit PotdemWords(std::vector<std::string> words);
  int narg() const { return static_cast<int>(words.size()); }
  char **arg() { return pointers.data(); }

 private:
  std::vector<std::string> words;
  std::vector<char *> pointers;
};

class PotdemInput : protected Pointers {
 public:
  // command: how the errors name the place, e.g. "fix potdem/damping"
  PotdemInput(LAMMPS *lmp, std::string command, int narg, char **arg);

  bool done() const { return at >= narg; }
  std::string word();                        // next argument
  double number(const std::string &name);    // next argument as a finite number
  double in_range(const std::string &name, const POTDEM::Range &);
  int whole(const std::string &name, int most);    // 1 to most
  bool logical(const std::string &name);           // yes or no
  int bond_type();
  bool next_is(const std::string &word);    // consume the next argument if it is this word
  void type_ranges(int &ilo, int &ihi, int &jlo, int &jhi);    // I J of pair_coeff
  bool
  next_matches(bool (*rule)(const std::string &)) const;    // the next argument, if there is one
  [[noreturn]] void unknown(const std::string &choices);
  [[noreturn]] void fail(const std::string &text);

 protected:
  std::string command;

 private:
  int narg, at;
  char **arg;
};

}    // namespace LAMMPS_NS

#endif
