// SPDX-License-Identifier: LGPL-2.1-or-later
// A geometry is a program: what it may not do leaves no trace.

#include <filesystem>

#include "../test_setup.h"
#include "refusals.h"

using namespace Setsudan;

void
test_commands()
{
  const std::string cube  = "Point(1) = {0, 0, 0};\n"
                            "p[] = Extrude {1, 0, 0} { Point{1}; Layers{1}; };\n"
                            "l[] = Extrude {0, 1, 0} { Line{p[1]}; Layers{1}; "
                            "Recombine; };\n"
                            "Extrude {0, 0, 1} { Surface{l[1]}; Layers{1}; "
                            "Recombine; }\n";
  const std::string shell = "SystemCall \"touch left_behind\";\n";
  write_text("included.geo", shell);
  for (const std::string &command :
       {shell,
        "NonBlocking" + shell,
        "Macro Call_it\n" + shell + "Return\nCall Call_it;\n",
        std::string("Include \"included.geo\";\n"),
        std::string("Printf(\"text\") > \"left_behind\";\n"),
        std::string("Mesh 3;\nSave \"left_behind\";\n"),
        std::string("Print \"left_behind.msh\";\n"),
        std::string("Merge \"missing.geo\";\n"),
        std::string("General.Verbosity = 0;\nSave \"left_behind\";\n"),
        std::string("Mesh 3;\nExit;\n")})
    refuse(write_text("command.geo", cube + command));
  refuse(write_text("command.geo",
                    cube + "Macro Endless\nCall Endless;\nReturn\n"
                           "Call Endless;\n"),
         0.5);
  refuse(write_text("command.geo", cube + "CreateDir \"left_behind\";\n"));
  for (const std::string file : {"left_behind", "left_behind.msh"})
    if (std::filesystem::exists(file))
      std::cout << "FAILED: " << file << std::endl;
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, test_commands);
}
