#include <setsudan/simulation/judgement.h>
#include <setsudan/solver/assembled_solver.h>

namespace Setsudan
{
using namespace dealii;

namespace
{
template <int dim>
std::function<CuttingStress(double)>
judge_by_stress(const Scene<dim> &scene,
                const CutBody<dim> &body,
                const unsigned int row,
                const Response<dim> &base,
                const Response<dim> *per_load)
{
  const auto stresses_of = [&](const LA::Vector &displacement) {
    return front_stresses(*body.model,
                          body.seam(),
                          body.seam_cells(),
                          body.seam().rows()[row],
                          scene.yield,
                          body.model->discretization.with_ghosts(displacement));
  };
  const FrontStresses at_base = stresses_of(base.displacement);
  const FrontStresses by_load =
    per_load ? stresses_of(per_load->displacement) : FrontStresses();
  const auto criterion    = scene.yield.criterion;
  const double sharpness  = scene.blade.sharpness;
  const auto communicator = body.communicator;
  return [=](const double factor) {
    return cutting_stress(criterion,
                          factor == 0 ? at_base
                                      : superpose(at_base, by_load, factor),
                          sharpness,
                          communicator);
  };
}



/** By which displacement the body gives way when a row's ties are taken off,
 * and K times it. */
template <int dim>
struct Release
{
  LA::Vector displacement;
  LA::Vector internal;
};



/**
 * The energy that taking off a row's ties sets free is that of the displacement
 * d which follows: before and after, the body is in the minimum of its
 * potential energy, once over a smaller set, so that E(before) - E(after) = d .
 * K d / 2. It equals half the ties' forces times the opening of their nodes,
 * and d is linear in the load.
 */
template <int dim>
std::function<CuttingStress(double)>
judge_by_energy(const Scene<dim> &scene,
                CutBody<dim> &body,
                const unsigned int row,
                const Response<dim> &base,
                const Response<dim> *per_load,
                SolveQuality &quality)
{
  const auto released = body.equilibrium_without(row);
  const auto release  = [&](const Response<dim> &response) -> Release<dim> {
    LA::Vector d = released->solve(
      response.forces, response.prescribed, response.displacement);
    quality = combine(quality, released->quality_of_last());
    d -= response.displacement;
    return {d, body.internal_forces(d)};
  };
  const Release<dim> at_base = release(base);
  const double constant      = at_base.displacement * at_base.internal;
  double linear = 0, quadratic = 0;
  if (per_load)
    {
      const Release<dim> by_load = release(*per_load);
      linear                     = at_base.displacement * by_load.internal;
      quadratic                  = by_load.displacement * by_load.internal;
    }
  const RowArea opened  = body.area_of_row(row);
  const double required = opened.energy * (1 - scene.blade.sharpness);
  return [=](const double factor) -> CuttingStress {
    // Behind the last nodes there is nothing to open.
    if (opened.area == 0)
      return {0, 0};
    const double energy =
      (constant + factor * (2 * linear + factor * quadratic)) / 2;
    return {energy / opened.area, required / opened.area};
  };
}
} // namespace


template <int dim>
std::function<CuttingStress(double)>
judge_row(const Scene<dim> &scene,
          CutBody<dim> &body,
          const unsigned int row,
          const Response<dim> &base,
          const Response<dim> *per_load,
          SolveQuality &quality)
{
  using Criterion = YieldParameters::Criterion;
  return scene.yield.criterion == Criterion::energy_release
           ? judge_by_energy(scene, body, row, base, per_load, quality)
           : judge_by_stress(scene, body, row, base, per_load);
}



template <int dim>
double
smallest_requirement(const Scene<dim> &scene)
{
  return required_stress(scene.yield.criterion ==
                             YieldParameters::Criterion::energy_release
                           ? scene.material.smallest_toughness()
                           : scene.material.smallest_shear_limit(),
                         scene.blade.sharpness);
}



template double
smallest_requirement(const Scene<2> &);
template double
smallest_requirement(const Scene<3> &);
template std::function<CuttingStress(double)>
judge_row(const Scene<2> &,
          CutBody<2> &,
          const unsigned int,
          const Response<2> &,
          const Response<2> *,
          SolveQuality &);
template std::function<CuttingStress(double)>
judge_row(const Scene<3> &,
          CutBody<3> &,
          const unsigned int,
          const Response<3> &,
          const Response<3> *,
          SolveQuality &);
} // namespace Setsudan
