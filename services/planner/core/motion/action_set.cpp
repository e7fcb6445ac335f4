#include "services/planner/core/motion/action_set.hpp"

#include <algorithm>
#include <cmath>

namespace tandem {
namespace {

using Eigen::Vector2d;

constexpr double kPartReach_m = 5.0;   ///< a start next to a wall still finds its part of the map
constexpr double kStartReach_m = 3.0;  ///< from so far off the floor an agent finds back
constexpr double kStandpointReach_m = 0.75;
constexpr double kSlack_m = 0.02;  ///< of clearance

MotionOptions motion_options(const Searcher& searcher) {
  MotionOptions options;
  options.radius_m = searcher.radius_m;
  options.preferred_clearance_m = searcher.preferred_clearance_m;
  return options;
}

std::vector<int> lookout_nodes(const MotionMap& motion, ViewTable& views, const ActionSetOptions& options,
                               const Vector2d& start_in_map) {
  const auto start = motion.nearest_node(start_in_map, kPartReach_m);
  if (!start) return {};
  return covering_lookouts(views.observability(), motion, *start, options.lookout_range_m, options.least_gain_m2);
}

}  // namespace

ActionSet::ActionSet(const OccupancyGrid& map, ViewTable& views, const ActionSetOptions& options,
                     const Vector2d& start_in_map, const std::vector<BlockedDisc>& blocked)
    : options_(options),
      views_(views),
      motion_(map, motion_options(views.searcher()), blocked),
      roads_(motion_, lookout_nodes(motion_, views, options, start_in_map), options.nearest) {
  for (int lookout = 0; lookout < lookouts(); ++lookout) points_.push_back(motion_.point(roads_.node(lookout)));
  nearest_.resize(points_.size());
  panoramas_.resize(points_.size());
}

void ActionSet::forget_added_places() {
  const auto count = static_cast<std::size_t>(lookouts());
  if (points_.size() == count) return;
  points_.resize(count);
  nearest_.resize(count);
  roads_.forget_added_places();
  added_legs_.clear();
}

bool ActionSet::can_stand_near(const Vector2d& point_in_map) const {
  return motion_.nearest_node(point_in_map, kStartReach_m).has_value();
}

std::optional<int> ActionSet::add_place(const Vector2d& point_in_map, double reach_m) {
  const auto node = motion_.nearest_node(point_in_map, reach_m);
  if (!node) return std::nullopt;
  const Vector2d& there = motion_.point(*node);
  const bool is_roomy = motion_.clearance_m(point_in_map, there) >= searcher().radius_m - kSlack_m;
  points_.push_back(is_roomy ? point_in_map : there);
  nearest_.emplace_back();
  return roads_.add_place(*node);
}

std::vector<int> ActionSet::near_lookouts(int from) {
  return roads_.ends(from);
}

const std::vector<int>& ActionSet::nearest_lookouts(int from) {
  auto& nearest = nearest_[static_cast<std::size_t>(from)];
  if (nearest.empty()) {
    for (const RoadGraph::Road& road : roads_.roads(from)) {
      if (static_cast<int>(nearest.size()) == options_.nearest) break;
      nearest.push_back(road.to);
    }
  }
  return nearest;
}

const Leg& ActionSet::leg(int from, int to) {
  const bool stays = from < lookouts() && to < lookouts();
  const auto [entry, is_new] = (stays ? legs_ : added_legs_).try_emplace({from, to});
  Leg& leg = entry->second;
  if (!is_new) return leg;
  leg.way = way(from, to);
  if (leg.way.empty()) return leg;
  leg.initial_heading_rad = heading_towards(leg.way[0], leg.way[1]);
  leg.final_heading_rad = heading_towards(leg.way[leg.way.size() - 2], leg.way.back());
  const TimedPath path = timed_path(leg.way, searcher(), leg.initial_heading_rad);
  leg.duration_s = path.duration_s();
  leg.seen = sightings_along(path, leg.initial_heading_rad, views_);
  if (!searcher().sees_all_around()) {
    leg.stay = sightings_of_stay({leg.way.back().x(), leg.way.back().y(), leg.final_heading_rad}, views_);
  }
  return leg;
}

bool ActionSet::is_near(int from, int to) {
  if (from >= lookouts() && to >= lookouts()) return is_connected(from, to);
  const auto leads_to = [&](int place, int other) {
    return std::ranges::find(roads_.ends(place), other) != roads_.ends(place).end();
  };
  return leads_to(from, to) || (to >= lookouts() && leads_to(to, from));
}

std::vector<int> ActionSet::joined(int from, std::span<const int> places) {
  std::vector<int> walk;
  for (const int place : places) {
    if (place == from) continue;
    if (is_near(from, place)) {
      walk.push_back(place);
      from = place;
    } else if (const auto& stops = roads_.stops(from, place); !stops.empty()) {
      walk.insert(walk.end(), stops.begin(), stops.end());
      from = place;
    }
  }
  return walk;
}

std::vector<Vector2d> ActionSet::way(int from, int to) {
  const std::vector<int> stops = roads_.stops(from, to);
  std::vector<Vector2d> way;
  if (stops.size() == 1) {
    if (const auto nodes = roads_.nodes(from, to); !nodes.empty()) way = motion_.way(nodes, place(from), place(to));
    if (way.size() < 2) way.clear();
    return way;
  }
  for (const int stop : stops) {
    const auto& part = leg(from, stop).way;
    way.insert(way.end(), part.begin() + (way.empty() || part.empty() ? 0 : 1), part.end());
    from = stop;
  }
  return way;
}

const View& ActionSet::panorama(int lookout) {
  View& panorama = panoramas_[static_cast<std::size_t>(lookout)];
  if (!panorama.empty()) return panorama;
  Observability& observability = views_.observability();
  const auto cell = observability.area().nearest_cell(place(lookout), kStandpointReach_m);
  if (!cell) return panorama;
  for (const int seen : observability.in_sight_of(*cell)) {
    if ((observability.area().point(seen) - place(lookout)).norm() <= options_.lookout_range_m)
      panorama.push_back(seen);
  }
  return panorama;
}

}  // namespace tandem
