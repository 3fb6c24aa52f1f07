/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Counts what a rank sends, by MPI's own profiling interface: loaded before MPI (LD_PRELOAD), it stands between LAMMPS and it. At the
   end each rank prints "MESSAGES sent bytes collective", the last of calls in which all ranks take part. bench/cluster.py and
   unittest/python/test_global_calls.py compile and use it. */

#include <mpi.h>
#include <stdio.h>

static long long sent, bytes, collective;

static void count(int n, MPI_Datatype type)
{
  int size;
  PMPI_Type_size(type, &size);
  sent++;
  bytes += (long long) n * size;
}

int MPI_Send(const void *data, int n, MPI_Datatype type, int to, int tag, MPI_Comm comm)
{
  count(n, type);
  return PMPI_Send(data, n, type, to, tag, comm);
}

int MPI_Isend(const void *data, int n, MPI_Datatype type, int to, int tag, MPI_Comm comm,
              MPI_Request *request)
{
  count(n, type);
  return PMPI_Isend(data, n, type, to, tag, comm, request);
}

int MPI_Sendrecv(const void *data, int n, MPI_Datatype type, int to, int tag, void *received,
                 int most, MPI_Datatype their_type, int from, int their_tag, MPI_Comm comm,
                 MPI_Status *status)
{
  count(n, type);
  return PMPI_Sendrecv(data, n, type, to, tag, received, most, their_type, from, their_tag, comm,
                       status);
}

int MPI_Allreduce(const void *data, void *result, int n, MPI_Datatype type, MPI_Op op,
                  MPI_Comm comm)
{
  collective++;
  return PMPI_Allreduce(data, result, n, type, op, comm);
}

int MPI_Allgather(const void *data, int n, MPI_Datatype type, void *all, int each,
                  MPI_Datatype their_type, MPI_Comm comm)
{
  collective++;
  return PMPI_Allgather(data, n, type, all, each, their_type, comm);
}

int MPI_Bcast(void *data, int n, MPI_Datatype type, int root, MPI_Comm comm)
{
  collective++;
  return PMPI_Bcast(data, n, type, root, comm);
}

int MPI_Reduce(const void *data, void *result, int n, MPI_Datatype type, MPI_Op op, int root,
               MPI_Comm comm)
{
  collective++;
  return PMPI_Reduce(data, result, n, type, op, root, comm);
}

int MPI_Barrier(MPI_Comm comm)
{
  collective++;
  return PMPI_Barrier(comm);
}

int MPI_Finalize(void)
{
  printf("MESSAGES %lld %lld %lld\n", sent, bytes, collective);
  fflush(stdout);
  return PMPI_Finalize();
}
