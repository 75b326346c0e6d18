// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/contact/contact_basis.h>
#include <setsudan/cut/seam/blade_load.h>
#include <setsudan/cut/seam/severed_parts.h>
#include <setsudan/cut/seam/sides.h>
#include <setsudan/cut/seam/wall_overlap.h>
#include <setsudan/cut/yield/yield_criterion.h>
#include <setsudan/simulation/scene.h>
#include <setsudan/solver/solver_selection.h>

#include <memory>
#include <optional>
#include <vector>

namespace Setsudan
{
/**
 * The body as far as it is cut: its mesh, the elastic model on it, the walls of
 * the cuts that are made, and the seam of the newest one, which is being worked
 * on. The constraints of a state are a pure function of what is split in it.
 */
template <int dim>
class CutBody : public YieldingBody<dim>
{
public:
  using Constraints = dealii::AffineConstraints<double>;

  /** The uncut body; `scene` must live as long. */
  CutBody(const Scene<dim> &scene,
          const Refinement &refinement,
          const MPI_Comm communicator);

  /** Refined as the scene says. */
  CutBody(const Scene<dim> &scene, const MPI_Comm communicator);

  /** Find the rows of a new cut. The mesh stays as it is. Pieces that have been
   * dropped are left out.
   *
   * @return whether there is anything left to cut.
   * @throw FloatingPieceError where the cut goes through a piece that nothing
   * holds against the blade. */
  bool
  begin_cut(const Cut<dim> &cut);

  /** Duplicate the newest cut's nodes; all its pairs are tied. */
  void
  split_nodes();

  /** The same, and carry a displacement, without ghosts, over to the new nodes.
   */
  LA::Vector
  split_nodes(const LA::Vector &displacement);

  /** Split a row of the newest cut. Parts that nothing holds any more, though
   * the cut goes on, are held or dropped.
   *
   * @throw FloatingPieceError where a lost part's loads are not balanced, or
   * where the rest of the cut goes through parts that nothing holds. */
  void
  release_row(const unsigned int row);

  /** Whether the front of a row lies on parts that have all been dropped. */
  bool
  is_left_out(const unsigned int row) const;

  /** Let go of the newest seam, name the pieces, and hold or drop those that
   * have lost their support.
   *
   * @throw FloatingPieceError where a lost piece's loads are not balanced. */
  void
  finish_cut();

  const Scene<dim> &
  scene() const
  {
    return the_scene;
  }

  MPI_Comm
  communicator() const
  {
    return mpi_communicator;
  }

  const Refinement &
  refinement() const
  {
    return the_refinement;
  }

  const CoarseMesh<dim> &
  mesh() const
  {
    return present_mesh;
  }

  const ElasticModel<dim> &
  model() const override
  {
    return *present_model;
  }

  /** The cells of the model, to set their refinement flags. */
  dealii::parallel::distributed::Triangulation<dim> &
  triangulation()
  {
    return present_model->discretization.triangulation;
  }

  /** Whether a cut has been begun. */
  bool
  has_cut() const
  {
    return newest_seam != nullptr;
  }

  /** The newest cut. */
  const Cut<dim> &
  cut() const
  {
    return *begun_cuts.back().cut;
  }

  /** The faces that it opens. */
  const CutSurface<dim> &
  surface() const
  {
    return begun_cuts.back().surface;
  }

  /** The faces and node pairs of the cuts before it. */
  std::vector<CutFaces<dim>>
  earlier_cuts() const;

  /** Of a cut whose nodes are split and a blade that travels, the outer faces
   * at its entry that the blade may touch. */
  const std::vector<EntryHat<dim>> &
  entry_hats() const
  {
    return present_entry_hats;
  }

  /** The board on which the body lies; null where there is none. */
  const BoardContacts<dim> *
  board() const
  {
    return present_board.get();
  }

  /** The seam of the newest cut, and its pairs' states now. */
  const Seam<dim> &
  seam() const override
  {
    return *newest_seam;
  }
  PairStates
  pair_states() const;

  const SeamCells<dim> &
  seam_cells() const override;

  const RowArea &
  area_of_row(const unsigned int row) override;

  /** How far the front goes as so many rows split, the last one to the end. */
  double
  length_of_rows(const unsigned int row, const unsigned int n) const;

  /** Behind the last row the load is gone. */
  BladeAdvance
  advance_of_blade(const unsigned int row) const override;

  /** The walls of all cuts, one for each, as far as they are split; valid until
   * the next cut is begun or split. */
  std::vector<CutWall<dim>>
  walls() const;

  /** Side of the newest cut and piece of each element. */
  const ElementLabels &
  labels() const
  {
    return element_labels;
  }

  /** The floating pieces. */
  const std::vector<FloatingPiece> &
  floating_pieces() const
  {
    return severed.floating();
  }

  unsigned int
  n_pieces() const;

  /** The pieces in which the front of a row lies, ascending. */
  std::vector<unsigned int>
  pieces_of_row(const unsigned int row) const;

  /** The closed constraints of the present state, and of other states of the
   * newest seam's pairs: supports, hanging nodes, the seam, and what holds
   * floating pieces. */
  Constraints
  constraints() const;
  Constraints
  constraints(const PairStates &states) const;

