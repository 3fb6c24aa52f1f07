/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* A style on several threads: LAMMPS's OPENMP package gives each thread a force array, and each does its share of the work.
   The style offers begin_work(), which says how much there is, share(), work() and end_work(). */

#ifndef LMP_POTDEM_OMP_H
#define LMP_POTDEM_OMP_H

#include "omp_compat.h"

#include "atom.h"
#include "comm.h"
#include "fix_omp.h"
#include "suffix.h"
#include "thr_data.h"
#include "thr_omp.h"

#include <vector>

namespace LAMMPS_NS {

// KIND: Timer::PAIR or Timer::BOND
template <class Style, int KIND> class PotdemOMP : public Style, public ThrOMP {
 public:
  PotdemOMP(LAMMPS *lmp) :
      Style(lmp), ThrOMP(lmp, KIND == Timer::PAIR ? ThrOMP::THR_PAIR : ThrOMP::THR_BOND)
  {
    this->suffix_flag |= Suffix::OMP;
  }

  void compute(int eflag, int vflag) override
  {
    this->ev_init(eflag, vflag);
    const int count = this->begin_work(), nthreads = this->comm->nthreads;
    const int nall = this->atom->nlocal + this->atom->nghost;
    std::vector<typename Style::ThreadShare> shares(nthreads);

#pragma omp parallel default(shared)
    {
      int from, to, tid;
      loop_setup_thr(from, to, tid, count, nthreads);
      ThrData *thread = fix->get_thr(tid);
      thread->timer(Timer::START);
      ev_setup_thr(eflag, vflag, nall, this->eatom, this->vatom, nullptr, thread);
      shares[tid] = Style::share(from, to, thread->get_f(), thread->get_torque(), thread);
      this->work(shares[tid]);
      thread->timer(static_cast<Timer::ttype>(KIND));
      reduce_thr(this, eflag, vflag, thread);
    }
    this->end_work(shares);
  }

  double memory_usage() override
  {
    return Style::memory_usage() + memory_usage_thr();
  }
};

}    // namespace LAMMPS_NS

#endif
