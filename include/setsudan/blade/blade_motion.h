// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

namespace Setsudan
{
/** How a blade slips along a wall at a hat. */
struct WallSlip
{
  /** 1 along its direction, -1 against it, 0 where the wall sticks to it. */
  int way = 1;
  /** Where the wall was when it began to stick, along the flank and from where
   * the blade was. */
  double anchor = 0;

  /** For boost::serialization. */
  template <typename Archive>
  void
  serialize(Archive &archive, const unsigned int)
  {
    archive &way &anchor;
  }
};

/** Which contacts a blade has; there may be other ones with which the body is
 * in equilibrium at the same travel. */
struct BladeContacts
{
  /** The facets of the blade that the walls are on. */
  std::vector<unsigned int> facets;
  /** Which conditions of contact hold with equality. */
  std::vector<bool> active;
  /** The shift of a blade that nothing pushes aside. */
  double resting_shift = 0;
  /** 1 while it is pushed, -1 while it is withdrawn. */
  int heading = 1;
  /** How it slips along each wall; none before it has turned. */
  std::vector<WallSlip> slips;
  /** The walls that adhere to it. */
  std::vector<bool> adhering;
  /** Where the corners on a board stick: what is measured along the board. */
  std::vector<double> board;

  /** For boost::serialization. */
  template <typename Archive>
  void
  serialize(Archive &archive, const unsigned int)
  {
    archive &facets &active &resting_shift &heading &slips &adhering &board;
  }
};

/** Where a blade that travels is, and what it has done so far; lengths, forces
 * and energies in the scene's units. */
struct BladeMotion
{
  /** Of the edge along the blade's direction, from the entry of the cut. */
  double travel = 0;
  /** How many stops of its path it has reached in this cut. */
  unsigned int n_stops = 0;
  /** Since the run began, where the blade's speed is given. */
  double time = 0;
  /** When the last rows split, or the cut began. */
  double time_of_split = 0;
  /** The forces of edge and flanks on the body along that direction, and the
   * area on which the flanks press. */
  double edge_force  = 0;
  double flank_force = 0;
  /** The part of the flanks' force that is friction. */
  double friction_force = 0;
  /** The blade's force on the body along its edge. */
  double force_along  = 0;
  double contact_area = 0;
  /** How far it has shifted sideways, towards the plus side. */
  double shift = 0;
  /** Since the run began: the blade's work; what new surface and what friction
   * takes; and what is set free besides, as a row splits that could have done
   * so before, or as a wall springs back from the blade's shoulder. */
  double work = 0;
  /** The part of the work that the body does not feel as a force along the
   * direction. */
  double unfelt_work     = 0;
  double surface_energy  = 0;
  double friction_energy = 0;
  double excess_energy   = 0;
  /** The potential energy of the body before the blade came. */
  double energy_at_rest = 0;
  /** How many rows split next, all at once; 0 where none does. */
  unsigned int n_rows_to_split = 0;
  BladeContacts contacts;

  /** The same at the entry of the next cut. */
  BladeMotion
  at_entry() const
  {
    BladeMotion motion   = *this;
    motion.travel        = 0;
    motion.n_stops       = 0;
    motion.time_of_split = time;
    motion.shift         = 0;
    motion.contacts      = {};
    return motion;
  }

  /** For boost::serialization. */
  template <typename Archive>
  void
  serialize(Archive &archive, const unsigned int)
  {
    archive &travel &n_stops &time &time_of_split &edge_force &flank_force;
    archive &friction_force &force_along;
    archive &contact_area &shift &work &unfelt_work &surface_energy
      &friction_energy;
    archive &excess_energy &energy_at_rest &n_rows_to_split &contacts;
  }
};
} // namespace Setsudan
