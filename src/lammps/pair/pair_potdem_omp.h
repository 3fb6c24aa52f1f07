/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#ifndef LMP_PAIR_POTDEM_OMP_H
#define LMP_PAIR_POTDEM_OMP_H

#include "lammps/glue/potdem_omp.h"
#include "lammps/pair/pair_potdem.h"

#include "force.h"

namespace LAMMPS_NS {

template <class Law> class PairPotdemOMP : public PotdemOMP<PairPotdem<Law>, Timer::PAIR> {
 public:
  using PotdemOMP<PairPotdem<Law>, Timer::PAIR>::PotdemOMP;

 protected:
  using typename PairPotdemBase::ThreadShare;

  void tally(const ThreadShare &share, int i, int j, const double *del, double energy,
             const double *f) override
  {
    this->ev_tally_xyz_thr(this, i, j, this->atom->nlocal, this->force->newton_pair, energy, 0.0,
                           f[0], f[1], f[2], del[0], del[1], del[2], share.thread);
  }
};

}    // namespace LAMMPS_NS

#endif
