#include <setsudan/body/group.h>

#include <algorithm>

namespace Setsudan
{
std::vector<const Group *>
find_groups(const std::vector<Group> &groups, const std::string &word)
{
  std::vector<const Group *> named, numbered;
  for (const auto &group : groups)
    {
      if (!word.empty() && group.name == word)
        named.push_back(&group);
      if (std::to_string(group.number) == word)
        numbered.push_back(&group);
    }
  return named.empty() ? numbered : named;
}



std::string
list_groups(const std::vector<Group> &groups)
{
  std::vector<std::string> names;
  for (const auto &group : groups)
    {
      const std::string name =
        group.name.empty() ? std::to_string(group.number) : group.name;
      if (std::find(names.begin(), names.end(), name) == names.end())
        names.push_back(name);
    }
  std::string text;
  for (const auto &name : names)
    text += (text.empty() ? "" : ", ") + name;
  return text;
}
} // namespace Setsudan
