#include <deal.II/base/mpi.h>

#include <setsudan/elasticity/balance.h>


namespace Setsudan
{
using namespace dealii;

template <int dim>
Balance
check_balance(const Discretization<dim> &discretization,
              const IndexSet &supported,
              const LA::Vector &internal,
              const LA::Vector &loads,
              const LA::Vector &applied,
              const std::vector<PointForce<dim>> &blade)
{
  Resultant<dim> resultant(discretization);
  const auto sites   = discretization.sites();
  unsigned int local = 0;
  for (const auto index : discretization.owned)
    {
      Tensor<1, dim> force;
      double &component = force[sites[local].component];
      component         = loads(index);
      if (supported.is_element(index))
        component += internal(index) - applied(index);
      if (component != 0)
        resultant.add(sites[local].position, force);
      ++local;
    }
  if (Utilities::MPI::this_mpi_process(discretization.communicator) == 0)
    for (const auto &[point, force] : blade)
      resultant.add(point, force);
  resultant.sum_over_processes();
  return resultant.relative();
}



template <int dim>
Tensor<1, dim>
support_reaction(const Discretization<dim> &discretization,
                 const IndexSet &supported,
                 const LA::Vector &internal,
                 const LA::Vector &applied)
{
  Tensor<1, dim> reaction;
  const auto sites   = discretization.sites();
  unsigned int local = 0;
  for (const auto index : discretization.owned)
    {
      if (supported.is_element(index))
        reaction[sites[local].component] += internal(index) - applied(index);
      ++local;
    }
  return Utilities::MPI::sum(reaction, discretization.communicator);
}



template Balance
check_balance(const Discretization<2> &,
              const IndexSet &,
              const LA::Vector &,
              const LA::Vector &,
              const LA::Vector &,
              const std::vector<PointForce<2>> &);
template Balance
check_balance(const Discretization<3> &,
              const IndexSet &,
              const LA::Vector &,
              const LA::Vector &,
              const LA::Vector &,
              const std::vector<PointForce<3>> &);
template Tensor<1, 2>
support_reaction(const Discretization<2> &,
                 const IndexSet &,
                 const LA::Vector &,
                 const LA::Vector &);
template Tensor<1, 3>
support_reaction(const Discretization<3> &,
                 const IndexSet &,
                 const LA::Vector &,
                 const LA::Vector &);
} // namespace Setsudan
