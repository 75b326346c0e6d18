// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/body/gmsh/gmsh_mesh.h>

#include <string>

namespace Setsudan
{
/**
 * Let gmsh mesh a geometry (.geo), unless the file does so itself. Where some
 * elements of dimension `dim` are in physical groups, only these are taken, as
 * in the files that gmsh writes.
 *
 * A geometry is a program; so a child process runs it, which can neither run
 * commands nor write files.
 *
 * @param time_limit in seconds.
 * @throw BodyFileError where gmsh refuses the file, crashes or does not end.
 */
GmshMesh
mesh_geometry(const std::string &file_name,
              const unsigned int dim,
              const double time_limit);
} // namespace Setsudan
