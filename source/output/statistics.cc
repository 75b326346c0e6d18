#include <setsudan/output/statistics.h>

#include <iomanip>
#include <ostream>
#include <sstream>

namespace Setsudan
{
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
  std::ostringstream line;
  line << std::setprecision(12) << event.frame << ',' << event.name << ','
       << event.cut << ',' << event.row << ',' << event.released_rows << ','
       << event.depth << ',' << event.load_factor << ',' << event.blade_force
       << ',' << event.cutting_stress << ',' << event.required_stress << ','
       << event.strain_energy << ',' << event.potential_energy << ','
       << event.max_displacement << ',' << std::setprecision(3)
       << event.force_residual << ',' << event.moment_residual << ','
       << std::setprecision(12) << event.min_jacobian << ',' << event.pieces
       << ',' << std::setprecision(4) << event.seconds << ','
       << std::setprecision(12) << event.max_strain << ',' << event.max_shear;
  for (const double component : event.reaction)
    line << ',' << component;
  for (const double component : event.clamp_force)
    line << ',' << component;
  for (unsigned int i = 0; i < event.row_pieces.size(); ++i)
    line << (i == 0 ? ',' : '+') << event.row_pieces[i];
  if (event.errors)
    line << std::setprecision(4) << ',' << (*event.errors)[0] << ','
         << (*event.errors)[1];
  line << '\n';
  table += line.str();
  directory.write("statistics.csv", [&](std::ostream &out) { out << table; });
}
} // namespace Setsudan
