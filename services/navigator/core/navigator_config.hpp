#pragma once

#include "services/common/config.hpp"

namespace tandem::navigator {

/// config/<place>/robot/navigator.toml.
///
/// The margins are wider than those of the safety gate (docs/faults.md: 0.15 m ahead, 0.10 m around a turn in place),
/// so that the navigator stops or turns away before the gate has to: a robot that the gate has stopped may be unable to
/// turn.
struct NavigatorConfig {
  double period_s = 0.05;  ///< Time from one velocity command to the next [s].

  // The hull: a rectangle around the base's centre.
  double hull_length_m = 0.626;
  double hull_width_m = 0.505;

  // How it drives.
  double max_speed_mps = 0.5;
  double max_turn_rate_radps = 0.8;    ///< On arcs, and in place where nothing is near.
  double near_turn_rate_radps = 0.45;  ///< In place, with something within near_turn_distance_m of the hull.
  double near_turn_distance_m = 0.7;
  double acceleration_mps2 = 0.3;
  double turn_acceleration_radps2 = 1.5;
  double goal_deceleration_mps2 = 0.25;  ///< With which it comes to rest at the goal; gentler than the gate's.
  double max_lateral_acceleration_mps2 = 0.3;
  double goal_tolerance_m = 0.2;
  double occupied_goal_tolerance_m = 0.6;  ///< Where something keeps it from getting closer.
  double lookahead_s = 1.0;                ///< The point aimed at lies this far ahead at the present speed,
  double min_lookahead_m = 0.35;           ///< but within these limits.
  double max_lookahead_m = 0.6;
  double turn_in_place_from_rad = 0.9;   ///< A larger bearing of the point aimed at is turned away in place,
  double turn_in_place_until_rad = 0.2;  ///< until it is below this one.
  double uncertain_speed_mps = 0.2;      ///< While localization is uncertain.

  // Obstacles.
  double side_margin_m = 0.05;            ///< Added to the hull on all sides.
  double stop_margin_m = 0.25;            ///< Free way that is left ahead after stopping.
  double reaction_time_s = 0.5;           ///< From a scan to braking, as the gate counts.
  double deceleration_mps2 = 0.6;         ///< What the gate brakes with.
  double turn_margin_m = 0.14;            ///< Free ring around the hull's circle to begin a turn in place,
  double turning_margin_m = 0.115;        ///< and to go on with it.
  double horizon_m = 1.5;                 ///< How far ahead the path is checked.
  double max_detour_m = 1.0;              ///< Never farther from the path to get around something.
  double min_turn_radius_m = 0.4;         ///< Of the arcs tried.
  double narrow_view_m = 1.5;             ///< With less free way than this, no faster than
  double narrow_view_speed_mps = 0.3;     ///< this (SAF-3), nor when coming up to a person from behind
  double person_behind_distance_m = 2.5;  ///< within this distance.

  // When it gives up.
  double blocked_after_s = 3.0;  ///< Standing in front of something.
  double stuck_after_s = 12.0;   ///< Moving without getting on along the path.
  double plan_timeout_s = 2.0;   ///< A plan not refreshed for this long is dead.
  double pose_timeout_s = 0.5;
  double scan_timeout_s = 0.5;
  double execution_period_s = 0.5;  ///< Time between two plan_execution messages without a change [s].

  template <typename Visitor>
  void visit_fields(Visitor& visitor) {
    visitor.field("period_s", period_s, Range{0.01, 0.1});
    visitor.field("hull_length_m", hull_length_m, Range{0.1, 3.0});
    visitor.field("hull_width_m", hull_width_m, Range{0.1, 3.0});
    visitor.field("max_speed_mps", max_speed_mps, Range{0.05, 0.7});
    visitor.field("max_turn_rate_radps", max_turn_rate_radps, Range{0.1, 2.0});
    visitor.field("near_turn_rate_radps", near_turn_rate_radps, Range{0.1, 0.5});
    visitor.field("near_turn_distance_m", near_turn_distance_m, Range{0.6, 5.0});
    visitor.field("acceleration_mps2", acceleration_mps2, Range{0.05, 1.0});
    visitor.field("turn_acceleration_radps2", turn_acceleration_radps2, Range{0.1, 10.0});
    visitor.field("goal_deceleration_mps2", goal_deceleration_mps2, Range{0.05, 0.6});
    visitor.field("max_lateral_acceleration_mps2", max_lateral_acceleration_mps2, Range{0.05, 2.0});
    visitor.field("goal_tolerance_m", goal_tolerance_m, Range{0.05, 1.0});
    visitor.field("occupied_goal_tolerance_m", occupied_goal_tolerance_m, Range{0.05, 2.0});
    visitor.field("lookahead_s", lookahead_s, Range{0.2, 5.0});
    visitor.field("min_lookahead_m", min_lookahead_m, Range{0.1, 2.0});
    visitor.field("max_lookahead_m", max_lookahead_m, Range{0.1, 3.0});
    visitor.field("turn_in_place_from_rad", turn_in_place_from_rad, Range{0.2, 3.0});
    visitor.field("turn_in_place_until_rad", turn_in_place_until_rad, Range{0.02, 1.0});
    visitor.field("uncertain_speed_mps", uncertain_speed_mps, Range{0.0, 0.7});
    visitor.field("side_margin_m", side_margin_m, Range{0.0, 0.5});
    visitor.field("stop_margin_m", stop_margin_m, Range{0.15, 1.0});
    visitor.field("reaction_time_s", reaction_time_s, Range{0.1, 2.0});
    visitor.field("deceleration_mps2", deceleration_mps2, Range{0.1, 2.0});
    visitor.field("turn_margin_m", turn_margin_m, Range{0.1, 1.0});
    visitor.field("turning_margin_m", turning_margin_m, Range{0.1, 1.0});
    visitor.field("horizon_m", horizon_m, Range{0.5, 5.0});
    visitor.field("max_detour_m", max_detour_m, Range{0.0, 3.0});
    visitor.field("min_turn_radius_m", min_turn_radius_m, Range{0.1, 2.0});
    visitor.field("narrow_view_m", narrow_view_m, Range{0.3, 5.0});
    visitor.field("narrow_view_speed_mps", narrow_view_speed_mps, Range{0.05, 0.7});
    visitor.field("person_behind_distance_m", person_behind_distance_m, Range{0.0, 10.0});
    visitor.field("blocked_after_s", blocked_after_s, Range{0.5, 60.0});
    visitor.field("stuck_after_s", stuck_after_s, Range{1.0, 120.0});
    visitor.field("plan_timeout_s", plan_timeout_s, Range{1.0, 10.0});
    visitor.field("pose_timeout_s", pose_timeout_s, Range{0.1, 2.0});
    visitor.field("scan_timeout_s", scan_timeout_s, Range{0.1, 2.0});
    visitor.field("execution_period_s", execution_period_s, Range{0.1, 2.0});
  }
};

}  // namespace tandem::navigator
