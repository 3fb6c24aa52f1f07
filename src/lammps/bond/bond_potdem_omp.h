/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The bond styles on several threads: LAMMPS's OPENMP package gives each thread a force array. */

#ifndef LMP_BOND_POTDEM_OMP_H
#define LMP_BOND_POTDEM_OMP_H

#include "lammps/bond/bond_potdem.h"

#include "thr_omp.h"

namespace LAMMPS_NS {

template <class Law> class BondPotdemOMP : public BondPotdem<Law>, public ThrOMP {
 public:
  BondPotdemOMP(class LAMMPS *);
  void compute(int, int) override;
  double memory_usage() override;

 protected:
  using typename BondPotdemBase::ThreadShare;
  void tally(const ThreadShare &, int i, int j, double energy, double push,
             const double *del) override;
};

}    // namespace LAMMPS_NS

#endif
