// SPDX-License-Identifier: LGPL-2.1-or-later
// Work in a child process: what it hands back, and how it can end without.

#include <setsudan/body/gmsh/child_process.h>

#include <csignal>
#include <cstdlib>
#include <functional>
#include <limits>
#include <new>
#include <string>

#include <unistd.h>

#include "../test_setup.h"

using namespace Setsudan;

/** Print what comes of some work. */
void
report(const std::string &name,
       const std::function<std::string()> &work,
       const double time_limit = std::numeric_limits<double>::infinity())
{
  std::cout << name << ": ";
  try
    {
      const std::string result = run_in_child(work, time_limit);
      if (result.size() < 100)
        std::cout << "'" << result << "'" << std::endl;
      else
        std::cout << result.size() << " characters, the last one is "
                  << result.back() << std::endl;
    }
  catch (const ChildFailure &failure)
    {
      if (failure.reason == ChildFailure::Reason::exception)
        std::cout << "error '" << failure.what() << "'" << std::endl;
      else if (failure.reason == ChildFailure::Reason::exit)
        std::cout << "it has called exit()" << std::endl;
      else if (failure.reason == ChildFailure::Reason::time_limit)
        std::cout << "it has not ended" << std::endl;
      else
        std::cout << "signal " << failure.signal_number << std::endl;
    }
  catch (const std::bad_alloc &)
    {
      std::cout << "no memory" << std::endl;
    }
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
test_results()
{
  report("a result", []() { return "seven"; });
  report("no result", []() { return ""; });
  report("a large one", []() { return std::string(10000000, 'a') + 'b'; });
  report("one with a zero", []() { return std::string(200, '\0') + 'c'; });
  report("an error",
         []() -> std::string { throw std::runtime_error("it is wrong"); });
  report("too much memory", []() -> std::string { throw std::bad_alloc(); });
}


void
test_ends()
{
  report("exit", []() -> std::string { std::exit(0); });
  report("segmentation fault", []() -> std::string {
    std::raise(SIGSEGV);
    return "";
  });
  report("abort", []() -> std::string { std::abort(); });
  report("overflow of the stack", []() {
    deeper(0);
    return "";
  });
  report(
    "an endless loop",
    []() -> std::string {
      while (true)
        usleep(1000);
    },
    0.1);
}


/** What it says is not heard, and it has nothing to read. */
void
test_streams()
{
  std::cout << "before: ";
  report("it speaks", []() {
    std::cout << "FAILED" << std::endl;
    std::cerr << "FAILED" << std::endl;
    return std::string("end of input: ") +
           (std::cin.get() == std::char_traits<char>::eof() ? "yes" : "FAILED");
  });
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test_results();
    test_ends();
    test_streams();
  });
}
