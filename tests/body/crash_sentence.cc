// Where a library crashes the program ends with a sentence.

#include <setsudan/body/crash_sentence.h>

#include <csignal>
#include <cstdlib>
#include <functional>
#include <string>

#include <sys/wait.h>
#include <unistd.h>

#include "../test_setup.h"

using namespace Setsudan;

/** Print how a process ends that does this, and what it says. */
void
report(const std::string &name, const std::function<void()> &crash)
{
  int ends[2];
  if (pipe(ends) != 0)
    throw std::runtime_error("no pipe");
  const pid_t child = fork();
  if (child == 0)
    {
      dup2(ends[1], STDERR_FILENO);
      crash();
      _exit(0);
    }
  close(ends[1]);
  std::string said;
  char buffer[256];
  for (ssize_t n = 0; (n = read(ends[0], buffer, sizeof(buffer))) > 0;)
    said.append(buffer, n);
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  std::cout << name << ": ";
  if (WIFEXITED(status))
    std::cout << "status " << WEXITSTATUS(status);
  else
    std::cout << "signal " << WTERMSIG(status);
  std::cout << (said.empty() ? "" : ", ") << said.substr(0, said.find('\n'))
            << std::endl;
}


volatile int depth_wanted = 1 << 30;

int
deeper(const int depth)
{
  volatile char room[4096];
  room[0] = static_cast<char>(depth);
  return depth < depth_wanted ? deeper(depth + 1) + room[0] : 0;
}


void
test()
{
  const std::string sentence = "The library crashes on this file.";
  report("segmentation fault", [&]() {
    const CrashSentence words(sentence);
    std::raise(SIGSEGV);
  });
  report("abort", [&]() {
    const CrashSentence words(sentence);
    std::abort();
  });
  report("overflow of the stack", [&]() {
    const CrashSentence words(sentence);
    deeper(0);
  });
  report("no crash", [&]() { const CrashSentence words(sentence); });
  report("a crash afterwards", [&]() {
    std::signal(SIGSEGV, SIG_DFL);
    {
      const CrashSentence words(sentence);
    }
    std::raise(SIGSEGV);
  });
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, test);
}
