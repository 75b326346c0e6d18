// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/body/gmsh/child_process.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <new>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace Setsudan
{
namespace
{
/** The first characters of a child's messages. */
constexpr char result_mark = 'r';
constexpr char error_mark  = 'e';
constexpr char memory_mark = 'm';

/** Exit statuses of a child. With 0 the message is whole. */
constexpr int has_answered = 0;
constexpr int is_cut_off   = 100;
constexpr int called_exit  = 101;

[[noreturn]] void
throw_system_error(const std::string &what)
{
  throw std::runtime_error(what + ": " + std::strerror(errno));
}

std::string
message_of(const std::function<std::string()> &work)
{
  try
    {
      return result_mark + work();
    }
  catch (const std::bad_alloc &)
    {
      return std::string(1, memory_mark);
    }
  catch (const std::exception &exception)
    {
      return error_mark + std::string(exception.what());
    }
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
  for (const int crash : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT})
    std::signal(crash, SIG_DFL);
  // What was registered last is called first: nothing of the parent's is.
  std::atexit([]() { _exit(called_exit); });
}

/** The child as its parent sees it, which ends it at the latest with itself. */
class Child
{
public:
  explicit Child(const std::function<std::string()> &work)
  {
    std::array<int, 2> ends;
    if (pipe(ends.data()) != 0)
      throw_system_error("there is no pipe to another process");
    // What is in the buffers would be written twice.
    std::cout.flush();
    std::fflush(nullptr);
    const pid_t parent = getpid();
    pid                = fork();
    if (pid == 0)
      {
        become_child(parent);
        close(ends[0]);
        _exit(write_all(ends[1], message_of(work)) ? has_answered : is_cut_off);
      }
    close(ends[1]);
    pipe_end = ends[0];
    if (pid < 0)
      {
        close(pipe_end);
        throw_system_error("no other process can be started");
      }
  }

  Child(const Child &) = delete;

  ~Child()
  {
    if (pid > 0)
      {
        kill(pid, SIGKILL);
        wait();
      }
    close(pipe_end);
  }

  /** All that it writes until it ends. */
  std::string
  read(const double time_limit)
  {
    using Clock      = std::chrono::steady_clock;
    using Seconds    = std::chrono::duration<double>;
    const auto begin = Clock::now();
    std::string text;
    std::array<char, 1 << 16> buffer;
    while (true)
      {
        const double rest = time_limit - Seconds(Clock::now() - begin).count();
        if (rest <= 0)
          throw ChildFailure(ChildFailure::Reason::time_limit);
        // It waits a second at most, so that no limit is too long for it.
        pollfd end        = {pipe_end, POLLIN, 0};
        const int timeout = std::min(1000., 1 + 1000 * rest);
        if (poll(&end, 1, timeout) <= 0)
          continue;
        const ssize_t n = ::read(pipe_end, buffer.data(), buffer.size());
        if (n == 0)
          return text;
        text.append(buffer.data(), std::max<ssize_t>(n, 0));
      }
  }

  /** Its status. */
  int
  wait()
  {
    int status = 0;
    while (waitpid(pid, &status, 0) < 0 && errno == EINTR)
      {
      }
    pid = 0;
    return status;
  }

private:
  pid_t pid;
  int pipe_end;
};
} // namespace


ChildFailure::ChildFailure(const Reason reason, const int signal_number)
  : std::runtime_error("a child process has ended without a result")
  , reason(reason)
  , signal_number(signal_number)
{
}



std::string
run_in_child(const std::function<std::string()> &work, const double time_limit)
{
  Child child(work);
  // It can only end when it has written all.
  std::string message = child.read(time_limit);
  const int status    = child.wait();
  if (WIFSIGNALED(status))
    throw ChildFailure(ChildFailure::Reason::signal, WTERMSIG(status));
  if (WEXITSTATUS(status) != has_answered || message.empty())
    throw ChildFailure(ChildFailure::Reason::exit);
  const char kind = message[0];
  message.erase(0, 1);
  if (kind == memory_mark)
    throw std::bad_alloc();
  if (kind == error_mark)
    throw std::runtime_error(message);
  return message;
}
} // namespace Setsudan
