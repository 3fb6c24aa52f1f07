/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* `area body`: hands LAMMPS's particles and the new bonds of one type to core/areas/body_area.h and puts
   the areas into the bonds' memory, and where there is a volume term the bonds' weights in it. */

#ifndef LMP_POTDEM_BODY_AREA_H
#define LMP_POTDEM_BODY_AREA_H

#include "core/areas/body_area.h"

#include "pointers.h"

#include <string>

namespace LAMMPS_NS {

class PotdemBodyArea : protected Pointers {
 public:
  PotdemBodyArea(LAMMPS *, class FixPotdemBondHistory *, const std::string &style);

  // density: V = m/density for each particle; 0: from the cells of the inner particles
  void solve(int type, double density, const POTDEM::Elasticity &);

 private:
  struct Halo : public POTDEM::BodyHalo {
    class FixPotdemBondHistory *store;
    MPI_Comm world;
    void forward(double *, int) override;
    void sum(double *, int) override;
  };

  class FixPotdemBondHistory *history;
  std::string style;
  Halo halo;
  POTDEM::BondedBody body;

  bool collect(int type);
  void give_volumes(double density);
  void keep() const;
  void keep(const POTDEM::BondedBody::Bond &, int end) const;
  void report(const POTDEM::BodyAreaReport &, int type, bigint count, double seconds) const;
};

}    // namespace LAMMPS_NS

#endif
