// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include <setsudan/simulation/interruption.h>

#include <csignal>

namespace Setsudan
{
namespace
{
// A signal handler can reach nothing else.
volatile std::sig_atomic_t signal_was_caught = 0;

extern "C" void
note_signal(const int)
{
  signal_was_caught = 1;
}
} // namespace


void
note_interruptions()
{
  struct sigaction action = {};
  action.sa_handler       = note_signal;
  // Behind the first signal the default action is back.
  action.sa_flags = SA_RESETHAND | SA_RESTART;
  for (const int signal : {SIGINT, SIGTERM})
    sigaction(signal, &action, nullptr);
}



bool
interrupted(const MPI_Comm communicator)
{
  const int own = signal_was_caught;
  return dealii::Utilities::MPI::max(own, communicator) == 1;
}
} // namespace Setsudan
