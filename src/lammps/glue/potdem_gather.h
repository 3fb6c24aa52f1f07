/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#ifndef LMP_POTDEM_GATHER_H
#define LMP_POTDEM_GATHER_H

#include "comm.h"
#include "error.h"
#include "lammps.h"

#include <mpi.h>
#include <type_traits>
#include <vector>

namespace LAMMPS_NS {

// every rank gets what the others have, in the order of the ranks; counted in items, not in bytes, which
// an int may not hold
template <class Item>
std::vector<Item> potdem_gather(LAMMPS *lmp, const std::vector<Item> &mine,
                                const char *items = "items")
{
  static_assert(std::is_trivially_copyable<Item>::value, "items are sent as bytes");
  const int nprocs = lmp->comm->nprocs;
  if (nprocs == 1) return mine;
  bigint count = mine.size(), total;
  MPI_Allreduce(&count, &total, 1, MPI_LMP_BIGINT, MPI_SUM, lmp->world);
  if (total > MAXSMALLINT)
    lmp->error->all(
        FLERR,
        "{} {} in one step are more than the {} that processors can tell each other at once: use "
        "a shorter timestep, or less of the body in one simulation",
        total, items, MAXSMALLINT);
  std::vector<Item> all(total);
  if (total == 0) return all;
  std::vector<int> counts(nprocs), starts(nprocs, 0);
  const int here = static_cast<int>(count);
  MPI_Allgather(&here, 1, MPI_INT, counts.data(), 1, MPI_INT, lmp->world);
  for (int rank = 1; rank < nprocs; rank++) starts[rank] = starts[rank - 1] + counts[rank - 1];
  MPI_Datatype type;
  MPI_Type_contiguous(sizeof(Item), MPI_BYTE, &type);
  MPI_Type_commit(&type);
  MPI_Allgatherv(mine.data(), here, type, all.data(), counts.data(), starts.data(), type,
                 lmp->world);
  MPI_Type_free(&type);
  return all;
}

}    // namespace LAMMPS_NS

#endif
