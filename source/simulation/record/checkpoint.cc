#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <setsudan/simulation/record/checkpoint.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <cmath>
#include <fstream>
#include <iterator>

namespace Setsudan
{
using namespace dealii;

namespace
{
template <typename Archive, typename... Values>
void
archive_all(Archive &archive, Values &...values)
{
  (archive & ... & values);
}
} // namespace


// What boost::serialization calls for each of the structs.

template <typename Archive>
void
serialize(Archive &archive, Event &event, const unsigned int)
{
  bool has_errors = event.errors.has_value();
  auto errors     = event.errors.value_or(std::array<double, 2>());
  archive_all(archive,
              event.frame,
              event.name,
              event.cut,
              event.row,
              event.released_rows,
              event.depth,
              event.load_factor,
              event.blade_force,
              event.cutting_stress,
              event.required_stress,
              event.strain_energy,
              event.potential_energy,
              event.max_displacement,
              event.force_residual,
              event.moment_residual,
              event.min_jacobian,
              event.pieces,
              event.seconds,
              event.max_strain,
              event.max_shear,
              event.reaction,
              event.clamp_force,
              event.overlap,
              event.row_pieces,
              has_errors,
              errors);
  if (has_errors)
    event.errors = errors;
}



template <typename Archive>
void
serialize(Archive &archive, Doubts &doubts, const unsigned int)
{
  archive_all(archive,
              doubts.n_states,
              doubts.strain,
              doubts.jacobian,
              doubts.overlap,
              doubts.round_off);
}

template <typename Archive>
void
serialize(Archive &archive, Record &record, const unsigned int)
{
  archive_all(archive,
              record.table,
              record.sequence,
              record.doubts,
              record.warned,
              record.earlier_depths,
              record.framed_at,
              record.cut_began,
              record.seconds);
}



template <typename Archive>
void
serialize(Archive &archive, Refinement &refinement, const unsigned int)
{
  archive_all(archive, refinement.global_levels, refinement.refined);
}



template <typename Archive>
void
serialize(Archive &archive, Checkpoint &checkpoint, const unsigned int)
{
  archive_all(archive,
              checkpoint.stage,
              checkpoint.n_frames,
              checkpoint.refinement,
              checkpoint.event,
              checkpoint.record,
              checkpoint.load_factor,
              checkpoint.stress.reached,
              checkpoint.stress.required,
              checkpoint.yields,
              checkpoint.displacement);
}



namespace
{
const std::string file_name = "checkpoint";
// Begins the file; the number changes with what is in it.
const std::string signature = "setsudan checkpoint 2\n";
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
        throw std::runtime_error("signature");
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
            const MPI_Comm communicator,
            Checkpoint &checkpoint)
{
  checkpoint.load_factor  = state.load_factor;
  checkpoint.stress       = state.stress;
  checkpoint.yields       = state.yields;
  checkpoint.displacement = Utilities::MPI::gather(
    communicator,
    std::vector<double>(state.displacement.begin(), state.displacement.end()));
}



template <int dim>
State<dim>
restore_state(const Scene<dim> &scene,
              const Checkpoint &checkpoint,
              CutBody<dim> &body)
{
  LA::Vector displacement = body.model->discretization.zero_vector();
  const unsigned int rank = Utilities::MPI::this_mpi_process(body.communicator);
  const auto &own         = checkpoint.displacement[rank];
  const auto n            = displacement.local_size();
  bool fits               = own.size() == n;
  fits = Utilities::MPI::min(static_cast<int>(fits), body.communicator) == 1;
  State<dim> state;
  if (fits)
    {
      std::copy(own.begin(), own.end(), displacement.begin());
      // The first matrices of a model may differ by round-off from those of
      // later sums, which begin with the shape that the last one ended with.
      body.internal_forces(displacement);
      state               = make_state(scene,
                         body,
                         checkpoint.stage == Checkpoint::Stage::divided
                                         ? no_blade(body)
                                         : blade_on_row(body, checkpoint.event.row),
                         checkpoint.load_factor,
                         displacement);
      const double energy = 0.5 * (state.displacement * state.internal);
      fits                = std::abs(energy - checkpoint.event.strain_energy) <=
             1e-10 * std::abs(energy);
    }
  if (!fits)
    throw SceneError("The checkpoint in '" + scene.output.directory +
                     "' is not of this body, whose file must have been "
                     "changed: the run cannot be resumed. Start it anew, "
                     "without --resume.");
  state.stress = checkpoint.stress;
  state.yields = checkpoint.yields;
  return state;
}



template void
store_state(const State<2> &, const MPI_Comm, Checkpoint &);
template State<2>
restore_state(const Scene<2> &, const Checkpoint &, CutBody<2> &);
template void
store_state(const State<3> &, const MPI_Comm, Checkpoint &);
template State<3>
restore_state(const Scene<3> &, const Checkpoint &, CutBody<3> &);
} // namespace Setsudan
