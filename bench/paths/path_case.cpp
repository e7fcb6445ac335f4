#include "bench/paths/path_case.hpp"

#include <stdexcept>

#include "bench/paths/shortest_way.hpp"
#include "services/common/random.hpp"

namespace tandem::bench {
namespace {

constexpr double kGoalRoom_m = 0.1;  ///< more than its radius
constexpr int kTries = 10'000;

}  // namespace

PathCase path_case(const std::string& family, std::uint64_t seed) {
  PathCase one;
  one.family = family;
  one.seed = seed;
  one.instance = instance_of(family, seed);
  const OccupancyGrid ground = layers_of(one.instance).front();
  const double radius_m = one.instance.searchers.front().radius_m;
  one.room = room_for(ground, radius_m);
  one.start_in_map = one.instance.starts.front().position();
  const OccupancyGrid roomy = room_for(ground, radius_m + kGoalRoom_m);
  const FloorPlan& plan = one.instance.plan;
  Rng rng{seed};
  for (int i = 0; i < kTries; ++i) {
    one.goal_in_map = {rng.uniform(0.0, plan.width_m), rng.uniform(0.0, plan.height_m)};
    if ((one.goal_in_map - one.start_in_map).norm() < 0.5 * plan.width_m) continue;
    if (roomy.at(one.goal_in_map) != CellState::Free) continue;
    if (const auto way = shortest_way(one.room, one.start_in_map, one.goal_in_map)) {
      one.shortest_m = length_m(*way);
      return one;
    }
  }
  throw std::runtime_error{family + " " + std::to_string(seed) + ": no place is far away"};
}

}  // namespace tandem::bench
