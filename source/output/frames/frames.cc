// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <setsudan/output/frames/frames.h>

#include <memory>
#include <ostream>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** @param base the files' names up to the ending.
 * @param rank  of this process, and how many there are. */
void
write_frame(const VtuGrid &content,
            const OutputDirectory &directory,
            const std::string &base,
            const unsigned int rank,
            const unsigned int n_ranks)
{
  const auto name_of_rank = [&](const unsigned int r) {
    return n_ranks == 1 ? base + ".vtu"
                        : base + "." + std::to_string(r) + ".vtu";
  };
  directory.write(name_of_rank(rank),
                  [&](std::ostream &out) { write_vtu(content, out); });
  if (rank > 0 || n_ranks == 1)
    return;
  std::vector<std::string> names;
  for (unsigned int r = 0; r < n_ranks; ++r)
    names.push_back(name_of_rank(r));
  directory.write(base + ".pvtu",
                  [&](std::ostream &out) { write_pvtu(content, names, out); });
}

const std::string blade_prefix = "blade_";

/** Body and blade are parts of their own. */
void
write_sequence(const std::vector<std::pair<double, std::string>> &shown,
               std::ostream &out)
{
  out.precision(12);
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" "
         "version=\"0.1\" byte_order=\"LittleEndian\">\n<Collection>\n";
  for (const auto &[time, file] : shown)
    out << "<DataSet timestep=\"" << time << "\" group=\"\" part=\""
        << (file.rfind(blade_prefix, 0) == 0) << "\" file=\"" << file
        << "\"/>\n";
  out << "</Collection>\n</VTKFile>\n";
}
} // namespace


FrameWriter::FrameWriter(const OutputDirectory &directory)
  : directory(directory)
{
}



void
FrameWriter::write(const unsigned int frame,
                   const double time,
                   const MPI_Comm communicator,
                   const std::shared_ptr<const VtuGrid> &content,
                   const std::shared_ptr<const VtuGrid> &blade)
{
  const unsigned int rank    = Utilities::MPI::this_mpi_process(communicator);
  const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
  const std::string number   = Utilities::to_string(frame, 4);
  finish();
  sequence.emplace_back(time,
                        "frame_" + number + (n_ranks == 1 ? ".vtu" : ".pvtu"));
  if (blade)
    sequence.emplace_back(time, blade_prefix + number + ".vtu");
  // MPI is not called from there.
  pending = std::async(
    std::launch::async,
    [this, content, blade, number, rank, n_ranks, shown = sequence] {
      write_frame(*content, directory, "frame_" + number, rank, n_ranks);
      if (rank > 0)
        return;
      if (blade)
        directory.write(blade_prefix + number + ".vtu",
                        [&](std::ostream &out) { write_vtu(*blade, out); });
      directory.write("cut.pvd",
                      [&](std::ostream &out) { write_sequence(shown, out); });
    });
}



void
FrameWriter::finish()
{
  if (pending.valid())
    pending.get();
}



} // namespace Setsudan
