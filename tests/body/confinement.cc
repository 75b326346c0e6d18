// SPDX-License-Identifier: LGPL-2.1-or-later
// A confined process reads files and starts threads, and neither writes files
// nor runs commands.

#include <setsudan/body/gmsh/child_process.h>
#include <setsudan/body/gmsh/confinement.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <string>
#include <thread>

#include <sys/socket.h>
#include <unistd.h>

#include "../test_setup.h"

using namespace Setsudan;

/** Print how what a confined process tries comes out, and whether it has left a
 * file. */
void
report(const std::string &name, const std::function<bool()> &action)
{
  const std::string file = "left_behind";
  std::filesystem::remove_all(file);
  std::cout << name << ": ";
  try
    {
      std::cout << run_in_child(
        [&]() -> std::string {
          if (!confine_process())
            return "FAILED: no filter";
          return action() ? "done" : "refused";
        },
        std::numeric_limits<double>::infinity());
    }
  catch (const ChildFailure &failure)
    {
      std::cout << "ended by signal " << failure.signal_number;
    }
  std::cout << (std::filesystem::exists(file) ? ", FAILED: there is a file"
                                              : "")
            << std::endl;
}


bool
opens(const char *const mode, const char *const file)
{
  return std::fopen(file, mode) != nullptr;
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    std::ofstream("present") << "text";
    report("read", []() { return opens("r", "present"); });
    report("a thread", []() {
      bool done = false;
      std::thread([&]() { done = true; }).join();
      return done;
    });
    report("write", []() { return opens("w", "left_behind"); });
    report("append", []() { return opens("a", "left_behind"); });
    report("change", []() { return opens("r+", "present"); });
    report("remove", []() { return std::remove("present") == 0; });
    report("rename",
           []() { return std::rename("present", "left_behind") == 0; });
    report("make a directory", []() {
      std::error_code error;
      return std::filesystem::create_directory("left_behind", error);
    });
    report("make a link", []() { return link("present", "left_behind") == 0; });
    report("shorten", []() { return truncate("present", 1) == 0; });
    report("a connection",
           []() { return socket(AF_UNIX, SOCK_STREAM, 0) >= 0; });
    report("a command", []() { return std::system("touch left_behind") == 0; });
    report("a command with a pipe",
           []() { return popen("touch left_behind", "r") != nullptr; });
    report("another process", []() { return fork() >= 0; });
    report("another program", []() {
      return execlp("touch", "touch", "left_behind", nullptr) != 0;
    });
    std::cout << "the file has " << std::filesystem::file_size("present")
              << " bytes" << std::endl;
  });
}
