#pragma once

#include <setsudan/cut/seam/row_areas.h>
#include <setsudan/cut/seam/seam_cells.h>
#include <setsudan/mechanics/elastic_model.h>
#include <setsudan/mechanics/pieces/piece_motions.h>
#include <setsudan/output/frames/frame_content.h>
#include <setsudan/simulation/equilibrium_choice.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace Setsudan
{
/**
 * The body as far as it is cut: its mesh, the elastic model on it, and the
 * seams of all cuts, the newest of which is being worked on.
 */
template <int dim>
class CutBody
{
public:
  /** The uncut body; `scene` must live as long. */
  CutBody(const Scene<dim> &scene,
          const Refinement &refinement,
          const MPI_Comm communicator);

  /** Refined as the scene says. */
  CutBody(const Scene<dim> &scene, const MPI_Comm communicator);

  /** Begin a new cut: find its rows. The mesh stays as it is. Pieces that have
   * been dropped are left out.
   *
   * @return whether there is anything left to cut.
   * @throw std::runtime_error where the cut goes through a piece that nothing
   * holds against the blade. */
  bool
  approach(const Cut<dim> &cut);

  /** Duplicate the newest cut's nodes; all its pairs are tied. */
  void
  open();

  /** Split a row of the newest cut. Parts that nothing holds any more, though
   * the cut goes on, are held or dropped.
   *
   * @throw std::runtime_error where a lost part's loads are not balanced, or
   * where the rest of the cut goes through parts that nothing holds. */
  void
  release(const unsigned int row);

  /** Whether the front of a row lies on parts that have all been dropped. */
  bool
  is_left_out(const unsigned int row) const;

  /** Let go of the newest seam, name the pieces, and hold or drop those that
   * have lost their support.
   *
   * @throw std::runtime_error where a lost piece's loads are not balanced. */
  void
  divide();

  /** The newest cut. */
  const Cut<dim> &
  cut() const;

  /** The seam of the newest cut. */
  Seam<dim> &
  seam();
  const Seam<dim> &
  seam() const;

  /** The cells that meet the newest seam. */
  const SeamCells<dim> &
  seam_cells() const;

  /** Supports, hanging nodes, the seams and what holds loose pieces; closed. */
  dealii::AffineConstraints<double>
  constraints() const;

  /** The equilibrium under these constraints. It may be the same object at the
   * next call, for others. */
  std::shared_ptr<TangentSolver>
  equilibrium();

  /** Why the rows of the newest cut are not all solved from one factorization,
   * in words that follow "every row is solved anew"; empty where they are. */
  std::string
  why_anew() const;

  /** Whether they are factored at once, before they split. */
  bool
  is_foreseen() const;

  /** Whether no piece can come loose. */
  bool
  all_held() const;

  /** Do not prepare for more than one state of a cut. */
  void
  expect_single_states();

  /** The equilibrium if the ties of one row were taken off.
   *
   * @throw std::runtime_error where that leaves a part which nothing holds. */
  std::shared_ptr<TangentSolver>
  equilibrium_without(const unsigned int row);

  unsigned int
  n_pieces() const;

  /** The pieces in which the front of a row lies, ascending. */
  std::vector<unsigned int>
  pieces_of_row(const unsigned int row) const;

  /** What splitting a row of the newest cut opens. */
  const RowArea &
  area_of_row(const unsigned int row);

  /** K u of a displacement without ghosts. */
  LA::Vector
  internal_forces(const LA::Vector &displacement);

  const MPI_Comm communicator;
  const Refinement refinement;
  CoarseMesh<dim> mesh;
  std::unique_ptr<ElasticModel<dim>> model;
  std::vector<Seam<dim>> seams;
  std::vector<FloatingPiece> floating_pieces;
  ElementLabels labels;

private:
  /** Find the pieces that are loose now, and hold or drop them. */
  void
  find_loose_pieces();

  void
  drop(const std::vector<FloatingPiece> &loose);

  /** Supports, hanging nodes, the first seams and what holds loose pieces;
   * closed. */
  dealii::AffineConstraints<double>
  constraints_of(const unsigned int n_seams) const;

  /** Visit the constraints now, and when each row of the newest cut in turn has
   * been split. */
  void
  for_each_row_to_come(
    const std::function<void(const dealii::AffineConstraints<double> &)>
      &visit);

  typename Seam<dim>::State
  state_of_split_rows() const;

  typename EquilibriumChoice<dim>::OtherStates
  other_states();

  std::shared_ptr<TangentSolver>
  equilibrium_under(dealii::AffineConstraints<double> &&constraints);

  /** A cut that has been begun, and the faces that it opens. */
  struct BegunCut
  {
    const Cut<dim> *cut;
    CutSurface<dim> surface;
  };

  /** Make the model on the present mesh. */
  void
  rebuild();

  /** @param split the mesh behind the surgery of this cut. */
  Seam<dim>
  make_seam(const BegunCut &begun, const CoarseMesh<dim> &split) const;

  const Scene<dim> &scene;
  EquilibriumChoice<dim> choice;
  std::vector<BegunCut> begun_cuts;
  unsigned int n_split_rows = 0;
  /** The mesh behind the newest cut's surgery, before it is made. */
  CoarseMesh<dim> split;
  /** What the pieces will be when the newest cut has gone through. */
  std::vector<unsigned int> parts;
  std::unique_ptr<PieceMotions<dim>> motions;
  /** Found when somebody asks. */
  mutable std::unique_ptr<SeamCells<dim>> cells_at_seam;
  /** What the newest cut's rows open; empty until somebody asks. */
  std::vector<RowArea> areas;
};
} // namespace Setsudan
