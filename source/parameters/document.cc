// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <setsudan/parameters/document.h>

#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>

#include <ostream>
#include <sstream>

namespace Setsudan
{
using namespace dealii;
using boost::property_tree::ptree;

namespace
{
/** deal.II writes characters outside [A-Za-z0-9] as '_' and two hex digits. */
std::string
demangle(const std::string &name)
{
  std::string text;
  for (std::size_t i = 0; i < name.size(); ++i)
    if (name[i] == '_' && i + 2 < name.size())
      {
        text +=
          static_cast<char>(std::stoi(name.substr(i + 1, 2), nullptr, 16));
        i += 2;
      }
    else
      text += name[i];
  return text;
}

/** A '|' would end the cell of a table. */
std::string
cell(const std::string &text)
{
  std::string escaped;
  for (const char c : text)
    escaped += c == '|' ? "\\|" : c == '\n' ? " " : std::string(1, c);
  return escaped;
}

void
write_table(const ptree &subsection, std::ostream &out)
{
  out << "\n| parameter | default | meaning |\n|---|---|---|\n";
  for (const auto &[name, entry] : subsection)
    if (const auto default_value =
          entry.get_optional<std::string>("default_value"))
      out << "| " << cell(demangle(name)) << " | "
          << (default_value->empty() ? "" : "`" + cell(*default_value) + "`")
          << " | " << cell(entry.get<std::string>("documentation")) << " |\n";
}

void
write_subsections(const ptree &tree, const std::string &path, std::ostream &out)
{
  for (const auto &[name, entry] : tree)
    if (!entry.get_optional<std::string>("default_value"))
      {
        const std::string full_name = path + demangle(name);
        out << "\n## " << full_name << '\n';
        write_table(entry, out);
        write_subsections(entry, full_name + "/", out);
      }
}
} // namespace



void
document_parameters(const Parameters::Declare &declare, std::ostream &out)
{
  ParameterHandler handler;
  declare(handler);
  std::stringstream json;
  handler.print_parameters(
    json, ParameterHandler::JSON | ParameterHandler::KeepDeclarationOrder);
  ptree tree;
  boost::property_tree::read_json(json, tree);
  write_table(tree, out);
  write_subsections(tree, "", out);
}
} // namespace Setsudan
