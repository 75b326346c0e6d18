#include <setsudan/elasticity/elastic_model.h>

namespace Setsudan
{
using namespace dealii;

template <int dim>
ElasticModel<dim>::ElasticModel(const CoarseMesh<dim> &mesh,
                                const Body<dim> &body,
                                const Supports<dim> &supports_of_body,
                                const LoadParameters<dim> &load_parameters,
                                const Hooke &material,
                                const MPI_Comm communicator)
  : material(material)
  , discretization(mesh, communicator)
  , stiffness(discretization, material)
  , supports(discretization.relevant)
  , supported(discretization.dof_handler.n_dofs())
  , loads(assemble_loads(discretization, load_parameters, body))
{
  constrain_supports(discretization, supports_of_body, supports);
  supports.close();
  for (const auto index : discretization.owned)
    if (supports.is_constrained(index))
      supported.add_index(index);
  supported.compress();
}



template struct ElasticModel<2>;
template struct ElasticModel<3>;
} // namespace Setsudan
