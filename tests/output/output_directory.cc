// SPDX-License-Identifier: LGPL-2.1-or-later
// The output directory: what an earlier run left goes, what is somebody else's
// stays.

#include <setsudan/output/output_directory.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include "../parameters/check.h"
#include "../test_setup.h"

using namespace Setsudan;
namespace fs = std::filesystem;

void
make_file(const fs::path &path)
{
  fs::create_directories(path.parent_path());
  std::ofstream(path) << "earlier";
}


void
print_files(const std::string &directory)
{
  std::set<std::string> names;
  for (const auto &entry : fs::directory_iterator(directory))
    names.insert(entry.path().filename().string() +
                 (entry.is_directory() ? "/" : ""));
  std::cout << directory << ":";
  for (const auto &name : names)
    std::cout << " " << name;
  std::cout << std::endl;
}


void
test_replacement()
{
  fs::remove_all("replaced");
  for (const std::string &name : {"parameters.prm",
                                  "checkpoint",
                                  "cut.pvd",
                                  "statistics.csv",
                                  "summary.json",
                                  "frame_0000.vtu",
                                  "frame_0001.pvtu",
                                  "frame_0001.0.vtu",
                                  "frame_0001.1.vtu",
                                  "frame_12345.vtu",
                                  "nodes_0000.csv",
                                  "piece_0.msh",
                                  "piece_0.vtu",
                                  "piece_12.msh",
                                  ".writing-cut.pvd",
                                  ".writing-probe"})
    make_file("replaced/" + std::string(name));
  for (const std::string &name : {"notes.txt",
                                  "parameters.prm.bak",
                                  "my_cut.pvd",
                                  "frame_0000.vtu.png",
                                  "frame_first.vtu",
                                  "nodes.csv",
                                  "cut.pvsm",
                                  "piece_0.stl",
                                  "statistics_old.csv",
                                  "deeper/cut.pvd",
                                  "frame_0002.vtu/file"})
    make_file("replaced/" + std::string(name));
  // Files of these names may be somebody's, as long as nothing says that they
  // are an earlier run's.
  print_refusal([] { OutputDirectory("replaced", MPI_COMM_WORLD); });
  std::ofstream("replaced/parameters.prm") << OutputDirectory::signature;
  print_refusal([] {
    OutputDirectory("replaced",
                    MPI_COMM_WORLD,
                    OutputDirectory::Earlier::removed,
                    {"missing", "replaced/deeper/../piece_0.msh"});
  });
  const OutputDirectory directory("replaced",
                                  MPI_COMM_WORLD,
                                  OutputDirectory::Earlier::removed,
                                  {"replaced/notes.txt"});
  print_files("replaced");
  check("deeper files stay", fs::exists("replaced/deeper/cut.pvd"));
}


/** A run that was stopped before it wrote its parameters, or while the files of
 * an earlier one were removed, is replaced too. */
void
test_mark()
{
  fs::remove_all("begun");
  {
    const OutputDirectory directory("begun", MPI_COMM_WORLD);
    directory.write("cut.pvd", [](std::ostream &out) { out << "first"; });
  }
  print_files("begun");
  const OutputDirectory kept(
    "begun", MPI_COMM_WORLD, OutputDirectory::Earlier::kept);
  print_files("begun");
  const OutputDirectory directory("begun", MPI_COMM_WORLD);
  directory.write("parameters.prm",
                  [](std::ostream &out) { out << OutputDirectory::signature; });
  print_files("begun");
}


/** A run that is resumed keeps its files, but not those that a writer who was
 * killed has left. */
void
test_kept()
{
  fs::remove_all("kept");
  for (const std::string &name :
       {"parameters.prm", "checkpoint", "statistics.csv", ".writing-cut.pvd"})
    make_file("kept/" + std::string(name));
  const OutputDirectory directory(
    "kept", MPI_COMM_WORLD, OutputDirectory::Earlier::kept);
  print_files("kept");
  check("there is a checkpoint", directory.has("checkpoint"));
  directory.write_durably("checkpoint",
                          [](std::ostream &out) { out << "later"; });
  std::string text;
  std::getline(std::ifstream("kept/checkpoint"), text);
  std::cout << text << std::endl;
  directory.remove("checkpoint");
  directory.remove("checkpoint");
  print_files("kept");
}


void
test_new_directory()
{
  fs::remove_all("new");
  const OutputDirectory directory("new/and/deep", MPI_COMM_WORLD);
  print_files("new/and/deep");
  directory.write("cut.pvd", [](std::ostream &out) { out << "first"; });
  directory.write("cut.pvd", [](std::ostream &out) { out << "second"; });
  print_files("new/and/deep");
  std::string text;
  std::getline(std::ifstream("new/and/deep/cut.pvd"), text);
  std::cout << text << std::endl;
}


/** Writers that want a name get one that ends like the file's. */
void
test_name()
{
  const OutputDirectory directory("named", MPI_COMM_WORLD);
  directory.write_file("piece_0.msh", [](const std::string &name) {
    check("another name", fs::path(name).filename() != "piece_0.msh");
    check("same directory", fs::path(name).parent_path() == "named");
    check("same extension", fs::path(name).extension() == ".msh");
    make_file(name);
  });
  print_files("named");
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test_replacement();
    test_mark();
    test_kept();
    test_new_directory();
    test_name();
  });
}
