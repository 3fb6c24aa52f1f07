/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Material files (docs/materials.md): which properties a material may have, and the files *.potdem that give them.

     # DATE: 2026-11-24 UNITS: si
     material concrete
     E        3e10
     density  2300

   LAMMPS's own reader of potential files knows only how to convert metal and real units, and reads on without
   UNITS; here the mechanical unit systems are converted, and a file without UNITS is refused. */

#ifndef LMP_POTDEM_MATERIAL_FILE_H
#define LMP_POTDEM_MATERIAL_FILE_H

#include "lammps/glue/potdem_input.h"

#include <map>
#include <string>
#include <vector>

namespace LAMMPS_NS {

struct PotdemProperty {
  enum Dimension { NONE, STRESS, DENSITY };

  const char *name;     // in a file
  const char *label;    // in error messages
  Dimension dimension;
  POTDEM::Range range;

  static const PotdemProperty *find(const std::string &name);    // null: there is no such property
  static std::string names();
};

class PotdemMaterialFile : protected Pointers {
 public:
  // whether a word stands for a material file
  static bool is(const std::string &word);

  // asking: whose argument the file is, for the errors
  PotdemMaterialFile(LAMMPS *, PotdemInput &asking, const std::string &name);

  // in the units of the script; error if there is no such material or it does not have it
  double value(PotdemInput &asking, const std::string &material, const std::string &property) const;

  // materials that stand for the atom types, in order; error if they are not as many, or not there
  void check_list(PotdemInput &asking, const std::vector<std::string> &words) const;

  std::string title() const;    // with its date, and its units if they are not those of the script

 private:
  std::string name, date, converted;
  std::map<std::string, std::map<std::string, double>> materials;    // name, properties

  std::string read(PotdemInput &asking);
  void check_whole(PotdemInput &asking, const std::string &text) const;
  std::string checked(std::string line, int number) const;
  PotdemInput at(int number, const std::string &current, PotdemWords &words) const;
  void parse(const std::vector<std::string> &line, int number, std::string &current);
  void convert(PotdemInput &asking, const std::string &units);
  std::string no_material(const std::string &material) const;
};

}    // namespace LAMMPS_NS

#endif
