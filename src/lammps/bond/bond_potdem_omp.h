/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#ifndef LMP_BOND_POTDEM_OMP_H
#define LMP_BOND_POTDEM_OMP_H

#include "lammps/bond/bond_potdem.h"
#include "lammps/glue/potdem_omp.h"

namespace LAMMPS_NS {

template <class Law> class BondPotdemOMP : public PotdemOMP<BondPotdem<Law>, Timer::BOND> {
 public:
  using PotdemOMP<BondPotdem<Law>, Timer::BOND>::PotdemOMP;

 protected:
  using typename BondPotdemBase::ThreadShare;

  void tally(const ThreadShare &share, int i, int j, double energy, double pull,
             const double *del) override
  {
    this->ev_tally_thr(this, i, j, this->atom->nlocal, 0, energy, -pull, del[0], del[1], del[2],
                       share.thread);
  }
};

}    // namespace LAMMPS_NS

#endif
