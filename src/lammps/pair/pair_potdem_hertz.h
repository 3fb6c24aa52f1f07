/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#ifndef LMP_PAIR_POTDEM_HERTZ_H
#define LMP_PAIR_POTDEM_HERTZ_H

#include "core/laws/hertz.h"
#include "lammps/pair/pair_potdem.h"

namespace LAMMPS_NS {

class PairPotdemHertz : public PairPotdem<POTDEM::Hertz> {
 public:
  using PairPotdem::PairPotdem;

 protected:
  const char *name() const override { return "potdem/hertz"; }
  bool read_setting(PotdemInput &) override;
  const char *setting_names() const override { return "rotation or attract"; }
  std::string setting_text() const override { return attract ? " attract yes" : ""; }
  void prepare(POTDEM::Hertz &law) const override { law.attract = attract; }
  void mix(int i, int j) override;

 private:
  int attract = 0;
};

}    // namespace LAMMPS_NS

#endif
