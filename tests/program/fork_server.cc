// SPDX-License-Identifier: LGPL-2.1-or-later
/*
 * Many short runs of one program, for tests: with this library in LD_PRELOAD
 * the program is loaded once, and each run is a fork of it that begins at
 * main(). Most of a short run is otherwise the dynamic linker and the
 * initialization of some 200 libraries.
 *
 * Each line of standard input asks for a run: its directory, a file for its
 * messages, its limits of processor time in seconds and of memory in bytes, and
 * its arguments, separated by tabs. The answer, a line on standard output, is
 * what waitpid() gives when it has ended. fork_server.py is the other end.
 */
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace
{
using Main = int (*)(int, char **, char **);

Main program = nullptr;

/** The next field of a request. */
std::string
next(std::istringstream &fields)
{
  std::string field;
  std::getline(fields, field, '\t');
  return field;
}



bool
limit(const int resource, const rlim_t most)
{
  // Beyond the first value there is a signal of its own, beyond the second
  // none.
  const rlimit value = {most, most + 1};
  return setrlimit(resource, &value) == 0;
}



/** Prepare the process of a run; whether that worked. */
bool
prepare(std::istringstream &fields)
{
  const bool is_there = chdir(next(fields).c_str()) == 0;
  const int nothing   = open("/dev/null", O_RDWR);
  const int messages =
    open(next(fields).c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  return is_there && limit(RLIMIT_CPU, std::stoull(next(fields))) &&
         limit(RLIMIT_AS, std::stoull(next(fields))) && dup2(nothing, 0) == 0 &&
         dup2(nothing, 1) == 1 && dup2(messages, 2) == 2;
}



int
run(const std::string &request, char *name, char **environment)
{
  std::istringstream fields(request);
  if (!prepare(fields))
    return 126;
  std::vector<std::string> arguments;
  while (fields)
    arguments.push_back(next(fields));
  arguments.pop_back();
  std::vector<char *> argv = {name};
  for (auto &one : arguments)
    argv.push_back(one.data());
  argv.push_back(nullptr);
  return program(argv.size() - 1, argv.data(), environment);
}



int
serve(int, char **argv, char **environment)
{
  unsetenv("LD_PRELOAD");
  std::string request;
  while (std::getline(std::cin, request))
    {
      const pid_t child = fork();
      if (child == 0)
        std::exit(run(request, argv[0], environment));
      int status = 0;
      waitpid(child, &status, 0);
      std::cout << status << std::endl;
    }
  return 0;
}
} // namespace


extern "C" int
__libc_start_main(Main main,
                  int argc,
                  char **argv,
                  void (*init)(),
                  void (*fini)(),
                  void (*end_of_linker)(),
                  void *end_of_stack)
{
  program          = main;
  const auto start = reinterpret_cast<decltype(&__libc_start_main)>(
    dlsym(RTLD_NEXT, "__libc_start_main"));
  return start(serve, argc, argv, init, fini, end_of_linker, end_of_stack);
}
