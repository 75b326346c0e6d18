// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/kernel/blas.h>
#include <setsudan/solver/condensed/connected_components.h>

#include <Epetra_CrsMatrix.h>

#include <algorithm>
#include <atomic>
#include <future>

namespace Setsudan
{
std::vector<std::vector<unsigned int>>
connected_components(const LA::SparseMatrix &matrix)
{
  const auto &rows = matrix.trilinos_matrix();
  std::vector<std::vector<unsigned int>> parts(1);
  std::vector<bool> is_known(matrix.m(), false);
  bool first_has_begun = false;
  for (unsigned int seed = 0; seed < is_known.size(); ++seed)
    if (!is_known[seed])
      {
        std::vector<unsigned int> part{seed};
        is_known[seed] = true;
        for (std::size_t i = 0; i < part.size(); ++i)
          {
            int n_entries, *columns;
            double *values;
            rows.ExtractMyRowView(part[i], n_entries, values, columns);
            for (int e = 0; e < n_entries; ++e)
              if (!is_known[columns[e]])
                {
                  is_known[columns[e]] = true;
                  part.push_back(columns[e]);
                }
          }
        if (part.size() > 1 && first_has_begun)
          parts.push_back(std::move(part));
        else
          {
            first_has_begun = first_has_begun || part.size() > 1;
            parts[0].insert(parts[0].end(), part.begin(), part.end());
          }
      }
  for (auto &part : parts)
    std::sort(part.begin(), part.end());
  return parts;
}



void
parallel_for(const unsigned int n_parts,
             const std::function<void(unsigned int)> &work)
{
  const unsigned int n_workers = std::min(n_parts, n_threads());
  const SingleThreadedBlas single_threaded;
  std::atomic<unsigned int> next(0);
  const auto take_parts = [&] {
    for (unsigned int part = next++; part < n_parts; part = next++)
      work(part);
  };
  std::vector<std::future<void>> others;
  for (unsigned int worker = 1; worker < n_workers; ++worker)
    others.push_back(std::async(std::launch::async, take_parts));
  take_parts();
  for (auto &other : others)
    other.get();
}
} // namespace Setsudan
