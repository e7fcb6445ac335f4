#pragma once

#include <memory>
#include <vector>

#include "services/planner/core/search/search_belief.hpp"
#include "services/planner/core/team/team_planner.hpp"
#include "tests/services/planner/support/room.hpp"

namespace tandem {

/// The area that can be walked to from there.
inline SearchAreaOptions start_at(double x, double y) {
  SearchAreaOptions options;
  options.start_in_map = {x, y};
  return options;
}

inline Searcher test_robot() {
  Searcher robot;
  robot.id = "robot";
  robot.speed_mps = 0.5;
  robot.radius_m = 0.45;
  robot.preferred_clearance_m = 0.8;
  robot.view_min_m = 0.6;
  robot.view_max_m = 4.0;
  robot.field_of_view_rad = from_degrees(60.0);
  robot.detection_rate_per_s = 1.0;
  return robot;
}

inline Searcher test_person() {
  Searcher person;
  person.id = "person";
  person.speed_mps = 0.75;
  person.radius_m = 0.25;
  return person;
}

/// A map with what planning on it needs.
class SearchWorld {
 public:
  SearchWorld(OccupancyGrid grid, const Eigen::Vector2d& start_in_map)
      : map(std::move(grid)), area(map, {.start_in_map = start_in_map, .outline_in_map = {}}), sight(map, area, 4.0) {}

  ActionSet& add(const Searcher& searcher, const Eigen::Vector2d& start_in_map, double range_m = 2.5) {
    ActionSetOptions options;
    options.lookout_range_m = range_m;
    sets.push_back(std::make_unique<ActionSet>(map, sight, searcher, options, start_in_map));
    problem.members.push_back({sets.back().get(), *sets.back()->add_place(start_in_map, 2.0), 0.0, {}});
    problem.mass = uniform_prior(area, start_in_map, 0.0);
    return *sets.back();
  }

  OccupancyGrid map;
  SearchArea area;
  Observability sight;
  std::vector<std::unique_ptr<ActionSet>> sets;
  TeamProblem problem;
};

}  // namespace tandem
