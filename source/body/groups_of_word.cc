#include <setsudan/body/groups_of_word.h>

namespace Setsudan
{
template <int dim>
std::vector<const Group *>
groups_of_word(const Parameters &parameters,
               const std::string &subsection,
               const std::string &name,
               const Body<dim> &body,
               const std::string &word)
{
  const auto groups = find_groups(body.groups, word);
  parameters.require(!groups.empty(),
                     subsection,
                     name,
                     body.groups.empty()
                       ? "no group, because the body has none"
                       : "the groups " + list_groups(body.groups) + ", and '" +
                           word + "' is none of them");
  for (const Group *group : groups)
    parameters.require(!group->cells.empty() || !group->entities.empty(),
                       subsection,
                       name,
                       "groups that have elements, and '" + word +
                         "' is empty");
  return groups;
}



template std::vector<const Group *>
groups_of_word(const Parameters &,
               const std::string &,
               const std::string &,
               const Body<2> &,
               const std::string &);
template std::vector<const Group *>
groups_of_word(const Parameters &,
               const std::string &,
               const std::string &,
               const Body<3> &,
               const std::string &);
} // namespace Setsudan
