/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The pair styles of this package on several threads: LAMMPS's OPENMP package gives each thread a force array. */

#ifndef LMP_PAIR_POTDEM_OMP_H
#define LMP_PAIR_POTDEM_OMP_H

#include "lammps/pair/pair_potdem_granular.h"
#include "lammps/pair/pair_potdem_hertz.h"
#include "lammps/pair/pair_potdem_lj.h"
#include "lammps/pair/pair_potdem_truss.h"

#include "thr_omp.h"

namespace LAMMPS_NS {

template <class Style> class PairPotdemOMP : public Style, public ThrOMP {
 public:
  PairPotdemOMP(class LAMMPS *);
  void compute(int, int) override;
  double memory_usage() override;

 protected:
  using typename Style::ThreadShare;
  void tally(const ThreadShare &, const PotdemTouch &, double energy, const double *f) override;
};

using PairPotdemGranularOMP = PairPotdemOMP<PairPotdemGranular>;
using PairPotdemHertzOMP = PairPotdemOMP<PairPotdemHertz>;
using PairPotdemLJOMP = PairPotdemOMP<PairPotdemLJ>;
using PairPotdemTrussOMP = PairPotdemOMP<PairPotdemTruss>;

}    // namespace LAMMPS_NS

#endif
