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

template <class Style>
PairPotdemOMP<Style>::PairPotdemOMP(LAMMPS *lmp) : Style(lmp), ThrOMP(lmp, ThrOMP::THR_PAIR)
{
  this->suffix_flag |= Suffix::OMP;
}

template <class Style> void PairPotdemOMP<Style>::compute(int eflag, int vflag)
{
  this->ev_init(eflag, vflag);
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

template <class Style>
void PairPotdemOMP<Style>::tally(const ThreadShare &share_of_thread, const PotdemTouch &touch,
                                 double energy, const double *f)
{
  ev_tally_xyz_thr(this, touch.i, touch.j, this->atom->nlocal, this->force->newton_pair, energy,
                   0.0, f[0], f[1], f[2], touch.del[0], touch.del[1], touch.del[2],
                   share_of_thread.thread);
}

template <class Style> double PairPotdemOMP<Style>::memory_usage()
{
  return Style::memory_usage() + memory_usage_thr();
}

template class PairPotdemOMP<PairPotdemGranular>;
template class PairPotdemOMP<PairPotdemHertz>;
template class PairPotdemOMP<PairPotdemLJ>;
template class PairPotdemOMP<PairPotdemTruss>;

}    // namespace LAMMPS_NS
