// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/body/gmsh/gmsh_mesh.h>
#include <setsudan/body/gmsh/text_file.h>

namespace Setsudan
{
/**
 * Read a mesh file (.msh), of version 2.2 or 4.1, text or binary, that is whole
 * in all counts and numbers.
 *
 * @throw BodyFileError where it is a mesh of another version, lacks a section
 * or has one twice, or where a section is damaged, with the place in a text.
 */
GmshMesh
read_msh_file(const TextFile &file);
} // namespace Setsudan
