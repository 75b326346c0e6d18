// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include <setsudan/body/mesh_size.h>
#include <setsudan/mesh/cell_lines.h>
#include <setsudan/mesh/face_index.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <set>

#include <sys/resource.h>
#include <unistd.h>

namespace Setsudan
{
using namespace dealii;

template <int dim>
MeshSize<dim>
MeshSize<dim>::refined() const
{
  // Within a part of dimension k there are new ones of dimension j: two halves
  // in each of j of its k directions, the middle in the others.
  MeshSize<dim> finer;
  for (unsigned int k = 0; k <= dim; ++k)
    {
      double n_choices = 1;
      for (unsigned int j = 0; j <= k; ++j)
        {
          finer.n_parts[j] += n_choices * std::pow(2., j) * n_parts[k];
          n_choices *= double(k - j) / (j + 1);
        }
    }
  return finer;
}



template <int dim>
double
MeshSize<dim>::n_cells() const
{
  return n_parts[dim];
}



template <int dim>
double
MeshSize<dim>::n_unknowns(const ElementType type) const
{
  double n_nodes = n_parts[0];
  if (type != ElementType::linear)
    n_nodes += n_parts[1];
  for (unsigned int d = 2; d <= dim && type == ElementType::quadratic; ++d)
    n_nodes += n_parts[d];
  return dim * n_nodes;
}



template <int dim>
MeshSize<dim>
size_of_box(const typename BoxNumbering<dim>::Indices &n_elements)
{
  MeshSize<dim> size;
  // A part extends along some axes, whose bits are set.
  for (unsigned int axes = 0; axes < (1u << dim); ++axes)
    {
      unsigned int dimension = 0;
      double n               = 1;
      for (unsigned int d = 0; d < dim; ++d)
        {
          const bool extends = (axes >> d & 1) == 1;
          n *= extends ? n_elements[d] : n_elements[d] + 1.;
          dimension += extends;
        }
      size.n_parts[dimension] += n;
    }
  return size;
}



template <int dim>
MeshSize<dim>
size_of_mesh(const CoarseMesh<dim> &mesh)
{
  MeshSize<dim> size;
  size.n_parts[0]      = mesh.vertices.size();
  size.n_parts[dim]    = mesh.cells.size();
  const auto lines     = collect_lines(mesh);
  const auto different = [](const auto &sorted, const auto &key) {
    double n = 0;
    for (std::size_t i = 0; i < sorted.size(); ++i)
      n += i == 0 || key(sorted[i]) != key(sorted[i - 1]);
    return n;
  };
  size.n_parts[1] =
    different(lines, [](const CellLine &line) { return line.vertices; });
  if (dim == 3)
    size.n_parts[dim - 1] =
      different(FaceIndex<dim>(mesh).faces(),
                [](const auto &face) { return face.first; });
  return size;
}



template <int dim>
double
memory_of_model(const double n_unknowns, const bool is_direct)
{
  // Of a nested dissection's factor; the numbers are CHOLMOD's on a cube.
  const double n_factor = dim == 3 ? 42 * std::pow(n_unknowns, 4. / 3)
                                   : 8 * n_unknowns * std::log2(n_unknowns + 1);
  return 1500 * n_unknowns + (is_direct ? sizeof(double) * n_factor : 0);
}



std::string
text_of_memory(const double bytes)
{
  const auto in = [&](const double unit, const char *const name) {
    return std::to_string(static_cast<long long>(std::ceil(bytes / unit))) +
           name;
  };
  return bytes < 1e9 ? in(1e6, " MB") : in(1e9, " GB");
}



namespace
{
/** The memory that this machine has for the process and those beside it. */
double
memory_of_machine()
{
  double bytes = double(sysconf(_SC_PHYS_PAGES)) * sysconf(_SC_PAGESIZE);
  struct rlimit limit;
  if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
    bytes = std::min(bytes, double(limit.rlim_cur));
  // A container's limit; the word there is "max" where there is none.
  double of_group = 0;
  if (std::ifstream("/sys/fs/cgroup/memory.max") >> of_group && of_group > 0)
    bytes = std::min(bytes, of_group);
  return bytes;
}

/** The part of all processes that are on this machine, which holds that part of
 * the model. */
double
share_of_machine()
{
  if (!Utilities::MPI::job_supports_mpi())
    return 1;
  MPI_Comm here;
  MPI_Comm_split_type(
    MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &here);
  const double n_here = Utilities::MPI::n_mpi_processes(here);
  MPI_Comm_free(&here);
  return n_here / Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
}

std::string
whole(const double number)
{
  return number < 1e18 ? std::to_string(static_cast<long long>(number))
                       : "more than 10^18";
}
} // namespace



void
check_memory(const Parameters &parameters,
             const std::string &subsection,
             const std::string &name,
             const double n_cells,
             const double n_unknowns,
             const double bytes)
{
  // Small models are not asked about, so that they pay nothing.
  if (bytes < 1e8)
    return;
  double lacks = bytes * share_of_machine() - memory_of_machine();
  double there = memory_of_machine();
  if (Utilities::MPI::job_supports_mpi())
    {
      lacks = Utilities::MPI::max(lacks, MPI_COMM_WORLD);
      there = Utilities::MPI::min(there, MPI_COMM_WORLD);
    }
  const std::string size = "it makes at least " + whole(n_cells) +
                           " elements with " + whole(n_unknowns) + " unknowns";
  parameters.require(n_unknowns <= std::numeric_limits<int>::max(),
                     subsection,
                     name,
                     "less: " + size + ", and 2147483647 can be numbered");
  parameters.require(lacks <= 0,
                     subsection,
                     name,
                     "less: " + size + ", which take " + text_of_memory(bytes) +
                       " of memory or more, and " + text_of_memory(there) +
                       " is what there is on a machine");
}



template struct MeshSize<2>;
template struct MeshSize<3>;
template MeshSize<2>
size_of_box(const BoxNumbering<2>::Indices &);
template MeshSize<3>
size_of_box(const BoxNumbering<3>::Indices &);
template MeshSize<2>
size_of_mesh(const CoarseMesh<2> &);
template MeshSize<3>
size_of_mesh(const CoarseMesh<3> &);
template double
memory_of_model<2>(const double, const bool);
template double
memory_of_model<3>(const double, const bool);
} // namespace Setsudan
