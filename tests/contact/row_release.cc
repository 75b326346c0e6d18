// SPDX-License-Identifier: LGPL-2.1-or-later
// A row is released step by step, with the blade at rest and without friction:
// what its ties and the edge's force on its front exert falls to nothing, and
// contact is found anew along the way, through all of its changes. Their work
// on the way is the energy that the body loses, before minus after, by a thin
// blade and by a wedge. Half the product of the ties' forces and how far the
// walls come apart in the end is nothing with a thin blade: no criterion.

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <setsudan/contact/complementarity.h>
#include <setsudan/simulation/stage_compliance.h>

#include <algorithm>
#include <cmath>

#include "../test_setup.h"

using namespace Setsudan;
using namespace dealii;

constexpr unsigned int n_split = 8;
constexpr double front_depth = 0.5, travel = 0.52;

std::vector<SceneEntry>
settings(const std::string &shape)
{
  return {{"Body", "Size", "1, 1", ""},
          {"Body", "Elements", "8, 16", ""},
          {"Material", "Young's modulus", "1", ""},
          {"Material", "Poisson's ratio", "0.3", ""},
          {"Support", "Fixed faces", "bottom", ""},
          {"Blade", "Drive", "travel", ""},
          {"Blade", "Shape", shape, ""},
          {"Blade", "Thickness", shape == "wedge" ? "0.3" : "0", ""},
          {"Cut", "Surfaces", "x:4", ""},
          {"Yield", "Criterion", "energy release", ""},
          {"Division", "Release", "element row", ""}};
}



/** A symmetric matrix of its lower triangle. */
LAPACKFullMatrix<double>
whole(LAPACKFullMatrix<double> matrix)
{
  for (unsigned int i = 0; i < matrix.m(); ++i)
    for (unsigned int j = i + 1; j < matrix.n(); ++j)
      matrix(i, j) = matrix(j, i);
  return matrix;
}



/** A block that is cut half through, and the row that is released next. */
struct Block
{
  using Basis     = ContactBasis<2>;
  using Wall      = Basis::Wall;
  using Component = Basis::Component;

  explicit Block(const std::string &shape)
    : scene(Parameters("test", settings(shape), Scene<2>::declare))
    , body(scene, MPI_COMM_WORLD)
    , basis(make_basis())
  {
    StageForces forces{basis.vectors(), {}};
    for (const unsigned int p : body.seam().rows()[n_split].pairs)
      for (unsigned int c = 0; c < 2; ++c)
        {
          ties.push_back(forces.vectors.size());
          const auto &pair = body.seam().pairs()[p];
          forces.vectors.push_back({{pair.plus[c], 1.}, {pair.minus[c], -1.}});
        }
    const auto compliance =
      StageCompliance<2>::make(body, forces, body.seam().rows().size());
    tied     = whole(compliance->products(n_split));
    released = whole(compliance->products(n_split + 1));
  }

  /** The conditions of a stage, which are no different at other parameters. */
  ContactConditions
  conditions(const unsigned int stage) const
  {
    std::vector<VectorSum> measured;
    std::vector<double> required;
    const auto add = [&](const VectorSum &vectors, const double least) {
      measured.push_back(vectors);
      required.push_back(least);
    };
    for (unsigned int h = 0; h < basis.hats().size(); ++h)
      {
        const auto &hat = basis.hats()[h];
        if (hat.outer || !hat.is_there(stage))
          continue;
        const auto vector = [&](const Wall wall, const Component component) {
          return basis.vector_of_hat(h, wall, component);
        };
        const unsigned int first = basis.first_vector_of_hat(h);
        if (!basis.has_flanks())
          add({{{first, 1.}, {first, 0.}, {first, 0.}}}, 0);
        else if (hat.depth > front_depth - 1e-9)
          add({{{vector(Wall::minus, Component::outward), 1.},
                {vector(Wall::plus, Component::outward), 1.},
                {first, 0.}}},
              0);
        else
          for (const Wall wall : {Wall::minus, Wall::plus})
            add({{{vector(wall, Component::outward), 1.},
                  {vector(wall, Component::along), slope()},
                  {first, 0.}}},
                hat.area * slope() * (travel - hat.depth));
      }
    for (unsigned int n = 0; n < basis.edge_nodes().size(); ++n)
      if (basis.edge_nodes()[n].row == stage)
        {
          const unsigned int vector = basis.vector_of_edge_node(n);
          add({{{vector, 1.}, {vector, 0.}, {vector, 0.}}},
              travel - basis.edge_nodes()[n].depth);
        }
    Vector<double> constant(required.begin(), required.end());
    return {measured, measured, {constant, Vector<double>(constant.size())}};
  }

  double
  slope() const
  {
    return scene.blade.profile.facets[0].slope;
  }

  Basis
  make_basis()
  {
    body.begin_cut(scene.cut.cuts[0]);
    body.split_nodes();
    return {body.model(),
            body.surface(),
            body.seam(),
            body.cut().edge,
            {scene.blade.sliding, !scene.blade.profile.facets.empty(), true},
            {},
            nullptr};
  }

  const Scene<2> scene;
  CutBody<2> body;
  const Basis basis;
  /** The numbers of the row's ties among the forces, and the products of these
   * with the row tied and released. */
  std::vector<unsigned int> ties;
  LAPACKFullMatrix<double> tied, released;
};



