/* POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2 */

/* Loaded before MPI's library: counts the calls in which all ranks take part, and says at the end how many there were. */

#include <mpi.h>
#include <stdio.h>

static int calls = 0;

int MPI_Allreduce(const void *send, void *recv, int n, MPI_Datatype type, MPI_Op op, MPI_Comm comm)
{
  calls++;
  return PMPI_Allreduce(send, recv, n, type, op, comm);
}

int MPI_Allgather(const void *send, int nsend, MPI_Datatype sent, void *recv, int nrecv, MPI_Datatype received, MPI_Comm comm)
{
  calls++;
  return PMPI_Allgather(send, nsend, sent, recv, nrecv, received, comm);
}

int MPI_Bcast(void *buffer, int n, MPI_Datatype type, int root, MPI_Comm comm)
{
  calls++;
  return PMPI_Bcast(buffer, n, type, root, comm);
}

int MPI_Reduce(const void *send, void *recv, int n, MPI_Datatype type, MPI_Op op, int root, MPI_Comm comm)
{
  calls++;
  return PMPI_Reduce(send, recv, n, type, op, root, comm);
}

int MPI_Barrier(MPI_Comm comm)
{
  calls++;
  return PMPI_Barrier(comm);
}

int MPI_Finalize(void)
{
  int rank;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank == 0) printf("global calls: %d\n", calls);
  fflush(stdout);
  return PMPI_Finalize();
}
