#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "services/experiment/core/episode/robot_drive.hpp"
#include "services/experiment/core/humans/human.hpp"
#include "services/planner/core/mission/search_mission.hpp"
#include "services/simulator/core/scenario.hpp"
#include "services/tracking/core/tracking_config.hpp"

namespace tandem::experiment {

/// The parts of the team of an episode, as their services are configured.
struct TeamOptions {
  PlannerConfig planner;
  navigator::NavigatorConfig navigator;
  tracking::TrackingConfig tracking;
  simulator::SlipModel slip;
};

/// A role and since when the team has it.
struct RoleSince {
  double time_s = 0.0;
  Role role = Role::LeaderFollower;

  friend bool operator==(const RoleSince&, const RoleSince&) = default;
};

/// What came of one search. Shares are those at the find, or at the end of the time.
struct EpisodeResult {
  std::uint64_t seed = 0;
  bool found = false;
  double time_s = 0.0;   ///< Until it was found; the limit if it was not.
  std::string found_by;  ///< "robot", "human"; empty: nobody
  double explored = 0.0;
  double explored_robot = 0.0;
  double explored_human = 0.0;
  DriveTally robot;
  double human_distance_m = 0.0;
  int plans = 0;
  std::map<std::string, int> messages;  ///< pressed on the phone, by kind
  std::vector<RoleSince> roles;         ///< ascending in time
};

/// How long each plan is computed.
struct PlanningTime {
  std::function<void()> begin;    ///< a plan may be begun now
  std::function<bool()> is_over;  ///< since then
};

/// Hears of an episode while it is played, to record it. Time goes on from one call to the next.
class EpisodeObserver {
 public:
  virtual ~EpisodeObserver() = default;
  virtual void began(Time now, const std::string& session, const Eigen::Vector2d& object_in_map) = 0;
  virtual void pressed(Time now, const simulator::PhoneMessage& message) = 0;
  /// A plan, or another standing of it.
  virtual void planned(Time now, const MissionPlan& plan, PlanStanding standing) = 0;
  /// Where everybody is; once a step.
  virtual void stood(Time now, const Pose2& map_from_robot, const Pose2& map_from_person,
                     std::span<const Pose2> map_from_passers_by, int collisions) = 0;
  /// Once a second, and when the episode ends.
  virtual void believed(Time now, const SearchMission& mission) = 0;
  virtual void ended(Time now, const EpisodeResult& result) = 0;
};

/// A scenario with all that stays the same from episode to episode, prepared once. One per thread.
class EpisodeWorld {
 public:
  /// `map` is the scenario's own. Throws ConfigError where the scenario does not fit it.
  EpisodeWorld(const simulator::Scenario& scenario, const OccupancyGrid& map, const TeamOptions& options);

  /// Plays the episode of `seed` with a person of kind `human` (human_names()), in steps of 0.1 s of simulated time.
  ///
  /// Planner, navigator, tracker, bodies and minds are those of the services and of the simulator; localization is
  /// exact and messages take no time. Where the tokens lie, who walks about and how wheels slip follow from the seed.
  /// Each plan has as many rollouts as the planner's config says, or, with `planning_time`, what it leaves time for;
  /// simulated time stands still meanwhile. Without it equal seeds give equal results, whatever was played before.
  /// None if `stop` asked to end before the end. `observer` changes nothing.
  [[nodiscard]] std::optional<EpisodeResult> play(std::string_view human, std::uint64_t seed,
                                                  const std::optional<PlanningTime>& planning_time = {},
                                                  const std::function<bool()>& stop = {},
                                                  EpisodeObserver* observer = nullptr);

 private:
  friend class Episode;
  simulator::Scenario scenario_;
  TeamOptions options_;
  simulator::Place place_;
  std::vector<Eigen::Vector2d> ground_;  ///< of passers-by
  PersonWorld person_world_;
  SearchMission mission_;
  Time now_;  ///< goes on from episode to episode
  std::uint64_t played_ = 0;
};

}  // namespace tandem::experiment
