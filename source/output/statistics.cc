#include <setsudan/output/statistics.h>

#include <iomanip>
#include <ostream>
#include <sstream>

namespace Setsudan
{
namespace
{
std::string
line_of(const Event &event)
{
  std::ostringstream line;
  const auto add = [&](const auto value, const int precision) {
    line << ',' << std::setprecision(precision) << value;
  };
  const auto add_if_whole = [&](const double value, const int precision) {
    if (event.is_whole)
      add(value, precision);
    else
      line << ',';
  };
  line << event.frame << ',' << event.name << ',' << event.cut << ','
       << event.row << ',' << event.released_rows;
  for (const double value : {event.depth,
                             event.load_factor,
                             event.blade_force,
                             event.cutting_stress,
                             event.required_stress})
    add(value, 12);
  for (const double value :
       {event.strain_energy, event.potential_energy, event.max_displacement})
    add_if_whole(value, 12);
  for (const double value : {event.force_residual, event.moment_residual})
    add_if_whole(value, 3);
  add_if_whole(event.min_jacobian, 12);
  add(event.pieces, 12);
  add(event.seconds, 4);
  for (const double value : {event.max_strain, event.max_shear})
    add_if_whole(value, 12);
  for (const auto *vector : {&event.reaction, &event.clamp_force})
    for (const double component : *vector)
      add_if_whole(component, 12);
  for (unsigned int i = 0; i < event.row_pieces.size(); ++i)
    line << (i == 0 ? ',' : '+') << event.row_pieces[i];
  if (event.errors)
    for (const double error : *event.errors)
      add_if_whole(error, 4);
  line << '\n';
  return line.str();
}
} // namespace


void
Statistics::add(const Event &event, const OutputDirectory &directory)
{
  if (table.empty())
    table = "frame,event,cut,row,released_rows,depth,load_factor,blade_force,"
            "cutting_stress,required_stress,strain_energy,potential_energy,"
            "max_displacement,force_residual,moment_residual,min_jacobian,"
            "pieces,seconds,max_strain,max_shear,reaction_x,reaction_y,"
            "reaction_z,clamp_x,clamp_y,clamp_z,row_pieces" +
            std::string(event.errors ? ",energy_error,stress_error\n" : "\n");
  table += line_of(event);
  is_written = false;
  // Where rows are fast, to write the table would take longer than they do.
  if (Clock::now() - last_written >= std::chrono::milliseconds(100))
    finish(directory);
}



void
Statistics::finish(const OutputDirectory &directory)
{
  if (is_written)
    return;
  directory.write("statistics.csv", [&](std::ostream &out) { out << table; });
  is_written   = true;
  last_written = Clock::now();
}
} // namespace Setsudan
