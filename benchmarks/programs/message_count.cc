// SPDX-License-Identifier: LGPL-2.1-or-later
#include "message_count.h"

#include <mpi.h>

namespace
{
MessageCount count;


/** Let a message of some entries count. */
void
include_message(const int n, MPI_Datatype type)
{
  int size = 0;
  MPI_Type_size(type, &size);
  ++count.messages;
  count.bytes += double(n) * size;
}
} // namespace


const MessageCount &
message_count()
{
  return count;
}


// The linker prefers these to the MPI library's, which are reached by the names
// that its profiling interface has for them.
extern "C"
{
#define SETSUDAN_COUNT_SEND(NAME)                             \
  int MPI_##NAME(const void *data,                            \
                 int n,                                       \
                 MPI_Datatype type,                           \
                 int to,                                      \
                 int tag,                                     \
                 MPI_Comm communicator)                       \
  {                                                           \
    include_message(n, type);                                 \
    return PMPI_##NAME(data, n, type, to, tag, communicator); \
  }

#define SETSUDAN_COUNT_START(NAME)                                     \
  int MPI_##NAME(const void *data,                                     \
                 int n,                                                \
                 MPI_Datatype type,                                    \
                 int to,                                               \
                 int tag,                                              \
                 MPI_Comm communicator,                                \
                 MPI_Request *request)                                 \
  {                                                                    \
    include_message(n, type);                                          \
    return PMPI_##NAME(data, n, type, to, tag, communicator, request); \
  }

  SETSUDAN_COUNT_SEND(Send)
  SETSUDAN_COUNT_SEND(Rsend)
  SETSUDAN_COUNT_SEND(Ssend)
  SETSUDAN_COUNT_START(Isend)
  SETSUDAN_COUNT_START(Irsend)
  SETSUDAN_COUNT_START(Issend)

  int
  MPI_Allreduce(const void *own,
                void *all,
                int n,
                MPI_Datatype type,
                MPI_Op operation,
                MPI_Comm communicator)
  {
    ++count.collectives;
    return PMPI_Allreduce(own, all, n, type, operation, communicator);
  }

  int
  MPI_Bcast(void *data,
            int n,
            MPI_Datatype type,
            int root,
            MPI_Comm communicator)
  {
    ++count.collectives;
    return PMPI_Bcast(data, n, type, root, communicator);
  }

  int
  MPI_Reduce(const void *own,
             void *all,
             int n,
             MPI_Datatype type,
             MPI_Op operation,
             int root,
             MPI_Comm communicator)
  {
    ++count.collectives;
    return PMPI_Reduce(own, all, n, type, operation, root, communicator);
  }

  int
  MPI_Allgather(const void *own,
                int n,
                MPI_Datatype type,
                void *all,
                int n_all,
                MPI_Datatype type_of_all,
                MPI_Comm communicator)
  {
    ++count.collectives;
    return PMPI_Allgather(own, n, type, all, n_all, type_of_all, communicator);
  }

  int
  MPI_Barrier(MPI_Comm communicator)
  {
    ++count.collectives;
    return PMPI_Barrier(communicator);
  }
}
