#include <deal.II/base/mpi.h>

#include <setsudan/elasticity/balance.h>

namespace Setsudan
{
using namespace dealii;

template <int dim>
BodyBalance<dim>
check_balance(const Discretization<dim> &discretization,
              const IndexSet &supported,
              const LA::Vector &internal,
              const LA::Vector &loads,
              const LA::Vector &applied,
              const std::vector<PointForce<dim>> &blade)
{
  const MPI_Comm communicator = discretization.communicator;
  Resultant<dim> resultant(discretization);
  BodyBalance<dim> balance;
  const auto sites   = discretization.sites();
  unsigned int local = 0;
  for (const auto index : discretization.owned)
    {
      const auto &[position, component] = sites[local++];
      Tensor<1, dim> force;
      force[component] = loads(index);
      if (supported.is_element(index))
        {
          force[component] += internal(index) - applied(index);
          balance.reaction[component] += internal(index) - applied(index);
        }
      if (force[component] != 0)
        resultant.add(position, force);
    }
  if (Utilities::MPI::this_mpi_process(communicator) == 0)
    for (const auto &[point, force] : blade)
      resultant.add(point, force);
  resultant.sum_over_processes();
  static_cast<Balance &>(balance) = resultant.relative();
  balance.reaction = Utilities::MPI::sum(balance.reaction, communicator);
  return balance;
}



template BodyBalance<2>
check_balance(const Discretization<2> &,
              const IndexSet &,
              const LA::Vector &,
              const LA::Vector &,
              const LA::Vector &,
              const std::vector<PointForce<2>> &);
template BodyBalance<3>
check_balance(const Discretization<3> &,
              const IndexSet &,
              const LA::Vector &,
              const LA::Vector &,
              const LA::Vector &,
              const std::vector<PointForce<3>> &);
} // namespace Setsudan
