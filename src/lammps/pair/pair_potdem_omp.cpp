/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/pair/pair_potdem_omp.h"

#include "omp_compat.h"

#include "atom.h"
#include "comm.h"
#include "fix_omp.h"
#include "force.h"
#include "neigh_list.h"
#include "suffix.h"
#include "thr_data.h"

#include <vector>

namespace LAMMPS_NS {

template <class Law>
PairPotdemOMP<Law>::PairPotdemOMP(LAMMPS *lmp) : PairPotdem<Law>(lmp), ThrOMP(lmp, ThrOMP::THR_PAIR)
{
  this->suffix_flag |= Suffix::OMP;
}

template <class Law> void PairPotdemOMP<Law>::compute(int eflag, int vflag)
{
  this->ev_init(eflag, vflag);
  this->prepare_work();
  const int nall = this->atom->nlocal + this->atom->nghost;
  const int nthreads = this->comm->nthreads, inum = this->list->inum;
  std::vector<ThreadShare> shares(nthreads);

#pragma omp parallel default(shared)
  {
    int from, to, tid;
    loop_setup_thr(from, to, tid, inum, nthreads);
    ThrData *thread = fix->get_thr(tid);
    thread->timer(Timer::START);
    ev_setup_thr(eflag, vflag, nall, this->eatom, this->vatom, nullptr, thread);
    shares[tid] = {from, to, thread->get_f(), thread->get_torque(), thread};
    this->work(shares[tid]);
    thread->timer(Timer::PAIR);
    reduce_thr(this, eflag, vflag, thread);
  }
  for (const auto &share_of_thread : shares) this->report(share_of_thread);
}

template <class Law>
void PairPotdemOMP<Law>::tally(const ThreadShare &share, int i, int j, const double *del,
                               double energy, const double *f)
{
  ev_tally_xyz_thr(this, i, j, this->atom->nlocal, this->force->newton_pair, energy, 0.0, f[0],
                   f[1], f[2], del[0], del[1], del[2], share.thread);
}

template <class Law> double PairPotdemOMP<Law>::memory_usage()
{
  return PairPotdem<Law>::memory_usage() + memory_usage_thr();
}

#define POTDEM_STYLE_OF_LAW(name, Law) template class PairPotdemOMP<POTDEM::Law>;
CONTACT_LAWS(POTDEM_STYLE_OF_LAW)

}    // namespace LAMMPS_NS
