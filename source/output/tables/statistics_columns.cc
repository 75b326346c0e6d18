// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/output/tables/statistics_columns.h>

#include <algorithm>
#include <ostream>
#include <set>
#include <sstream>

namespace Setsudan
{
namespace
{
template <typename Number>
std::string
digits_of(const Number number, const int precision)
{
  std::ostringstream text;
  text.precision(precision);
  text << number;
  return text.str();
}

/** The digits that a comparison needs. */
constexpr int all_digits = 12;

/** A column of a member of Event. */
template <typename Number>
StatisticsColumn
column(const std::string &name,
       const std::string &unit,
       const std::string &meaning,
       Number Event::*const member,
       const int precision = all_digits)
{
  return {name, unit, meaning, [=](const Event &event) {
            return digits_of(event.*member, precision);
          }};
}

/** The columns of a vector's components. */
void
add_vector(const std::string &name,
           const std::string &meaning,
           std::array<double, 3> Event::*const member,
           std::vector<StatisticsColumn> &columns)
{
  for (unsigned int c = 0; c < 3; ++c)
    {
      const std::string axis(1, "xyz"[c]);
      columns.push_back({name + "_" + axis,
                         "F",
                         meaning + " along " + axis + ".",
                         [=](const Event &event) {
                           return digits_of((event.*member)[c], all_digits);
                         }});
    }
}

std::string
pieces_of_row(const Event &event)
{
  std::string text;
  for (const unsigned int piece : event.row_pieces)
    text += (text.empty() ? "" : "+") + std::to_string(piece);
  return text;
}

/** The place of the event in the story, and what the blade does. */
std::vector<StatisticsColumn>
columns_of_cut()
{
  return {
    column("frame",
           "-",
           "The solved state that the line describes, from 0; several events "
           "can be of one state. Files of that number show it.",
           &Event::frame),
    {"event",
     "-",
     "rest, deform, time, travel, yield, release, arrest or divide: see below.",
     [](const Event &event) { return event.name; }},
    column("cut", "-", "The cut, from 0.", &Event::cut),
    column(
      "row", "-", "The row of this cut under the blade, from 0.", &Event::row),
    column("released_rows",
           "-",
           "Rows of this cut that are split.",
           &Event::released_rows),
    column("depth",
           "L",
           "How far the front of the row lies behind the entry of the cut, "
           "along the blade's direction.",
           &Event::depth),
    column("load_factor",
           "-",
           "What Blade/Edge loads are multiplied with.",
           &Event::load_factor),
    column("blade_force",
           "F",
           "The sum of the blade's forces, along its direction.",
           &Event::blade_force),
    column("cutting_stress",
           "F/L^2",
           "What Yield/Criterion measures at the front of the row: a stress, "
           "or with energy release an energy per area (F/L). Its maximum "
           "shear is the largest of the elements that meet at a node of the "
           "front, and grows as elements shrink.",
           &Event::cutting_stress),
    column("required_stress",
           "F/L^2",
           "What it must exceed for the row to split.",
           &Event::required_stress)};
}

StatisticsColumn
column(const std::string &name,
       const std::string &unit,
       const std::string &meaning,
       double BladeMotion::*const member)
{
  return {name, unit, meaning, [=](const Event &event) {
            return digits_of(event.motion.value_or(BladeMotion()).*member,
                             all_digits);
          }};
}

const char *const meaning_of_time =
  "The time since the run began, in the unit of Blade/Speed and Time/Steps; 0 "
  "where these are not given.";

/** Where a blade that travels is, and its forces. */
void
add_motion(std::vector<StatisticsColumn> &columns)
{
  const auto add = [&](const auto &...of_column) {
    columns.push_back(column(of_column...));
  };
  add(
    "travel",
    "L",
    "How far the edge is behind the entry of the cut; these columns are there "
    "with Blade/Drive = travel.",
    &BladeMotion::travel);
  add("time", "s", meaning_of_time, &BladeMotion::time);
  columns.push_back(
    column("mean_force",
           "F",
           "The blade's work over its travel, from the event "
           "before in which it was elsewhere: the force between "
           "two events rises and falls with the elements. The work of a blade "
           "that slices is that along its edge, too.",
           &Event::mean_force));
  add("edge_force",
      "F",
      "The part of blade_force that acts on the edge.",
      &BladeMotion::edge_force);
  add("flank_force", "F", "That on the flanks.", &BladeMotion::flank_force);
  add("friction_force",
      "F",
      "The part of flank_force that is friction.",
      &BladeMotion::friction_force);
  add("force_along",
      "F",
      "The blade's force on the body along its edge, where it slices.",
      &BladeMotion::force_along);
  add("contact_area",
      "L^2",
      "On which the flanks press, both together.",
      &BladeMotion::contact_area);
  add(
    "shift",
    "L",
    "How far a blade with Guide = free has shifted sideways, towards the side "
    "that the cut's normal points to.",
    &BladeMotion::shift);
}

/** What a blade that travels has done. */
void
add_energies(std::vector<StatisticsColumn> &columns)
{
  const auto add = [&](const auto &...of_column) {
    columns.push_back(column(of_column...));
  };
  add("work",
      "F L",
      "The work of the blade since the run began.",
      &BladeMotion::work);
  add(
    "surface_energy",
    "F L",
    "What the new surface has taken: toughness times area, less the part that "
    "Blade/Sharpness makes up for; with a criterion of stress all that its "
    "splits set free besides friction.",
    &BladeMotion::surface_energy);
  add("friction_energy",
      "F L",
      "What friction has taken.",
      &BladeMotion::friction_energy);
  add(
    "excess_energy",
    "F L",
    "What has been set free besides, and is lost: where rows could have split "
    "before, and where a wall springs back from the blade's shoulder.",
    &BladeMotion::excess_energy);
}

/** What keeps the walls apart where no blade does by contact. */
void
add_opening(std::vector<StatisticsColumn> &columns)
{
  columns.push_back(
    column("opening_force",
           "F",
           "The force on one wall, across the cut, that keeps split rows "
           "Blade/Thickness apart; these columns are there with Blade/Drive = "
           "force.",
           &Event::opening_force));
  columns.push_back(
    column("opening_pull",
           "F",
           "The part of it that pulls rows together, which no blade does.",
           &Event::opening_pull));
}

/** The state of the whole body. */
std::vector<StatisticsColumn>
columns_of_body()
{
  return {
    column("strain_energy",
           "F L",
           "The elastic energy of the body, u.Ku/2 of a linear one.",
           &Event::strain_energy),
    column("potential_energy",
           "F L",
           "That minus the work of all loads at their present size, f.u; with "
           "finite strain also minus pressures times the volume below their "
           "surface.",
           &Event::potential_energy),
    column("max_displacement",
           "L",
           "The largest displacement of a node.",
           &Event::max_displacement),
    column(
      "force_residual",
      "-",
      "How far all forces on the body are from cancelling, over the sum of "
      "their sizes.",
      &Event::force_residual,
      3),
    column("moment_residual",
           "-",
           "The same of their moments, over that sum times the body's length.",
           &Event::moment_residual,
           3),
    column("min_jacobian",
           "-",
           "The smallest determinant of the deformation gradient at nodes and "
           "Gauss points: 1 undeformed, 0 or less where an element is turned "
           "inside out.",
           &Event::min_jacobian),
    column("pieces", "-", "The separate bodies there are.", &Event::pieces),
    column("seconds", "s", "The time since the run began.", &Event::seconds, 4),
    column("max_strain",
           "-",
           "The largest principal strain, in magnitude, at a Gauss point; with "
           "finite strain an elongation.",
           &Event::max_strain),
    column("max_shear",
           "F/L^2",
           "The largest maximum shear (s1 - s3)/2 at a Gauss point of the "
           "whole body: unlike cutting_stress not at nodes, where it is "
           "singular under the blade.",
           &Event::max_shear)};
}
} // namespace


std::vector<StatisticsColumn>
statistics_columns(const Event &event)
{
  const bool travels = event.motion.has_value();
  auto columns       = columns_of_cut();
  const auto of_body = columns_of_body();
  columns.insert(columns.end(), of_body.begin(), of_body.end());
  add_vector("reaction",
             "The force of the supports that hold still on the body,",
             &Event::reaction,
             columns);
  add_vector("clamp",
             "The force of the clamps that move (Support/Displacements) on the "
             "body,",
             &Event::clamp_force,
             columns);
  if (event.board_force)
    columns.push_back({"board_force",
                       "F",
                       "The force of the board on the body along the board's "
                       "normal; with Board/Plane.",
                       [](const Event &event) {
                         return digits_of(*event.board_force, all_digits);
                       }});
  if (event.plastic_energy)
    columns.push_back(
      {"plastic_energy",
       "F L",
       "What plastic flow has taken since the run began, as heat and in its "
       "hardening; with Material/Yield stress.",
       [](const Event &event) {
         return digits_of(*event.plastic_energy, all_digits);
       }});
  if (event.viscous_energy)
    columns.push_back(
      {"viscous_energy",
       "F L",
       "What viscosity has turned into heat since the run began; with "
       "Material/Viscous.",
       [](const Event &event) {
         return digits_of(*event.viscous_energy, all_digits);
       }});
  if (event.time)
    columns.push_back({"time", "s", meaning_of_time, [](const Event &event) {
                         return digits_of(*event.time, all_digits);
                       }});
  columns.push_back(column("overlap",
                           "L",
                           "How far the walls of cuts have moved through each "
                           "other, at most; without contact nothing prevents "
                           "it.",
                           &Event::overlap));
  if (!travels)
    add_opening(columns);
  columns.push_back({"row_pieces",
                     "-",
                     "The pieces in which the front of the row lies, joined by "
                     "'+'.",
                     pieces_of_row});
  if (travels)
    {
      add_motion(columns);
      add_energies(columns);
    }
  if (event.errors)
    {
      columns.push_back(
        {"energy_error",
         "-",
         "The estimated relative error of the strain energy; "
         "with Accuracy/Estimate.",
         [](const Event &event) { return digits_of((*event.errors)[0], 4); }});
      columns.push_back(
        {"stress_error",
         "-",
         "That of cutting_stress.",
         [](const Event &event) { return digits_of((*event.errors)[1], 4); }});
    }
  return columns;
}



void
document_columns(std::ostream &out)
{
  out << "| column | unit | meaning |\n|---|---|---|\n";
  const auto write = [&](const StatisticsColumn &column) {
    out << "| `" << column.name << "` | " << column.unit << " | "
        << column.meaning << " |\n";
  };
  Event all;
  all.errors         = std::array<double, 2>();
  all.motion         = BladeMotion();
  all.board_force    = 0;
  all.plastic_energy = 0;
  all.viscous_energy = 0;
  std::set<std::string> written;
  for (const Event &event : {Event(), all})
    for (const auto &column : statistics_columns(event))
      if (written.insert(column.name).second)
        write(column);
}
} // namespace Setsudan
