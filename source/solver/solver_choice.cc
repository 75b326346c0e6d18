// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include <setsudan/mechanics/law_kernel.h>
#include <setsudan/solver/solver_choice.h>

namespace Setsudan
{
namespace
{
// The factor of a larger body takes more memory than a machine is likely to
// have.
constexpr dealii::types::global_dof_index most_factored_unknowns = 400000;
// The factor of a body of more unknowns takes longer than a few iterative
// solves, and an order of magnitude more memory.
constexpr dealii::types::global_dof_index most_condensed_unknowns = 200000;
// Bytes that a condensation may take besides the factor.
constexpr double most_interface_memory = 4e9;
// With fewer rows the second factorization does not pay.
constexpr unsigned int fewest_condensed_rows = 3;

// With a larger one the factor of one state is a poor preconditioner of the
// tangent of the next: the volume resists more than all else, and in other
// directions once the body has moved.
constexpr double largest_preconditioned_ratio = 0.49;
// Moduli do not give back a ratio to the last digit.
constexpr double round_off = 1e-8;

SolverKind
direct_kind(const SystemSize &size)
{
  return size.n_processes == 1 ? SolverKind::cholesky : SolverKind::mumps;
}

Choice<CutStrategy>
row_by_row(const std::string &reason)
{
  return {CutStrategy::row_by_row, reason};
}

/** The Schur complement of the two sides, a block each, and its factor. */
double
interface_memory(const double n)
{
  return sizeof(double) * n * n * (1 + 0.5 + 1);
}

/** The same where contact is found: a solve for each vector of contact in each
 * stage takes so much longer that one factorization is taken where it fits. */
Choice<CutStrategy>
choose_for_contact(const SolverParameters &parameters,
                   const SystemSize &size,
                   const CutSize &cut)
{
  using CutSolve                      = SolverParameters::CutSolve;
  const Choice<CutStrategy> condensed = {
    CutStrategy::condensed,
    std::string("on which the blade's contact is found") +
      (size.n_processes > 1 ? " by the first process" : "")};
  if (cut.has_foundation || parameters.cut_solve == CutSolve::condensed)
    return condensed;
  if (parameters.cut_solve == CutSolve::row_by_row)
    return row_by_row("as Division/Solve says");
  if (size.n_unknowns > most_factored_unknowns)
    return row_by_row("since more than " +
                      std::to_string(most_factored_unknowns) +
                      " unknowns are too many to be factored");
  if (interface_memory(cut.n_interface_unknowns) > most_interface_memory)
    return row_by_row("since the cut has too many unknowns for the memory");
  return condensed;
}
} // namespace


template <int dim>
SystemSize
size_of(const Discretization<dim> &discretization)
{
  return {discretization.dof_handler.n_dofs(),
          discretization.type,
          dealii::Utilities::MPI::n_mpi_processes(discretization.communicator)};
}



SolverKind
choose_assembled(const SolverParameters &parameters, const SystemSize &size)
{
  return parameters.is_direct(size.n_unknowns)
           ? direct_kind(size)
           : SolverKind::algebraic_multigrid;
}



Choice<SolverKind>
choose_solver(const SolverParameters &parameters, const SystemSize &size)
{
  const bool is_direct  = parameters.is_direct(size.n_unknowns);
  const SolverKind kind = is_direct || size.element_type == ElementType::linear
                            ? choose_assembled(parameters, size)
                            : SolverKind::matrix_free;
  return {
    kind,
    parameters.method != SolverParameters::Method::automatic
      ? "as Solver/Method says"
      : std::string("chosen because the unknowns ") +
          (is_direct ? "do not exceed " : "exceed ") +
          "Solver/Direct up to = " + std::to_string(parameters.direct_up_to)};
}



template <int dim>
SolverKind
choose_tangent_solver(const ElasticModel<dim> &model,
                      const SolverParameters &parameters)
{
  const SystemSize size = size_of(model.discretization);
  return parameters.is_direct(size.n_unknowns) || !has_law_kernel(model)
           ? choose_assembled(parameters, size)
           : SolverKind::matrix_free;
}



SolverKind
choose_fallback(const SystemSize &size)
{
  return size.n_unknowns <= most_factored_unknowns
           ? direct_kind(size)
           : SolverKind::algebraic_multigrid;
}



Choice<CutStrategy>
choose_cut_strategy(const SolverParameters &parameters,
                    const SystemSize &size,
                    const CutSize &cut)
{
  using CutSolve = SolverParameters::CutSolve;
  if (cut.n_interface_unknowns == 0)
    return row_by_row("since no ties are left to take off");
  if (cut.has_contact)
    return choose_for_contact(parameters, size, cut);
  if (parameters.cut_solve == CutSolve::row_by_row)
    return row_by_row("as Division/Solve says");
  if (size.n_processes > 1)
    return row_by_row("since there are several processes");
  if (parameters.cut_solve == CutSolve::condensed)
    return {CutStrategy::condensed, "as Division/Solve says"};
  if (parameters.method == SolverParameters::Method::iterative)
    return row_by_row("since Solver/Method is iterative");
  if (cut.n_rows < fewest_condensed_rows)
    return row_by_row("since there are few rows");
  if (size.n_unknowns > most_condensed_unknowns)
    return row_by_row("since there are more than " +
                      std::to_string(most_condensed_unknowns) + " unknowns");
  if (interface_memory(cut.n_interface_unknowns) > most_interface_memory)
    return row_by_row("since the cut has too many unknowns for the memory");
  return {CutStrategy::condensed,
          "since there are " + std::to_string(cut.n_rows) + " rows"};
}



template <int dim>
Choice<CutStrategy>
choose_nonlinear_cut_strategy(const ElasticModel<dim> &model,
                              const SolverParameters &parameters,
                              const CutSize &cut)
{
  if (cut.has_contact || !model.materials.finite_strain ||
      model.discretization.type == ElementType::linear)
    return row_by_row("since the material is not linear");
  for (const auto &material : model.materials.all())
    if (material.at_rest.poissons_ratio() >
        largest_preconditioned_ratio + round_off)
      return row_by_row("since Poisson's ratio exceeds 0.49");
  const auto choice =
    choose_cut_strategy(parameters, size_of(model.discretization), cut);
  if (choice.kind == CutStrategy::condensed)
    return {CutStrategy::preconditioned, choice.reason};
  return choice;
}



std::string
description(const SolverKind kind)
{
  switch (kind)
    {
      case SolverKind::cholesky:
        return "direct (CHOLMOD)";
      case SolverKind::mumps:
        return "direct (MUMPS, Cholesky)";
      case SolverKind::indefinite:
        return "direct (MUMPS, LDL^T)";
      case SolverKind::matrix_free:
        return "iterative (conjugate gradients with multigrid, without a "
               "matrix)";
      case SolverKind::algebraic_multigrid:
        return "iterative (conjugate gradients with algebraic multigrid)";
    }
  return "";
}



template SystemSize
size_of(const Discretization<2> &);
template SystemSize
size_of(const Discretization<3> &);
template Choice<CutStrategy>
choose_nonlinear_cut_strategy(const ElasticModel<2> &,
                              const SolverParameters &,
                              const CutSize &);
template Choice<CutStrategy>
choose_nonlinear_cut_strategy(const ElasticModel<3> &,
                              const SolverParameters &,
                              const CutSize &);
template SolverKind
choose_tangent_solver(const ElasticModel<2> &, const SolverParameters &);
template SolverKind
choose_tangent_solver(const ElasticModel<3> &, const SolverParameters &);
} // namespace Setsudan
