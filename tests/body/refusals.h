// SPDX-License-Identifier: LGPL-2.1-or-later
// What reading gmsh files refuses, printed.
#pragma once

#include <setsudan/body/gmsh/gmsh_file.h>
#include <setsudan/parameters/exceptions.h>

#include <functional>
#include <iostream>
#include <limits>
#include <string>

#include "gmsh_text.h"

namespace Setsudan
{
template <int dim = 3>
void
refuse(const std::string &file_name,
       const double time_limit = std::numeric_limits<double>::infinity())
{
  try
    {
      read_gmsh_file<dim>(file_name, time_limit);
      std::cout << "FAILED: accepted" << std::endl;
    }
  catch (const BodyFileError &error)
    {
      std::cout << error.what() << std::endl;
    }
}


template <int dim = 3>
void
refuse_text(const std::string &text)
{
  refuse<dim>(write_text("refused.msh", text));
}


/** Change a mesh, and try it. */
template <int dim = 3>
void
refuse_mesh(TextMesh mesh, const std::function<void(TextMesh &)> &spoil)
{
  spoil(mesh);
  refuse_text<dim>(mesh.text());
}


inline std::string
replace(std::string text, const std::string &what, const std::string &with)
{
  return text.replace(text.find(what), what.size(), with);
}
} // namespace Setsudan
