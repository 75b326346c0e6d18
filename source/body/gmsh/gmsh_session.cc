// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/body/gmsh/gmsh_session.h>

#include <gmsh.h>

#include <stdexcept>
#include <vector>

namespace Setsudan
{
namespace
{
// What gmsh does on an error: with 2 it throws the message as a std::string.
const std::string on_error = "General.AbortOnError";
constexpr double go_on     = 0;
constexpr double stop      = 2;

/** Records what gmsh says, as long as the object lives. */
struct Log
{
  Log()
  {
    gmsh::logger::start();
  }

  /** gmsh keeps an old record for the next session otherwise. */
  ~Log()
  {
    gmsh::logger::stop();
  }

  /** The first errors, which tell what is wrong; others follow from them. */
  std::string
  first_errors() const
  {
    constexpr unsigned int n_reported = 3;
    const std::string prefix          = "Error: ";
    std::vector<std::string> entries;
    gmsh::logger::get(entries);
    std::string errors;
    unsigned int n_errors = 0;
    for (const auto &entry : entries)
      if (entry.compare(0, prefix.size(), prefix) == 0 &&
          ++n_errors <= n_reported)
        errors += (n_errors > 1 ? "; " : "") + entry.substr(prefix.size());
    return errors;
  }
};

/** What is behind an error that does not tell it. */
std::string
explanation(const std::string &errors)
{
  if (errors.find("Unable to open file") == std::string::npos &&
      errors.find("output file") == std::string::npos)
    return "";
  return " (a file that the geometry reads must exist, and it may not write "
         "any: take out 'Save', 'Print' and 'Printf' to files)";
}

/** Run `action`; @throw std::runtime_error that gmsh cannot do `what`, where
 * gmsh throws or logs errors. */
template <typename Action>
void
guard(const std::string &what, const Action &action)
{
  const Log log;
  std::string errors;
  try
    {
      action();
      errors = log.first_errors();
    }
  catch (const std::string &message)
    {
      errors = message;
    }
  if (!errors.empty())
    throw std::runtime_error("gmsh cannot " + what + ": " + errors +
                             explanation(errors));
}

bool
has_elements(const unsigned int dim)
{
  std::vector<int> types;
  gmsh::model::mesh::getElementTypes(types, dim);
  return !types.empty();
}

/** gmsh does not log errors where a file asks it not to. */
void
check_verbosity()
{
  double verbosity;
  gmsh::option::getNumber("General.Verbosity", verbosity);
  if (verbosity < 1)
    throw std::runtime_error(
      "the geometry hides gmsh's errors by 'General.Verbosity'; take that out");
}
} // namespace


GmshSession::GmshSession()
{
  gmsh::initialize(0, nullptr, false);
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::option::setNumber(on_error, stop);
}



GmshSession::~GmshSession()
{
  gmsh::finalize();
}



void
GmshSession::open_mesh(const std::string &file_name)
{
  guard("read the file", [&]() { gmsh::open(file_name); });
}



void
GmshSession::open_geometry(const std::string &file_name, const unsigned int dim)
{
  // The message that names the line is often not the first.
  gmsh::option::setNumber(on_error, go_on);
  guard("read the file", [&]() { gmsh::open(file_name); });
  check_verbosity();
  // gmsh meshes in threads, out of which nothing can be thrown, and the file
  // may have changed the option.
  gmsh::option::setNumber(on_error, go_on);
  if (!has_elements(dim))
    guard("mesh the geometry", [&]() { gmsh::model::mesh::generate(dim); });
  gmsh::option::setNumber(on_error, stop);
}
} // namespace Setsudan
