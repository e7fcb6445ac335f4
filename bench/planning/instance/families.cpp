#include "bench/planning/instance/families.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "bench/planning/instance/layouts.hpp"
#include "bench/planning/instance/recipes.hpp"
#include "services/common/config.hpp"
#include "services/mapping/core/distance_field.hpp"

namespace tandem::bench {
namespace {

using Eigen::Vector2d;

FloorPlan floor_plan(Layout layout, Rng& rng) {
  switch (layout) {
    case Layout::WallsAndColumns:
      return walls_and_columns(rng, false);
    case Layout::WallsAndColumnsLow:
      return walls_and_columns(rng, true);
    case Layout::SmallRooms:
      return small_rooms(rng);
    case Layout::Office:
      return office_floor(rng, false);
    case Layout::OfficeLow:
      return office_floor(rng, true);
    case Layout::Plaza:
      return plaza(rng);
    case Layout::Campus:
      return campus(rng);
    case Layout::Brl:
      return brl_square();
  }
  return {};
}

/// A random place with at least `clearance_m` to all walls, accepted by `is_fit`; the corner of the map if none is
/// found.
Vector2d free_place(const OccupancyGrid& map, const FloorPlan& plan, double clearance_m, Rng& rng,
                    const std::function<bool(const Vector2d&)>& is_fit) {
  const DistanceField clearance(map, clearance_m + 0.5, Obstacles::OccupiedOrUnknown);
  for (int attempt = 0; attempt < 20000; ++attempt) {
    const Vector2d place{rng.uniform(0.0, plan.width_m), rng.uniform(0.0, plan.height_m)};
    if (clearance.nearest(place) >= clearance_m && is_fit(place)) return place;
  }
  return Vector2d::Constant(clearance_m);
}

Vector2d farthest_corner(const FloorPlan& plan, const Vector2d& from) {
  return {from.x() < 0.5 * plan.width_m ? plan.width_m - 3.0 : 3.0,
          from.y() < 0.5 * plan.height_m ? plan.height_m - 3.0 : 3.0};
}

PriorSpec prior_spec(PriorKind kind, const FloorPlan& plan, const Vector2d& start, Rng& rng) {
  const Vector2d far = farthest_corner(plan, start);
  const double side_m = std::min(plan.width_m, plan.height_m);
  switch (kind) {
    case PriorKind::Uniform:
      return {};
    case PriorKind::Excluded10m:
      return {1.0, {}, 10.0};
    case PriorKind::Hills: {
      PriorSpec spec{0.2, {}, 0.0};
      for (int i = 0; i < 3; ++i) {
        const Vector2d centre{rng.uniform(0.0, plan.width_m), rng.uniform(0.0, plan.height_m)};
        spec.gaussians.push_back({centre, rng.uniform(0.08, 0.16) * side_m, rng.uniform(0.2, 0.4)});
      }
      return spec;
    }
    case PriorKind::FarRoom:
      return {0.2, {{far, 0.1 * side_m, 0.8}}, 0.0};
    case PriorKind::Deceptive: {
      // A thin trail that leads away from the start to the near side, and a large hill on the other side.
      const Vector2d away = 2.0 * start - far;
      const Vector2d near{std::clamp(away.x(), 1.0, plan.width_m - 1.0),
                          std::clamp(away.y(), 1.0, plan.height_m - 1.0)};
      return {0.15,
              {{0.5 * (start + near), 0.06 * side_m, 0.1}, {near, 0.08 * side_m, 0.15}, {far, 0.12 * side_m, 0.6}},
              0.0};
    }
  }
  return {};
}

std::vector<Searcher> searchers_of(const Recipe& recipe) {
  std::vector<Searcher> all;
  const auto add = [&](int count, const std::string& kind, const Searcher& like) {
    for (int i = 0; i < count; ++i) {
      all.push_back(like);
      all.back().id = kind + std::to_string(i + 1);
    }
  };
  Searcher robot;
  robot.speed_mps = 0.5;
  robot.radius_m = 0.3;
  robot.view_max_m = recipe.range_m;
  robot.detection_rate_per_s = recipe.rate_per_s;
  Searcher person = robot;
  person.speed_mps = 0.75;
  Searcher drone = robot;
  drone.speed_mps = 2.0;
  drone.view_max_m = 1.5 * recipe.range_m;
  drone.detection_rate_per_s = 0.3;
  drone.layer = 1;
  drone.endurance_s = 600.0;
  add(recipe.robots, "robot", robot);
  add(recipe.persons, "person", person);
  add(recipe.drones, "drone", drone);
  return all;
}

void add_events(PlanningInstance& instance, const OccupancyGrid& map, Rng& rng) {
  using Kind = WorldEvent::Kind;
  const auto somewhere = [&] { return free_place(map, instance.plan, 0.8, rng, [](const Vector2d&) { return true; }); };
  instance.events = {{Kind::RejectedPlan, 30.0, {}, 0.0, 1.0},
                     {Kind::BlockedPassage, 60.0, somewhere(), 0.6, 1.0},
                     {Kind::Hint, 80.0, somewhere(), 4.0, 5.0},
                     {Kind::Passer, 20.0, somewhere(), 8.0, 1.0},
                     {Kind::Passer, 40.0, somewhere(), 8.0, 1.0}};
  std::ranges::stable_sort(instance.events, {}, &WorldEvent::time_s);
}

}  // namespace

const std::vector<FamilySpec>& families() {
  static const std::vector<FamilySpec> list = [] {
    std::vector<FamilySpec> specs;
    for (const Recipe& recipe : recipes()) specs.push_back(recipe.spec);
    return specs;
  }();
  return list;
}

PlanningInstance instance_of(std::string_view family, std::uint64_t seed) {
  const auto recipe = std::ranges::find(recipes(), family, [](const Recipe& r) { return r.spec.name; });
  if (recipe == recipes().end()) {
    std::string names;
    for (const FamilySpec& spec : families()) names += " " + std::string(spec.name);
    throw ConfigError("no family of instances is named '" + std::string(family) + "'; there are" + names);
  }
  // Families on one layout share their maps and starts, seed by seed, so that variants compare.
  Rng rng{seed * 7919 + static_cast<std::uint64_t>(recipe->layout)};
  PlanningInstance instance;
  instance.family = family;
  instance.seed = seed;
  instance.searchers = searchers_of(*recipe);
  instance.area.cell_size_m = recipe->cell_size_m;
  instance.horizon_s = recipe->horizon_s;
  instance.replan_period_s = recipe->replan_period_s;
  instance.human = recipe->human;
  instance.drone_altitude_m = recipe->drones > 0 ? 2.0 : 0.0;

  const double body_m = instance.searchers.front().radius_m + 0.1;
  OccupancyGrid map;
  Vector2d start;
  do {  // until nearly all of it can be walked to
    instance.plan = floor_plan(recipe->layout, rng);
    map = drawn(instance.plan, 0.0);
    start = free_place(map, instance.plan, body_m + 0.3, rng, [](const Vector2d&) { return true; });
  } while (reachable_share(map, start, body_m) < 0.97);
  instance.area.start_in_map = start;
  for (std::size_t i = 0; i < instance.searchers.size(); ++i) {
    const Vector2d place = i == 0 ? start : free_place(map, instance.plan, body_m, rng, [&](const Vector2d& p) {
      return (p - start).norm() < 2.0 && std::ranges::all_of(instance.starts, [&](const Pose2& other) {
               return (other.position() - p).norm() > 0.5;
             });
    });
    instance.starts.push_back({place.x(), place.y(), rng.uniform(-std::numbers::pi, std::numbers::pi)});
  }
  Rng own = rng.fork();
  instance.prior = prior_spec(recipe->prior, instance.plan, start, own);
  if (recipe->dynamic) add_events(instance, map, own);
  return instance;
}

std::size_t person_of(const PlanningInstance& instance) {
  const auto person = std::ranges::find(instance.searchers, "person1", &Searcher::id);
  return static_cast<std::size_t>(person - instance.searchers.begin());
}

std::vector<OccupancyGrid> layers_of(const PlanningInstance& instance) {
  std::vector<OccupancyGrid> layers{drawn(instance.plan, 0.0)};
  if (instance.drone_altitude_m > 0.0) layers.push_back(drawn(instance.plan, instance.drone_altitude_m));
  return layers;
}

}  // namespace tandem::bench
