// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/lac/affine_constraints.h>

#include <setsudan/mechanics/elastic_model.h>

#include <array>
#include <map>
#include <utility>
#include <vector>

namespace Setsudan
{
/** A displacement, and the problem that it solves. */
template <int dim>
struct SolvedProblem
{
  /** The mesh as far as it is cut. */
  const CoarseMesh<dim> &mesh;
  const ElasticModel<dim> &model;
  /** Homogeneous and closed. */
  const dealii::AffineConstraints<double> &constraints;
  /** Any displacement that has what supports and openings prescribe. */
  const LA::Vector &prescribed;
  const LA::Vector &forces;
  const LA::Vector &displacement;
};

/**
 * A solved problem in whole, for another program: nodes and elements numbered
 * from 0, alike on any number of processes.
 */
template <int dim>
struct NodalProblem
{
  struct Node
  {
    /** Its number in the uncut body, which both copies of a split node have;
     * invalid for a node that refinement has made. */
    unsigned int number_in_body;
    dealii::Point<dim> position;
    dealii::Tensor<1, dim> displacement;
    dealii::Tensor<1, dim> force;
  };

  struct Element
  {
    unsigned int material;
    /** In the order of nodes.h. */
    std::array<unsigned int, n_element_nodes<dim>> nodes;
  };

  struct Unknown
  {
    unsigned int node;
    unsigned int component;
  };

  /** dependent = constant + sum of weight times independent. A support is an
   * equation without terms. No unknown is determined twice, and none that is
   * determined is a term of another equation. */
  struct Equation
  {
    Unknown dependent;
    std::vector<std::pair<Unknown, double>> terms;
    double constant;
  };

  std::vector<Node> nodes;
  /** In the order of the elements of the body, refined ones one behind the
   * other. */
  std::vector<Element> elements;
  std::map<unsigned int, Material> materials;
  std::vector<Equation> equations;
};

/** Called by all processes; the first one gets the problem, the others an
 * empty one. */
template <int dim>
NodalProblem<dim>
gather_problem(const SolvedProblem<dim> &solved, const Body<dim> &body);
} // namespace Setsudan