/** Multipliers of conditions as forces on the vectors. */
Vector<double>
forces_of(const ContactConditions &conditions,
          const Vector<double> &multipliers,
          const unsigned int n)
{
  Vector<double> forces(n);
  for (unsigned int i = 0; i < multipliers.size(); ++i)
    for (const auto &[vector, factor] : conditions.exerted[i])
      forces[vector] += factor * multipliers[i];
  return forces;
}



Vector<double>
times(const LAPACKFullMatrix<double> &products, const Vector<double> &forces)
{
  Vector<double> result(forces.size());
  products.vmult(result, forces);
  return result;
}



/** Add the forces of the ties that hold the row as it is. */
void
add_ties(const Block &block, Vector<double> &forces)
{
  const Vector<double> moved = times(block.released, forces);
  const unsigned int n       = block.ties.size();
  FullMatrix<double> compliance(n, n);
  Vector<double> right(n), of_ties(n);
  for (unsigned int i = 0; i < n; ++i)
    {
      right[i] = -moved[block.ties[i]];
      for (unsigned int j = 0; j < n; ++j)
        compliance(i, j) = block.released(block.ties[i], block.ties[j]);
    }
  compliance.gauss_jordan();
  compliance.vmult(of_ties, right);
  for (unsigned int i = 0; i < n; ++i)
    forces[block.ties[i]] += of_ties[i];
}



/** The work of forces that fall from themselves to nothing on the way.
 *
 * @param before the displacements that they begin with.
 * @param after is set to the displacements in the end. */
double
work_of_release(const Block &block,
                const Vector<double> &falling,
                const Vector<double> &before,
                Vector<double> &after,
                unsigned int &n_pieces)
{
  auto conditions            = block.conditions(n_split + 1);
  const Vector<double> moved = times(block.released, falling);
  // A new hat reaches up to rows whose walls met in the mean over other hats:
  // what it finds to overlap is taken off with the forces, and has its work.
  Vector<double> overlap(conditions.measured.size());
  for (unsigned int i = 0; i < overlap.size(); ++i)
    {
      double gap = -conditions.required.constant[i];
      for (const auto &[vector, factor] : conditions.measured[i])
        {
          gap += factor * before[vector];
          conditions.required.constant[i] -= factor * moved[vector];
          conditions.required.slope[i] += factor * moved[vector];
        }
      overlap[i] = std::max(-gap, 0.);
      conditions.required.constant[i] -= overlap[i];
      conditions.required.slope[i] += overlap[i];
    }
  const Complementarity problem(block.released, conditions);
  constexpr double little = 1e-10;
  double work = 0, begin = 0;
  ActiveSet active;
  for (n_pieces = 0; begin < 1; ++n_pieces)
    {
      const auto piece = problem.solution(begin + little, active);
      const auto next  = problem.end_of(piece, begin + little);
      const double end = next ? std::min(next->p, 1.) : 1.;
      active           = piece.active;
      // By contact, and by the forces themselves.
      const double rate = falling * piece.displacements.slope - falling * moved;
      work += rate * ((end - end * end / 2) - (begin - begin * begin / 2));
      for (unsigned int i = 0; i < overlap.size(); ++i)
        work +=
          overlap[i] * piece.multipliers(i, (begin + end) / 2) * (end - begin);
      after = piece.displacements.constant;
      after += piece.displacements.slope;
      begin = end;
    }
  return work;
}



void
test(const std::string &shape)
{
  const Block block(shape);
  const unsigned int n  = block.tied.m();
  const auto conditions = block.conditions(n_split);
  const Complementarity problem(block.tied, conditions);
  const auto before = problem.solution(0);
  const auto forces = forces_of(conditions, before.multipliers.constant, n);
  const Vector<double> moved = times(block.tied, forces);

  Vector<double> all = forces;
  add_ties(block, all);
  Vector<double> same = times(block.released, all);
  same -= moved;
  check_below(shape + ": ties hold the row",
              same.linfty_norm() / moved.linfty_norm(),
              1e-10);

  Vector<double> falling(n), after(n);
  for (const unsigned int tie : block.ties)
    falling[tie] = all[tie];
  for (unsigned int i = 0; i < block.basis.edge_nodes().size(); ++i)
    {
      const unsigned int vector = block.basis.vector_of_edge_node(i);
      falling[vector]           = forces[vector];
    }
  unsigned int n_pieces;
  const double work = work_of_release(block, falling, moved, after, n_pieces);

  const auto last = block.conditions(n_split + 1);
  const Complementarity end(block.released, last);
  const auto contact = forces_of(last, end.solution(0).multipliers.constant, n);
  const double lost =
    (forces * moved - contact * times(block.released, contact)) / 2;
  std::cout << shape << ": energy is lost: " << (lost > 0);
  // A thin blade leaves at once all that it touches, at the end of the way.
  if (shape == "wedge")
    std::cout << ", contacts change on the way: " << (n_pieces > 1);
  std::cout << std::endl;
  check_below(shape + ": work on the way, and energy that is lost",
              std::abs(work + lost) / lost,
              1e-9);
  double of_ties = 0;
  for (const unsigned int tie : block.ties)
    of_ties += all[tie] * after[tie] / 2;
  if (shape == "line")
    check_below(
      "half of ties' forces times opening", std::abs(of_ties) / lost, 1e-9);
  else
    std::cout << "half of ties' forces times opening, part of it: "
              << -of_ties / lost << std::endl;
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test("line");
    test("wedge");
  });
}
