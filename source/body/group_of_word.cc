// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/body/group_of_word.h>

namespace Setsudan
{
namespace
{
/** All groups of a body that have parts. */
template <int dim>
std::string
list_all(const Body<dim> &body)
{
  std::vector<const Group *> groups;
  for (const auto &group : body.groups)
    groups.push_back(&group);
  return list_groups(groups, dim);
}

/** Those of a dimension. */
std::vector<const Group *>
of_dimension(const std::vector<const Group *> &groups,
             const unsigned int dimension)
{
  std::vector<const Group *> result;
  for (const Group *group : groups)
    if (group->dimension == dimension)
      result.push_back(group);
  return result;
}
} // namespace



template <int dim>
const Group &
find_group_or_reject(const Parameters &parameters,
                     const std::string &subsection,
                     const std::string &name,
                     const Body<dim> &body,
                     const std::string &word,
                     const GroupKind kind)
{
  const auto require = [&](const bool condition, const std::string &allowed) {
    parameters.require(condition, subsection, name, allowed);
  };
  const auto all = find_groups(body.groups, word);
  require(!all.empty(),
          body.groups.empty() ? "no group, because the body has none"
                              : "the groups " + list_all(body) + ", and '" +
                                  word + "' is none of them");
  auto meant = of_dimension(all, kind == GroupKind::elements ? dim : dim - 1);
  if (meant.empty() && kind == GroupKind::faces_or_nodes)
    meant = all;
  require(!meant.empty(),
          std::string("groups of ") +
            (kind == GroupKind::elements ? "elements" : "faces") + ", and '" +
            word + "' is none: it means " + list_groups(all, dim));
  require(meant.size() == 1,
          "words that mean one group, and '" + word + "' means " +
            list_groups(meant, dim) +
            "; give each a name or number of its own");
  const Group &group = *meant.front();
  require(!group.cells.empty() || !group.entities.empty(),
          "groups that have elements, and '" + word + "' is empty");
  return group;
}



template const Group &
find_group_or_reject(const Parameters &,
                     const std::string &,
                     const std::string &,
                     const Body<2> &,
                     const std::string &,
                     const GroupKind);
template const Group &
find_group_or_reject(const Parameters &,
                     const std::string &,
                     const std::string &,
                     const Body<3> &,
                     const std::string &,
                     const GroupKind);
} // namespace Setsudan
