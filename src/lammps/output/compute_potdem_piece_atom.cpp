/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The piece of a particle: what is connected with it by live bonds, named by its lowest ID. Each rank first
   unites what hangs together by its own bonds (union-find, once); then whole parts exchange their lowest
   IDs over the ghosts they reach, until none is lowered. So the number of exchanges grows with the rank
   boundaries between a particle and the one of lowest ID, not with the length of a chain. */

#include "lammps/output/compute_potdem_piece_atom.h"

#include "lammps/glue/find_styles.h"
#include "lammps/glue/fix_potdem_bond_history.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "memory.h"
#include "update.h"

#include <algorithm>
#include <numeric>
#include <utility>

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

ComputePotdemPieceAtom::ComputePotdemPieceAtom(LAMMPS *lmp, int narg, char **arg) :
    Compute(lmp, narg, arg), nmax(0), piece(nullptr), lowered(false)
{
  if (narg > 3)
    error->all(FLERR, "compute potdem/piece/atom: unknown keyword '{}', it takes none", arg[3]);
  // the bond style makes the memory when the first run begins
  if (!FixPotdemBondHistory::find(lmp) && potdem_find<BondMemory>(lmp).empty())
    error->all(FLERR,
               "compute potdem/piece/atom {} finds no memory of bonds: define it after bond_style "
               "potdem/truss or potdem_bonds",
               id);
  peratom_flag = scalar_flag = 1;
  size_peratom_cols = 0;
  extscalar = 0;
  comm_forward = 1;
}

ComputePotdemPieceAtom::~ComputePotdemPieceAtom()
{
  memory->destroy(piece);
}

FixPotdemBondHistory *ComputePotdemPieceAtom::history() const
{
  return FixPotdemBondHistory::get(lmp, fmt::format("compute potdem/piece/atom {}", id));
}

void ComputePotdemPieceAtom::init()
{
  history();
}

/* ---------------------------------------------------------------------- */

double ComputePotdemPieceAtom::compute_scalar()
{
  if (invoked_peratom != update->ntimestep) compute_peratom();
  invoked_scalar = update->ntimestep;
  bigint mine = 0, all;
  for (int i = 0; i < atom->nlocal; i++)
    if ((atom->mask[i] & groupbit) && piece[i] == static_cast<double>(atom->tag[i])) mine++;
  MPI_Allreduce(&mine, &all, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  return scalar = static_cast<double>(all);
}

void ComputePotdemPieceAtom::compute_peratom()
{
  invoked_peratom = update->ntimestep;
  if (atom->nmax > nmax) {
    nmax = atom->nmax;
    memory->destroy(piece);
    memory->create(piece, nmax, "potdem/piece/atom:piece");
    vector_atom = piece;
  }
  start();
  unite_bonded();
  do {
    lowered = false;
    comm->forward_comm(this);
  } while (lowered_anywhere());
  for (int i = 0; i < atom->nlocal; i++) piece[i] = static_cast<double>(lowest[root[i]]);
}

/* ----------------------------------------------------------------------
   each particle alone. Ghosts hear from their owners whether they are in the group: in a dynamic group
   their own masks are old
------------------------------------------------------------------------- */

void ComputePotdemPieceAtom::start()
{
  const int nlocal = atom->nlocal, nall = nlocal + atom->nghost;
  root.resize(nall);
  std::iota(root.begin(), root.end(), 0);
  lowest.assign(nall, MAXTAGINT);
  for (int i = 0; i < nlocal; i++) lowest[i] = (atom->mask[i] & groupbit) ? atom->tag[i] : 0;
  comm->forward_comm(this);
}

/* ----------------------------------------------------------------------
   both ends have the bond: that of lower index unites. One image of a ghost is enough, what it hears from
   its owner does not depend on the place. Index -1: the partner was lost
------------------------------------------------------------------------- */

void ComputePotdemPieceAtom::unite_bonded()
{
  const auto *const store = history();
  for (int i = 0; i < atom->nlocal; i++) {
    if (lowest[i] == 0) continue;
    for (int m = 0; m < atom->num_bond[i]; m++) {
      const int j = atom->map(atom->bond_atom[i][m]);
      if (j > i && atom->bond_type[i][m] > 0 && store->length(i, m) > 0.0 && lowest[j] != 0)
        unite(i, j);
    }
  }
  for (int &r : root) r = root[r];
}

void ComputePotdemPieceAtom::unite(int i, int j)
{
  i = root_of(i);
  j = root_of(j);
  if (i == j) return;
  if (i > j) std::swap(i, j);
  root[j] = i;
  lowest[i] = MIN(lowest[i], lowest[j]);
}

int ComputePotdemPieceAtom::root_of(int i)
{
  while (root[i] != i) i = root[i] = root[root[i]];
  return i;
}

bool ComputePotdemPieceAtom::lowered_anywhere()
{
  const int mine = lowered ? 1 : 0;
  int any;
  MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, world);
  return any;
}

/* ---------------------------------------------------------------------- */

int ComputePotdemPieceAtom::pack_forward_comm(int n, int *list, double *buf, int /*pbc_flag*/,
                                              int * /*pbc*/)
{
  for (int k = 0; k < n; k++) buf[k] = ubuf(lowest[root[list[k]]]).d;
  return n;
}

/* ----------------------------------------------------------------------
   what a ghost hears is true of its whole part; only parts with own particles, which have such a root,
   have anything to pass on
------------------------------------------------------------------------- */

void ComputePotdemPieceAtom::unpack_forward_comm(int n, int first, double *buf)
{
  for (int k = 0; k < n; k++) {
    const auto heard = static_cast<tagint>(ubuf(buf[k]).i);
    const int r = root[first + k];
    if (heard >= lowest[r]) continue;
    lowest[r] = heard;
    if (r < atom->nlocal) lowered = true;
  }
}

double ComputePotdemPieceAtom::memory_usage()
{
  return static_cast<double>(nmax) * sizeof(double) +
      static_cast<double>(root.capacity()) * (sizeof(int) + sizeof(tagint));
}
