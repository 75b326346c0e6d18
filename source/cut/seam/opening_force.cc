// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include <setsudan/cut/seam/opening_force.h>

#include <algorithm>

namespace Setsudan
{
using namespace dealii;

template <int dim>
OpeningForce
opening_force(const Seam<dim> &seam,
              const PairStates &states,
              const LA::Vector &exerted)
{
  std::vector<double> of_rows(seam.rows().size(), 0.);
  for (unsigned int row = 0; row < of_rows.size(); ++row)
    for (const unsigned int p : seam.rows()[row].pairs)
      if (const auto &pair = seam.pairs()[p];
          states[p] == PairState::opened && pair.is_double())
        for (unsigned int c = 0; c < dim; ++c)
          if (exerted.in_local_range(pair.plus[c]))
            of_rows[row] += pair.normal[c] * exerted(pair.plus[c]);
  Utilities::MPI::sum(of_rows, exerted.get_mpi_communicator(), of_rows);
  OpeningForce force;
  for (const double of_row : of_rows)
    {
      force.total += of_row;
      force.pull += std::max(-of_row, 0.);
    }
  return force;
}



template OpeningForce
opening_force(const Seam<2> &, const PairStates &, const LA::Vector &);
template OpeningForce
opening_force(const Seam<3> &, const PairStates &, const LA::Vector &);
} // namespace Setsudan
