#include "bench/paths/own_ways.hpp"

#include "bench/paths/shortest_way.hpp"
#include "bench/planning/instance/instance_world.hpp"
#include "bench/planning/loop/cpu_clock.hpp"

namespace tandem::bench {
namespace {

using Eigen::Vector2d;

constexpr double kReach_m = 1.0;

int nearest_lookout(const ActionSet& actions, const Vector2d& point_in_map) {
  int nearest = 0;
  for (int lookout = 1; lookout < actions.lookouts(); ++lookout) {
    const double distance_m = (actions.place(lookout) - point_in_map).norm();
    if (distance_m < (actions.place(nearest) - point_in_map).norm()) nearest = lookout;
  }
  return nearest;
}

PathRecord record_of(const PathCase& one, const std::string& planner) {
  PathRecord record;
  record.family = one.family;
  record.seed = one.seed;
  record.planner = planner;
  return record;
}

PathRecord to_goal(const PathCase& one, const PlanningInstance& instance, const std::string& name) {
  PathRecord record = record_of(one, name);
  MotionOptions options;
  options.radius_m = instance.searchers.front().radius_m;
  options.preferred_clearance_m = instance.searchers.front().preferred_clearance_m;
  double before_ms = thread_cpu_ms();
  const MotionMap motion(layers_of(instance).front(), options);
  record.prepare_ms = thread_cpu_ms() - before_ms;
  before_ms = thread_cpu_ms();
  const auto start = motion.nearest_node(one.start_in_map, kReach_m);
  const auto goal = motion.nearest_node(one.goal_in_map, kReach_m);
  if (start && goal) {
    LocalSearch search(motion);
    bool found = false;
    search.run(*start, [&](int node, double) {
      found = node == *goal;
      return !found;
    });
    if (found) record.length_m = length_m(motion.way(search.nodes_to(*goal), one.start_in_map, one.goal_in_map));
  }
  record.budget_ms = thread_cpu_ms() - before_ms;
  record.shortest_m = one.shortest_m;
  return record;
}

PathRecord over_lookouts(const PathCase& one, const PlanningInstance& instance, const std::string& name) {
  PathRecord record = record_of(one, name);
  double before_ms = thread_cpu_ms();
  const auto world = world_of(instance);
  while (world->prepare_next()) {
  }
  record.prepare_ms = thread_cpu_ms() - before_ms;
  ActionSet& actions = world->actions(0);
  const int start = nearest_lookout(actions, one.start_in_map);
  const int goal = nearest_lookout(actions, one.goal_in_map);
  before_ms = thread_cpu_ms();
  std::vector<Vector2d> way{actions.place(start)};
  int from = start;
  for (const int stop : actions.joined(start, std::vector{goal})) {
    const std::vector<Vector2d>& part = actions.leg(from, stop).way;
    way.insert(way.end(), part.begin() + 1, part.end());
    from = stop;
  }
  record.budget_ms = thread_cpu_ms() - before_ms;
  record.length_m = from == goal ? length_m(way) : 0.0;
  if (const auto shortest = shortest_way(one.room, actions.place(start), actions.place(goal))) {
    record.shortest_m = length_m(*shortest);
  }
  return record;
}

}  // namespace

std::vector<PathRecord> own_ways(const PathCase& one) {
  PlanningInstance narrow = one.instance;
  narrow.searchers.resize(1);
  PlanningInstance roomy = narrow;
  narrow.searchers.front().preferred_clearance_m = narrow.searchers.front().radius_m;
  return {to_goal(one, narrow, "ours, shortest"), over_lookouts(one, narrow, "ours, shortest, over lookouts"),
          to_goal(one, roomy, "ours, with clearance"),
          over_lookouts(one, roomy, "ours, with clearance, over lookouts")};
}

}  // namespace tandem::bench
