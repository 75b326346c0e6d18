// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/blade/blade_motion.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace Setsudan
{
/** One event of a run, a line of statistics.csv; stresses, forces and lengths
 * in the scene's units. */
struct Event
{
  /** The solved state that the line describes, counted from 0. */
  unsigned int frame = 0;
  /** rest, deform, time, travel, yield, release, arrest or divide. */
  std::string name = "rest";
  unsigned int cut = 0;
  unsigned int row = 0;
  /** Rows of this cut that are split. */
  unsigned int released_rows = 0;
  /** The front row's coordinate along the blade's direction from the entry. */
  double depth            = 0;
  double load_factor      = 0;
  double blade_force      = 0;
  double cutting_stress   = 0;
  double required_stress  = 0;
  double strain_energy    = 0;
  double potential_energy = 0;
  double max_displacement = 0;
  double force_residual   = 0;
  double moment_residual  = 0;
  double min_jacobian     = 1;
  unsigned int pieces     = 1;
  double seconds          = 0;
  /** Largest principal strain and maximum shear at Gauss points: unlike the
   * stress at nodes they are not taken where it is singular. */
  double max_strain = 0;
  double max_shear  = 0;
  /** What the supports that hold still give back to the body. */
  std::array<double, 3> reaction{};
  /** The force of the clamps that move. */
  std::array<double, 3> clamp_force{};
  /** Estimated relative errors of the strain energy and of the cutting stress,
   * where they are asked for: in all events of a run, or in none. */
  std::optional<std::array<double, 2>> errors;
  /** Where a blade that travels is: in all events of a run, or in none. */
  std::optional<BladeMotion> motion;
  /** Its mean force since the last event in which it had moved. */
  double mean_force = 0;
  /** The force of the board on the body along its normal: in all events of a
   * run, or in none. */
  std::optional<double> board_force;
  /** What plastic flow has taken since the run began, and viscosity: in all
   * events of a run, or in none. */
  std::optional<double> plastic_energy, viscous_energy;
  /** Since the run began, where no blade travels: in all events of a run, or in
   * none. */
  std::optional<double> time;
  /** How far the walls of cuts have moved through each other. */
  double overlap = 0;
  /** The force that keeps split rows the blade's thickness apart, and the part
   * of it that pulls. */
  double opening_force = 0;
  double opening_pull  = 0;
  /** The pieces in which the row's front lies, as they were before this cut. */
  std::vector<unsigned int> row_pieces = {0};

  /** For boost::serialization: all members, which a checkpoint keeps. */
  template <typename Archive>
  void
  serialize(Archive &archive, const unsigned int)
  {
    bool has_errors = errors.has_value();
    auto values     = errors.value_or(std::array<double, 2>());
    archive &frame &name &cut &row &released_rows &depth &load_factor;
    archive &blade_force &cutting_stress &required_stress &strain_energy;
    archive &potential_energy &max_displacement &force_residual;
    archive &moment_residual &min_jacobian &pieces &seconds &max_strain;
    archive &max_shear &reaction &clamp_force &overlap &row_pieces;
    archive &opening_force &opening_pull;
    archive &has_errors &values;
    if (has_errors)
      errors = values;
    for (auto *const value :
         {&board_force, &plastic_energy, &viscous_energy, &time})
      {
        bool is_there = value->has_value();
        double number = value->value_or(0);
        archive &is_there &number;
        if (is_there)
          *value = number;
      }
    bool has_motion    = motion.has_value();
    BladeMotion moving = motion.value_or(BladeMotion());
    archive &has_motion &moving &mean_force;
    if (has_motion)
      motion = moving;
  }
};
} // namespace Setsudan