  /** What the blade's thickness prescribes in the present state. */
  LA::Vector
  opening() const;

  /** The blade on the front of a row of the newest cut. */
  BladeLoad<dim>
  blade_on_row(const unsigned int row) const;

  /** Let the body have the laws of finite strain from now on. */
  void
  take_finite_strain();

  /** Let the internal variables be those of the state that was evaluated last.
   */
  void
  accept()
  {
    present_model->internal.accept();
  }

  /** Let them be those of a state that was solved for.
   *
   * @param displacement of it, without ghosts. */
  void
  accept(const LA::Vector &displacement)
  {
    if (present_model->internal.empty())
      return;
    evaluate_laws(*present_model, displacement);
    accept();
  }

  /** Let the states that are solved for be so much later than the last accepted
   * one [time]. */
  void
  let_time_pass(const double duration)
  {
    present_model->internal.set_time_step(duration);
  }

  /** See ElasticModel. */
  void
  set_load_factor(const double factor);

  /** Take the internal variables of an earlier run. */
  void
  set_internal(const CellData &data)
  {
    present_model->internal.set(data);
  }

  /** The solver of the present state, or under the constraints of any. It may
   * be the same object at the next call, for another state. */
  std::shared_ptr<TangentSolver>
  solver();
  std::shared_ptr<TangentSolver>
  solver(std::shared_ptr<const Constraints> constraints);

  std::shared_ptr<TangentSolver>
  solver_without(const unsigned int row) override;

  /** Whether the newest cut frees no part besides those that float already,
   * while its first rows are split. */
  bool
  holds_all_after(const unsigned int n_split) const;

  /** The solver of all states of the newest cut, in the present one, or while
   * its first rows are split; of a body without a cut, on its board.
   *
   * @throw SolverError where these states are not solved together, and
   *   FloatingPieceError where that leaves a part which nothing holds. */
  std::shared_ptr<CondensedSolver<dim>>
  condensed_solver();
  std::shared_ptr<CondensedSolver<dim>>
  condensed_solver(const unsigned int n_split);

  /** The closed constraints while the first rows of the newest cut are split.
   *
   * @throw FloatingPieceError where that leaves a part which nothing holds. */
  Constraints
  constraints_after(const unsigned int n_split) const;

  /** How often more has changed so far than the ties of a cut. */
  unsigned int
  n_changes() const
  {
    return selection.n_forgotten();
  }

  /** How a single state is solved, and how those of the newest cut. */
  Choice<SolverKind>
  solver_choice() const;
  Choice<CutStrategy>
  cut_strategy() const;

  /** Do not prepare for more than one state of a cut. */
  void
  expect_single_states();

private:
  /** A cut that has been begun, and the faces that it opens. */
  struct BegunCut
  {
    const Cut<dim> *cut;
    CutSurface<dim> surface;
  };

  /** Make the model on the present mesh. */
  void
  rebuild();

  /** Duplicate the nodes; the model of the mesh before is returned. */
  std::unique_ptr<ElasticModel<dim>>
  make_surgery();

  /** Of what has not been dropped. */
  std::vector<EntryHat<dim>>
  find_entry_hats() const;

  /** The rows of the newest cut. */
  std::vector<Row>
  find_rows(const SurfaceNodes<dim> &nodes);

  /** The parts of its faces. */
  std::vector<SurfaceStrip>
  strips() const;

  /** Find the parts that float now, and hold or drop them. */
  void
  update_parts();

  /** The state of a split row's pairs. */
  PairState
  split_state() const;

  /** All but the seam, not closed. */
  Constraints
  constraints_without_seam() const;

  /**
   * The stages of the newest cut for the solver; nothing where its states are
   * solved one by one.
   */
  std::optional<CutStages>
  stages() const;

  const Scene<dim> &the_scene;
  /** As the scene has them, until they take finite strain. */
  MaterialParameters<dim> materials;
  const MPI_Comm mpi_communicator;
  const Refinement the_refinement;
  CoarseMesh<dim> present_mesh;
  std::unique_ptr<ElasticModel<dim>> present_model;
  std::unique_ptr<BoardContacts<dim>> present_board;
  std::vector<EntryHat<dim>> present_entry_hats;
  SolverSelection<dim> selection;
  bool has_single_states = false;
  double load_factor     = 1;

  std::vector<BegunCut> begun_cuts;
  /** The pairs of the cuts before the newest one, which are free. */
  std::vector<std::vector<NodePair<dim>>> finished_pairs;
  std::unique_ptr<Seam<dim>> newest_seam;
  unsigned int n_split_rows = 0;
  bool is_finished          = false;
  /** On the faces of the newest cut, along a line of an element. */
  unsigned int n_cells_on_line = 1;
  /** The mesh behind the newest cut's surgery, before it is made. */
  CoarseMesh<dim> split_mesh_to_come;

  ElementLabels element_labels;
  SeveredParts<dim> severed;

  /** Found when somebody asks. */
  mutable std::unique_ptr<SeamCells<dim>> cells_at_seam;
  /** What the newest cut's rows open; empty until somebody asks. */
  std::vector<RowArea> areas;
};
} // namespace Setsudan
