// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/body/gmsh/child_process.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <new>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

namespace Setsudan
{
namespace
{
/** Exit statuses of a child; with the first two all that it says is whole. */
enum Status
{
  has_result = 100,
  has_thrown,
  lacks_memory,
  is_cut_off,
  called_exit
};

[[noreturn]] void
throw_system_error(const std::string &what)
{
  throw std::runtime_error(what + ": " + std::strerror(errno));
}

/** Let the system end this process by SIGALRM. */
void
set_timer(const double time_limit)
{
  // More than a timer can be set to is never reached.
  const double seconds = std::min(time_limit, 1e9), whole = std::floor(seconds);
  const itimerval timer = {
    {0, 0}, {time_t(whole), suseconds_t(1 + 999998 * (seconds - whole))}};
  setitimer(ITIMER_REAL, &timer, nullptr);
}

/** Leave behind what the parent has set up for itself. */
void
become_child(const pid_t parent)
{
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  // The parent may have ended before that.
  if (getppid() != parent)
    _exit(is_cut_off);
  const int nothing = open("/dev/null", O_RDWR);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    dup2(nothing, stream);
  // MPI reports crashes.
  for (const int end : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGALRM})
    std::signal(end, SIG_DFL);
  // What was registered last is called first: nothing of the parent's is.
  std::atexit([]() { _exit(called_exit); });
}

bool
write_all(const int file, const std::string &text)
{
  std::size_t n_written = 0;
  while (n_written < text.size())
    {
      const ssize_t n =
        write(file, text.data() + n_written, text.size() - n_written);
      if (n < 0 && errno != EINTR)
        return false;
      n_written += std::max<ssize_t>(n, 0);
    }
  return true;
}

/** Write what comes of some work. */
Status
answer(const std::function<std::string()> &work, const int file)
{
  std::string text;
  Status status = has_result;
  try
    {
      text = work();
    }
  catch (const std::bad_alloc &)
    {
      return lacks_memory;
    }
  catch (const std::exception &exception)
    {
      text   = exception.what();
      status = has_thrown;
    }
  return write_all(file, text) ? status : is_cut_off;
}

/** All that is written to a pipe until its other end is closed. */
std::string
read_all(const int file)
{
  std::string text;
  std::array<char, 1 << 16> buffer;
  ssize_t n = 0;
  while ((n = read(file, buffer.data(), buffer.size())) > 0 ||
         (n < 0 && errno == EINTR))
    text.append(buffer.data(), std::max<ssize_t>(n, 0));
  return text;
}
} // namespace


ChildFailure::ChildFailure(const Reason reason,
                           const int signal_number,
                           const std::string &message)
  : std::runtime_error(message)
  , reason(reason)
  , signal_number(signal_number)
{
}



std::string
run_in_child(const std::function<std::string()> &work, const double time_limit)
{
  std::array<int, 2> ends;
  if (pipe(ends.data()) != 0)
    throw_system_error("there is no pipe to another process");
  // What is in the buffers would be written twice.
  std::cout.flush();
  std::fflush(nullptr);
  const pid_t parent = getpid(), child = fork();
  if (child == 0)
    {
      become_child(parent);
      set_timer(time_limit);
      _exit(answer(work, ends[1]));
    }
  close(ends[1]);
  if (child < 0)
    throw_system_error("no other process can be started");
  std::string text = read_all(ends[0]);
  close(ends[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR)
    {
    }
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM)
    throw ChildFailure(ChildFailure::Reason::time_limit);
  if (WIFSIGNALED(status))
    throw ChildFailure(ChildFailure::Reason::signal, WTERMSIG(status));
  if (WEXITSTATUS(status) == lacks_memory)
    throw std::bad_alloc();
  if (WEXITSTATUS(status) == has_thrown)
    throw ChildFailure(ChildFailure::Reason::exception, 0, text);
  if (WEXITSTATUS(status) != has_result)
    throw ChildFailure(ChildFailure::Reason::exit);
  return text;
}
} // namespace Setsudan
