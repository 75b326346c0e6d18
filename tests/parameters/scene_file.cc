// SPDX-License-Identifier: LGPL-2.1-or-later
// The reader of scene files: comments, continued lines, included files, nested
// subsections, and where each entry was written.

#include <setsudan/parameters/scene_file.h>

#include <filesystem>
#include <fstream>

#include "../test_setup.h"
#include "check.h"

using namespace Setsudan;

void
write_file(const std::string &name, const std::string &text)
{
  std::ofstream(name, std::ios::binary) << text;
}


void
print_entries(const std::string &name)
{
  std::cout << name << std::endl;
  for (const SceneEntry &entry : read_scene_file(name))
    std::cout << "  at " << entry.location << " [" << entry.subsection << "] ["
              << entry.name << "] = [" << entry.value << "]" << std::endl;
}


void
test_syntax()
{
  write_file("syntax.prm",
             "# a comment\n"
             "\n"
             "set Dimension = 3 # another\n"
             "  set\tLength unit=a unit \n"
             "subsection Outer room\n"
             "  set A = 1\n"
             "  subsection Inner\n"
             "    set B = x = y\n"
             "    set Empty =\n"
             "  end\n"
             "  set C = 1, \\\n"
             "          2, \\\n"
             "          3\n"
             "  set Dimension = 2\n"
             "end\n"
             "set Last = no line end");
  print_entries("syntax.prm");
}


void
test_line_ends()
{
  write_file("line_ends.prm",
             "subsection A\r\n  set B = 1, \\\r\n 2\r\nend\r\nset C = 3\r\n");
  print_entries("line_ends.prm");
  write_file("mac.prm", "# first\rsubsection A\r  set B = 1\rend\r");
  print_entries("mac.prm");
  write_file("mixed.prm", "set A = 1\r\nset B = 2\rset C = 3\n\r\nset D = 4");
  print_entries("mixed.prm");
  write_file("mark.prm", "\xef\xbb\xbfset A = 1\n");
  print_entries("mark.prm");
  write_file("empty.prm", "");
  print_entries("empty.prm");
}


/** An included file is found from the file that includes it; within a
 * subsection its entries belong to that one, and it cannot end it. */
void
test_include()
{
  std::filesystem::create_directories("parts/deeper");
  write_file("including.prm",
             "set Before = 1\n"
             "include parts/part.prm\n"
             "set After = 2\n");
  write_file("parts/part.prm",
             "subsection P\n  set Q = 3\nend\ninclude deeper/last.prm\n");
  write_file("parts/deeper/last.prm", "\n\nset Before = 4\n");
  print_entries("including.prm");

  write_file("within.prm",
             "subsection P\n  include parts/deeper/last.prm\nend\n");
  print_entries("within.prm");
  write_file("parts/ends.prm", "end\n");
  write_file("ended.prm", "subsection P\ninclude parts/ends.prm\n");
  print_refusal([] { read_scene_file("ended.prm"); });
}


/** What looks like a scene's character and is another is named with its place;
 * in comments and in names in any script nothing is refused. */
void
test_characters()
{
  write_file(
    "names.prm",
    "set File = \u4f53#1.geo # \u2212 \u00a0 \xff\nset A = K\u00f6rper\n");
  print_entries("names.prm");
  const auto refuse = [](const std::string &text) {
    write_file("wrong.prm", text);
    print_refusal([] { read_scene_file("wrong.prm"); });
  };
  refuse("set A = \u22121\n");
  refuse("\nset Young\u2019s modulus = 1\n");
  refuse("set A = \u201cbottom\u201d\n");
  refuse("set\u00a0A = 1\n");
  refuse("set A = 1\u30001\n");
  refuse("set A = \u00e9, 1\uff0c1\n");
  refuse("set A = \u200b1\n");
  refuse("set A = \xe9\n");
  refuse("set A = \xc3");
  refuse(std::string("set A = \0\n", 10));
  refuse(std::string("\xff\xfes\0e\0t\0", 8));
  refuse("set A = 1\n\xef\xbb\xbfset B = 1\n");
}


void
test_refusals()
{
  const auto refuse = [](const std::string &text) {
    write_file("wrong.prm", text);
    print_refusal([] { read_scene_file("wrong.prm"); });
  };
  refuse("set Dimension = 3\nsett Dimension = 3\n");
  refuse("set Dimension\n");
  refuse("set = 3\n");
  refuse("# \\\nset A = 1 \\\n\\\n  2\nend\n");
  refuse("subsection A\nend\nend\n");
  refuse("subsection A\n  subsection B\n  end\nset C = 1\n");
  print_refusal([] { read_scene_file("missing.prm"); });
  print_refusal([] { read_scene_file("parts"); });
}


void
test_assignments()
{
  for (const std::string &text : {"Dimension=2",
                                  " Body/Size = 1, 2, 3 ",
                                  "Outer/Inner/A=b=c",
                                  "Body/Size="})
    {
      const SceneEntry entry = parse_assignment(text);
      std::cout << entry.location << " [" << entry.subsection << "] ["
                << entry.name << "] = [" << entry.value << "]" << std::endl;
    }
  print_refusal([] { parse_assignment("Body/Size"); });
  print_refusal([] { parse_assignment("=3"); });
  print_refusal([] { parse_assignment("A=\u22123"); });
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test_syntax();
    test_line_ends();
    test_include();
    test_characters();
    test_refusals();
    test_assignments();
  });
}
