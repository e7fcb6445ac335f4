#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "bench/planning/instance/families.hpp"

namespace tandem::bench {

/// A way to be found: from where the robot of a planning instance starts to a place at least half of the map's width
/// away.
struct PathCase {
  std::string family;
  std::uint64_t seed = 0;
  PlanningInstance instance;
  OccupancyGrid room;            ///< where the middle of the robot can be: room_for() of the ground
  Eigen::Vector2d start_in_map;  ///< [m]
  Eigen::Vector2d goal_in_map;   ///< [m]
  double shortest_m = 0.0;       ///< length of the shortest way
};

/// Equal family and seed, equal case.
[[nodiscard]] PathCase path_case(const std::string& family, std::uint64_t seed);

/// How well somebody found a way: a line of paths.jsonl.
struct PathRecord {
  std::string family;
  std::uint64_t seed = 0;
  std::string planner;
  double budget_ms = 0.0;   ///< of processor time, of all its threads; of ours, what it took
  double prepare_ms = 0.0;  ///< of ours, once a map
  double length_m = 0.0;    ///< 0: it found none
  double shortest_m = 0.0;  ///< between the same places

  template <typename Self, typename Visitor>
  static void visit_fields(Self& record, Visitor&& field) {
    field("family", record.family);
    field("seed", record.seed);
    field("planner", record.planner);
    field("budget_ms", record.budget_ms);
    field("prepare_ms", record.prepare_ms);
    field("length_m", record.length_m);
    field("shortest_m", record.shortest_m);
  }
};

}  // namespace tandem::bench
