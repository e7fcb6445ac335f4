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

}  // namespace

ActionSet::ActionSet(const OccupancyGrid& map, ViewTable& views, const ActionSetOptions& options,
                     const Vector2d& start_in_map, const std::vector<BlockedDisc>& blocked)
    : options_(options), views_(views), motion_(map, motion_options(views.searcher()), blocked) {
  if (const auto start = motion_.nearest_node(start_in_map, kPartReach_m)) {
    for (const int node :
         covering_lookouts(views_.observability(), motion_, *start, options_.lookout_range_m, options_.least_gain_m2)) {
      places_.push_back({motion_.point(node), node});
    }
  }
  lookout_count_ = static_cast<int>(places_.size());
  paths_.resize(places_.size());
  nearest_.resize(places_.size());
  panoramas_.resize(places_.size());
}

bool ActionSet::prepare_next() {
  if (prepared_ == lookout_count_) return false;
  for (const int lookout : nearest_lookouts(prepared_)) (void)leg(prepared_, lookout);
  ++prepared_;
  return true;
}

void ActionSet::forget_added_places() {
  const auto count = static_cast<std::size_t>(lookout_count_);
  places_.resize(count);
  paths_.resize(count);
  nearest_.resize(count);
  std::erase_if(legs_, [&](const auto& entry) {
    return entry.first.first >= lookout_count_ || entry.first.second >= lookout_count_;
  });
}

bool ActionSet::can_stand_near(const Vector2d& point_in_map) const {
  return motion_.nearest_node(point_in_map, kStartReach_m).has_value();
}

std::optional<int> ActionSet::add_place(const Vector2d& point_in_map, double reach_m) {
  const auto node = motion_.nearest_node(point_in_map, reach_m);
  if (!node) return std::nullopt;
  const Vector2d& there = motion_.point(*node);
  const bool is_roomy = motion_.clearance_m(point_in_map, there) >= searcher().radius_m - kSlack_m;
  places_.push_back({is_roomy ? point_in_map : there, *node});
  paths_.emplace_back();
  nearest_.emplace_back();
  return static_cast<int>(places_.size()) - 1;
}

const ShortestPaths& ActionSet::paths_from(int place) {
  ShortestPaths& paths = paths_[static_cast<std::size_t>(place)];
  if (paths.from < 0) paths = motion_.shortest_paths(place_at(place).node);
  return paths;
}

double ActionSet::distance_m(int from, int to) {
  return paths_from(from).cost_m[static_cast<std::size_t>(place_at(to).node)];
}

const std::vector<int>& ActionSet::nearest_lookouts(int from) {
  auto& nearest = nearest_[static_cast<std::size_t>(from)];
  if (!nearest.empty()) return nearest;
  std::vector<std::pair<double, int>> order;
  for (int lookout = 0; lookout < lookout_count_; ++lookout) {
    if (lookout != from && is_connected(from, lookout)) order.emplace_back(distance_m(from, lookout), lookout);
  }
  std::sort(order.begin(), order.end());
  for (const auto& [distance, lookout] : order) {
    if (static_cast<int>(nearest.size()) >= options_.nearest) break;
    nearest.push_back(lookout);
  }
  return nearest;
}

const Leg& ActionSet::leg(int from, int to) {
  const auto [entry, is_new] = legs_.try_emplace({from, to});
  Leg& leg = entry->second;
  if (!is_new) return leg;
  leg.way = motion_.way(paths_from(from), place_at(to).node, place(from), place(to));
  if (leg.way.size() < 2) {
    leg.way.clear();
    return leg;
  }
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
