#include "services/planner/core/motion/action_set.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tandem {
namespace {

using Eigen::Vector2d;

constexpr int kSectors = 24;           ///< of heading, for views
constexpr double kStartReach_m = 5.0;  ///< a start next to a wall still finds its part of the map
constexpr double kStandpointReach_m = 0.75;

MotionOptions motion_options(const Searcher& searcher) {
  MotionOptions options;
  options.radius_m = searcher.radius_m;
  options.preferred_clearance_m = searcher.preferred_clearance_m;
  return options;
}

}  // namespace

ActionSet::ActionSet(const OccupancyGrid& map, Observability& observability, const Searcher& searcher,
                     const ActionSetOptions& options, const Vector2d& start_in_map,
                     const std::vector<BlockedDisc>& blocked)
    : searcher_(searcher),
      options_(options),
      observability_(observability),
      motion_(map, motion_options(searcher), blocked) {
  if (const auto start = motion_.nearest_node(start_in_map, kStartReach_m)) {
    nodes_ = covering_lookouts(observability_, motion_, *start, options_.lookout_range_m, options_.least_gain_m2);
  }
  lookout_count_ = static_cast<int>(nodes_.size());
  paths_.resize(nodes_.size());
  nearest_.resize(nodes_.size());
  panoramas_.resize(nodes_.size());
}

bool ActionSet::prepare_next() {
  if (prepared_ == lookout_count_) return false;
  for (const int lookout : nearest_lookouts(prepared_)) (void)leg(prepared_, lookout);
  ++prepared_;
  return true;
}

void ActionSet::forget_added_places() {
  const auto count = static_cast<std::size_t>(lookout_count_);
  nodes_.resize(count);
  paths_.resize(count);
  nearest_.resize(count);
  std::erase_if(legs_, [&](const auto& entry) {
    return entry.first.first >= lookout_count_ || entry.first.second >= lookout_count_;
  });
}

std::optional<int> ActionSet::add_place(const Vector2d& point_in_map, double reach_m) {
  const auto node = motion_.nearest_node(point_in_map, reach_m);
  if (!node) return std::nullopt;
  nodes_.push_back(*node);
  paths_.emplace_back();
  nearest_.emplace_back();
  return static_cast<int>(nodes_.size()) - 1;
}

const Vector2d& ActionSet::place(int index) const {
  return motion_.point(nodes_[static_cast<std::size_t>(index)]);
}

const ShortestPaths& ActionSet::paths_from(int place) {
  ShortestPaths& paths = paths_[static_cast<std::size_t>(place)];
  if (paths.from < 0) paths = motion_.shortest_paths(nodes_[static_cast<std::size_t>(place)]);
  return paths;
}

double ActionSet::distance_m(int from, int to) {
  return paths_from(from).cost_m[static_cast<std::size_t>(nodes_[static_cast<std::size_t>(to)])];
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

int ActionSet::turning_steps(double from_rad, double to_rad) const {
  return static_cast<int>(std::ceil(turning_time_s(searcher_, from_rad, to_rad) / options_.step_s - 1e-9));
}

int ActionSet::view_at(const Pose2& pose) {
  const bool all_around = searcher_.field_of_view_rad >= 2.0 * std::numbers::pi;
  const double sector_rad = 2.0 * std::numbers::pi / kSectors;
  const int sector =
      all_around ? 0 : static_cast<int>(std::lround((pose.heading + std::numbers::pi) / sector_rad)) % kSectors;
  const int standpoint = observability_.area().nearest_cell(pose.position(), kStandpointReach_m).value_or(-1);
  const auto [entry, is_new] = view_of_.try_emplace({standpoint, sector}, static_cast<int>(views_.size()));
  if (is_new) {
    View view;
    if (standpoint >= 0) {
      const Vector2d& point = observability_.area().point(standpoint);
      view = observability_.seen_from(searcher_, {point.x(), point.y(), sector * sector_rad - std::numbers::pi});
    }
    views_.push_back(std::move(view));
  }
  return entry->second;
}

const Leg& ActionSet::leg(int from, int to) {
  const auto [entry, is_new] = legs_.try_emplace({from, to});
  Leg& leg = entry->second;
  if (!is_new) return leg;
  leg.way = motion_.way(paths_from(from), nodes_[static_cast<std::size_t>(to)]);
  if (leg.way.size() < 2) return leg;
  leg.initial_heading_rad = heading_towards(leg.way[0], leg.way[1]);
  leg.final_heading_rad = heading_towards(leg.way[leg.way.size() - 2], leg.way.back());
  const TimedPath path = timed_path(leg.way, searcher_, leg.initial_heading_rad);
  const int steps = std::max(1, static_cast<int>(std::ceil(path.duration_s() / options_.step_s - 1e-9)));
  std::map<int, int> looks;
  for (int step = 0; step < steps; ++step) {
    leg.views.push_back(view_at(pose_at(path, (step + 0.5) * options_.step_s)));
    for (const int cell : view(leg.views.back())) ++looks[cell];
  }
  const double exposure_per_step = searcher_.detection_rate_per_s * options_.step_s;
  for (const auto& [cell, count] : looks) leg.looks.push_back({cell, -std::expm1(-exposure_per_step * count)});
  return leg;
}

const View& ActionSet::panorama(int lookout) {
  View& panorama = panoramas_[static_cast<std::size_t>(lookout)];
  if (!panorama.empty()) return panorama;
  const auto cell = observability_.area().nearest_cell(place(lookout), kStandpointReach_m);
  if (!cell) return panorama;
  for (const int seen : observability_.in_sight_of(*cell)) {
    if ((observability_.area().point(seen) - place(lookout)).norm() <= options_.lookout_range_m)
      panorama.push_back(seen);
  }
  return panorama;
}

}  // namespace tandem
