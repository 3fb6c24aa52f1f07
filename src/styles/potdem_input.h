/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Reading the arguments that several styles share, each value checked against its range. */

#ifndef LMP_POTDEM_INPUT_H
#define LMP_POTDEM_INPUT_H

#include "laws/friction.h"

#include "pointers.h"

#include <string>

namespace LAMMPS_NS {

class PotdemInput : protected Pointers {
 public:
  // command: how the errors name the place, e.g. "fix potdem/damping"
  PotdemInput(LAMMPS *lmp, std::string command, int narg, char **arg);

  bool done() const { return at >= narg; }
  std::string word();                          // next argument
  double number(const std::string &name);      // next argument as a finite number
  double positive(const std::string &name);
  double nonnegative(const std::string &name);
  double poisson(const std::string &name);     // -1 < nu <= 0.5
  int exponent(const std::string &name);       // 1 to 64
  bool logical(const std::string &name);
  bool next_is(const std::string &word);       // consume the next argument if it is this word
  POTDEM::Friction friction();                 // the values after 'friction': mu eta|auto
  [[noreturn]] void unknown(const std::string &choices);
  [[noreturn]] void fail(const std::string &text);

 private:
  std::string command;
  int narg, at;
  char **arg;

  [[noreturn]] void range(const std::string &name, double value, const std::string &allowed);
};

}    // namespace LAMMPS_NS

#endif
