#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "services/common/angle.hpp"
#include "services/common/config.hpp"
#include "services/planner/core/search/searcher.hpp"

namespace tandem {

/// config/<place>/laptop/planner.toml. Each field is listed once more in visit_fields, with its allowed range.
struct PlannerConfig {
  // The area and the belief.
  double cell_size_m = 0.5;           ///< Side of a search cell [m].
  std::vector<double> area_in_map_m;  ///< Corners x, y, x, y, ... of the searched area; empty: all within reach.
  double excluded_radius_m = 0.0;     ///< The object is known not to lie this near to the robot's start [m].
  double explored_probability = 0.5;  ///< A cell is explored once an object there would be detected this likely.
  double person_credit_s = 10.0;      ///< A person not seen for longer is not taken to search any more [s].

  // The plan.
  std::string planner = "tandem";  ///< A name that planners/registry.hpp knows, perhaps with options.
  std::int64_t rollouts = 400;     ///< Budget of one plan.
  std::int64_t seed = 1;
  double horizon_s = 120.0;         ///< Length of plans [s].
  double acceptance_delay_s = 3.0;  ///< A proposal without a Replan is accepted after this [s].
  double slice_s = 0.03;            ///< Computing at a stretch, between heartbeats [s].
  double wait_for_person_s = 10.0;  ///< How long the first plan waits for a person who has not shown up [s].
  double surprise = 0.15;           ///< Replans when the object is this much less likely seen than planned.
  double late_s = 10.0;             ///< So much behind the plan is still on it [s].
  double deviation_m = 5.0;         ///< Replans when the person is this far from the plan [m] ...
  double deviation_s = 10.0;        ///< ... for so long [s].
  double person_reaction_s = 3.0;   ///< So long a person goes on with the old plan before they turn to a new one [s].
  double person_trust_s = 60.0;     ///< A new person counts as having followed plans for so long [s].
  double replan_pause_s = 20.0;     ///< Replans of its own accord only this long after the last one [s].
  double blocked_s = 3.0;           ///< A path reported as blocked for so long is given up [s].
  double blocked_radius_m = 0.7;    ///< What is avoided around the blocked point [m].
  double blocked_memory_s = 60.0;   ///< For how long [s].
  double goal_reach_m = 0.75;       ///< A goal is reached at this distance [m].

  // What the person is told.
  double inform_cost_s = 3.0;    ///< What does not find the object so much sooner is not worth their attention [s].
  double inform_pause_s = 20.0;  ///< From one message to the next [s].
  double inform_life_s = 30.0;   ///< So long they have to take notice of it [s].

  // The robot.
  double robot_speed_mps = 0.5;
  double robot_turn_rate_radps = 0.8;
  double robot_radius_m = 0.45;
  double robot_preferred_clearance_m = 0.8;
  double robot_lookout_range_m = 2.5;
  double camera_min_m = 0.6;
  double camera_max_m = 4.0;
  double camera_field_of_view_deg = 60.0;
  double camera_detection_rate_per_s = 1.0;

  // The person.
  double person_speed_mps = 0.75;
  double person_radius_m = 0.25;
  double person_preferred_clearance_m = 0.5;
  double person_lookout_range_m = 3.0;
  double person_view_m = 3.0;
  double person_detection_rate_per_s = 0.5;

