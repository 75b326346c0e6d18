// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/body/group.h>

namespace Setsudan
{
std::vector<const Group *>
find_groups(const std::vector<Group> &groups, const std::string &word)
{
  std::vector<const Group *> found;
  for (const auto &group : groups)
    if (!word.empty() &&
        (group.name == word || std::to_string(group.number) == word))
      found.push_back(&group);
  return found;
}



std::string
describe_group(const Group &group, const unsigned int dim)
{
  const std::string kind   = group.dimension == dim       ? "elements"
                             : group.dimension + 1 == dim ? "faces"
                             : group.dimension == 1       ? "lines"
                                                          : "points";
  const std::string number = std::to_string(group.number);
  return group.name.empty()
           ? number + " (" + kind + ")"
           : '"' + group.name + "\" (" + number + ", " + kind + ")";
}



std::string
list_groups(const std::vector<const Group *> &groups, const unsigned int dim)
{
  std::string text;
  for (const Group *group : groups)
    text += (text.empty() ? "" : ", ") + describe_group(*group, dim);
  return text;
}
} // namespace Setsudan
