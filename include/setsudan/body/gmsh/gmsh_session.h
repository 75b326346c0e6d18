// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <gmsh.h>

namespace Setsudan
{
/**
 * gmsh, from the beginning to the end of the object's life. There can be one
 * at a time. It neither reads the user's configuration nor prints, and throws
 * its errors as std::string.
 */
struct GmshSession
{
  GmshSession()
  {
    gmsh::initialize(0, nullptr, false);
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::option::setNumber("General.AbortOnError", 2);
  }

  GmshSession(const GmshSession &) = delete;

  ~GmshSession()
  {
    gmsh::finalize();
  }
};
} // namespace Setsudan
