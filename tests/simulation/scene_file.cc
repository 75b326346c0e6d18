// SPDX-License-Identifier: LGPL-2.1-or-later
// Prints doc/scene_file.md from the declarations of the parameters: the file
// is this test's expected output, and `scripts/document` writes it.

#include <setsudan/parameters/document.h>
#include <setsudan/simulation/scene.h>

#include <iostream>

using namespace Setsudan;

int
main()
{
  std::cout
    << "# The scene file\n\n"
       "<!-- Written by scripts/document from the declarations in the code. "
       "-->\n\n"
       "A scene is one file of parameters in deal.II's syntax: `set NAME = "
       "VALUE`, grouped by\n"
       "`subsection NAME` … `end`, with comments after a `#` at the "
       "beginning of a line or\n"
       "behind a blank; `include FILE` "
       "reads "
       "another file first, whose\n"
       "values the following lines replace. On the command line, `--set "
       "'Subsection/Name=value'` does\n"
       "the same. Any consistent set of units works; brackets name the kind of "
       "unit.\n\n"
       "Defaults are those of three dimensions. In two, lists have two "
       "components, the faces are left,\n"
       "right, bottom and top (y), and forces are per unit of thickness.\n";
  document_parameters(Scene<3>::declare, std::cout);
  return 0;
}
