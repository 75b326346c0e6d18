// SPDX-License-Identifier: LGPL-2.1-or-later
// Materials whose values are lists or pairs: in the units of a scene, and
// tables that are wrong.

#include <setsudan/material/presets.h>
#include <setsudan/simulation/scene.h>

#include <iostream>

#include "../body/small_body.h"
#include "../parameters/check.h"

using namespace Setsudan;

const std::string columns =
  "material,quantity,value,unit,conditions,source,tag\n";
const std::string table =
  columns + "gum,Young's modulus,2,kPa,-,-,assumed\n"
            "gum,Poisson's ratio,0.4,-,-,-,assumed\n"
            "gum,Shear limit,1,Pa,-,-,assumed\n"
            "gum,Hardening,\"3, 0.5\",kPa,-,-,assumed\n"
            "gum,Viscous,\"0.5 : 0.1, 0.2 : 30\",- : s,-,-,assumed\n"
            "gum,Law,Ogden,-,-,-,assumed\n"
            "gum,Ogden terms,0.63 : 1.3; -0.01 : -2,kPa : -,-,-,assumed\n"
            "ply,Young's moduli,\"10, 1, 0.5\",GPa,-,-,assumed\n";


void
print_entries(const std::string &material, const Assignments &others = {})
{
  Assignments assignments = {
    "Material/Preset=" + material, "Length unit=mm", "Force unit=N"};
  assignments.insert(assignments.end(), others.begin(), others.end());
  const Parameters parameters = parameters_of(assignments, Scene<2>::declare);
  const Presets presets(table);
  for (const auto &entry : presets.entries(parameters))
    std::cout << entry.name << " = " << entry.value << std::endl;
  for (const auto &line : presets.describe(parameters))
    std::cout << line << std::endl;
}


void
refuse_table(const std::string &line)
{
  try
    {
      Presets(columns + line);
      std::cout << "FAILED: accepted" << std::endl;
    }
  catch (const dealii::ExceptionBase &)
    {
      std::cout << "refused: " << line << std::endl;
    }
}


int
main()
{
  print_entries("gum", {"Cut/Surfaces=x:1"});
  // Of an orthotropic material there is no single modulus.
  print_entries("ply");
  print_entries("ply",
                {"Cut/Surfaces=x:1", "Material/Shear limit by axis=1, 2, 3"});
  print_refusal([] { print_entries("ply", {"Cut/Surfaces=x:1"}); });
  refuse_table("gum,Hardening,\"3, soft\",kPa,-,-,assumed");
  refuse_table("gum,Hardening,\"3, 1\",pounds,-,-,assumed");
  refuse_table("gum,Viscous,0.5 : 0.1,kPa,-,-,assumed");
  refuse_table("gum,Viscous,\"0.5 : 0.1, 0.2\",- : s,-,-,assumed");
  refuse_table("gum,Young's modulus,2,kPa");
  return 0;
}
