/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

// What the ranks of fix potdem/failure tell each other, at sizes that no run of a test reaches.
// Usage: mpirun -np N mpi_gather few | bytes | items     prints 'right' or LAMMPS's error

#include "lammps/glue/potdem_gather.h"

#include "lammps.h"

#include <array>
#include <cstdio>
#include <exception>
#include <string>

using namespace LAMMPS_NS;

using Row = std::array<double, 11>;    // as long as what the fix sends of a failed bond

static bool is(const Row &row, int rank, std::size_t k)
{
  return row.front() == rank && row.back() == static_cast<double>(k);
}

// count[rank] rows of each rank, in the order of the ranks
static bool rows_arrive(LAMMPS &lmp, const std::vector<std::size_t> &count)
{
  const int me = lmp.comm->me;
  std::vector<Row> mine(count[me]);
  for (std::size_t k = 0; k < mine.size(); k++) {
    mine[k].front() = me;
    mine[k].back() = static_cast<double>(k);
  }
  const auto all = potdem_gather(&lmp, mine, "rows");
  std::size_t n = 0;
  for (int rank = 0; rank < lmp.comm->nprocs; rank++)
    for (std::size_t k = 0; k < count[rank]; k++, n++)
      if (n >= all.size() || !is(all[n], rank, k)) return false;
  return n == all.size();
}

static bool run(LAMMPS &lmp, const std::string &what)
{
  const int nprocs = lmp.comm->nprocs;
  std::vector<std::size_t> count(nprocs, 0);
  if (what == "few") {
    bool right = rows_arrive(lmp, count);
    for (int rank = 0; rank < nprocs; rank++) count[rank] = 3 * rank;
    right = rows_arrive(lmp, count) && right;
    count.assign(nprocs, 0);
    count[0] = 5;
    return rows_arrive(lmp, count) && right;
  }
  if (what == "bytes") {    // 2^31 of them, and one row more
    count.assign(nprocs, (std::size_t(1) << 31) / sizeof(Row) / nprocs + 1);
    return rows_arrive(lmp, count);
  }
  std::vector<char> mine((std::size_t(1) << 31) / nprocs);    // one more than an int counts
  potdem_gather(&lmp, mine, "grains of sand");
  return false;
}

int main(int narg, char **arg)
{
  MPI_Init(&narg, &arg);
  int status = 1;
  {
    const char *quiet[] = {"lmp", "-screen", "none", "-log", "none"};
    LAMMPS lmp(5, const_cast<char **>(quiet), MPI_COMM_WORLD);
    std::string text;
    try {
      text = run(lmp, narg > 1 ? arg[1] : "") ? "right" : "wrong";
    } catch (const std::exception &reason) {
      text = reason.what();
    }
    status = text == "wrong";
    printf("rank %d: %s\n", lmp.comm->me, text.c_str());
  }
  MPI_Finalize();
  return status;
}
