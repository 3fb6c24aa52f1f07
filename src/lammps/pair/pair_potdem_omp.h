/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The pair styles of this package on several threads: LAMMPS's OPENMP package gives each thread a force array. */

#ifndef LMP_PAIR_POTDEM_OMP_H
#define LMP_PAIR_POTDEM_OMP_H

#include "lammps/pair/pair_potdem.h"

#include "thr_omp.h"

namespace LAMMPS_NS {

template <class Law> class PairPotdemOMP : public PairPotdem<Law>, public ThrOMP {
 public:
  PairPotdemOMP(class LAMMPS *);
  void compute(int, int) override;
  double memory_usage() override;

 protected:
  using typename PairPotdemBase::ThreadShare;
  void tally(const ThreadShare &, int i, int j, const double *del, double energy,
             const double *f) override;
};

}    // namespace LAMMPS_NS

#endif
