// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/mechanics/stress/ellipticity.h>
#include <setsudan/mesh/geometry.h>
#include <setsudan/simulation/record/results_writer.h>

#include <algorithm>
#include <sstream>

namespace Setsudan
{
using namespace dealii;

namespace
{
std::string
warn_of_strain(const Event &event, const double linear_range)
{
  std::ostringstream message;
  message.precision(3);
  message << "in frame " << event.frame << " a principal strain of "
          << event.max_strain
          << " exceeds Material/Linear range = " << linear_range
          << ": small-strain theory is not valid there, do not interpret the "
             "deformation quantitatively.";
  return message.str();
}

std::string
warn_of_jacobian(const Event &event)
{
  std::ostringstream message;
  message.precision(3);
  message << "in frame " << event.frame
          << " the deformed body overlaps itself (the determinant of the "
             "deformation gradient falls to "
          << event.min_jacobian
          << "): the load is too large for a linear body, or too concentrated "
             "for its elements.";
  return message.str();
}

template <int dim>
std::string
warn_of_overlap(const Event &event,
                const WallOverlap<dim> &overlap,
                const std::string &length_unit)
{
  std::ostringstream message;
  message.precision(3);
  message
    << "in frame " << event.frame << " the walls of cut " << overlap.cut
    << " overlap: they have moved through each other by " << overlap.depth
    << " " << length_unit << " at " << text_of(overlap.position)
    << ", since there is no contact between them. Forces that walls would "
       "take from each other are missing from here on.";
  return message.str();
}

template <int dim>
std::string
warn_of_passing(const Event &event,
                const BoardLoad<dim> &board,
                const std::string &length_unit)
{
  std::ostringstream message;
  message.precision(3);
  message << "in frame " << event.frame << " the body has passed the board by "
          << board.passed << " " << length_unit
          << ", with faces that were too far away to be expected there. Make "
             "loads smaller, or shape the body so that these faces lie on the "
             "board from the beginning.";
  return message.str();
}

template <int dim>
std::string
warn_of_slide(const Event &event, const BoardLoad<dim> &board)
{
  std::ostringstream message;
  message.precision(3);
  message << "in frame " << event.frame << " piece " << board.sliding_piece
          << " cannot stay on the board: what holds it there along the board "
             "is "
          << board.part_of_friction
          << " times Coulomb's friction. It is held nevertheless. Set "
             "Board/Friction larger, or hold the piece in subsection Support.";
  return message.str();
}

std::string
warn_of_pull(const Event &event, const std::string &force_unit)
{
  std::ostringstream message;
  message.precision(3);
  message << "in frame " << event.frame
          << " split rows would gape by more than Blade/Thickness: keeping "
             "them that far apart pulls with a force of "
          << event.opening_pull << " " << force_unit
          << ", which no blade does. Set Division/Split rows = wedged.";
  return message.str();
}

template <int dim>
std::string
warn_of_ellipticity(const Event &event,
                    const ElasticModel<dim> &model,
                    const LeastEllipticity<dim> &softest)
{
  return "in frame " + std::to_string(event.frame) + " " +
         describe_ellipticity(model, softest);
}

std::string
warn_of_round_off(const SolveQuality &quality)
{
  std::ostringstream message;
  message.precision(2);
  message << "digits are lost, the system is ill-conditioned: the relative "
             "residual is "
          << quality.residual
          << " and the estimated relative error of displacements "
          << quality.estimated_relative_error
          << ", because the body is very slender or its stiffness very uneven "
             "(a Poisson's ratio near 1/2, flat elements, or materials far "
             "apart).";
  return message.str();
}
} // namespace



template <int dim>
void
ResultsWriter<dim>::doubt(const CutBody<dim> &body,
                          const Event &event,
                          const State<dim> &state,
                          const WallOverlap<dim> &overlap)
{
  if (!state.quality.warning.empty())
    progress.warn(state.quality.warning);
  bool is_doubtful     = false;
  const auto doubt_for = [&](unsigned int Doubts::*const reason,
                             const bool holds,
                             const auto &message) {
    if (!holds)
      return;
    is_doubtful = true;
    ++(doubts.*reason);
    if (warned.*reason == 0)
      progress.warn(message());
    ++(warned.*reason);
  };
  doubt_for(&Doubts::strain,
            !body.model().materials.finite_strain &&
              event.max_strain > scene.material.linear_range,
            [&] { return warn_of_strain(event, scene.material.linear_range); });
  if (!body.model().materials.finite_strain)
    doubts.largest_strain = std::max(doubts.largest_strain, event.max_strain);
  doubt_for(&Doubts::jacobian, event.min_jacobian <= 0, [&] {
    return warn_of_jacobian(event);
  });
  // Less is round-off, or nothing that a picture shows. Contact keeps walls
  // apart in the mean over a hat, and lets single nodes through.
  const bool has_contact = scene.has_contact();
  doubt_for(&Doubts::overlap,
            !has_contact && overlap.depth > 1e-6 * scene.body.mesh.extent(),
            [&] { return warn_of_overlap(event, overlap, scene.length_unit); });
  doubt_for(&Doubts::slide,
            state.board && state.board->part_of_friction > 1 + 1e-9,
            [&] { return warn_of_slide(event, *state.board); });
  // Contact keeps the body above its board in the mean over a hat.
  constexpr double far_beyond = 0.01;
  doubt_for(
    &Doubts::passed,
    state.board && state.board->passed > far_beyond * scene.body.mesh.extent(),
    [&] { return warn_of_passing(event, *state.board, scene.length_unit); });
  // A gap that is prescribed up to tied rows pulls a little between pushes.
  constexpr double large_part = 0.1;
  const double push           = event.opening_force + event.opening_pull;
  doubt_for(&Doubts::pull, event.opening_pull > large_part * push, [&] {
    return warn_of_pull(event, scene.force_unit);
  });
  doubt_for(&Doubts::round_off,
            state.quality.residual > 1e-8 ||
              state.quality.estimated_relative_error > 1e-5,
            [&] { return warn_of_round_off(state.quality); });
  const auto softest = find_least_ellipticity(body.model(), state.displacement);
  doubt_for(&Doubts::ellipticity, softest.ratio <= 0, [&] {
    return warn_of_ellipticity(event, body.model(), softest);
  });
  doubts.n_states += is_doubtful;
}



template <int dim>
void
ResultsWriter<dim>::warn_anew()
{
  const unsigned int round_off = warned.round_off;
  warned                       = {};
  warned.round_off             = round_off;
}



template <int dim>
std::string
ResultsWriter<dim>::describe_doubts() const
{
  if (doubts.n_states == 0)
    return "";
  std::string reasons;
  const auto add = [&](const unsigned int n, const std::string &why) {
    if (n > 0)
      reasons +=
        (reasons.empty() ? "" : ", ") + why + " in " + std::to_string(n);
  };
  std::ostringstream strain;
  strain.precision(3);
  strain << "strain of up to " << doubts.largest_strain
         << " beyond Material/Linear range";
  add(doubts.strain, strain.str());
  add(doubts.jacobian, "elements inside out");
  add(doubts.overlap, "walls of a cut through each other");
  add(doubts.slide, "a piece held on the board beyond its friction");
  add(doubts.passed, "nodes beyond the board");
  add(doubts.pull, "rows pulled together by the blade's thickness");
  add(doubts.ellipticity, "a law without resistance");
  add(doubts.round_off, "digits lost by the solver");
  return std::to_string(doubts.n_states) +
         " of them not to be trusted: " + reasons;
}



template void
ResultsWriter<2>::doubt(const CutBody<2> &,
                        const Event &,
                        const State<2> &,
                        const WallOverlap<2> &);
template void
ResultsWriter<2>::warn_anew();
template std::string
ResultsWriter<2>::describe_doubts() const;
template void
ResultsWriter<3>::doubt(const CutBody<3> &,
                        const Event &,
                        const State<3> &,
                        const WallOverlap<3> &);
template void
ResultsWriter<3>::warn_anew();
template std::string
ResultsWriter<3>::describe_doubts() const;
} // namespace Setsudan
