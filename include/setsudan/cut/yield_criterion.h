#pragma once

#include <setsudan/cut/seam.h>
#include <setsudan/elasticity/elastic_model.h>

#include <vector>

namespace Setsudan
{
/** Subsection `Yield`. */
struct YieldParameters
{
  enum class Check
  {
    once,
    every_row
  };

  Check check;

  static void
  declare(dealii::ParameterHandler &handler);

  explicit YieldParameters(const Parameters &parameters);
};

/** The stress at a node, in one of the cells that meet there. */
struct FrontStress
{
  dealii::SymmetricTensor<2, 3> stress;
  /** Of that cell's material. */
  double shear_limit;
};

/** Stresses at the front row's nodes, one per cell that meets there, of the
 * cells of this process. */
using FrontStresses = std::vector<FrontStress>;

/** @param displacement with ghosts. */
template <int dim>
FrontStresses
front_stresses(const ElasticModel<dim> &model,
               const Seam<dim> &seam,
               const Row &row,
               const LA::Vector &displacement);

/** What decides whether a row yields. */
struct CuttingStress
{
  double reached  = 0;
  double required = 0;

  /** Whether the stress exceeds what is required, or nothing is. */
  bool
  yields() const;
};

/**
 * The cutting stress (equation 17 of Kakefuda et al. 1996): the largest
 * maximum shear over the cells that meet at the front row's nodes; where they
 * are of different materials, that which is largest in relation to its shear
 * limit.
 *
 * The stress under a concentrated load is singular, so that this measure
 * grows as elements shrink.
 */
CuttingStress
cutting_stress(const FrontStresses &stresses,
               const double sharpness,
               const MPI_Comm communicator);

/** The stress that yield requires: shear limit x (1 - sharpness), equation
 * 18. */
double
required_stress(const double shear_limit, const double sharpness);

/** The load factor at which a row yields. */
struct YieldLoad
{
  /** The factor, or the largest allowed one where the row does not yield. */
  double load_factor;
  CuttingStress stress;
  /** At the factor that was found stress is what is required, and no more. */
  bool yields;
};

/**
 * The smallest load factor in [0, max_load_factor] at which the front's
 * stress, base + factor x per_load, reaches what is required. The stress in
 * relation to the limit is convex in the factor, so that there is at most one
 * such point beyond 0, and a bracketing root finder cannot miss it.
 */
YieldLoad
find_yield_load(const FrontStresses &base,
                const FrontStresses &per_load,
                const double sharpness,
                const double max_load_factor,
                const MPI_Comm communicator);
} // namespace Setsudan
