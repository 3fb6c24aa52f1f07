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
      const int tid = thread_number(), npieces = PIECES * nthreads;
      ThrData *thread = fix->get_thr(tid);
      thread->timer(Timer::START);
      ev_setup_thr(eflag, vflag, nall, this->eatom, this->vatom, nullptr, thread);
      auto &share = shares[tid];
      share = Style::share(0, 0, thread->get_f(), thread->get_torque(), thread);
      for (int piece = tid; piece < npieces; piece += nthreads) {
        share.from = begin_of(piece, npieces, count);
        share.to = begin_of(piece + 1, npieces, count);
        this->work(share);
      }
      thread->timer(static_cast<Timer::ttype>(KIND));
      reduce_thr(this, eflag, vflag, thread);
    }
    this->end_work(shares);
  }

  double memory_usage() override
  {
    return Style::memory_usage() + memory_usage_thr();
  }

 private:
  // of each thread, taken in turn: particles are sorted by place, and those at the bottom of a heap have most contacts
  static constexpr int PIECES = 8;

  static int begin_of(int piece, int npieces, int count)
  {
    return static_cast<int>(static_cast<bigint>(count) * piece / npieces);
  }
  static int thread_number()
  {
#ifdef _OPENMP
    return omp_get_thread_num();
#else
    return 0;
#endif
  }
};

}    // namespace LAMMPS_NS

#endif
