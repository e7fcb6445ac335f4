#pragma once

#include "services/common/config.hpp"

namespace tandem::safety {

/// The numbers of the safety gate, part of config/<place>/robot/base.toml. Requirements SAF-1..6 of docs/safety.md.
struct GateConfig {
  double max_speed_mps = 0.5;           ///< SAF-1; 0.7 is the hard limit.
  double max_turn_rate_radps = 1.0472;  ///< 60 deg/s.
  double acceleration_mps2 = 0.3;
  double turn_acceleration_radps2 = 1.745;  ///< 100 deg/s^2.
  double deceleration_mps2 = 0.6;           ///< What we ask of the base, and count on if it reads back at least this.

  double hull_length_m = 0.626;  ///< A rectangle around the base's centre.
  double hull_width_m = 0.505;
  double side_margin_m = 0.02;   ///< Grown on all sides of the hull: noise of the laser.
  double reaction_time_s = 0.5;  ///< From an obstacle in reach to braking.
  double stop_margin_m = 0.15;   ///< Left free ahead after stopping.
  double narrow_view_m = 1.5;    ///< With less free way than this (SAF-3), no faster than
  double narrow_view_speed_mps = 0.3;

  double turn_clearance_m = 0.1;      ///< SAF-4: nothing closer to the circle swept by a turn in place.
  double near_turn_distance_m = 0.6;  ///< With anything inside this distance of the hull, in place no faster than
  double near_turn_rate_radps = 0.5;
  double max_reverse_speed_mps = 0.1;   ///< Backwards only by an operator, this fast
  double max_reverse_distance_m = 0.3;  ///< and this far.

  double zone_margin_m = 0.1;  ///< Kept between the hull and a hard zone of the map: the pose is not exact.

  double unknown_people_speed_mps = 0.3;  ///< While `people` is older than people_timeout_s,
  double unknown_brakes_speed_mps = 0.3;  ///< and while watchdog or deceleration of the base are not known to be good.
  double max_watchdog_s = 1.0;

  double scan_timeout_s = 0.3;
  double command_timeout_s = 0.3;
  double pose_timeout_s = 0.5;
  double people_timeout_s = 0.5;
  double link_timeout_s = 1.5;
  double link_latch_s = 10.0;  ///< A link gone for longer needs a deliberate resume.
  double last_leg_m = 10.0;    ///< Where the site's on_link_loss lets the robot go on without a link: at most so far,
  double last_leg_s = 60.0;    ///< so long
  double last_leg_speed_mps = 0.3;  ///< and so fast.
  double max_invalid_share = 0.3;   ///< Of the beams of a scan; raise it where most of a place is out of range.
  bool require_link = true;         ///< Off where nobody but an operator at the robot commands it.
  bool require_pose = true;         ///< Of commanders other than teleop.

  double healthy_s = 3.0;      ///< How long every cause must be gone before motion resumes by itself,
  double warning_s = 2.0;      ///< and how long people are warned then, also after a resume.
  double resume_hold_s = 1.0;  ///< How long the button must have been held.

  double battery_warning_v = 11.8;
  double battery_return_v = 11.5;
  double battery_stop_v = 11.2;
  double battery_filter_s = 5.0;

  template <typename Visitor>
  void visit_fields(Visitor& visitor) {
    visitor.field("max_speed_mps", max_speed_mps, Range{0.05, 0.7});
    visitor.field("max_turn_rate_radps", max_turn_rate_radps, Range{0.05, 2.0});
    visitor.field("acceleration_mps2", acceleration_mps2, Range{0.05, 0.3});
    visitor.field("turn_acceleration_radps2", turn_acceleration_radps2, Range{0.1, 5.0});
    visitor.field("deceleration_mps2", deceleration_mps2, Range{0.1, 3.0});
    visitor.field("hull_length_m", hull_length_m, Range{0.1, 3.0});
    visitor.field("hull_width_m", hull_width_m, Range{0.1, 3.0});
    visitor.field("side_margin_m", side_margin_m, Range{0.0, 0.5});
    visitor.field("reaction_time_s", reaction_time_s, Range{0.3, 3.0});
    visitor.field("stop_margin_m", stop_margin_m, Range{0.05, 2.0});
    visitor.field("narrow_view_m", narrow_view_m, Range{0.0, 10.0});
    visitor.field("narrow_view_speed_mps", narrow_view_speed_mps, Range{0.05, 0.7});
    visitor.field("turn_clearance_m", turn_clearance_m, Range{0.0, 1.0});
    visitor.field("near_turn_distance_m", near_turn_distance_m, Range{0.0, 5.0});
    visitor.field("near_turn_rate_radps", near_turn_rate_radps, Range{0.05, 2.0});
    visitor.field("max_reverse_speed_mps", max_reverse_speed_mps, Range{0.0, 0.1});
    visitor.field("max_reverse_distance_m", max_reverse_distance_m, Range{0.0, 0.3});
    visitor.field("zone_margin_m", zone_margin_m, Range{0.0, 2.0});
    visitor.field("unknown_people_speed_mps", unknown_people_speed_mps, Range{0.0, 0.3});
    visitor.field("unknown_brakes_speed_mps", unknown_brakes_speed_mps, Range{0.0, 0.3});
    visitor.field("max_watchdog_s", max_watchdog_s, Range{0.1, 10.0});
    visitor.field("scan_timeout_s", scan_timeout_s, Range{0.05, 0.3});
    visitor.field("command_timeout_s", command_timeout_s, Range{0.05, 0.6});
    visitor.field("pose_timeout_s", pose_timeout_s, Range{0.1, 2.0});
    visitor.field("people_timeout_s", people_timeout_s, Range{0.1, 2.0});
    visitor.field("link_timeout_s", link_timeout_s, Range{0.2, 10.0});
    visitor.field("link_latch_s", link_latch_s, Range{0.2, 100.0});
    visitor.field("last_leg_m", last_leg_m, Range{0.0, 50.0});
    visitor.field("last_leg_s", last_leg_s, Range{0.0, 300.0});
    visitor.field("last_leg_speed_mps", last_leg_speed_mps, Range{0.0, 0.3});
    visitor.field("max_invalid_share", max_invalid_share, Range{0.05, 0.99});
    visitor.field("require_link", require_link);
    visitor.field("require_pose", require_pose);
    visitor.field("healthy_s", healthy_s, Range{0.0, 60.0});
    visitor.field("warning_s", warning_s, Range{0.5, 60.0});
    visitor.field("resume_hold_s", resume_hold_s, Range{0.5, 10.0});
    visitor.field("battery_warning_v", battery_warning_v, Range{0.0, 60.0});
    visitor.field("battery_return_v", battery_return_v, Range{0.0, 60.0});
    visitor.field("battery_stop_v", battery_stop_v, Range{0.0, 60.0});
    visitor.field("battery_filter_s", battery_filter_s, Range{0.1, 60.0});
  }
};

}  // namespace tandem::safety
