// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/body/mesh_size.h>
#include <setsudan/mesh/geometry.h>
#include <setsudan/output/pieces/piece_table.h>
#include <setsudan/parameters/exceptions.h>
#include <setsudan/parameters/lists.h>
#include <setsudan/simulation/cut_body.h>
#include <setsudan/simulation/messages.h>
#include <setsudan/simulation/model_size.h>
#include <setsudan/simulation/validation.h>

#include <cmath>
#include <set>
#include <sstream>

namespace Setsudan
{
using namespace dealii;

namespace
{
std::string
counted(const double n, const std::string &what)
{
  return std::to_string(static_cast<long long>(n)) + " " + what +
         (n == 1 ? "" : "s");
}

template <int dim>
std::string
describe_size(const Scene<dim> &scene)
{
  const ModelSize size =
    estimate_size(scene.body_parameters, scene.body, scene.cut, scene.solver);
  return "Body: " + std::to_string(dim) + "D, " +
         counted(scene.body.mesh.cells.size(), "element") + ", " +
         counted(scene.body.n_nodes(), "node") + "; solved with about " +
         counted(size.n_unknowns, "unknown") + ", in " +
         text_of_memory(size.bytes) + " of memory or more.";
}

template <int dim>
std::string
describe_groups(const Body<dim> &body)
{
  std::string line;
  for (const auto &group : body.groups)
    line += (line.empty() ? "Groups: " : "; ") + describe_group(group, dim) +
            " with " +
            std::to_string(group.dimension == dim ? group.cells.size()
                                                  : group.entities.size());
  return line.empty() ? "Groups: none." : line + ".";
}

/** The names of the held components. */
template <int dim>
std::string
text_of_components(const std::bitset<dim> &components)
{
  std::string text;
  for (unsigned int c = 0; c < dim; ++c)
    if (components[c])
      text += "xyz"[c];
  return text;
}

/** What each support takes: its nodes in the body before refinement. */
template <int dim>
std::vector<std::string>
describe_supports(const Scene<dim> &scene)
{
  std::vector<std::string> lines;
  for (const auto &support : scene.supports.all())
    {
      std::set<unsigned int> nodes;
      for (unsigned int e = 0; e < scene.body.mesh.cells.size(); ++e)
        for (unsigned int n = 0; n < n_element_nodes<dim>; ++n)
          if (support.region.contains(
                scene.body, e, unit_point_of_node<dim>(n)))
            nodes.insert(scene.body.node_numbers[e][n]);
      std::string line =
        "Support (" + support.text + "): " + counted(nodes.size(), "node") +
        " held along " + text_of_components<dim>(support.components);
      if (support.displacement != Tensor<1, dim>())
        line += " and moved by " + text_of(Point<dim>(support.displacement));
      lines.push_back(line + ".");
    }
  return lines;
}

template <int dim>
std::vector<std::string>
describe_loads(const Scene<dim> &scene)
{
  std::vector<std::string> lines;
  if (scene.loads.body_force != Tensor<1, dim>())
    lines.push_back("Load (Body force): on all elements.");
  for (const auto &[text, n_faces] : scene.loads.surface_items)
    lines.push_back("Load (" + text + "): on " +
                    counted(n_faces, "element face") + ".");
  if (!scene.loads.nodal_forces.empty())
    lines.push_back("Load (Nodal forces): on " +
                    counted(scene.loads.nodal_forces.size(), "node") + ".");
  return lines;
}

/** The rows of the newest cut. */
template <int dim>
RowsOfNodes
rows_of_nodes(const Seam<dim> &seam)
{
  RowsOfNodes rows;
  for (unsigned int row = 0; row < seam.rows().size(); ++row)
    for (const unsigned int pair : seam.rows()[row].pairs)
      rows[seam.pairs()[pair].name] = row;
  return rows;
}

/** A vector with the digits that a person reads. */
template <int dim>
std::string
rounded(const Tensor<1, dim> &vector, const double size)
{
  std::ostringstream text;
  text.precision(5);
  for (unsigned int c = 0; c < dim; ++c)
    text << (c == 0 ? "(" : ", ")
         << (std::abs(vector[c]) < 1e-9 * size ? 0. : vector[c]);
  return text.str() + ")";
}

/** The pieces, as a list. */
template <int dim>
std::vector<std::string>
describe_pieces(const Scene<dim> &scene, const CutBody<dim> &body)
{
  std::vector<std::string> lines;
  const auto summaries = summarize_pieces(scene.body, body.labels().piece);
  for (unsigned int p = 0; p < summaries.size(); ++p)
    {
      std::ostringstream line;
      line.precision(6);
      line << "  piece " << p << ": "
           << counted(summaries[p].n_elements, "element") << ", volume "
           << summaries[p].volume << ", centre "
           << rounded<dim>(summaries[p].center, scene.body.mesh.extent());
      const auto weight = summaries[p].volume * scene.loads.body_force;
      if (weight.norm() > 0)
        line << ", weight " << rounded<dim>(weight, weight.norm());
      lines.push_back(line.str() + ".");
    }
  return lines;
}

/** Make one cut without solving. */
template <int dim>
void
make_cut(const Scene<dim> &scene,
         const unsigned int cut,
         CutBody<dim> &body,
         Validation &validation)
{
  auto &lines = validation.lines;
  validation.rows.emplace_back();
  if (!body.begin_cut(scene.cut.cuts[cut]))
    {
      lines.push_back("Cut " + std::to_string(cut) + " (" +
                      scene.cut.cuts[cut].text +
                      "): nothing is left to cut there.");
      return;
    }
  validation.rows.back() = rows_of_nodes(body.seam());
  lines.push_back(
    describe_cut(body, cut) + " It opens " +
    counted(scene.cut.cuts[cut].surface.faces.size(), "element face") + ".");
  body.split_nodes();
  const unsigned int n_before = body.n_pieces();
  for (unsigned int row = 0; row < body.seam().rows().size(); ++row)
    {
      const auto known = body.floating_pieces();
      if (!body.is_left_out(row))
        body.release_row(row);
      for (const auto &line : describe_loose_pieces(body, known))
        lines.push_back("  behind row " + std::to_string(row + 1) + ":" +
                        line.substr(1));
    }
  const auto known = body.floating_pieces();
  body.finish_cut();
  for (const auto &line : describe_loose_pieces(body, known))
    lines.push_back(line);
  lines.push_back("  it leaves " + counted(body.n_pieces(), "piece") +
                  (body.n_pieces() == n_before ? ", as before it." : "."));
}
} // namespace



template <int dim>
Validation
validate(const Scene<dim> &scene, const MPI_Comm communicator)
{
  Validation validation;
  auto &lines       = validation.lines;
  const auto append = [&](const std::vector<std::string> &more) {
    lines.insert(lines.end(), more.begin(), more.end());
  };
  lines = {describe_size(scene), describe_groups(scene.body)};
  for (const auto &joint : describe_open_joints(scene))
    lines.push_back("Warning: " + joint);
  append(describe_supports(scene));
  append(describe_loads(scene));
  CutBody<dim> body(scene, Refinement(), communicator);
  for (unsigned int cut = 0; cut < scene.cut.cuts.size(); ++cut)
    try
      {
        make_cut(scene, cut, body, validation);
      }
    catch (const CutError &error)
      {
        lines.push_back("Warning: the run will stop in cut " +
                        std::to_string(cut) + ": " + error.what());
        break;
      }
  append(describe_pieces(scene, body));
  validation.pieces = body.labels().piece;
  return validation;
}



template Validation
validate(const Scene<2> &, const MPI_Comm);
template Validation
validate(const Scene<3> &, const MPI_Comm);
} // namespace Setsudan
