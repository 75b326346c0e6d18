// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/output/output_directory.h>
#include <setsudan/output/tables/event.h>

#include <optional>

namespace Setsudan
{
/** The few numbers of a run that a study compares, gathered from its events;
 * lengths and forces in the scene's units. */
class Summary
{
public:
  /** What the events do not tell. */
  struct Circumstances
  {
    unsigned int n_doubtful_states = 0;
    unsigned int n_processes       = 1;
    /** Since the run began, also before it was resumed. */
    double seconds = 0;
  };

  void
  add(const Event &event);

  /** Write summary.json: one line. Numbers that the run does not have are null.
   *
   * @throw OutputError where that is not possible. */
  void
  write(const Circumstances &circumstances,
        const OutputDirectory &directory) const;

  /** For boost::serialization: all members, which a checkpoint keeps. */
  template <typename Archive>
  void
  serialize(Archive &archive, const unsigned int)
  {
    archive &n_states &n_pieces &n_yields &first_yield &max_strain;
    archive &travels &work &steady_work &steady_travel;
    archive &last_yield.cut &last_yield.travel &last_yield.work;
  }

private:
  /** Where the blade was when a row yielded, and its work until then. */
  struct Yield
  {
    unsigned int cut = 0;
    double travel    = 0;
    double work      = 0;
  };

  void
  add_yield(const Event &event);

  /** The work between yields of one cut over the travel between them, of all
   * cuts together; none where the blade has not moved between two. */
  std::optional<double>
  mean_force() const;

  unsigned int n_states = 0;
  unsigned int n_pieces = 1;
  unsigned int n_yields = 0;
  /** The travel, or without one the load factor. */
  double first_yield = 0;
  double max_strain  = 0;
  /** Whether the blade does. */
  bool travels         = false;
  double work          = 0;
  double steady_work   = 0;
  double steady_travel = 0;
  Yield last_yield;
};
} // namespace Setsudan
