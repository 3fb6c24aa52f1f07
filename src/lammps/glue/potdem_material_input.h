/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Reading arguments for which a material may stand (docs/materials.md): 'FILE.potdem MATERIAL' in place of E, of E nu, and
   with 'length L' of a stiffness K0. */

#ifndef LMP_POTDEM_MATERIAL_INPUT_H
#define LMP_POTDEM_MATERIAL_INPUT_H

#include "lammps/glue/potdem_input.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace LAMMPS_NS {

class PotdemMaterialFile;

class PotdemMaterialInput : public PotdemInput {
 public:
  using PotdemInput::PotdemInput;

  // properties of a material (PotdemProperty): numbers in this order, or 'FILE.potdem MATERIAL'
  std::vector<double> properties(const std::vector<const char *> &names,
                                 const std::string &owner = "");
  double property(const char *name) { return properties({name}).front(); }
  double stiffness(const std::string &name);    // a number, or 'FILE.potdem MATERIAL length L'
  double friction_mu();    // mu, a material, or 'file': that of the materials of this command

 private:
  std::vector<std::pair<std::shared_ptr<PotdemMaterialFile>, std::string>> materials;    // so far

  std::vector<double> of_material(const std::vector<const char *> &names);
  double friction_of_materials();
};

}    // namespace LAMMPS_NS

#endif
