#pragma once

#include <setsudan/cut/seam.h>
#include <setsudan/elasticity/elastic_model.h>
#include <setsudan/elasticity/loose_pieces.h>
#include <setsudan/output/frames.h>
#include <setsudan/simulation/scene.h>

#include <memory>
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
  CutBody(const Scene<dim> &scene, const MPI_Comm communicator);

  /** Begin a new cut: find its rows. The mesh stays as it is.
   *
   * @throw std::runtime_error where the cut goes through a piece that nothing
   * holds against the blade. */
  void
  approach(const CutSurface<dim> &surface);

  /** Duplicate the newest surface's nodes; all its pairs are tied. */
  void
  open();

  /** Let go of the newest seam, find the pieces, and hold those that have lost
   * their support.
   *
   * @throw std::runtime_error where a lost piece's loads are not balanced. */
  void
  divide();

  /** The seam of the newest cut. */
  Seam<dim> &
  seam();
  const Seam<dim> &
  seam() const;

  /** Supports, the seams and what holds loose pieces; closed. */
  dealii::AffineConstraints<double>
  constraints() const;

  unsigned int
  n_pieces() const;

  const MPI_Comm communicator;
  CoarseMesh<dim> mesh;
  std::unique_ptr<ElasticModel<dim>> model;
  std::vector<Seam<dim>> seams;
  std::vector<LoosePiece> loose_pieces;
  ElementLabels labels;

private:
  /** Make the model and the seams of all surfaces on the present mesh. */
  void
  rebuild();

  Seam<dim>
  make_seam(const CutSurface<dim> &surface) const;

  const Scene<dim> &scene;
  std::vector<CutSurface<dim>> surfaces;
};
} // namespace Setsudan
