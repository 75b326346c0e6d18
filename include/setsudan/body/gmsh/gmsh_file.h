// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/body/body.h>

#include <limits>
#include <string>

namespace Setsudan
{
/**
 * Read a body from a gmsh file: a mesh (.msh, versions 2.2 and 4.1, text and
 * binary), or a geometry (.geo) that gmsh meshes with the options that the
 * file sets. Elements are hexahedra of 8, 20 or 27 nodes (in 2D quadrilaterals
 * of 4, 8 or 9, in the plane z = 0); nodes in the middle of faces and elements
 * are left out. Nodes of different numbers stay different, also where they lie
 * in one place.
 *
 * Elements come in the order of their numbers in the file, nodes keep theirs;
 * the middle nodes that 8-node elements do not have get numbers behind the
 * largest of the file. Physical groups become the body's groups.
 *
 * @param time_limit of gmsh for a geometry, in seconds.
 * @throw BodyFileError with a sentence that says what is wrong with the file
 * and where.
 */
template <int dim>
Body<dim>
read_gmsh_file(
  const std::string &file_name,
  const double time_limit = std::numeric_limits<double>::infinity());
} // namespace Setsudan
