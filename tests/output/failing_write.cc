// SPDX-License-Identifier: LGPL-2.1-or-later
// A file that cannot be written as a whole is not there at all: no half of it,
// no temporary one; and an earlier one stays as it was.

#include <setsudan/output/output_directory.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "../parameters/check.h"
#include "../test_setup.h"

using namespace Setsudan;
namespace fs = std::filesystem;

void
print_failure(const std::function<void()> &write)
{
  try
    {
      write();
      std::cout << "FAILED: written" << std::endl;
    }
  catch (const std::runtime_error &error)
    {
      std::cout << error.what() << std::endl;
    }
}


void
check_files(const unsigned int n_files)
{
  unsigned int n = 0;
  for (const auto &entry : fs::directory_iterator("written"))
    // Tells that the directory is a run's.
    n += entry.path().filename() != ".writing-mark";
  check("files left", n == n_files);
}


void
test_interrupted(const OutputDirectory &directory)
{
  const auto half = [](std::ostream &out) {
    out << "half" << std::flush;
    throw std::runtime_error("no more of it");
  };
  print_failure([&] { directory.write("cut.pvd", half); });
  check_files(0);

  directory.write("cut.pvd", [](std::ostream &out) { out << "whole"; });
  print_failure([&] { directory.write("cut.pvd", half); });
  check_files(1);
  std::string text;
  std::getline(std::ifstream("written/cut.pvd"), text);
  std::cout << text << std::endl;
}


/** The temporary name leads to a device that is full. */
void
test_full_disk(const OutputDirectory &directory)
{
  directory.write_file("statistics.csv", [](const std::string &name) {
    std::ofstream(name) << "whole";
  });
  std::string temporary;
  directory.write_file("statistics.csv", [&](const std::string &name) {
    temporary = name;
    std::ofstream(name) << "whole";
  });
  fs::create_symlink("/dev/full", temporary);
  print_failure([&] {
    directory.write("statistics.csv", [](std::ostream &out) {
      out << std::string(1 << 20, 'x');
    });
  });
  check_files(2);
  check("the earlier one is whole",
        fs::file_size("written/statistics.csv") == 5);
}


/** Nothing is written by a writer who does not find the directory any more. */
void
test_no_directory(const OutputDirectory &directory)
{
  fs::remove_all("written");
  print_failure(
    [&] { directory.write("cut.pvd", [](std::ostream &out) { out << 1; }); });
  check("no directory", !fs::exists("written"));
}


/** Where a directory has the name of the file. */
void
test_directory_in_the_way(const OutputDirectory &directory)
{
  fs::create_directories("written/cut.pvd/inside");
  try
    {
      directory.write("cut.pvd", [](std::ostream &out) { out << 1; });
      std::cout << "FAILED: written" << std::endl;
    }
  catch (const std::runtime_error &error)
    {
      check("the message names it",
            std::string(error.what()).find("'written/cut.pvd'") !=
              std::string::npos);
    }
  check_files(1);
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    fs::remove_all("written");
    const OutputDirectory directory("written", MPI_COMM_WORLD);
    test_interrupted(directory);
    test_full_disk(directory);
    test_no_directory(directory);
    test_directory_in_the_way(directory);
  });
}
