// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/element/element_type.h>
#include <setsudan/solver/solver_parameters.h>
#include <setsudan/space/discretization.h>

#include <string>

namespace Setsudan
{
template <int dim>
struct ElasticModel;

/** How the equations of one state are solved. */
enum class SolverKind
{
  /** Sparse Cholesky factorization on one process, by CHOLMOD. */
  cholesky,
  /** The same on several processes, by MUMPS. */
  mumps,
  /** The factorization L D L^T of a matrix that need not be definite. */
  indefinite,
  /** Conjugate gradients with p-multigrid, without a matrix. */
  matrix_free,
  /** Conjugate gradients with algebraic multigrid of the assembled matrix. */
  algebraic_multigrid
};

/** How the states of a cut are solved. */
enum class CutStrategy
{
  /** All from one factorization, condensed onto the cut. */
  condensed,
  /** Each by a solve of its own. */
  row_by_row,
  /** Each by Newton's method, with conjugate gradients that one factorization
   * of the body at rest preconditions, or of a state before. */
  preconditioned
};

/** A choice, and why it was made: words that follow it on the screen. */
template <typename Kind>
struct Choice
{
  Kind kind;
  std::string reason;
};

/** The sizes on which a choice depends. */
struct SystemSize
{
  dealii::types::global_dof_index n_unknowns;
  ElementType element_type;
  unsigned int n_processes;
};

template <int dim>
SystemSize
size_of(const Discretization<dim> &discretization);

/** What a cut adds to them; all 0 where there is none. */
struct CutSize
{
  unsigned int n_rows               = 0;
  unsigned int n_interface_unknowns = 0;
  /** Whether the contact of a blade is to be found on its unknowns. */
  bool has_contact = false;
  /** Whether a foundation carries the body meanwhile, which the condensed
   * solver alone knows. */
  bool has_foundation = false;
};

Choice<SolverKind>
choose_solver(const SolverParameters &parameters, const SystemSize &size);

/** The kind with an assembled matrix. */
SolverKind
choose_assembled(const SolverParameters &parameters, const SystemSize &size);

/** The kind with which steps of Newton's method are solved. */
template <int dim>
SolverKind
choose_tangent_solver(const ElasticModel<dim> &model,
                      const SolverParameters &parameters);

/** The kind from where SolverKind::matrix_free has failed on. */
SolverKind
choose_fallback(const SystemSize &size);

Choice<CutStrategy>
choose_cut_strategy(const SolverParameters &parameters,
                    const SystemSize &size,
                    const CutSize &cut);

/** The same of a body whose laws are not linear. */
template <int dim>
Choice<CutStrategy>
choose_nonlinear_cut_strategy(const ElasticModel<dim> &model,
                              const SolverParameters &parameters,
                              const CutSize &cut);

/** Where multigrid takes more iterations, other solvers take less time. */
inline constexpr unsigned int most_multigrid_iterations = 500;

/** A kind in words. */
std::string
description(const SolverKind kind);
} // namespace Setsudan
