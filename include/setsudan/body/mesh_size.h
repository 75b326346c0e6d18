// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/body/box_numbering.h>
#include <setsudan/element/element_type.h>
#include <setsudan/mesh/coarse_mesh.h>
#include <setsudan/parameters/parameters.h>

#include <array>
#include <string>

namespace Setsudan
{
/** How many vertices, lines, faces and cells a mesh has, by their dimension.
 * They are real numbers, since what a scene asks for may exceed all others. */
template <int dim>
struct MeshSize
{
  std::array<double, dim + 1> n_parts{};

  /** The size when all cells are halved along each axis. */
  MeshSize
  refined() const;

  double
  n_cells() const;

  /** The displacement components of all nodes. */
  double
  n_unknowns(const ElementType type) const;
};

template <int dim>
MeshSize<dim>
size_of_box(const typename BoxNumbering<dim>::Indices &n_elements);

template <int dim>
MeshSize<dim>
size_of_mesh(const CoarseMesh<dim> &mesh);

/**
 * The least memory that a model takes [bytes], as measured
 * (doc/performance.md): 1.5 kB for each unknown, and the factor of a direct
 * solver, if it is one.
 */
template <int dim>
double
memory_of_model(const double n_unknowns, const bool is_direct);

/** Bytes in words: "15 GB". */
std::string
text_of_memory(const double bytes);

/**
 * Refuse a model that the memory of the machines cannot hold, or that has more
 * unknowns than can be numbered. Called by all processes.
 *
 * @param bytes            see memory_of_model().
 * @param subsection, name the parameter that makes it so large.
 * @throw SceneError with the numbers.
 */
void
check_memory(const Parameters &parameters,
             const std::string &subsection,
             const std::string &name,
             const double n_cells,
             const double n_unknowns,
             const double bytes);
} // namespace Setsudan
