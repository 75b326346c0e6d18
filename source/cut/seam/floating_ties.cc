#include <setsudan/cut/seam/floating_ties.h>

#include <algorithm>

namespace Setsudan
{
using namespace dealii;

template <int dim>
void
check_ties_of_loose_group(const Seam<dim> &seam,
                          const std::vector<unsigned int> &pieces,
                          const FloatingGroup<dim> &group,
                          const Tensor<1, dim> &direction)
{
  for (unsigned int p = 0; p < seam.pairs().size(); ++p)
    {
      const auto &pair = seam.pairs()[p];
      const auto body  = std::find(
        group.pieces.begin(), group.pieces.end(), pieces[pair.element]);
      if (!pair.is_double() || seam.state(p) != Seam<dim>::State::tied ||
          body == group.pieces.end())
        continue;
      auto form = group.held.zero();
      group.held.add_displacement(
        body - group.pieces.begin(), pair.position, direction, form);
      if (group.held.unconstrained_part(form).l2_norm() > 1e-6)
        throw std::runtime_error(
          "The cut goes on through piece " + std::to_string(*body) +
          ", which it has severed and which has no support to press it "
          "against. Hold it in subsection Support, or set Support/Loose pieces "
          "= drop.");
    }
}



template void
check_ties_of_loose_group(const Seam<2> &,
                          const std::vector<unsigned int> &,
                          const FloatingGroup<2> &,
                          const Tensor<1, 2> &);
template void
check_ties_of_loose_group(const Seam<3> &,
                          const std::vector<unsigned int> &,
                          const FloatingGroup<3> &,
                          const Tensor<1, 3> &);
} // namespace Setsudan
