/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/bond/bond_potdem_omp.h"

#include "omp_compat.h"

#include "atom.h"
#include "comm.h"
#include "fix_omp.h"
#include "suffix.h"
#include "thr_data.h"

using namespace LAMMPS_NS;

template <class Law>
BondPotdemOMP<Law>::BondPotdemOMP(LAMMPS *lmp) : BondPotdem<Law>(lmp), ThrOMP(lmp, ThrOMP::THR_BOND)
{
  this->suffix_flag |= Suffix::OMP;
}

template <class Law> void BondPotdemOMP<Law>::compute(int eflag, int vflag)
{
  this->ev_init(eflag, vflag);
  this->follow_lists();
  const int nlocal = this->atom->nlocal, nall = nlocal + this->atom->nghost;
  const int nthreads = this->comm->nthreads;
  std::vector<ThreadShare> shares(nthreads);

#pragma omp parallel default(shared)
  {
    int from, to, tid;
    loop_setup_thr(from, to, tid, nlocal, nthreads);
    ThrData *thread = fix->get_thr(tid);
    thread->timer(Timer::START);
    ev_setup_thr(eflag, vflag, nall, this->eatom, this->vatom, nullptr, thread);
    shares[tid] = {from, to, thread->get_f(), thread, {}};
    this->work(shares[tid]);
    thread->timer(Timer::BOND);
    reduce_thr(this, eflag, vflag, thread);
  }
  this->over.clear();
  for (const auto &share : shares) this->collect(share);
  this->bonds.state_changes();
}

template <class Law>
void BondPotdemOMP<Law>::tally(const ThreadShare &share, int i, int j, double energy, double push,
                               const double *del)
{
  ev_tally_thr(this, i, j, this->atom->nlocal, 0, energy, push, del[0], del[1], del[2],
               share.thread);
}

template <class Law> double BondPotdemOMP<Law>::memory_usage()
{
  return BondPotdem<Law>::memory_usage() + memory_usage_thr();
}

#define POTDEM_INSTANTIATE(name, Law) template class LAMMPS_NS::BondPotdemOMP<POTDEM::Law>;
BOND_LAWS(POTDEM_INSTANTIATE)
