/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* What ranks that share bonds tell each other, straight and of any length. LAMMPS's own communication has such messages
   only from ghosts to owners, and not with comm_style tiled. */

#ifndef LMP_POTDEM_SWAP_H
#define LMP_POTDEM_SWAP_H

#include <map>
#include <mpi.h>
#include <type_traits>
#include <vector>

namespace LAMMPS_NS {

// each rank here gets what there is for it, and what it has for us takes its place; it has us in its own map
template <class Item> void potdem_swap(MPI_Comm world, std::map<int, std::vector<Item>> &by_rank)
{
  static_assert(std::is_trivially_copyable<Item>::value, "items are sent as bytes");
  static constexpr int TAG = 1;    // none of LAMMPS's
  std::vector<MPI_Request> sent;
  sent.reserve(by_rank.size());
  for (const auto &[rank, items] : by_rank)
    MPI_Isend(items.data(), static_cast<int>(items.size() * sizeof(Item)), MPI_BYTE, rank, TAG,
              world, &sent.emplace_back());
  std::map<int, std::vector<Item>> received;
  for (const auto &[rank, items] : by_rank) {
    MPI_Status status;
    int bytes;
    MPI_Probe(rank, TAG, world, &status);
    MPI_Get_count(&status, MPI_BYTE, &bytes);
    auto &from = received[rank];
    from.resize(bytes / sizeof(Item));
    MPI_Recv(from.data(), bytes, MPI_BYTE, rank, TAG, world, MPI_STATUS_IGNORE);
  }
  MPI_Waitall(static_cast<int>(sent.size()), sent.data(), MPI_STATUSES_IGNORE);
  by_rank.swap(received);
}

}    // namespace LAMMPS_NS

#endif
