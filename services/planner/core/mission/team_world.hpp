#pragma once

#include <memory>
#include <string>
#include <vector>

#include "services/planner/core/motion/action_set.hpp"
#include "services/planner/core/planner_config.hpp"
#include "services/planner/core/search/search_belief.hpp"

namespace tandem {

/// What stays the same from plan to plan: the map, the area on it, who sees what from where, and the action sets.
class TeamWorld {
 public:
  /// `start_in_map` is where the robot is when the search is prepared.
  TeamWorld(OccupancyGrid map, const PlannerConfig& config, const std::string& robot, const std::string& person,
            const Eigen::Vector2d& start_in_map);
  TeamWorld(const TeamWorld&) = delete;  // its parts point at each other
  TeamWorld& operator=(const TeamWorld&) = delete;

  /// Finds the robot's ways anew around `blocked` places.
  void block(const std::vector<BlockedDisc>& blocked, const Eigen::Vector2d& robot_in_map);

  [[nodiscard]] const SearchArea& area() const { return area_; }
  [[nodiscard]] Observability& observability() { return observability_; }
  [[nodiscard]] ActionSet& robot() { return *robot_; }
  [[nodiscard]] ActionSet& person() { return *person_; }
  /// The time the team would need to sweep the area once, seen from afar [s].
  [[nodiscard]] double sweep_time_s() const;

 private:
  [[nodiscard]] ActionSetOptions options(double lookout_range_m) const;

  PlannerConfig config_;
  OccupancyGrid map_;
  SearchArea area_;
  Observability observability_;
  std::unique_ptr<ActionSet> robot_;
  std::unique_ptr<ActionSet> person_;
};

}  // namespace tandem
