#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "services/experiment/core/report/episode_log.hpp"

namespace tandem::experiment {

/// How near the robot came to people of one kind, over the time they were known of.
struct Distances {
  double known_s = 0.0;    ///< 0: the rest says nothing
  double nearest_m = 0.0;  ///< between the middles of robot and person
  double mean_m = 0.0;
  double intimate = 0.0;                          ///< share of the time nearer than 0.45 m (Hall's zones),
  double personal = 0.0;                          ///< 0.45 to 1.2 m,
  double social = 0.0;                            ///< 1.2 to 3.6 m
  std::optional<double> min_time_to_collision_s;  ///< both going on as they do, discs of 0.4 and 0.25 m; none: never
};

/// A way walked or driven.
struct Motion {
  double distance_m = 0.0;
  double mean_mps = 0.0;     ///< over the whole time
  double max_mps = 0.0;      ///< over half seconds
  double idle_s = 0.0;       ///< half seconds slower than 0.05 m/s and 0.1 rad/s
  double turning_rad = 0.0;  ///< change of heading, summed
};

/// An episode in numbers. Shares are in [0, 1]; what was not recorded is none.
struct EpisodeMetrics {
  // Task
  bool found = false;
  double time_s = 0.0;
  std::optional<double> explored;  ///< at the end
  std::optional<double> explored_robot;
  std::optional<double> explored_human;
  std::optional<double> first_expected_s;     ///< of the first plan: expected time to find,
  std::optional<double> first_lower_bound_s;  ///< and what no plan undercuts

  // Safety
  std::uint32_t collisions = 0;
  std::optional<int> stop_count;
  std::map<std::string, int> stops;         ///< by the most urgent reason at their onset
  std::map<std::string, double> stopped_s;  ///< time, by the most urgent reason of each moment
  std::optional<double> slowed;             ///< share of the time below the highest speed limit that was allowed

  // Comfort
  Distances teammate;
  Distances passers_by;

  // Motion
  Motion robot;
  Motion human;

  // Fluency (Hoffman)
  double robot_idle = 0.0;
  double human_idle = 0.0;
  double both_active = 0.0;
  std::vector<double> answer_s;  ///< from each *Replan* to the next new plan
  int plans = 0;                 ///< new ones
  int rejected = 0;

  // Communication
  std::map<std::string, int> messages;  ///< during the search, by kind
  double my_pose_per_min = 0.0;
  double longest_silence_s = 0.0;          ///< without *My pose*, the ends counted
  std::optional<double> reminder_effect;   ///< share of reminders that were obeyed; none: there were none
  std::vector<double> pose_age_at_plan_s;  ///< of the newest *My pose* at each new plan
  std::optional<double> link_up;           ///< share of the time
  std::optional<double> round_trip_s;      ///< median
};

[[nodiscard]] EpisodeMetrics metrics_of(const EpisodeLog& episode);

}  // namespace tandem::experiment
