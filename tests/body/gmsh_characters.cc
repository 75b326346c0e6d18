// SPDX-License-Identifier: LGPL-2.1-or-later
// Characters that look right in gmsh files, and are something else.

#include <algorithm>

#include "../test_setup.h"
#include "refusals.h"

using namespace Setsudan;

void
test_meshes()
{
  const std::string text = two_cubes().text();
  const std::string node = "\n2 1 0 0\n";
  for (const std::string number :
       {"1,0", "1.0D+00", "\u22121", "1\u00A0", "nan", "1e400", "one"})
    refuse_text(replace(text, node, "\n2 " + number + " 0 0\n"));
  refuse_text(replace(text, "1 5 2", "1 5 \u0662"));
  refuse_text("\xEF\xBB\xBF" + text);
  std::string returns = text;
  std::replace(returns.begin(), returns.end(), '\n', '\r');
  refuse_text(returns);
  std::string wide;
  for (const char c : text)
    wide += {c, '\0'};
  refuse_text(wide);
  refuse_text("\xFF\xFE" + wide);
}


void
test_geometries()
{
  refuse(write_text("wrong.geo", "// A minus: \u2212\nx = \u22121;\n"));
  refuse(
    write_text("wrong.geo", "/* \u2212\n*/ s = \"\u2212\"; x = \u201Ca\";\n"));
  refuse(write_text("wrong.geo", "x = 1; \xE4 = 2;\n"));
  refuse(write_text("wrong.geo", "x = 1;\n// note\rx = 2;\n"));
  refuse(write_text("wrong.geo", "// note\rx = 2;\r"));
  refuse(write_text("wrong.geo", "\xFE\xFF// wide"));
  refuse(write_text("wrong.geo", "x = 1.0D+00;\n"));
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test_meshes();
    test_geometries();
  });
}
