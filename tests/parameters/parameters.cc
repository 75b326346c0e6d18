// SPDX-License-Identifier: LGPL-2.1-or-later
// Parameters: types, the later of two entries wins, and messages know where
// the one that won was written.

#include <setsudan/parameters/parameters.h>

#include <deal.II/base/patterns.h>

#include <fstream>
#include <vector>

#include "../test_setup.h"
#include "check.h"

using namespace Setsudan;
using dealii::ParameterHandler;
namespace Patterns = dealii::Patterns;

void
declare_all(ParameterHandler &handler)
{
  declare(handler, "", "Top", "top", Patterns::Anything(), "A text.");
  declare(handler, "A", "Number", "1.5", Patterns::Double(), "A number [-].");
  declare(handler, "A", "Count", "7", Patterns::Integer(1), "A count [-].");
  declare(handler, "A", "Truth", "false", Patterns::Bool(), "A truth.");
  declare(handler, "A/B", "List", "1, 2", Patterns::Anything(), "A list.");
}


Parameters
parameters_of(const std::vector<SceneEntry> &entries)
{
  return Parameters("scene.prm", entries, declare_all);
}


void
print_values(const Parameters &parameters)
{
  std::cout << "[" << parameters.text("", "Top") << "] "
            << parameters.number("A", "Number") << " "
            << parameters.natural("A", "Count") << " "
            << (parameters.truth("A", "Truth") ? "true" : "false") << " [";
  for (const double number : parameters.numbers("A/B", "List"))
    std::cout << " " << number;
  std::cout << " ]" << std::endl;
}


void
test_values()
{
  print_values(parameters_of({}));
  const Parameters parameters =
    parameters_of({{"A", "Number", "2.5", "scene.prm:2"},
                   {"A/B", "List", "3,4 , 5", "scene.prm:3"},
                   {"", "Top", " two words ", "scene.prm:4"},
                   {"A", "Number", "-3e2", "scene.prm:5"},
                   {"A", "Truth", "true", "--set"},
                   {"A", "Count", "8", "--set"}});
  print_values(parameters);
  check("given", parameters.is_given("A", "Number"));
  check("not given", !parameters_of({}).is_given("A", "Number"));
  print_refusal([&] { parameters.reject("A", "Number", "something else"); });
  print_refusal([&] { parameters.reject("A", "Truth", "something else"); });
  print_refusal([&] { parameters.numbers("A/B", "List", 2); });
  parameters.require(true, "A", "Count", "anything");
  print_refusal([&] { parameters.require(false, "A", "Count", "less"); });
  print_refusal([&] { parameters_of({}).reject("A/B", "List", "a list"); });
}


/** Up to what is allowed, which in these is deal.II's to describe. */
void
refuse_value(const std::string &name, const std::string &value)
{
  print_refusal([&] {
    try
      {
        parameters_of({{"A", name, value, "scene.prm:1"}});
      }
    catch (const SceneError &error)
      {
        const std::string text = error.what();
        throw SceneError(text.substr(0, text.find(':', text.find(';'))));
      }
  });
}


void
test_refusals()
{
  const auto refuse = [](const SceneEntry &entry) {
    print_refusal([&] { parameters_of({entry}); });
  };
  refuse({"A", "Numbre", "1", "scene.prm:1"});
  refuse({"", "Number", "1", "scene.prm:2"});
  refuse({"B", "List", "1", "scene.prm:3"});
  refuse({"A/B/C", "List", "1", "scene.prm:4"});
  for (const std::string value :
       {"nan", "-inf", "1e999", "", "1 2", "0x", "1,5"})
    refuse_value("Number", value);
  for (const std::string value : {"0", "-1", "1.5", "3000000000"})
    refuse_value("Count", value);
  refuse_value("Truth", "perhaps");
  const auto list = parameters_of({{"A/B", "List", "1, x", "scene.prm:5"}});
  print_refusal([&] { list.numbers("A/B", "List"); });
}


/** Files are looked for where the scene is. */
void
test_path()
{
  for (const std::string scene : {"scene.prm", "a/b/scene.prm", "/a/scene.prm"})
    for (const std::string file : {"body.msh", "parts/body.msh", "/b/body.msh"})
      std::cout << "'" << file << "' in '" << scene << "' is '"
                << Parameters(scene, {{"", "Top", file, "1"}}, declare_all)
                     .path("", "Top")
                << "'" << std::endl;
}


/** What is printed is a scene file with the same values. */
void
test_print()
{
  const Parameters parameters = parameters_of({{"A", "Number", "2.5", "--set"},
                                               {"A/B", "List", "3, 4", "--set"},
                                               {"", "Top", "x = y", "--set"}});
  std::ofstream file("printed.prm");
  parameters.print(file);
  file.close();
  print_values(parameters_of(read_scene_file("printed.prm")));
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test_values();
    test_refusals();
    test_path();
    test_print();
  });
}
