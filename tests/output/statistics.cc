// SPDX-License-Identifier: LGPL-2.1-or-later
// The table of events: the columns that scripts rely on, the values in the
// columns of their names, and a whole table when it is written.

#include <setsudan/output/tables/statistics.h>
#include <setsudan/parameters/lists.h>

#include <fstream>
#include <string>
#include <vector>

#include "../parameters/check.h"
#include "../test_setup.h"

using namespace Setsudan;

/** The columns in the order of the contract; more may follow. */
const std::string contract =
  "frame,event,cut,row,released_rows,depth,load_factor,blade_force,"
  "cutting_stress,required_stress,strain_energy,potential_energy,"
  "max_displacement,force_residual,moment_residual,min_jacobian,pieces,seconds,"
  "max_strain,max_shear,reaction_x,reaction_y,reaction_z,clamp_x,clamp_y,"
  "clamp_z,overlap";


std::vector<std::string>
read_lines()
{
  std::vector<std::string> lines;
  std::ifstream file("table/statistics.csv");
  for (std::string line; std::getline(file, line);)
    lines.push_back(line);
  return lines;
}


/** An event in which the n-th column of numbers has the value n. */
Event
numbered_event()
{
  Event event;
  event.frame            = 1;
  event.name             = "release";
  event.cut              = 3;
  event.row              = 4;
  event.released_rows    = 5;
  event.depth            = 6;
  event.load_factor      = 7;
  event.blade_force      = 8;
  event.cutting_stress   = 9;
  event.required_stress  = 10;
  event.strain_energy    = 11;
  event.potential_energy = 12;
  event.max_displacement = 13;
  event.force_residual   = 14;
  event.moment_residual  = 15;
  event.min_jacobian     = 16;
  event.pieces           = 17;
  event.seconds          = 18;
  event.max_strain       = 19;
  event.max_shear        = 20;
  event.reaction         = {{21, 22, 23}};
  event.clamp_force      = {{24, 25, 26}};
  event.overlap          = 27;
  return event;
}


/** Add an event and have the table written. */
void
add(Statistics &statistics,
    const Event &event,
    const OutputDirectory &directory)
{
  statistics.add(event, directory);
  statistics.finish(directory);
}


void
test_columns(const std::vector<std::string> &lines)
{
  check("the contract's columns come first",
        (lines[0] + ",").rfind(contract + ",", 0) == 0);
  const auto names = split(contract, ',');
  for (const auto &line : lines)
    check("as many columns as names",
          split(line, ',').size() == split(lines[0], ',').size());
  const auto values = split(lines[1], ',');
  for (unsigned int c = 0; c < names.size(); ++c)
    if (values[c] != std::to_string(c + 1) && names[c] != "event")
      std::cout << "FAILED: " << names[c] << " is " << values[c] << std::endl;
  std::cout << "event is " << values[1] << std::endl;
}


/** The last column is a list of pieces. */
void
test_pieces(Statistics &statistics, const OutputDirectory &directory)
{
  const auto lines = read_lines();
  check("the last column is row_pieces",
        split(lines[0], ',').back() == "row_pieces");
  // numdiff takes texts for numbers, and would not see all differences.
  Event event;
  const auto is_written_as = [&](const std::string &text) {
    add(statistics, event, directory);
    return split(read_lines().back(), ',').back() == text;
  };
  check("the first piece", is_written_as("0"));
  event.row_pieces = {3};
  check("one piece", is_written_as("3"));
  event.row_pieces = {1, 2, 10};
  check("several pieces", is_written_as("1+2+10"));
}


/** Numbers are written with the digits that a comparison needs. */
void
test_digits(Statistics &statistics, const OutputDirectory &directory)
{
  Event event;
  event.cutting_stress   = 1. / 3;
  event.strain_energy    = 2e-20 / 3;
  event.max_displacement = 2e20 / 3;
  add(statistics, event, directory);
  const auto values = split(read_lines().back(), ',');
  check_below("stress", std::abs(std::stod(values[8]) * 3 - 1), 1e-11);
  check_below("energy", std::abs(std::stod(values[10]) * 1.5e20 - 1), 1e-11);
  check_below(
    "displacement", std::abs(std::stod(values[12]) * 1.5e-20 - 1), 1e-11);
}


/** Units stand in a comment or a row of their own, for every column. */
void
test_units(const OutputDirectory &directory)
{
  for (const auto units :
       {OutputParameters::Units::comment, OutputParameters::Units::row})
    {
      Statistics statistics(units, "mm", "N");
      add(statistics, numbered_event(), directory);
      const auto lines    = read_lines();
      const bool is_row   = units == OutputParameters::Units::row;
      const auto &names   = lines[is_row ? 0 : 1];
      const auto &of_them = lines[is_row ? 1 : 0];
      std::cout << of_them << std::endl;
      check("a unit for each column",
            split(names, ',').size() == split(of_them, ',').size());
    }
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    const OutputDirectory directory("table", MPI_COMM_WORLD);
    Statistics statistics(OutputParameters::Units::none, "cm", "gf");
    add(statistics, numbered_event(), directory);
    std::cout << read_lines().size() << " lines" << std::endl;
    test_columns(read_lines());
    test_digits(statistics, directory);
    test_pieces(statistics, directory);
    std::cout << read_lines().size() << " lines" << std::endl;
    test_columns(read_lines());
    test_units(directory);
  });
}
