// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include <setsudan/mesh/point_name.h>
#include <setsudan/output/pieces/nodal_problem.h>

#include <algorithm>
#include <tuple>

namespace Setsudan
{
using namespace dealii;

namespace
{
using Index = types::global_dof_index;

/** A node as the process that owns it knows it. */
template <int dim>
struct OwnNode
{
  /** What it is sorted by, whatever the numbers of its unknowns are: its
   * number in the uncut body, its name on the cut one, and whether it lies
   * between corners, since a hanging corner lies in such a node's place. */
  std::tuple<unsigned int, PointName, bool> name;
  std::array<Index, dim> indices;
  Point<dim> position;
  Tensor<1, dim> displacement;
  Tensor<1, dim> force;

  template <class Archive>
  void
  serialize(Archive &archive, const unsigned int)
  {
    archive &std::get<0>(name) & std::get<1>(name) & std::get<2>(name);
    archive &indices &position &displacement &force;
  }
};

/** A cell as the process that owns it knows it. */
template <int dim>
struct OwnCell
{
  CellPath path;
  unsigned int material;
  /** The first unknown of each node. */
  std::array<Index, n_element_nodes<dim>> nodes;

  template <class Archive>
  void
  serialize(Archive &archive, const unsigned int)
  {
    archive &path &material &nodes;
  }
};

/** The part of a problem that a process owns. */
template <int dim>
struct Part
{
  std::vector<OwnNode<dim>> nodes;
  std::vector<OwnCell<dim>> cells;
  /** The terms of each constrained unknown. */
  std::map<Index, std::vector<std::pair<Index, double>>> constraints;
  /** Where the prescribed displacement is not zero. */
  std::map<Index, double> prescribed;

