// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace Setsudan
{
/**
 * gmsh, from the beginning to the end of the object's life. There can be one
 * at a time. It neither reads the user's configuration nor prints.
 */
class GmshSession
{
public:
  GmshSession();

  GmshSession(const GmshSession &) = delete;

  ~GmshSession();

  /** @throw std::runtime_error with gmsh's own message. */
  void
  open_mesh(const std::string &file_name);

  /**
   * Open a geometry, and mesh it, unless the file does so itself.
   *
   * @param dim the elements' dimension.
   * @throw std::runtime_error with gmsh's own messages and their lines.
   */
  void
  open_geometry(const std::string &file_name, const unsigned int dim);
};
} // namespace Setsudan
