// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include <setsudan/mechanics/stress/stress_evaluator.h>
#include <setsudan/mesh/point_name.h>
#include <setsudan/output/tables/node_table.h>

#include <iomanip>
#include <map>
#include <ostream>
#include <sstream>
#include <string>
#include <tuple>

namespace Setsudan
{
using namespace dealii;

namespace
{
/** A node by its number in the uncut body, or for one that refinement has made
 * by the largest number there is and its name; and by its side: "0", or a sign
 * for each cut. */
using NodeKey = std::tuple<unsigned int, PointName, std::string>;

/** What the elements that meet at a node say of it. */
struct NodeRecord
{
  std::array<double, 3> position{};
  std::array<double, 3> displacement{};
  double max_shear = 0;
  SymmetricTensor<2, 3> stress_sum;
  unsigned int n_elements = 0;

  void
  add(const NodeRecord &other)
  {
    position     = other.position;
    displacement = other.displacement;
    max_shear    = std::max(max_shear, other.max_shear);
    stress_sum += other.stress_sum;
    n_elements += other.n_elements;
  }

  template <class Archive>
  void
  serialize(Archive &archive, const unsigned int)
  {
    archive &position &displacement &max_shear &stress_sum &n_elements;
  }
};

using NodeRecords = std::map<NodeKey, NodeRecord>;

/** The signs of the nodes that a cut has split, by their first unknown. */
template <int dim>
std::map<types::global_dof_index, std::string>
collect_signs(const std::vector<CutWall<dim>> &walls)
{
  std::map<types::global_dof_index, std::string> signs;
  for (const auto &[pairs, states] : walls)
    {
      // A node on a crossing belongs to several pairs of the same cut.
      std::map<types::global_dof_index, char> sign;
      for (unsigned int p = 0; p < pairs.size(); ++p)
        if (pairs[p].is_double() && states[p] != PairState::tied)
          {
            sign[pairs[p].minus[0]] = '-';
            sign[pairs[p].plus[0]]  = '+';
          }
      for (const auto &[index, s] : sign)
        signs[index] += s;
    }
  return signs;
}



template <int dim>
NodeRecords
collect_own_records(const Body<dim> &body,
                    const ElasticModel<dim> &model,
                    const std::vector<CutWall<dim>> &walls,
                    const LA::Vector &displacement)
{
  const auto signs           = collect_signs(walls);
  const auto &discretization = model.discretization;
  StressEvaluator<dim> recovery(discretization,
                                model.materials,
                                node_points(discretization),
                                &model.internal);
  NodeRecords records;
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        recovery.reinit(cell, displacement);
        const unsigned int element = discretization.element(cell);
        const auto nodes           = discretization.node_indices(cell);
        const auto points          = discretization.points_in_element(cell);
        const auto where           = discretization.node_positions(cell);
        for (unsigned int node = 0; node < nodes.size(); ++node)
          {
            NodeRecord record;
            const auto &position = where[node];
            for (unsigned int c = 0; c < dim; ++c)
              {
                record.position[c]     = position[c];
                record.displacement[c] = displacement(nodes[node][c]);
              }
            record.stress_sum = recovery.stress(node);
            record.max_shear  = maximum_shear(record.stress_sum);
            record.n_elements = 1;
            const auto sign   = signs.find(nodes[node][0]);
            NodeKey key{numbers::invalid_unsigned_int,
                        {},
                        sign == signs.end() ? "0" : sign->second};
            if (const auto of_body = node_at(points[node]))
              std::get<0>(key) = body.node_numbers[element][*of_body];
            else
              std::get<1>(key) =
                name_of_point(body.mesh, element, points[node]);
            records[key].add(record);
          }
      }
  return records;
}


std::string
table_of(const NodeRecords &records)
{
  std::ostringstream out;
  out << "number,side,x,y,z,ux,uy,uz,max_shear,sxx,syy,szz,sxy,syz,sxz\n"
      << std::setprecision(12);
  unsigned int last = 0;
  PointName last_name;
  for (const auto &[key, record] : records)
    {
      const auto &[number, name, side] = key;
      // The copies of a new node follow each other.
      if (number != numbers::invalid_unsigned_int)
        last = number;
      else if (name != last_name)
        ++last;
      last_name = name;
      out << last << ',' << side;
      for (const double x : record.position)
        out << ',' << x;
      for (const double u : record.displacement)
        out << ',' << u;
      out << ',' << record.max_shear;
      const auto stress = record.stress_sum / double(record.n_elements);
      for (const auto &[i, j] : std::vector<std::pair<int, int>>{
             {0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {0, 2}})
        out << ',' << stress[i][j];
      out << '\n';
    }
  return out.str();
}
} // namespace


template <int dim>
void
write_node_table(const Body<dim> &body,
                 const ElasticModel<dim> &model,
                 const std::vector<CutWall<dim>> &walls,
                 const LA::Vector &displacement,
                 const OutputDirectory &directory,
                 const std::string &name)
{
  const MPI_Comm communicator = model.discretization.communicator;
  NodeRecords records;
  for (const auto &part : Utilities::MPI::gather(
         communicator, collect_own_records(body, model, walls, displacement)))
    for (const auto &[key, record] : part)
      records[key].add(record);
  if (Utilities::MPI::this_mpi_process(communicator) > 0)
    return;

  const std::string table = table_of(records);
  directory.write(name, [&](std::ostream &out) { out << table; });
}



template void
write_node_table(const Body<2> &,
                 const ElasticModel<2> &,
                 const std::vector<CutWall<2>> &,
                 const LA::Vector &,
                 const OutputDirectory &,
                 const std::string &);
template void
write_node_table(const Body<3> &,
                 const ElasticModel<3> &,
                 const std::vector<CutWall<3>> &,
                 const LA::Vector &,
                 const OutputDirectory &,
                 const std::string &);
} // namespace Setsudan