  template <typename Visitor>
  void visit_fields(Visitor& visitor) {
    visitor.field("cell_size_m", cell_size_m, Range{0.2, 2.0});
    visitor.field("area_in_map_m", area_in_map_m, Range{});
    visitor.field("excluded_radius_m", excluded_radius_m, Range{0.0, 100.0});
    visitor.field("explored_probability", explored_probability, Range{0.01, 0.99});
    visitor.field("person_credit_s", person_credit_s, Range{0.0, 120.0});
    visitor.field("planner", planner);
    visitor.field("rollouts", rollouts, Range{0, 1e6});
    visitor.field("seed", seed, Range{0, 1e15});
    visitor.field("horizon_s", horizon_s, Range{5.0, 1000.0});
    visitor.field("acceptance_delay_s", acceptance_delay_s, Range{0.0, 60.0});
    visitor.field("slice_s", slice_s, Range{0.001, 1.0});
    visitor.field("wait_for_person_s", wait_for_person_s, Range{0.0, 600.0});
    visitor.field("surprise", surprise, Range{0.01, 1.0});
    visitor.field("late_s", late_s, Range{0.0, 120.0});
    visitor.field("deviation_m", deviation_m, Range{0.5, 100.0});
    visitor.field("deviation_s", deviation_s, Range{0.0, 600.0});
    visitor.field("person_reaction_s", person_reaction_s, Range{0.0, 30.0});
    visitor.field("person_trust_s", person_trust_s, Range{1.0, 3600.0});
    visitor.field("replan_pause_s", replan_pause_s, Range{0.0, 600.0});
    visitor.field("blocked_s", blocked_s, Range{0.0, 60.0});
    visitor.field("blocked_radius_m", blocked_radius_m, Range{0.1, 5.0});
    visitor.field("blocked_memory_s", blocked_memory_s, Range{1.0, 3600.0});
    visitor.field("goal_reach_m", goal_reach_m, Range{0.1, 5.0});
    visitor.field("inform_cost_s", inform_cost_s, Range{0.1, 1000.0});
    visitor.field("inform_pause_s", inform_pause_s, Range{1.0, 3600.0});
    visitor.field("inform_life_s", inform_life_s, Range{1.0, 600.0});
    visitor.field("robot_speed_mps", robot_speed_mps, Range{0.05, 2.0});
    visitor.field("robot_turn_rate_radps", robot_turn_rate_radps, Range{0.05, 5.0});
    visitor.field("robot_radius_m", robot_radius_m, Range{0.1, 2.0});
    visitor.field("robot_preferred_clearance_m", robot_preferred_clearance_m, Range{0.1, 2.0});
    visitor.field("robot_lookout_range_m", robot_lookout_range_m, Range{0.5, 20.0});
    visitor.field("camera_min_m", camera_min_m, Range{0.0, 10.0});
    visitor.field("camera_max_m", camera_max_m, Range{0.5, 20.0});
    visitor.field("camera_field_of_view_deg", camera_field_of_view_deg, Range{5.0, 360.0});
    visitor.field("camera_detection_rate_per_s", camera_detection_rate_per_s, Range{0.001, 100.0});
    visitor.field("person_speed_mps", person_speed_mps, Range{0.05, 3.0});
    visitor.field("person_radius_m", person_radius_m, Range{0.1, 2.0});
    visitor.field("person_preferred_clearance_m", person_preferred_clearance_m, Range{0.1, 2.0});
    visitor.field("person_lookout_range_m", person_lookout_range_m, Range{0.5, 20.0});
    visitor.field("person_view_m", person_view_m, Range{0.5, 20.0});
    visitor.field("person_detection_rate_per_s", person_detection_rate_per_s, Range{0.001, 100.0});
  }
};

/// The robot of `config` as a searcher.
[[nodiscard]] inline Searcher robot_of(const PlannerConfig& config, const std::string& id) {
  return {id,
          config.robot_speed_mps,
          config.robot_turn_rate_radps,
          config.robot_radius_m,
          config.robot_preferred_clearance_m,
          config.camera_min_m,
          config.camera_max_m,
          from_degrees(config.camera_field_of_view_deg),
          config.camera_detection_rate_per_s};
}

/// The person of `config` as a searcher, who looks all around.
[[nodiscard]] inline Searcher person_of(const PlannerConfig& config, const std::string& id) {
  Searcher person;
  person.id = id;
  person.speed_mps = config.person_speed_mps;
  person.radius_m = config.person_radius_m;
  person.preferred_clearance_m = config.person_preferred_clearance_m;
  person.view_max_m = config.person_view_m;
  person.detection_rate_per_s = config.person_detection_rate_per_s;
  return person;
}

}  // namespace tandem
