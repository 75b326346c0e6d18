// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <setsudan/simulation/record/checkpoint.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/map.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <cmath>
#include <fstream>
#include <iterator>

namespace Setsudan
{
using namespace dealii;

// What boost::serialization calls for each of the structs.

template <typename Archive>
void
serialize(Archive &archive, Doubts &doubts, const unsigned int)
{
  archive &doubts.n_states &doubts.strain &doubts.jacobian &doubts
    .overlap &doubts.pull &doubts.slide &doubts.passed &doubts.round_off &doubts
    .ellipticity &doubts.largest_strain;
}



template <typename Archive>
void
serialize(Archive &archive, WriterState &record, const unsigned int)
{
  archive &record.table &record.summary &record.sequence &record.doubts &record
    .warned &record.earlier_depths &record.framed_at &record.cut_began &record
    .seconds;
}



template <typename Archive>
void
serialize(Archive &archive, Refinement &refinement, const unsigned int)
{
  archive &refinement.global_levels &refinement.refined;
}



template <typename Archive>
void
serialize(Archive &archive, Checkpoint &checkpoint, const unsigned int)
{
  archive &checkpoint.stage &checkpoint.n_frames &checkpoint
    .finite_strain &checkpoint.refinement &checkpoint.event &checkpoint
    .record &checkpoint.load_factor &checkpoint.stress.reached &checkpoint
    .stress.required &checkpoint.yields &checkpoint.displacement &checkpoint
    .internal;
}



namespace
{
const std::string file_name = "checkpoint";
// Begins the file; the number changes with what is in it.
const std::string signature = "setsudan checkpoint 5\n";
} // namespace


void
write_checkpoint(const Checkpoint &checkpoint,
                 const OutputDirectory &directory,
                 const MPI_Comm communicator)
{
  if (Utilities::MPI::this_mpi_process(communicator) != 0)
    return;
  directory.write_durably(file_name, [&](std::ostream &out) {
    const auto bytes = Utilities::pack(checkpoint, false);
    out << signature;
    out.write(bytes.data(), bytes.size());
  });
}



void
remove_checkpoint(const OutputDirectory &directory, const MPI_Comm communicator)
{
  if (Utilities::MPI::this_mpi_process(communicator) == 0)
    directory.remove(file_name);
}



std::optional<Checkpoint>
read_checkpoint(const OutputDirectory &directory, const MPI_Comm communicator)
{
  std::vector<char> bytes;
  if (Utilities::MPI::this_mpi_process(communicator) == 0)
    {
      std::ifstream in(directory.path + "/" + file_name, std::ios::binary);
      bytes.assign(std::istreambuf_iterator<char>(in), {});
    }
  bytes = Utilities::MPI::broadcast(communicator, bytes);
  if (bytes.empty())
    return {};
  try
    {
      if (bytes.size() < signature.size() ||
          !std::equal(signature.begin(), signature.end(), bytes.begin()))
        throw SceneError("signature");
      return Utilities::unpack<Checkpoint>(
        bytes.begin() + signature.size(), bytes.end(), false);
    }
  catch (const std::exception &)
    {
      throw SceneError("The checkpoint in '" + directory.path +
                       "' is damaged, or of another version of the program: "
                       "the run cannot be resumed. Start it anew, without "
                       "--resume.");
    }
}



template <int dim>
void
store_state(const State<dim> &state,
            const CutBody<dim> &body,
            Checkpoint &checkpoint)
{
  checkpoint.finite_strain = body.model().materials.finite_strain;
  checkpoint.load_factor   = state.load_factor;
  checkpoint.stress        = state.stress;
  checkpoint.yields        = state.yields;
  checkpoint.displacement  = Utilities::MPI::gather(
    body.communicator(),
    std::vector<double>(state.displacement.begin(), state.displacement.end()));
  checkpoint.internal = Utilities::MPI::gather(body.communicator(),
                                               body.model().internal.by_cell());
}



template <int dim>
State<dim>
restore_state(const Checkpoint &checkpoint, CutBody<dim> &body)
{
  const auto &model = body.model();
  Solution solution;
  solution.displacement = model.discretization.zero_vector();
  const auto &own =
    checkpoint
      .displacement[Utilities::MPI::this_mpi_process(body.communicator())];
  const auto n = solution.displacement.local_size();
  bool fits    = own.size() == n;
  fits = Utilities::MPI::min(static_cast<int>(fits), body.communicator()) == 1;
  State<dim> state;
  if (fits)
    {
      body.set_internal(
        checkpoint
          .internal[Utilities::MPI::this_mpi_process(body.communicator())]);
      std::copy(own.begin(), own.end(), solution.displacement.begin());
      solution.internal = internal_forces(model, solution.displacement);
      state             = loaded_state(body,
                           checkpoint.stage == Checkpoint::Stage::divided
                                         ? no_blade(model)
                                         : body.blade_on_row(checkpoint.event.row),
                           checkpoint.load_factor);
      set_solution(model, std::move(solution), state);
      fits = std::abs(state.strain_energy - checkpoint.event.strain_energy) <=
             1e-10 * std::abs(state.strain_energy);
    }
  if (!fits)
    throw SceneError("The checkpoint in '" + body.scene().output.directory +
                     "' is not of this body, whose file must have been "
                     "changed: the run cannot be resumed. Start it anew, "
                     "without --resume.");
  state.stress = checkpoint.stress;
  state.yields = checkpoint.yields;
  return state;
}



template void
store_state(const State<2> &, const CutBody<2> &, Checkpoint &);
template State<2>
restore_state(const Checkpoint &, CutBody<2> &);
template void
store_state(const State<3> &, const CutBody<3> &, Checkpoint &);
template State<3>
restore_state(const Checkpoint &, CutBody<3> &);
} // namespace Setsudan
