// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/kernel/neo_hooke.h>

namespace Setsudan
{
/**
 * Several cells of one element type that are worked on at once, one in each
 * lane of the processor's vector registers. All arrays begin at multiples of 64
 * bytes, and the lane is their fastest index.
 *
 * The points are those of Gauss's rule with 3 points in each direction, x
 * fastest.
 */
struct CellBatch
{
  /** Where the first component of each node's displacement is in a vector, the
   * others behind it: [node][lane], nodes as deal.II orders those of FE_Q(2).
   */
  const unsigned int *nodes;

  /** At each point the gradient of each reference coordinate r, times the
   * square root of the point's weight and volume: [point][r][direction][lane];
   * without lanes where `is_uniform`. */
  const double *gradients;

  /** Lamé's constants: [lambda, mu][lane]. */
  const double *moduli;

  /** For a mixed formulation: an orthonormal basis of the functions onto which
   * the dilatation is projected, at each point times the square root of weight
   * and volume: [point][dim + 1][lane]. Nothing for others. */
  const double *pressures;

  /** Whether all cells have the same shape. */
  bool is_uniform;

  /** The lanes that hold a cell; the rest repeats the last of them. */
  unsigned int n_cells;

  /** The gradients of the batch that comes next, which are fetched meanwhile;
   * nothing where they are the same or there is none. */
  const double *next_gradients;

  /** Of a tangent in its place, the symmetric matrix of the components of
   * gradients in reference coordinates, times g = sqrt(3/5) in each:
   * [point][row by row of one half][lane]. Nothing for Hooke's law. */
  const double *tangent = nullptr;
};

/** The entries of CellBatch::tangent at a point. */
template <int dim>
constexpr unsigned int n_in_tangent = dim *dim *(dim *dim + 1) / 2;

/** A deformed body of neo-Hookean cells. */
struct NeoHookeState
{
  NeoHookeForm form;
  /** Of the nodes at rest, and the displacement, like those of K u. */
  const double *positions;
  const double *displacement;
};

/**
 * Products with the element stiffness matrices, which are not formed: K u and
 * parts of K, for batches of cells. The kernels know neither vectors nor
 * meshes, so that they can be compiled for several kinds of processors, the
 * best of which is chosen at run time.
 */
template <int dim>
struct StiffnessKernel
{
  /** The kind of processor. */
  const char *name;

  /** Cells in a batch. */
  unsigned int n_lanes;

  /**
   * Add K u of a batch's cells to forces; K is the tangent where there is one.
   *
   * Displacements are expanded to the 3^dim nodes of the full quadratic
   * element, which adds nothing but what the serendipity functions are at them;
   * there, all sums over the nodes are taken one direction after the other.
   */
  void (*apply_serendipity)(const CellBatch &batch,
                            const double *displacement,
                            double *forces);

  /** The same for full quadratic elements. */
  void (*apply_quadratic)(const CellBatch &batch,
                          const double *displacement,
                          double *forces);

  /**
   * The displacement's gradient, first at a grid of 3^dim points that has the
   * nodes in it, then at Gauss's points, both with x fastest.
   *
   * @param positions of the nodes, like the displacement.
   * @param gradients [point][component][direction][lane].
   */
  void (*serendipity_gradients)(const CellBatch &batch,
                                const double *positions,
                                const double *displacement,
                                double *gradients);

  /** The same for full quadratic elements. */
  void (*quadratic_gradients)(const CellBatch &batch,
                              const double *positions,
                              const double *displacement,
                              double *gradients);

  /**
   * The stiffness that functions have, or the tangent.
   *
   * @param gradients of the functions in reference coordinates:
   *   [point][function][direction].
   * @param matrix [function][component][function][component][lane], or, if it
   *   is `diagonal`, [function][component][lane].
   */
  void (*integrate)(const CellBatch &batch,
                    const double *gradients,
                    unsigned int n_functions,
                    bool diagonal,
                    double *matrix);

  /**
   * Add the internal forces of neo-Hookean cells.
   *
   * @param energies of each lane; infinite where a volume is not positive, and
   *   the forces have no meaning there.
   */
  void (*serendipity_neo_hooke)(const CellBatch &batch,
                                const NeoHookeState &state,
                                double *forces,
                                double *energies);

  /** The same for full quadratic elements. */
  void (*quadratic_neo_hooke)(const CellBatch &batch,
                              const NeoHookeState &state,
                              double *forces,
                              double *energies);

  /** The tangent as CellBatch has it.
   *
   * @param before the displacement from which its stress is extrapolated (see
   *   LawIntegration), or null. */
  void (*serendipity_tangent)(const CellBatch &batch,
                              const NeoHookeState &state,
                              const double *before,
                              double *tangent);

  /** The same for full quadratic elements. */
  void (*quadratic_tangent)(const CellBatch &batch,
                            const NeoHookeState &state,
                            const double *before,
                            double *tangent);
};

/** The kernel for the processor that this is. */
template <int dim>
const StiffnessKernel<dim> &
stiffness_kernel();
} // namespace Setsudan
