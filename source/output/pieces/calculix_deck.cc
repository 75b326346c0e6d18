// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/output/pieces/calculix_deck.h>
#include <setsudan/output/pieces/calculix_material.h>
#include <setsudan/output/pieces/element_order.h>

#include <iomanip>
#include <ostream>

namespace Setsudan
{
using namespace dealii;

namespace
{
// CalculiX reads at most 20 characters of a number, and a line of elements may
// hold 16 entries and one of an equation 4 terms.
constexpr int n_digits                = 12;
constexpr unsigned int n_line_entries = 16;
constexpr unsigned int n_line_terms   = 4;

/** All numbers of nodes and elements count from 1. */
template <int dim>
class DeckWriter
{
public:
  DeckWriter(const NodalProblem<dim> &problem, std::ostream &out)
    : problem(problem)
    , out(out)
  {
    out << std::scientific << std::setprecision(n_digits);
  }

  void
  write()
  {
    write_nodes();
    write_elements();
    write_materials();
    write_equations();
    write_step();
    write_boundary();
    write_forces();
    out << "*NODE PRINT, NSET=BODY\nU\n"
           "*NODE FILE\nU\n*EL FILE\nS\n*END STEP\n";
  }

private:
  using Equation = typename NodalProblem<dim>::Equation;
  using Unknown  = typename NodalProblem<dim>::Unknown;

  /** The node that moves by 1, whose multiples are the constants of
   * equations. */
  unsigned int
  unit_node() const
  {
    return problem.nodes.size() + 1;
  }

  static bool
  is_support(const Equation &equation)
  {
    return equation.terms.empty();
  }

  void
  write_nodes()
  {
    out << "*NODE, NSET=BODY\n";
    for (unsigned int n = 0; n < problem.nodes.size(); ++n)
      {
        out << n + 1;
        for (unsigned int d = 0; d < 3; ++d)
          out << ", " << (d < dim ? problem.nodes[n].position[d % dim] : 0.);
        out << '\n';
      }
    out << "** A node outside of the body that moves by 1: the openings of "
           "equations are multiples of it.\n"
        << "*NODE, NSET=UNIT\n"
        << unit_node() << ", 0., 0., 0.\n";
  }

  void
  write_elements()
  {
    const auto order = node_order<dim>(vtk_edges<dim>());
    for (const auto &material : problem.materials)
      {
        out << "*ELEMENT, TYPE=" << (dim == 2 ? "CPE8" : "C3D20")
            << ", ELSET=MATERIAL_" << material.first << '\n';
        for (unsigned int e = 0; e < problem.elements.size(); ++e)
          if (problem.elements[e].material == material.first)
            {
              out << e + 1;
              for (unsigned int n = 0; n < order.size(); ++n)
                out << ((n + 1) % n_line_entries == 0 ? ",\n" : ", ")
                    << problem.elements[e].nodes[order[n]] + 1;
              out << '\n';
            }
      }
  }

  bool
  has_finite_strain() const
  {
    return problem.materials.begin()->second.law->hyperelastic() != nullptr;
  }

  void
  write_materials()
  {
    for (const auto &[number, material] : problem.materials)
      {
        out << "*MATERIAL, NAME=MATERIAL_" << number << '\n'
            << calculix_material(material).value();
        const auto orientation = calculix_orientation(material);
        if (orientation)
          out << "*ORIENTATION, NAME=AXES_" << number << '\n' << *orientation;
        out << "*SOLID SECTION, ELSET=MATERIAL_" << number
            << ", MATERIAL=MATERIAL_" << number;
        if (orientation)
          out << ", ORIENTATION=AXES_" << number;
        out << '\n';
        if (dim == 2)
          out << "1.\n";
      }
  }

  void
  write_step()
  {
    if (has_finite_strain())
      // Until Newton's method has left less of forces and displacements than
      // what CalculiX prints.
      out << "*STEP, NLGEOM\n*STATIC\n1., 1.\n"
             "*CONTROLS, PARAMETERS=FIELD\n1e-8, 1e-8, , , 1e-8\n";
    else
      out << "*STEP\n*STATIC\n";
  }

  void
  write_term(const Unknown &unknown, const double weight)
  {
    out << unknown.node + 1 << ", " << unknown.component + 1 << ", " << weight;
  }

  /** dependent - sum of weight times independent - constant times 1 = 0. */
  void
  write_equations()
  {
    for (const auto &equation : problem.equations)
      {
        if (is_support(equation))
          continue;
        const bool has_constant = equation.constant != 0;
        out << "*EQUATION\n"
            << 1 + equation.terms.size() + has_constant << '\n';
        write_term(equation.dependent, 1);
        unsigned int n     = 1;
        const auto advance = [&]() {
          out << (n++ % n_line_terms == 0 ? ",\n" : ", ");
        };
        for (const auto &[unknown, weight] : equation.terms)
          {
            advance();
            write_term(unknown, -weight);
          }
        if (has_constant)
          {
            advance();
            write_term({unit_node() - 1, 0}, -equation.constant);
          }
        out << '\n';
      }
  }

  void
  write_boundary()
  {
    out << "*BOUNDARY\n" << unit_node() << ", 1, 1, 1.\n";
    for (const auto &equation : problem.equations)
      if (is_support(equation))
        out << equation.dependent.node + 1 << ", "
            << equation.dependent.component + 1 << ", "
            << equation.dependent.component + 1 << ", " << equation.constant
            << '\n';
  }

  void
  write_forces()
  {
    bool any = false;
    for (unsigned int n = 0; n < problem.nodes.size(); ++n)
      for (unsigned int c = 0; c < dim; ++c)
        if (problem.nodes[n].force[c] != 0)
          {
            out << (any ? "" : "*CLOAD\n") << n + 1 << ", " << c + 1 << ", "
                << problem.nodes[n].force[c] << '\n';
            any = true;
          }
  }

  const NodalProblem<dim> &problem;
  std::ostream &out;
};



template <int dim>
void
write_displacements(const NodalProblem<dim> &problem, std::ostream &out)
{
  out << "node,number,x,y,z,ux,uy,uz\n" << std::setprecision(n_digits);
  for (unsigned int n = 0; n < problem.nodes.size(); ++n)
    {
      const auto &node = problem.nodes[n];
      out << n + 1 << ',';
      if (node.number_in_body != numbers::invalid_unsigned_int)
        out << node.number_in_body;
      for (const Tensor<1, dim> &vector :
           {Tensor<1, dim>(node.position), node.displacement})
        for (unsigned int d = 0; d < 3; ++d)
          out << ',' << (d < dim ? vector[d % dim] : 0.);
      out << '\n';
    }
}
} // namespace


template <int dim>
void
write_calculix_deck(const NodalProblem<dim> &problem,
                    const OutputDirectory &directory,
                    const std::string &name)
{
  directory.write(name + ".inp", [&](std::ostream &out) {
    out << "** A solved state of Setsudan: 'ccx " << name
        << "' solves it again.\n** Setsudan's displacements are in " << name
        << ".csv, by the same numbers of nodes.\n";
    DeckWriter<dim>(problem, out).write();
  });
  directory.write(name + ".csv", [&](std::ostream &out) {
    write_displacements(problem, out);
  });
}



template void
write_calculix_deck(const NodalProblem<2> &,
                    const OutputDirectory &,
                    const std::string &);
template void
write_calculix_deck(const NodalProblem<3> &,
                    const OutputDirectory &,
                    const std::string &);
} // namespace Setsudan
