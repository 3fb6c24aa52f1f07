/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The truss on several threads: LAMMPS's OPENMP package gives each thread a force array. */

#ifndef LMP_BOND_POTDEM_TRUSS_OMP_H
#define LMP_BOND_POTDEM_TRUSS_OMP_H

#include "lammps/bond/bond_potdem_truss.h"

#include "thr_omp.h"

namespace LAMMPS_NS {

class BondPotdemTrussOMP : public BondPotdemTruss, public ThrOMP {
 public:
  BondPotdemTrussOMP(class LAMMPS *);
  void compute(int, int) override;
  double memory_usage() override;

 protected:
  void tally(const ThreadShare &, int i, int j, double energy, double push,
             const double *del) override;
};

}    // namespace LAMMPS_NS

#endif