  template <class Archive>
  void
  serialize(Archive &archive, const unsigned int)
  {
    archive &nodes &cells &constraints &prescribed;
  }
};



/** Add a cell, and those of its nodes that this process owns. */
template <int dim>
void
add_cell(const typename Discretization<dim>::Cell &cell,
         const SolvedProblem<dim> &solved,
         const Body<dim> &body,
         std::map<Index, OwnNode<dim>> &nodes,
         std::vector<OwnCell<dim>> &cells)
{
  const auto &discretization = solved.model.discretization;
  const unsigned int element = discretization.element(cell);
  const auto indices         = discretization.node_indices(cell);
  const auto points          = discretization.points_in_element(cell);
  const auto positions       = discretization.node_positions(cell);
  OwnCell<dim> own_cell{
    path_of_cell<dim>(cell), solved.model.materials.number(element), {}};
  for (unsigned int n = 0; n < indices.size(); ++n)
    {
      own_cell.nodes[n] = indices[n][0];
      if (!discretization.owned.is_element(indices[n][0]) ||
          nodes.count(indices[n][0]) > 0)
        continue;
      const auto of_body = node_at(points[n]);
      OwnNode<dim> node;
      node.name = {of_body ? body.node_numbers[element][*of_body]
                           : numbers::invalid_unsigned_int,
                   name_of_point(solved.mesh, element, points[n]),
                   n >= GeometryInfo<dim>::vertices_per_cell};
      node.indices  = indices[n];
      node.position = positions[n];
      for (unsigned int c = 0; c < dim; ++c)
        {
          node.displacement[c] = solved.displacement(indices[n][c]);
          node.force[c]        = solved.forces(indices[n][c]);
        }
      nodes.emplace(indices[n][0], node);
    }
  cells.push_back(own_cell);
}



template <int dim>
Part<dim>
collect_own_part(const SolvedProblem<dim> &solved, const Body<dim> &body)
{
  const auto &discretization = solved.model.discretization;
  Part<dim> part;
  std::map<Index, OwnNode<dim>> nodes;
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      add_cell<dim>(cell, solved, body, nodes, part.cells);
  for (const auto &node : nodes)
    part.nodes.push_back(node.second);
  for (const auto index : discretization.owned)
    {
      if (solved.constraints.is_constrained(index))
        part.constraints[index] =
          *solved.constraints.get_constraint_entries(index);
      if (solved.prescribed(index) != 0)
        part.prescribed[index] = solved.prescribed(index);
    }
  return part;
}



/** Put the parts of all processes together. */
template <int dim>
Part<dim>
join(const std::vector<Part<dim>> &parts)
{
  Part<dim> whole;
  for (const auto &part : parts)
    {
      whole.nodes.insert(
        whole.nodes.end(), part.nodes.begin(), part.nodes.end());
      whole.cells.insert(
        whole.cells.end(), part.cells.begin(), part.cells.end());
      whole.constraints.insert(part.constraints.begin(),
                               part.constraints.end());
      whole.prescribed.insert(part.prescribed.begin(), part.prescribed.end());
    }
  std::sort(whole.nodes.begin(),
            whole.nodes.end(),
            [](const auto &a, const auto &b) { return a.name < b.name; });
  std::sort(whole.cells.begin(),
            whole.cells.end(),
            [](const auto &a, const auto &b) { return a.path < b.path; });
  return whole;
}



template <int dim>
using Unknown = typename NodalProblem<dim>::Unknown;

template <int dim>
typename NodalProblem<dim>::Equation
make_equation(const Index index,
              const Part<dim> &whole,
              const std::map<Index, Unknown<dim>> &unknowns)
{
  const auto prescribed_at = [&](const Index i) {
    const auto found = whole.prescribed.find(i);
    return found == whole.prescribed.end() ? 0. : found->second;
  };
  // The constraint holds for what is left besides the prescribed part.
  typename NodalProblem<dim>::Equation equation{
    unknowns.at(index), {}, prescribed_at(index)};
  for (const auto &[term, weight] : whole.constraints.at(index))
    {
      Assert(whole.constraints.count(term) == 0,
             ExcMessage("The constraints of the processes are not closed."));
      equation.terms.emplace_back(unknowns.at(term), weight);
      equation.constant -= weight * prescribed_at(term);
    }
  std::sort(equation.terms.begin(),
            equation.terms.end(),
            [](const auto &a, const auto &b) {
              return std::tie(a.first.node, a.first.component) <
                     std::tie(b.first.node, b.first.component);
            });
  return equation;
}
} // namespace


template <int dim>
NodalProblem<dim>
gather_problem(const SolvedProblem<dim> &solved, const Body<dim> &body)
{
  const auto parts = Utilities::MPI::gather(
    solved.model.discretization.communicator, collect_own_part(solved, body));
  NodalProblem<dim> problem;
  const Part<dim> whole = join(parts);
  std::map<Index, Unknown<dim>> unknowns;
  for (const auto &node : whole.nodes)
    {
      for (unsigned int c = 0; c < dim; ++c)
        unknowns[node.indices[c]] = {
          static_cast<unsigned int>(problem.nodes.size()), c};
      problem.nodes.push_back(
        {std::get<0>(node.name), node.position, node.displacement, node.force});
    }
  for (const auto &cell : whole.cells)
    {
      typename NodalProblem<dim>::Element element{cell.material, {}};
      for (unsigned int n = 0; n < cell.nodes.size(); ++n)
        element.nodes[n] = unknowns.at(cell.nodes[n]).node;
      problem.elements.push_back(element);
      problem.materials.emplace(
        cell.material, solved.model.materials.of_element(cell.path.element));
    }
  for (const auto &node : whole.nodes)
    for (const auto index : node.indices)
      if (whole.constraints.count(index) > 0)
        problem.equations.push_back(make_equation<dim>(index, whole, unknowns));
  return problem;
}



template NodalProblem<2>
gather_problem(const SolvedProblem<2> &, const Body<2> &);
template NodalProblem<3>
gather_problem(const SolvedProblem<3> &, const Body<3> &);
} // namespace Setsudan
