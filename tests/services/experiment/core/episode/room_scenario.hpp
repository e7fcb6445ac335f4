#pragma once

#include "services/experiment/core/episode/episode.hpp"
#include "tests/services/planner/support/room.hpp"

namespace tandem::experiment {

/// A search in an empty hall of 12 m x 8 m; robot and person begin in its lower left corner.
inline simulator::Scenario hall_scenario() {
  simulator::Scenario scenario;
  scenario.name = "hall";
  scenario.robot_start = {2.0, 2.0, 0.0};
  scenario.person_start = {2.0, 3.5, 0.0};
  scenario.tokens_min_distance_m = 4.0;
  scenario.limit_s = 200.0;
  return scenario;
}

inline OccupancyGrid hall_map() {
  return empty_room(12, 8);
}

/// Few rollouts: these tests are about the course of an episode.
inline TeamOptions quick_team() {
  TeamOptions team;
  team.planner.rollouts = 5;
  team.planner.horizon_s = 60.0;
  return team;
}

}  // namespace tandem::experiment
