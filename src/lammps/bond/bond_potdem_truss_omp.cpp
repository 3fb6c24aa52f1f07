/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/bond/bond_potdem_truss_omp.h"

#include "omp_compat.h"

#include "atom.h"
#include "comm.h"
#include "fix_omp.h"
#include "suffix.h"
#include "thr_data.h"

using namespace LAMMPS_NS;

BondPotdemTrussOMP::BondPotdemTrussOMP(LAMMPS *lmp) :
    BondPotdemTruss(lmp), ThrOMP(lmp, ThrOMP::THR_BOND)
{
  suffix_flag |= Suffix::OMP;
}

void BondPotdemTrussOMP::compute(int eflag, int vflag)
{
  ev_init(eflag, vflag);
  refresh();
  const int nall = atom->nlocal + atom->nghost, nthreads = comm->nthreads;
  std::vector<ThreadShare> shares(nthreads);

#pragma omp parallel default(shared)
  {
    int from, to, tid;
    loop_setup_thr(from, to, tid, atom->nlocal, nthreads);
    ThrData *thread = fix->get_thr(tid);
    thread->timer(Timer::START);
    ev_setup_thr(eflag, vflag, nall, eatom, vatom, nullptr, thread);
    shares[tid] = {from, to, thread->get_f(), thread, {}};
    work(shares[tid]);
    thread->timer(Timer::BOND);
    reduce_thr(this, eflag, vflag, thread);
  }
  over.clear();
  for (const auto &share_of_thread : shares) collect(share_of_thread);
}

void BondPotdemTrussOMP::tally(const ThreadShare &share_of_thread, int i, int j, double energy,
                               double push, const double *del)
{
  ev_tally_thr(this, i, j, atom->nlocal, 0, energy, push, del[0], del[1], del[2],
               share_of_thread.thread);
}

double BondPotdemTrussOMP::memory_usage()
{
  return BondPotdemTruss::memory_usage() + memory_usage_thr();
}
