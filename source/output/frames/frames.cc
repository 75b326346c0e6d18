// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/data_out_base.h>
#include <deal.II/base/mpi.h>

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
} // namespace


FrameWriter::FrameWriter(const OutputDirectory &directory)
  : directory(directory)
{
}



void
FrameWriter::write(const unsigned int frame,
                   const double time,
                   const MPI_Comm communicator,
                   const std::shared_ptr<const VtuGrid> &content)
{
  const unsigned int rank    = Utilities::MPI::this_mpi_process(communicator);
  const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
  const std::string base     = "frame_" + Utilities::to_string(frame, 4);
  finish();
  sequence.emplace_back(time, base + (n_ranks == 1 ? ".vtu" : ".pvtu"));
  // MPI is not called from there.
  pending = std::async(std::launch::async,
                       [this, content, base, rank, n_ranks, shown = sequence] {
                         write_frame(*content, directory, base, rank, n_ranks);
                         if (rank == 0)
                           directory.write("cut.pvd", [&](std::ostream &out) {
                             DataOutBase::write_pvd_record(out, shown);
                           });
                       });
}



void
FrameWriter::finish()
{
  if (pending.valid())
    pending.get();
}



} // namespace Setsudan
